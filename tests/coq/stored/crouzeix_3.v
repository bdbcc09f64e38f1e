(** * Crouzeix, SDIRK of order 3, s = 2

    Source: M. Crouzeix, thesis, Univ. Paris VI (1975); S. P. Norsett, Trondheim Math. Comp. 6/74 (1974); E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., Springer 1996, sect. IV.6
    Proved here of its 2 stages: order 3, A-stable, algebraically stable. *)

From Coq Require Import List Arith ZArith QArith Reals.
Require Import stagecraft.
Import ListNotations.
Open Scope nat_scope.

Module Method.

Definition d : Q := 3.
Lemma d_positive : (0 <= d)%Q.
Proof. discriminate. Qed.
Definition A : list (list coefficient) :=
  [ [((1 # 2), (1 # 6)); (0, 0)]%Q;
    [(0, (-1 # 3)); ((1 # 2), (1 # 6))]%Q ].
Definition b : list coefficient :=
  map q [(1 # 2); (1 # 2)]%Q.

(** Order 3: the conditions of all trees of at most 3 nodes hold, and that of one of 4 nodes does not: dot(b, A*(A*c)) == 1/24. *)
Theorem order_of_the_method : forall F : field d,
  order_is (table F A b) 3.
Proof.
  intro F.
  apply (@table_order_is d F A b 3 (graft leaf (graft leaf (graft leaf leaf)))).
  vm_cast_no_check (eq_refl true).
Qed.

(** R(z) = top / bottom. *)
Definition top : list coefficient :=
  [(1, 0); (0, (-1 # 3)); ((-1 # 6), (-1 # 6))]%Q.
Definition bottom : list coefficient :=
  [(1, 0); ((-1), (-1 # 3)); ((1 # 3), (1 # 6))]%Q.
Theorem stability_function_of_the_method : forall F : field d,
  stability_function (table F A b) top bottom.
Proof.
  intro F.
  apply (@table_function_is d F A b 0 [q 1] top bottom).
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

(** b >= 0, and M = B A + A^T B - b b^T >= 0: a sum of D (L^T v)^2 for each pair (D, L). *)
Definition squares_of_b : squares :=
  [ (((1 # 2), 0)%Q, map q [1; 0]%Q);
    (((1 # 2), 0)%Q, map q [0; 1]%Q) ].
Definition squares_of_m : squares :=
  [ (((1 # 4), (1 # 6))%Q, map q [1; (-1)]%Q) ].
Theorem algebraically_stable_method : algebraically_stable (table (reals d_positive) A b).
Proof.
  apply (table_algebraic_is d_positive A b squares_of_b squares_of_m).
  vm_cast_no_check (eq_refl true).
Qed.

Print Assumptions order_of_the_method.
End Method.
