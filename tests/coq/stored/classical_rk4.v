(** * The Runge-Kutta method of order 4 (RK4)

    Source: W. Kutta, Z. Math. Phys. 46 (1901) 435-453; Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sect. II.1
    Proved here of its 4 stages: order 4, not A-stable, not algebraically stable. *)

From Coq Require Import List Arith ZArith QArith Reals.
Require Import stagecraft.
Import ListNotations.
Open Scope nat_scope.

Module Method.

Definition d : Q := 0.
Lemma d_positive : (0 <= d)%Q.
Proof. discriminate. Qed.
Definition A : list (list coefficient) :=
  [ map q [0; 0; 0; 0]%Q;
    map q [(1 # 2); 0; 0; 0]%Q;
    map q [0; (1 # 2); 0; 0]%Q;
    map q [0; 0; 1; 0]%Q ].
Definition b : list coefficient :=
  map q [(1 # 6); (1 # 3); (1 # 3); (1 # 6)]%Q.

(** Order 4: the conditions of all trees of at most 4 nodes hold, and that of one of 5 nodes does not: dot(b, A*(A*(A*c))) == 1/120. *)
Theorem order_of_the_method : forall F : field d,
  order_is (table F A b) 4.
Proof.
  intro F.
  apply (@table_order_is d F A b 4 (graft leaf (graft leaf (graft leaf (graft leaf leaf))))).
  vm_cast_no_check (eq_refl true).
Qed.

(** R(z) = top / bottom. *)
Definition top : list coefficient :=
  map q [1; 1; (1 # 2); (1 # 6); (1 # 24)]%Q.
Definition bottom : list coefficient :=
  map q [1]%Q.
Theorem stability_function_of_the_method : forall F : field d,
  stability_function (table F A b) top bottom.
Proof.
  intro F.
  apply (@table_function_is d F A b 3 [q 1] top bottom).
  vm_cast_no_check (eq_refl true).
Qed.

(** |R(z)| > 1 at z = 0 + 3 i. *)
Theorem not_a_stable_method : ~ a_stable d_positive top bottom.
Proof.
  apply exceeds_one_refutes, (@exceeds_is_checked d d_positive top bottom (0, 0)%Q (3, 0)%Q).
  vm_cast_no_check (eq_refl true).
Qed.

(** A vector v with v^T M v < 0. *)
Definition direction : list coefficient :=
  map q [1; 0; 0; 0]%Q.
Theorem not_algebraically_stable_method : not_algebraically_stable (table (reals d_positive) A b).
Proof.
  apply (table_m_negative_is d_positive A b direction).
  vm_cast_no_check (eq_refl true).
Qed.

Print Assumptions order_of_the_method.
End Method.
