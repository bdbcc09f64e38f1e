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

(** |Q|^2 - |P|^2 = sum of D |h|^2 + u sum of D |k|^2 at z = -u + iy, with the pairs (D, h) and (D, k); and so is
    |Q|^2 - e. *)
Definition growth_on_axis : squares :=
  [ ((1, 0)%Q, map q [0; 0; (-33429 # 1048576); (-26401 # 4194304); (-41633 # 16777216)]%Q);
    (((139684779781 # 2061584302080000), 0)%Q, map q [0; 0; (-1)]%Q);
    (((13050899761913 # 2473901162496000000), 0)%Q, map q [0; 0; 0; (-1)]%Q);
    (((45131210918111 # 109951162777600000000), 0)%Q, map q [0; 0; 0; 0; (-1)]%Q) ].
Definition growth_inside : squares :=
  [ ((2, 0)%Q, map q [1; (-2 # 5); (49 # 2400); (-6561 # 2560000)]%Q);
    (((1 # 6), 0)%Q, map q [0; 1; (-251837 # 640000); (19683 # 1280000)]%Q);
    (((12893837876472893 # 7730941132800000000), 0)%Q, map q [0; 0; 1; (-8831692139320899 # 51575351505891572)]%Q);
    (((7236032641405237601165029643767 # 44302889599501730612405862400000000), 0)%Q, map q [0; 0; 0; 1]%Q) ].
Definition poles_on_axis : squares :=
  [ (((1 # 2), 0)%Q, map q [1]%Q);
    (((81 # 400), 0)%Q, map q [0; 1]%Q);
    (((19683 # 1280000), 0)%Q, map q [0; 0; 1]%Q);
    (((531441 # 1024000000), 0)%Q, map q [0; 0; 0; 1]%Q);
    (((43046721 # 6553600000000), 0)%Q, map q [0; 0; 0; 0; 1]%Q) ].
Definition poles_inside : squares :=
  [ (((9 # 5), 0)%Q, map q [1; (-27 # 80); (81 # 1600); (-729 # 256000)]%Q);
    (((8019 # 32000), 0)%Q, map q [0; 1; (-81 # 440); (81 # 7040)]%Q);
    (((1121931 # 112640000), 0)%Q, map q [0; 0; 1; (-117 # 1520)]%Q);
    (((157837977 # 1245184000000), 0)%Q, map q [0; 0; 0; 1]%Q) ].
Theorem a_stable_method : a_stable d_positive top bottom.
Proof.
  apply (a_stable_by_squares d_positive _ _ growth_on_axis growth_inside ((1 # 2), 0)%Q poles_on_axis poles_inside).
  vm_cast_no_check (eq_refl true).
Qed.

(** And R(infinity) = 0. *)
Theorem l_stable_method : l_stable d_positive top bottom.
Proof.
  apply (l_stable_is_checked a_stable_method).
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
