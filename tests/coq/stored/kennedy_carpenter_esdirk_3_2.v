(** * Kennedy-Carpenter ESDIRK3(2)5L[2]SA

    Source: C. A. Kennedy, M. H. Carpenter, NASA/TM-2016-219173; Appl. Numer. Math. 146 (2019) 221-244
    Proved here of its 5 stages: order 3, L-stable, not algebraically stable, stiffly accurate. *)

From Coq Require Import List Arith ZArith QArith Reals.
Require Import stagecraft.
Import ListNotations.
Open Scope nat_scope.

Module Method.

Definition d : Q := 2.
Lemma d_positive : (0 <= d)%Q.
Proof. discriminate. Qed.
Definition A : list (list coefficient) :=
  [ map q [0; 0; 0; 0; 0]%Q;
    map q [(9 # 40); (9 # 40); 0; 0; 0]%Q;
    [((9 # 80), (9 # 80)); ((9 # 80), (9 # 80)); ((9 # 40), 0); (0, 0); (0, 0)]%Q;
    [((1 # 10), (7 # 80)); ((1 # 10), (7 # 80)); ((7 # 40), (-7 # 40)); ((9 # 40), 0); (0, 0)]%Q;
    [((-1181 # 2835), (1187 # 2835)); ((-1181 # 2835), (1187 # 2835)); ((2374 # 2835), (-2374 # 2835));
       ((5827 # 7560), 0); ((9 # 40), 0)]%Q ].
Definition b : list coefficient :=
  [((-1181 # 2835), (1187 # 2835)); ((-1181 # 2835), (1187 # 2835)); ((2374 # 2835), (-2374 # 2835));
   ((5827 # 7560), 0); ((9 # 40), 0)]%Q.

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
  map q [1; (1 # 10); (-77 # 800); (-1207 # 48000)]%Q.
Definition bottom : list coefficient :=
  map q [1; (-9 # 10); (243 # 800); (-729 # 16000); (6561 # 2560000)]%Q.
Theorem stability_function_of_the_method : forall F : field d,
  stability_function (table F A b) top bottom.
Proof.
  intro F.
  apply (@table_function_is d F A b 0 [q 1] top bottom).
  vm_cast_no_check (eq_refl true).
Qed.

(** W |Q|^2 - 1 and W (|Q|^2 - |P|^2) at z = -u + iy have no negative coefficient. *)
Definition W : list coefficient :=
  map q [1; 0; (1 # 4); 0; (3 # 128); 0; (1 # 1024); 0; (1 # 65536)]%Q.
Theorem l_stable_method : l_stable d_positive top bottom.
Proof.
  apply (l_stable_is_checked d_positive [W]).
  vm_cast_no_check (eq_refl true).
Qed.

(** A vector v with v^T diag(b) v < 0. *)
Definition direction : list coefficient :=
  map q [0; 0; 1; 0; 0]%Q.
Theorem not_algebraically_stable_method : not_algebraically_stable (table (reals d_positive) A b).
Proof.
  apply (table_b_negative_is d_positive A b direction).
  vm_cast_no_check (eq_refl true).
Qed.

(** The last stage is the step. *)
Theorem stiffly_accurate_method : forall F : field d,
  stiffly_accurate (table F A b).
Proof.
  intro F.
  apply (@table_stiff_is d F A b).
  vm_cast_no_check (eq_refl true).
Qed.

Print Assumptions order_of_the_method.
End Method.
