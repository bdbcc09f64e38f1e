(** * radau_iia of 3 stages

    Proved here of its 3 stages: order 5, L-stable, algebraically stable, nodes real, distinct and in [0, 1]. *)

From Coq Require Import List Arith ZArith QArith Reals.
Require Import stagecraft.
Import ListNotations.
Open Scope nat_scope.

Module Method.

Definition d : Q := 0.
Lemma d_positive : (0 <= d)%Q.
Proof. discriminate. Qed.
Definition N : list coefficient :=
  map q [(1 # 10); (-9 # 10); (9 # 5)]%Q.

(** Order 5: the conditions of all trees of at most 5 nodes hold, and that of one of 6 nodes does not: b^T c^5 == 1/6. *)
Theorem order_of_the_method : forall (F : field d) (T : tableau F) (c : nat -> F), collocation T c N ->
  order_is T 5.
Proof.
  intros F T c H.
  apply (@acts_order_is d F T c N (integrals d N) (inverses (length N)) 5 3 2 (graft (graft (graft (graft (graft leaf leaf) leaf) leaf) leaf) leaf) (collocation_acts H)).
  vm_cast_no_check (eq_refl true).
Qed.

(** R(z) = top / bottom. *)
Definition top : list coefficient :=
  map q [1; (2 # 5); (1 # 20)]%Q.
Definition bottom : list coefficient :=
  map q [1; (-3 # 5); (3 # 20); (-1 # 60)]%Q.
Theorem stability_function_of_the_method : forall (F : field d) (T : tableau F) (c : nat -> F), collocation T c N ->
  stability_function T top bottom.
Proof.
  intros F T c H.
  apply (@acts_function_is d F T c N (integrals d N) (inverses (length N)) 0 [q 1] top bottom (collocation_acts H)).
  vm_cast_no_check (eq_refl true).
Qed.

(** |Q|^2 - 1 and |Q|^2 - |P|^2 at z = -u + iy have no negative coefficient. *)
Theorem a_stable_method : a_stable d_positive top bottom.
Proof.
  apply (a_stable_is_checked d_positive).
  vm_cast_no_check (eq_refl true).
Qed.

(** And R(infinity) = 0. *)
Theorem l_stable_method : l_stable d_positive top bottom.
Proof.
  apply (l_stable_is_checked a_stable_method).
  vm_cast_no_check (eq_refl true).
Qed.

(** b >= 0, and M = B A + A^T B - b b^T >= 0: a sum of D (L^T v)^2 for each pair (D, L). *)
Definition squares_of_b : squares :=
  [ ((1, 0)%Q, map q [1; (1 # 2); (1 # 3)]%Q);
    (((1 # 12), 0)%Q, map q [0; 1; 1]%Q);
    (((1 # 180), 0)%Q, map q [0; 0; 1]%Q) ].
Definition squares_of_m : squares :=
  [ (((1 # 900), 0)%Q, map q [0; 0; 1]%Q) ].
Theorem algebraically_stable_method : forall (T : tableau (reals d_positive)) (c : nat -> R), collocation T c N ->
  distinct (stages T) c -> algebraically_stable T.
Proof.
  intros T c H D. apply (acts_algebraic_is (collocation_acts H) D squares_of_b squares_of_m).
  vm_cast_no_check (eq_refl true).
Qed.

(** The nodes are real, distinct, and in [0, 1]: each in one of these brackets. *)
Definition node_brackets : list (Q * Q) :=
  [(0, (1 # 4)); ((1 # 2), (3 # 4)); (1, 1)]%Q.
Theorem nodes_of_the_method : has_nodes d_positive N.
Proof.
  apply (nodes_are_checked d_positive N node_brackets).
  vm_cast_no_check (eq_refl true).
Qed.

(** So what is said here of every such method is said of one. *)
Theorem there_is_such_a_method : exists (T : tableau (reals d_positive)) (c : nat -> R),
  collocation T c N /\ distinct (stages T) c /\ forall i, i < stages T -> (0 <= c i <= 1)%R.
Proof.
  exact (collocation_exists nodes_of_the_method).
Qed.

Print Assumptions order_of_the_method.
End Method.
