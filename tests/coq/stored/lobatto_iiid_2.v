(** * Lobatto IIID, s = 2

    Source: L. O. Jay, Lobatto methods, in: B. Engquist (ed.), Encyclopedia of Applied and Computational Mathematics, Springer 2015 (symplectic: mean of Lobatto IIIC and IIIC* ); G. Sun, J. Comput. Math. 18 (2000) 61-68
    Proved here of its 2 stages: order 2, A-stable, algebraically stable, symplectic, symmetric. *)

From Coq Require Import List Arith ZArith QArith Reals.
Require Import stagecraft.
Import ListNotations.
Open Scope nat_scope.

Module Method.

Definition d : Q := 0.
Lemma d_positive : (0 <= d)%Q.
Proof. discriminate. Qed.
Definition A : list (list coefficient) :=
  [ map q [(1 # 4); (-1 # 4)]%Q;
    map q [(3 # 4); (1 # 4)]%Q ].
Definition b : list coefficient :=
  map q [(1 # 2); (1 # 2)]%Q.

(** Order 2: the conditions of all trees of at most 2 nodes hold, and that of one of 3 nodes does not: dot(b, A*c) == 1/6. *)
Theorem order_of_the_method : forall F : field d,
  order_is (table F A b) 2.
Proof.
  intro F.
  apply (@table_order_is d F A b 2 (graft leaf (graft leaf leaf))).
  vm_cast_no_check (eq_refl true).
Qed.

(** R(z) = top / bottom. *)
Definition top : list coefficient :=
  map q [1; (1 # 2); (1 # 4)]%Q.
Definition bottom : list coefficient :=
  map q [1; (-1 # 2); (1 # 4)]%Q.
Theorem stability_function_of_the_method : forall F : field d,
  stability_function (table F A b) top bottom.
Proof.
  intro F.
  apply (@table_function_is d F A b 0 [q 1] top bottom).
  vm_cast_no_check (eq_refl true).
Qed.

(** |Q|^2 - |P|^2 = sum of D |h|^2 + u sum of D |k|^2 at z = -u + iy, with the pairs (D, h) and (D, k); and so is
    |Q|^2 - e. *)
Definition growth_on_axis : squares :=
  [].
Definition growth_inside : squares :=
  [ ((2, 0)%Q, map q [1; 0]%Q);
    (((1 # 2), 0)%Q, map q [0; 1]%Q) ].
Definition poles_on_axis : squares :=
  [ ((1, 0)%Q, map q [(44869 # 65536); (34779 # 131072); (63455 # 262144)]%Q);
    (((134256487 # 4294967296), 0)%Q, map q [1]%Q);
    (((189778653 # 17179869184), 0)%Q, map q [0; 1]%Q);
    (((268430271 # 68719476736), 0)%Q, map q [0; 0; 1]%Q) ].
Definition poles_inside : squares :=
  [ (((5855466247 # 4294967296), 0)%Q, map q [1; (-1447804901 # 11710932494)]%Q);
    (((17987666961995132613 # 50298072067393716224), 0)%Q, map q [0; 1]%Q) ].
Theorem a_stable_method : a_stable d_positive top bottom.
Proof.
  apply (a_stable_by_squares d_positive _ _ growth_on_axis growth_inside ((1 # 2), 0)%Q poles_on_axis poles_inside).
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
  [].
Theorem algebraically_stable_method : algebraically_stable (table (reals d_positive) A b).
Proof.
  apply (table_algebraic_is d_positive A b squares_of_b squares_of_m).
  vm_cast_no_check (eq_refl true).
Qed.

(** M = 0. *)
Theorem symplectic_method : symplectic (table (reals d_positive) A b).
Proof.
  apply (table_symplectic_is d_positive A b).
  vm_cast_no_check (eq_refl true).
Qed.

(** The method is its own adjoint. *)
Theorem symmetric_method : forall F : field d,
  symmetric (table F A b).
Proof.
  intro F.
  apply (@table_symmetric_is d F A b).
  vm_cast_no_check (eq_refl true).
Qed.

Print Assumptions order_of_the_method.
End Method.
