(** * lobatto_iiib of 3 stages

    Proved here of its 3 stages: order 4, A-stable, not algebraically stable, nodes real, distinct and in [0, 1]. *)

From Coq Require Import List Arith ZArith QArith Reals.
Require Import stagecraft.
Import ListNotations.
Open Scope nat_scope.

Module Method.

Definition d : Q := 0.
Lemma d_positive : (0 <= d)%Q.
Proof. discriminate. Qed.
Definition N : list coefficient :=
  map q [0; (-1 # 2); (3 # 2)]%Q.
Definition alpha : list (list coefficient) :=
  [ map q [0; 1; 0]%Q;
    map q [(-1 # 12); (1 # 2); 0]%Q;
    map q [(-1 # 24); (1 # 4); 0]%Q ].
Definition beta : list coefficient :=
  map q [1; (1 # 2); (1 # 3)]%Q.

(** Order 4: the conditions of all trees of at most 4 nodes hold, and that of one of 5 nodes does not: b^T c^4 == 1/5. *)
Theorem order_of_the_method : forall (F : field d) (T : tableau F) (c : nat -> F), acts T c N alpha beta ->
  order_is T 4.
Proof.
  intros F T c H.
  apply (@acts_order_is d F T c N alpha beta 4 1 3 (graft (graft (graft (graft leaf leaf) leaf) leaf) leaf) H).
  vm_cast_no_check (eq_refl true).
Qed.

(** R(z) = top / bottom. *)
Definition top : list coefficient :=
  map q [1; (1 # 2); (1 # 12)]%Q.
Definition bottom : list coefficient :=
  map q [1; (-1 # 2); (1 # 12)]%Q.
Theorem stability_function_of_the_method : forall (F : field d) (T : tableau F) (c : nat -> F), acts T c N alpha beta ->
  stability_function T top bottom.
Proof.
  intros F T c H.
  apply (@acts_function_is d F T c N alpha beta 0 [q 1] top bottom H).
  vm_cast_no_check (eq_refl true).
Qed.

(** |Q|^2 - 1 and |Q|^2 - |P|^2 at z = -u + iy have no negative coefficient. *)
Theorem a_stable_method : a_stable d_positive top bottom.
Proof.
  apply (a_stable_is_checked d_positive).
  vm_cast_no_check (eq_refl true).
Qed.

(** R(infinity) is not 0: top has the degree of bottom. *)
Theorem not_l_stable_method : ~ l_stable d_positive top bottom.
Proof.
  intros [_ [L _]]. apply Nat.ltb_lt in L. vm_compute in L. discriminate.
Qed.

(** A vector v with v^T M v < 0. *)
Definition direction : list coefficient :=
  map q [0; 0; 1]%Q.
Theorem not_algebraically_stable_method : forall (T : tableau (reals d_positive)) (c : nat -> R), acts T c N alpha beta ->
  not_algebraically_stable T.
Proof.
  intros T c H. apply (acts_m_negative_is H direction).
  vm_cast_no_check (eq_refl true).
Qed.

(** The nodes are real, distinct, and in [0, 1]: each in one of these brackets. *)
Definition node_brackets : list (Q * Q) :=
  [(0, 0); ((1 # 2), (1 # 2)); (1, 1)]%Q.
Theorem nodes_of_the_method : has_nodes d_positive N.
Proof.
  apply (nodes_are_checked d_positive N node_brackets).
  vm_cast_no_check (eq_refl true).
Qed.

(** So what is said here of every such method is said of one. *)
Theorem there_is_such_a_method : exists (T : tableau (reals d_positive)) (c : nat -> R),
  acts T c N alpha beta /\ distinct (stages T) c /\ forall i, i < stages T -> (0 <= c i <= 1)%R.
Proof.
  exact (acts_exists alpha beta nodes_of_the_method eq_refl).
Qed.

Print Assumptions order_of_the_method.
End Method.
