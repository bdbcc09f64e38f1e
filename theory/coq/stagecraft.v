(** * Runge-Kutta methods: what a certificate of stagecraft states, and how Coq computes it

    Written by hand; every exported file contains it and ends with the numbers of one method. Read the definitions
    of sections 1 to 3 (trees, fields, tableaux: what is stated); the rest is how it is decided, and Coq vouches for it. *)

From Coq Require Import List Arith Lia ZArith QArith Qreduction Bool Ring.
Import ListNotations.
Open Scope nat_scope.
Set Implicit Arguments.

(** ** 1. Rooted trees

    Every rooted tree comes from single nodes by grafting: [graft t u] gives the root of [t] one more subtree [u]. (The
    order of the subtrees is kept, so that a tree may occur more than once; a condition is then stated more than once.) *)

Inductive tree := leaf | graft (t u : tree).

Fixpoint size (t : tree) : nat :=
  match t with leaf => 1 | graft t u => size t + size u end.

(** gamma, the density: the product of the sizes of all subtrees, the tree itself included. *)
Fixpoint branches (t : tree) : Z :=
  match t with leaf => 1%Z | graft t u => (branches t * (Z.of_nat (size u) * branches u))%Z end.
Definition gamma (t : tree) : Z := (Z.of_nat (size t) * branches t)%Z.

(** ** 2. Where the coefficients live

    Any commutative ring with 1 <> 0 that contains the rational numbers and a square root of [d]: the real numbers, say,
    or the complex ones. A coefficient x + y sqrt(d) is written [(x, y)]. *)

Record field (d : Q) := {
  K :> Type;
  zero : K; one : K; add : K -> K -> K; mul : K -> K -> K; sub : K -> K -> K; opp : K -> K;
  is_ring : ring_theory zero one add mul sub opp eq;
  one_is_not_zero : one <> zero;
  rat : Q -> K;
  rat_eq : forall x y, (x == y)%Q -> rat x = rat y;
  rat_one : rat 1 = one;
  rat_add : forall x y, rat (x + y) = add (rat x) (rat y);
  rat_mul : forall x y, rat (x * y) = mul (rat x) (rat y);
  root : K;
  root_square : mul root root = rat d }.

Definition coefficient := (Q * Q)%type.
Definition q (x : Q) : coefficient := (x, 0%Q).

Section Statements.
Variable d : Q.
Variable F : field d.
Notation "0" := (zero F).
Notation "1" := (one F).
Infix "+" := (add F).
Infix "*" := (mul F).
Add Ring F_ring : (is_ring F).

Definition value (x : coefficient) : F := rat F (fst x) + rat F (snd x) * root F.
Definition whole (z : Z) : F := rat F (inject_Z z).

(** ** 3. Tableaux and their order *)

Fixpoint sum (n : nat) (f : nat -> F) : F :=
  match n with O => 0 | S n => sum n f + f n end.

Record tableau := { stages : nat; a : nat -> nat -> F; b : nat -> F }.

(** The stage vector of a tree and its elementary weight (Hairer-Norsett-Wanner I.II.2). *)
Fixpoint phi (T : tableau) (t : tree) (i : nat) : F :=
  match t with
  | leaf => 1
  | graft t u => phi T t i * sum (stages T) (fun j => a T i j * phi T u j)
  end.
Definition weight (T : tableau) (t : tree) : F := sum (stages T) (fun i => b T i * phi T t i).

Definition condition (T : tableau) (t : tree) : Prop := whole (gamma t) * weight T t = 1.
Definition has_order (T : tableau) (p : nat) : Prop := forall t, size t <= p -> condition T t.
Definition order_is (T : tableau) (p : nat) : Prop :=
  has_order T p /\ exists t, size t = S p /\ ~ condition T t.

Lemma order_is_refutes T p n : order_is T p -> p < n -> ~ has_order T n.
Proof. intros [_ [t [S N]]] L H. apply N, H. lia. Qed.

(** The tableau with the numbers of a file. *)
Definition entry (v : list coefficient) (i : nat) : F := value (nth i v (q 0)).
Definition table (A : list (list coefficient)) (b : list coefficient) : tableau :=
  {| stages := length b; a := fun i j => entry (nth i A []) j; b := entry b |}.

(** A tableau of which only this is known: its nodes c are roots of x^s - N, and it maps the power c^k to the polynomial
    alpha_k in c, and integrates it to beta_k. Where the nodes are distinct that is all that there is to know. *)
Fixpoint power (x : F) (k : nat) : F := match k with O => 1 | S k => x * power x k end.
Fixpoint polynomial (p : list coefficient) (x : F) : F :=
  match p with [] => 0 | e :: p => value e + x * polynomial p x end.
Record acts (T : tableau) (c : nat -> F) (N : list coefficient) (alpha : list (list coefficient))
       (beta : list coefficient) : Prop := {
  number_of_stages : stages T = length beta;
  on_nodes : forall i, i < stages T -> power (c i) (stages T) = polynomial N (c i);
  on_stages : forall i k, i < stages T -> k < stages T ->
     sum (stages T) (fun j => a T i j * power (c j) k) = polynomial (nth k alpha []) (c i);
  on_weights : forall k, k < stages T ->
     sum (stages T) (fun j => b T j * power (c j) k) = value (nth k beta (q 0)) }.

(** R = P/Q is the stability function: the stages Y/(GQ) solve the equations of y' = lambda y with y_0 = 1 and
    z = h lambda, and the step is P/Q. (Both sides times GQ, so that it says nothing where that vanishes. G is 1 unless
    the stages have more poles than R.) *)
Definition stability_function (T : tableau) (P Q : list coefficient) : Prop :=
  exists G, polynomial G 0 = 1 /\ forall z, exists Y : nat -> F,
    (forall i, i < stages T ->
       Y i = polynomial G z * polynomial Q z + z * sum (stages T) (fun j => a T i j * Y j)) /\
    polynomial G z * polynomial P z = polynomial G z * polynomial Q z + z * sum (stages T) (fun i => b T i * Y i).

(** ** 4. Computing with coefficients *)

Lemma sum_ext n f g : (forall i, i < n -> f i = g i) -> sum n f = sum n g.
Proof. induction n; simpl; intro H; [reflexivity|]. rewrite IHn, H; auto. Qed.
Lemma sum_add n f g : sum n (fun i => f i + g i) = sum n f + sum n g.
Proof. induction n; simpl; [ring|]. rewrite IHn; ring. Qed.
Lemma sum_scale n x f : sum n (fun i => x * f i) = x * sum n f.
Proof. induction n; simpl; [ring|]. rewrite IHn; ring. Qed.
Lemma sum_nothing n f : sum n (fun i => f i * 0) = 0.
Proof. induction n; simpl; [reflexivity|]. rewrite IHn; ring. Qed.

Lemma rat_zero : rat F 0 = 0.
Proof.
  assert (H : rat F 0 + rat F 0 = rat F 0) by (rewrite <- rat_add; apply rat_eq; reflexivity).
  transitivity (sub F (rat F 0 + rat F 0) (rat F 0)); [ring|]. rewrite H; ring.
Qed.
Lemma rat_red x : rat F (Qred x) = rat F x.
Proof. apply rat_eq, Qred_correct. Qed.
Lemma rat_opp x : rat F (- x) = opp F (rat F x).
Proof.
  assert (H : rat F x + rat F (- x) = 0).
  { rewrite <- rat_add, <- rat_zero. apply rat_eq. ring. }
  transitivity (rat F x + rat F (- x) + opp F (rat F x)); [ring|]. rewrite H; ring.
Qed.
Lemma rat_injective x : rat F x = 0 -> (x == 0)%Q.
Proof.
  intro H. destruct (Qeq_dec x 0) as [E|E]; [exact E|exfalso].
  apply (one_is_not_zero F). rewrite <- rat_one.
  rewrite (rat_eq F (x := 1) (y := x * / x)) by (field; exact E). rewrite rat_mul, H; ring.
Qed.

Definition is_zero (x : Q) : bool := match Qnum x with Z0 => true | _ => false end.
Lemma is_zero_sound x : is_zero x = true -> (x == 0)%Q.
Proof. destruct x as [[|n|n] m]; discriminate || reflexivity. Qed.
Lemma is_zero_complete x : is_zero x = false -> ~ (x == 0)%Q.
Proof. destruct x as [[|n|n] m]; discriminate. Qed.

Definition qplus (x y : Q) : Q := if is_zero x then y else if is_zero y then x else Qred (x + y).
Definition qtimes (x y : Q) : Q := if is_zero x then 0%Q else if is_zero y then 0%Q else Qred (x * y).
Lemma rat_plus x y : rat F (qplus x y) = rat F x + rat F y.
Proof.
  unfold qplus. destruct (is_zero x) eqn:E; [|destruct (is_zero y) eqn:E'].
  - rewrite (rat_eq F (is_zero_sound _ E)), rat_zero; ring.
  - rewrite (rat_eq F (is_zero_sound _ E')), rat_zero; ring.
  - rewrite rat_red; apply rat_add.
Qed.
Lemma rat_times x y : rat F (qtimes x y) = rat F x * rat F y.
Proof.
  unfold qtimes. destruct (is_zero x) eqn:E; [|destruct (is_zero y) eqn:E'].
  - rewrite (rat_eq F (is_zero_sound _ E)), rat_zero; ring.
  - rewrite (rat_eq F (is_zero_sound _ E')), rat_zero; ring.
  - rewrite rat_red; apply rat_mul.
Qed.

Definition plus (x y : coefficient) : coefficient := (qplus (fst x) (fst y), qplus (snd x) (snd y)).
Definition times (x y : coefficient) : coefficient :=
  (qplus (qtimes (fst x) (fst y)) (qtimes d (qtimes (snd x) (snd y))),
   qplus (qtimes (fst x) (snd y)) (qtimes (snd x) (fst y))).
Definition null (x : coefficient) : bool := is_zero (fst x) && is_zero (snd x).

Lemma value_plus x y : value (plus x y) = value x + value y.
Proof. unfold value, plus; simpl. rewrite !rat_plus; ring. Qed.
Lemma value_times x y : value (times x y) = value x * value y.
Proof. unfold value, times; simpl. rewrite !rat_plus, !rat_times, <- root_square; ring. Qed.
Lemma value_q x : value (q x) = rat F x.
Proof. unfold value, q; simpl. rewrite rat_zero; ring. Qed.
Lemma value_zero : value (q 0) = 0.
Proof. rewrite value_q; apply rat_zero. Qed.
Lemma value_null x : null x = true -> value x = 0.
Proof.
  unfold null, value. intro H. apply andb_prop in H. destruct H as [H H'].
  rewrite (rat_eq F (is_zero_sound _ H)), (rat_eq F (is_zero_sound _ H')), rat_zero; ring.
Qed.
(** x + y sqrt(d) is not zero where its norm x^2 - d y^2 is not. *)
Definition not_null (x : coefficient) : bool :=
  negb (is_zero (Qred (fst x * fst x - d * (snd x * snd x)))).
Lemma value_not_null x : not_null x = true -> value x <> 0.
Proof.
  unfold not_null, value. intros H E. apply negb_true_iff, is_zero_complete in H. apply H.
  rewrite Qred_correct. apply rat_injective.
  unfold Qminus. rewrite rat_add, rat_opp, !rat_mul, <- root_square.
  set (u := rat F (fst x)) in *. set (v := rat F (snd x)) in *.
  transitivity ((u + v * root F) * (u + opp F (v * root F))); [ring|]. rewrite E; ring.
Qed.

(** ** 5. Stage vectors as lists of coordinates

    In a basis B of stage vectors (the unit vectors, or the powers of c) on which a tableau acts by known rules. *)

Fixpoint vplus (u v : list coefficient) : list coefficient :=
  match u, v with
  | [], _ => v | _, [] => u
  | x :: u, y :: v => plus x y :: vplus u v
  end.
Definition scaled (x : coefficient) (v : list coefficient) : list coefficient :=
  if null x then [] else map (times x) v.
Fixpoint combination (v : list coefficient) (rows : list (list coefficient)) : list coefficient :=
  match v, rows with
  | x :: v, row :: rows => vplus (scaled x row) (combination v rows)
  | _, _ => []
  end.
Fixpoint product (u v : list coefficient) : coefficient :=
  match u, v with x :: u, y :: v => plus (times x y) (product u v) | _, _ => q 0 end.

Lemma polynomial_plus u : forall v x, polynomial (vplus u v) x = polynomial u x + polynomial v x.
Proof.
  induction u as [|e u IH]; intros [|f v] x; simpl; try ring. rewrite value_plus, IH; ring.
Qed.
Lemma polynomial_scaled e v x : polynomial (scaled e v) x = value e * polynomial v x.
Proof.
  unfold scaled. destruct (null e) eqn:E; [rewrite (value_null _ E); simpl; ring|].
  induction v as [|f v IH]; simpl; [ring|]. rewrite value_times, IH; ring.
Qed.
Lemma polynomial_null p x : forallb null p = true -> polynomial p x = 0.
Proof.
  induction p as [|e p IH]; simpl; intro H; [reflexivity|]. apply andb_prop in H. destruct H as [H H'].
  rewrite (value_null _ H), IH by exact H'. ring.
Qed.
Fixpoint times1 (p r : list coefficient) : list coefficient :=
  match p with [] => [] | e :: p => vplus (scaled e r) (q 0 :: times1 p r) end.
Lemma polynomial_times1 p r x : polynomial (times1 p r) x = polynomial p x * polynomial r x.
Proof.
  induction p as [|e p IH]; cbn [times1 polynomial]; [ring|].
  rewrite polynomial_plus, polynomial_scaled. cbn [polynomial]. rewrite value_zero, IH. ring.
Qed.

Section Coordinates.
Variable T : tableau.
Variable B : nat -> nat -> F.
Fixpoint stage_from (k : nat) (v : list coefficient) (i : nat) : F :=
  match v with [] => 0 | x :: v => value x * B k i + stage_from (S k) v i end.
Definition stage (v : list coefficient) (i : nat) : F := stage_from 0%nat v i.

Lemma stage_plus u : forall k v i, stage_from k (vplus u v) i = stage_from k u i + stage_from k v i.
Proof.
  induction u as [|x u IH]; destruct v as [|y v]; intro i; simpl; try ring.
  rewrite value_plus, IH; ring.
Qed.
Lemma stage_scaled x v i : forall k, stage_from k (scaled x v) i = value x * stage_from k v i.
Proof.
  unfold scaled. destruct (null x) eqn:E.
  - intro k. rewrite (value_null _ E); simpl; ring.
  - induction v as [|y v IH]; intro k; simpl; [ring|]. rewrite value_times, IH; ring.
Qed.

(** What has to be known of T in the basis B, and of the product of two lists. *)
Variables (alpha : list (list coefficient)) (beta unit : list coefficient)
          (times_in : list coefficient -> list coefficient -> list coefficient).
Record model : Prop := {
  same_length : length alpha = length beta;
  acts_on_stages : forall i k, i < stages T -> k < length beta ->
    sum (stages T) (fun j => a T i j * B k j) = stage (nth k alpha []) i;
  acts_on_weights : forall k, k < length beta ->
    sum (stages T) (fun j => b T j * B k j) = value (nth k beta (q 0));
  has_unit : forall i, i < stages T -> stage unit i = 1;
  has_product : forall u v i, i < stages T -> stage (times_in u v) i = stage u i * stage v i }.
Hypothesis M : model.

Lemma stage_combination v : length v <= length beta -> forall i, i < stages T ->
  sum (stages T) (fun j => a T i j * stage v j) = stage (combination v alpha) i.
Proof.
  intros L i Hi.
  enough (G : forall rows v k, length v <= length rows -> (forall n, nth n rows [] = nth (k + n)%nat alpha []) ->
    (k + length rows <= length beta)%nat ->
    sum (stages T) (fun j => a T i j * stage_from k v j) = stage (combination v rows) i).
  { apply (G alpha v 0%nat); [rewrite (same_length M); exact L|reflexivity|rewrite (same_length M); simpl; lia]. }
  clear v L. induction rows as [|row rows IH]; intros [|x v] k L E Hk; simpl in *; try lia; try apply sum_nothing.
  unfold stage at 1. rewrite stage_plus, stage_scaled. fold (stage (combination v rows) i).
  rewrite <- (IH v (S k)); try lia.
  2: { intro n. specialize (E (S n)). simpl in E. rewrite E. f_equal. lia. }
  specialize (E 0%nat); simpl in E. rewrite Nat.add_0_r in E.
  fold (stage row i). rewrite E, <- (acts_on_stages M) by lia.
  rewrite <- sum_scale, <- sum_add. apply sum_ext. intros; ring.
Qed.

Lemma stage_product v : length v <= length beta ->
  sum (stages T) (fun j => b T j * stage v j) = value (product v beta).
Proof.
  intros L.
  enough (G : forall ws v k, length v <= length ws -> (forall n, nth n ws (q 0) = nth (k + n)%nat beta (q 0)) ->
    (k + length ws <= length beta)%nat ->
    sum (stages T) (fun j => b T j * stage_from k v j) = value (product v ws)).
  { apply (G beta v 0%nat); [exact L|reflexivity|simpl; lia]. }
  clear v L. induction ws as [|w ws IH]; intros [|x v] k L E Hk; simpl in *; try lia;
    try (rewrite value_zero; apply sum_nothing).
  rewrite value_plus, value_times, <- (IH v (S k)); try lia.
  2: { intro n. specialize (E (S n)). simpl in E. rewrite E. f_equal. lia. }
  specialize (E 0%nat); simpl in E. rewrite Nat.add_0_r in E.
  rewrite E, <- (acts_on_weights M) by lia.
  rewrite <- sum_scale, <- sum_add. apply sum_ext. intros; ring.
Qed.

(** ** 6. All trees up to an order

    Level n has the scaled stage vectors [branches t * phi t] of every tree with n nodes, each value once: where C(q)
    holds, or a tree occurs more than once, there are far fewer of them than trees. *)

Definition same_q (x y : Q) : bool := Z.eqb (Qnum x) (Qnum y) && Pos.eqb (Qden x) (Qden y).
Fixpoint same (u v : list coefficient) : bool :=
  match u, v with
  | [], [] => true
  | x :: u, y :: v => same_q (fst x) (fst y) && (same_q (snd x) (snd y) && same u v)
  | _, _ => false
  end.
Lemma same_q_eq x y : same_q x y = true -> x = y.
Proof.
  destruct x, y; unfold same_q; simpl. intro H. apply andb_prop in H. destruct H as [H H'].
  apply Z.eqb_eq in H. apply Pos.eqb_eq in H'. congruence.
Qed.
Lemma same_eq u : forall v, same u v = true -> u = v.
Proof.
  induction u as [|[x x'] u IH]; intros [|[y y'] v]; simpl; try discriminate; [reflexivity|].
  intro H. apply andb_prop in H. destruct H as [H H']. apply andb_prop in H'. destruct H' as [H' H''].
  apply same_q_eq in H. apply same_q_eq in H'. apply IH in H''. congruence.
Qed.
Fixpoint once (l : list (list coefficient)) : list (list coefficient) :=
  match l with
  | [] => []
  | v :: l => let rest := once l in if existsb (same v) rest then rest else v :: rest
  end.
Lemma once_complete v l : In v l -> In v (once l).
Proof.
  induction l as [|w l IH]; simpl; [tauto|]. intros [E|H].
  - subst w. destruct (existsb (same v) (once l)) eqn:X; [|left; reflexivity].
    apply existsb_exists in X. destruct X as [w [I S]]. apply same_eq in S. subst; exact I.
  - destruct (existsb (same w) (once l)); [|right]; auto.
Qed.

Definition grown (k : nat) (v : list coefficient) : list coefficient :=
  scaled (q (inject_Z (Z.of_nat k))) (combination v alpha).
Definition grafted (pair : list (list coefficient) * list (list coefficient)) : list (list coefficient) :=
  flat_map (fun u => map (fun t => times_in t u) (fst pair)) (snd pair).

(** The levels n, ..., 1, and 1 A, ..., n A of the levels 1, ..., n. *)
Fixpoint levels (n : nat) : list (list (list coefficient)) * list (list (list coefficient)) :=
  match n with
  | O => ([], [])
  | S n' =>
    let (down, up) := levels n' in
    let new := match n' with O => [unit] | _ => once (flat_map grafted (combine down up)) end in
    (new :: down, up ++ [once (map (grown n) new)])
  end.
Definition level (n k : nat) := nth (n - k) (fst (levels n)) [].

Lemma levels_length n : length (fst (levels n)) = n /\ length (snd (levels n)) = n.
Proof.
  induction n; simpl; [split; reflexivity|]. destruct (levels n) as [down up]; simpl in *.
  rewrite app_length; simpl; lia.
Qed.
Lemma level_stable n k : 1 <= k <= n -> level n k = level k k.
Proof.
  induction n; intro H; [lia|]. destruct (Nat.eq_dec k (S n)) as [->|N]; [reflexivity|].
  rewrite <- IHn by lia. unfold level. simpl. destruct (levels n) as [down up]; simpl.
  replace (match k with O => S n | S l => n - l end)%nat with (S (n - k)) by (destruct k; lia). reflexivity.
Qed.
Lemma up_is_grown n k : 1 <= k <= n -> nth (k - 1) (snd (levels n)) [] = once (map (grown k) (level k k)).
Proof.
  induction n; intro H; [lia|].
  pose proof (levels_length n) as [_ L]. destruct (Nat.eq_dec k (S n)) as [->|N].
  - unfold level. rewrite Nat.sub_diag. cbn [levels]. destruct (levels n) as [down up] eqn:E; cbn [fst snd nth] in *.
    rewrite app_nth2 by lia. replace (S n - 1 - length up)%nat with 0%nat by lia. reflexivity.
  - rewrite <- IHn by lia. cbn [levels]. destruct (levels n) as [down up] eqn:E; cbn [fst snd] in *.
    apply app_nth1. lia.
Qed.
(** Completeness of the enumeration: grafting two vectors of their levels gives one of the level of the sum. *)
Lemma levels_complete n k t u : 1 <= n -> 1 <= k -> In t (level n n) -> In u (level k k) ->
  In (times_in t (grown k u)) (level (n + k) (n + k)).
Proof.
  intros Hn Hk It Iu. set (m := (n + k - 1)%nat). replace (n + k)%nat with (S m) by lia.
  unfold level at 1. rewrite Nat.sub_diag. cbn [levels].
  pose proof (levels_length m) as [L1 L2].
  rewrite <- (@level_stable m n) in It by lia. unfold level in It.
  pose proof (@up_is_grown m k) as U. 
  destruct (levels m) as [down up] eqn:E; cbn [fst snd nth] in *.
  destruct m as [|m'] eqn:Em; [lia|]. cbn [nth]. apply once_complete, in_flat_map.
  exists (nth (k - 1) down [], nth (k - 1) up []). split.
  - rewrite <- combine_nth by lia. apply nth_In. rewrite combine_length. lia.
  - unfold grafted; simpl. apply in_flat_map. exists (grown k u). split.
    + rewrite U by lia. apply once_complete, in_map, Iu.
    + apply (in_map (fun t => times_in t (grown k u))).
      replace (k - 1)%nat with (S m' - n)%nat by lia. exact It.
Qed.

Definition defect (n : nat) (v : list coefficient) : coefficient :=
  plus (times (q (inject_Z (Z.of_nat n))) (product v beta)) (q (-1)).
Definition short (v : list coefficient) : bool := length v <=? length beta.
Fixpoint levels_hold (down : list (list (list coefficient))) : bool :=
  match down with
  | [] => true
  | l :: rest => forallb (fun v => short v && null (defect (length down) v)) l && levels_hold rest
  end.
Definition order_holds (p : nat) : bool := levels_hold (fst (levels p)).

Lemma order_holds_at p : order_holds p = true -> forall n v, 1 <= n <= p -> In v (level n n) ->
  length v <= length beta /\ value (defect n v) = 0.
Proof.
  intros H n v Hn I. rewrite <- (@level_stable p n) in I by lia. revert I. unfold level, order_holds in *.
  pose proof (levels_length p) as [L _].
  rewrite <- L at 1. rewrite <- L in Hn. revert H Hn. generalize (fst (levels p)) as down. clear L. induction down as [|l rest IH]; intros H Hn I; [simpl in *; lia|].
  cbn [levels_hold] in H. apply andb_prop in H. destruct H as [H H'].
  destruct (Nat.eq_dec n (length (l :: rest))) as [E|E].
  - rewrite <- E, Nat.sub_diag in I. cbn [nth] in I. rewrite forallb_forall in H. specialize (H v I).
    apply andb_prop in H. destruct H as [S N]. rewrite <- E in N. split; [apply Nat.leb_le, S|apply value_null, N].
  - apply IH; [exact H'|simpl in *; lia|].
    replace (length (l :: rest) - n)%nat with (S (length rest - n)) in I by (cbn [length] in *; lia). exact I.
Qed.

Lemma whole_mul x y : whole (x * y) = whole x * whole y.
Proof. unfold whole. rewrite inject_Z_mult. apply rat_mul. Qed.
Lemma whole_one : whole 1 = 1.
Proof. unfold whole. rewrite <- rat_one. apply rat_eq. reflexivity. Qed.
Lemma size_positive t : 1 <= size t.
Proof. induction t; simpl; lia. Qed.
Lemma stage_grown k u : length u <= length beta -> forall i, i < stages T ->
  stage (grown k u) i = whole (Z.of_nat k) * sum (stages T) (fun j => a T i j * stage u j).
Proof.
  intros L i Hi. unfold grown, stage. rewrite stage_scaled, value_q. fold (stage (combination u alpha) i).
  rewrite <- stage_combination by assumption. reflexivity.
Qed.

(** Each tree's vector is in its level. *)
Lemma level_has_tree p : (forall n v, 1 <= n <= p -> In v (level n n) -> length v <= length beta) ->
  forall t, size t <= S p ->
  exists v, In v (level (size t) (size t)) /\ forall i, i < stages T -> stage v i = whole (branches t) * phi T t i.
Proof.
  intros L. induction t as [|t IHt u IHu]; intro S.
  - exists unit. split; [left; reflexivity|]. intros i Hi. simpl. rewrite (has_unit M) by exact Hi.
    rewrite whole_one; ring.
  - simpl in S. pose proof (size_positive t). pose proof (size_positive u).
    destruct IHt as [v [Iv Ev]]; [lia|]. destruct IHu as [w [Iw Ew]]; [lia|].
    exists (times_in v (grown (size u) w)). split; [apply levels_complete; auto|].
    intros i Hi. rewrite (has_product M) by exact Hi. rewrite Ev by exact Hi.
    rewrite stage_grown by (try exact Hi; apply (L (size u)); auto; lia). simpl.
    rewrite (@sum_ext _ _ (fun j => whole (branches u) * (a T i j * phi T u j))).
    2: { intros j Hj. rewrite Ew by exact Hj. ring. }
    rewrite sum_scale, !whole_mul. ring.
Qed.

Lemma defect_value n v t : length v <= length beta -> n = size t ->
  (forall i, i < stages T -> stage v i = whole (branches t) * phi T t i) ->
  value (defect n v) = whole (gamma t) * weight T t + opp F 1.
Proof.
  intros L -> E. unfold defect, gamma, weight.
  rewrite value_plus, value_times, <- stage_product, !value_q by exact L.
  rewrite (@sum_ext _ _ (fun j => whole (branches t) * (b T j * phi T t j))).
  2: { intros j Hj. rewrite E by exact Hj. ring. }
  rewrite sum_scale, whole_mul. fold (whole (Z.of_nat (size t))).
  change (-1)%Q with (- (1))%Q. rewrite rat_opp, rat_one. ring.
Qed.

Theorem order_is_checked p : order_holds p = true -> has_order T p.
Proof.
  intros H t S. pose proof (size_positive t).
  destruct (@level_has_tree p) with (t := t) as [v [I E]]; [|lia|].
  { intros n v Hn I. apply (@order_holds_at p H n v Hn I). }
  destruct (@order_holds_at p H (size t) v) as [L D]; [lia|exact I|].
  rewrite (@defect_value (size t) v t L eq_refl E) in D. unfold condition.
  transitivity (whole (gamma t) * weight T t + opp F 1 + 1); [ring|]. rewrite D; ring.
Qed.

(** A single tree whose condition fails. *)
Definition when_short (v : list coefficient) : option (list coefficient) := if short v then Some v else None.
Fixpoint vector (t : tree) : option (list coefficient) :=
  match t with
  | leaf => when_short unit
  | graft t u => match vector t, vector u with
                 | Some v, Some w => when_short (times_in v (grown (size u) w)) | _, _ => None end
  end.
Lemma when_short_is v w : when_short v = Some w -> w = v /\ length v <= length beta.
Proof.
  unfold when_short. destruct (short v) eqn:S; intro E; [|discriminate]. injection E as <-. split; [reflexivity|].
  apply Nat.leb_le, S.
Qed.
Lemma vector_stage t : forall v, vector t = Some v -> length v <= length beta /\
  forall i, i < stages T -> stage v i = whole (branches t) * phi T t i.
Proof.
  induction t as [|t IHt u IHu]; intros v H; cbn [vector] in H.
  - apply when_short_is in H. destruct H as [-> L]. split; [exact L|]. intros i Hi.
    rewrite (has_unit M) by exact Hi. simpl. rewrite whole_one; ring.
  - destruct (vector t) as [x|]; [|discriminate]. destruct (vector u) as [y|]; [|discriminate].
    apply when_short_is in H. destruct H as [-> L]. split; [exact L|]. intros i Hi.
    destruct (IHt x eq_refl) as [_ X]. destruct (IHu y eq_refl) as [Ly Y].
    rewrite (has_product M) by exact Hi. rewrite X, stage_grown by assumption. simpl.
    rewrite (@sum_ext _ _ (fun j => whole (branches u) * (a T i j * phi T u j))).
    2: { intros j Hj. rewrite Y by exact Hj. ring. }
    rewrite sum_scale, !whole_mul. ring.
Qed.
Definition fails (t : tree) : bool := match vector t with Some v => not_null (defect (size t) v) | None => false end.
Theorem failure_is_checked t : fails t = true -> ~ condition T t.
Proof.
  unfold fails. destruct (vector t) as [v|] eqn:E; [|discriminate]. intros N C.
  destruct (@vector_stage t v E) as [L V]. apply value_not_null in N. apply N.
  rewrite (@defect_value (size t) v t L eq_refl V). unfold condition in C. rewrite C. ring.
Qed.

Definition order_verdict (p : nat) (t : tree) : bool := order_holds p && ((size t =? S p) && fails t).
Theorem order_is_decided p t : order_verdict p t = true -> order_is T p.
Proof.
  unfold order_verdict. intro H. apply andb_prop in H. destruct H as [H H']. apply andb_prop in H'.
  destruct H' as [S N]. split; [apply order_is_checked, H|].
  exists t. split; [apply Nat.eqb_eq, S|apply failure_is_checked, N].
Qed.

(** The stability function as a polynomial in z: Y(z) = sum of z^k Y_k solves Y = Q(z) 1 + z A Y, from the bottom up. *)
Fixpoint solution (y Q : list coefficient) : list (list coefficient) :=
  match Q with
  | [] => []
  | e :: Q => let new := vplus (scaled e unit) (combination y alpha) in new :: solution new Q
  end.
Fixpoint solution_ends (y Q : list coefficient) : bool :=
  short y &&
  match Q with
  | [] => forallb null (combination y alpha)
  | e :: Q => solution_ends (vplus (scaled e unit) (combination y alpha)) Q
  end.
Definition numerator (Q : list coefficient) : list coefficient :=
  vplus Q (q 0 :: map (fun y => product y beta) (solution [] Q)).
Fixpoint along (ys : list (list coefficient)) (z : F) (i : nat) : F :=
  match ys with [] => 0 | y :: ys => stage y i + z * along ys z i end.

Lemma stage_null y : forallb null y = true -> forall k i, stage_from k y i = 0.
Proof.
  induction y as [|e y IH]; simpl; intros H k i; [reflexivity|]. apply andb_prop in H. destruct H as [H H'].
  rewrite (value_null _ H), IH by exact H'. ring.
Qed.
Lemma along_solves z Q : forall y, solution_ends y Q = true -> forall i, i < stages T ->
  along (solution y Q) z i = polynomial Q z + sum (stages T) (fun j => a T i j * stage y j)
                             + z * sum (stages T) (fun j => a T i j * along (solution y Q) z j).
Proof.
  induction Q as [|e Q IH]; intros y H i Hi; cbn [solution_ends] in H; apply andb_prop in H; destruct H as [S H];
    apply Nat.leb_le in S.
  - cbn [solution along polynomial]. rewrite stage_combination by assumption. unfold stage.
    rewrite stage_null by exact H. rewrite sum_nothing. ring.
  - cbn [solution along polynomial]. set (new := vplus (scaled e unit) (combination y alpha)) in *.
    rewrite (IH new H i Hi) at 1.
    assert (N : stage new i = value e + sum (stages T) (fun j => a T i j * stage y j)).
    { unfold new, stage. rewrite stage_plus, stage_scaled. fold (stage unit i) (stage (combination y alpha) i).
      rewrite (has_unit M) by exact Hi. rewrite stage_combination by assumption. ring. }
    rewrite N.
    rewrite (@sum_ext _ (fun j => a T i j * (stage new j + z * along (solution new Q) z j))
               (fun j => a T i j * stage new j + z * (a T i j * along (solution new Q) z j))) by (intros; ring).
    rewrite sum_add, sum_scale. ring.
Qed.
Lemma along_weighs z Q : forall y, solution_ends y Q = true ->
  polynomial (map (fun y => product y beta) (solution y Q)) z
  = sum (stages T) (fun i => b T i * along (solution y Q) z i).
Proof.
  induction Q as [|e Q IH]; intros y H; cbn [solution_ends] in H; apply andb_prop in H; destruct H as [S H];
    cbn [solution along polynomial map]; [rewrite sum_nothing; reflexivity|].
  set (new := vplus (scaled e unit) (combination y alpha)) in *. rewrite (IH new H).
  rewrite <- stage_product by (destruct Q; cbn [solution_ends] in H; apply andb_prop in H; apply Nat.leb_le, H).
  rewrite <- sum_scale, <- sum_add. apply sum_ext. intros; ring.
Qed.

Lemma polynomial_padded Q n z : polynomial (Q ++ repeat (q 0) n) z = polynomial Q z.
Proof.
  induction Q as [|e Q IH]; cbn [app polynomial]; [|rewrite IH; reflexivity].
  induction n; cbn [repeat polynomial]; [reflexivity|]. rewrite value_zero, IHn. ring.
Qed.
Definition function_verdict (n : nat) (G P' Q' : list coefficient) : bool :=
  let Q := times1 G Q' ++ repeat (q 0) n in
  let P := times1 G P' in
  null (plus (nth 0 G (q 0)) (q (-1))) && (solution_ends [] Q && forallb null (vplus (scaled (q (-1)) P) (numerator Q))).
Theorem function_is_checked n G P Q : function_verdict n G P Q = true -> stability_function T P Q.
Proof.
  unfold function_verdict. intro H. apply andb_prop in H. destruct H as [G1 H]. exists G. split.
  { apply value_null in G1. rewrite value_plus, value_q in G1. change (-1)%Q with (- (1))%Q in G1.
    rewrite rat_opp, rat_one in G1. destruct G as [|e G]; cbn [nth polynomial] in *.
    - exfalso. apply (one_is_not_zero F). rewrite value_zero in G1.
      transitivity (opp F (0 + opp F 1)); [ring|]. rewrite G1; ring.
    - transitivity (value e + opp F 1 + 1); [ring|]. rewrite G1; ring. }
  intro z. rewrite <- !polynomial_times1, <- (polynomial_padded (times1 G Q) n).
  revert H. generalize (times1 G P) as P'. generalize (times1 G Q ++ repeat (q 0) n) as Q'. clear P Q G1.
  intros Q P H. apply andb_prop in H. destruct H as [H E].
  exists (along (solution [] Q) z). split.
  - intros i Hi. rewrite (@along_solves z Q [] H i Hi) at 1. cbn [stage stage_from].
    unfold stage; cbn [stage_from]. rewrite sum_nothing. ring.
  - rewrite <- along_weighs by exact H.
    pose proof (polynomial_null _ z E) as X.
    rewrite polynomial_plus, polynomial_scaled in X. unfold numerator in X. rewrite polynomial_plus in X.
    cbn [polynomial] in X. rewrite value_zero in X. rewrite value_q in X.
    change (-1)%Q with (- (1))%Q in X. rewrite rat_opp, rat_one in X.
    transitivity (polynomial P z + 0); [ring|]. rewrite <- X. ring.
Qed.
End Coordinates.

(** ** 7. Two kinds of tableaux: numbers, and polynomials modulo that of the nodes *)

Fixpoint pointwise (u v : list coefficient) : list coefficient :=
  match u, v with x :: u, y :: v => times x y :: pointwise u v | _, _ => [] end.
Definition columns (A : list (list coefficient)) (s : nat) : list (list coefficient) :=
  map (fun k => map (fun row => nth k row (q 0)) A) (seq 0 s).
Definition ones (s : nat) : list coefficient := repeat (q 1) s.
Definition axes (k i : nat) : F := if k =? i then 1 else 0.

Lemma value_one : value (q 1) = 1.
Proof. rewrite value_q. apply rat_one. Qed.
Lemma sum_axes s f k : k < s -> sum s (fun j => f j * axes k j) = f k.
Proof.
  intro H. unfold axes. induction s; [lia|]. simpl. destruct (Nat.eqb_spec k s) as [->|N].
  - rewrite (@sum_ext s _ (fun j => f j * 0)).
    + rewrite sum_nothing; ring.
    + intros j Hj. destruct (Nat.eqb_spec s j); [lia|reflexivity].
  - rewrite IHs by lia. ring.
Qed.
Lemma stage_axes v : forall k i, stage_from axes k v i = if i <? k then 0 else entry v (i - k).
Proof.
  unfold entry. induction v as [|x v IH]; intros k i; simpl.
  - destruct (i <? k); [reflexivity|]. destruct (i - k)%nat; rewrite value_zero; reflexivity.
  - rewrite IH. unfold axes.
    destruct (Nat.eqb_spec k i), (Nat.ltb_spec i k), (Nat.ltb_spec i (S k)); try lia.
    + subst. rewrite Nat.sub_diag. ring.
    + ring.
    + replace (i - k)%nat with (S (i - S k)) by lia. ring.
Qed.
Lemma entry_pointwise u : forall v i, entry (pointwise u v) i = entry u i * entry v i.
Proof.
  unfold entry. induction u as [|x u IH]; intros [|y v] [|i]; simpl; rewrite ?value_zero, ?value_times; try ring.
  apply IH.
Qed.

Lemma nth_seq (X : Type) (f : nat -> X) n k x : k < n -> nth k (map f (seq 0 n)) x = f k.
Proof.
  intro H. rewrite (nth_indep _ x (f 0%nat)) by (rewrite map_length, seq_length; exact H).
  rewrite map_nth, seq_nth by exact H. reflexivity.
Qed.
Lemma nth_columns A s k : k < s -> nth k (columns A s) [] = map (fun row => nth k row (q 0)) A.
Proof.
  apply nth_seq.
Qed.
Lemma table_model A b : model (table A b) axes (columns A (length b)) b (ones (length b)) pointwise.
Proof.
  split; unfold stage; cbn [stages a Statements.b table].
  - unfold columns. rewrite map_length, seq_length. reflexivity.
  - intros i k Hi Hk. rewrite sum_axes by exact Hk. rewrite stage_axes, Nat.sub_0_r. cbn [Nat.ltb Nat.leb].
    rewrite nth_columns by exact Hk. unfold entry. f_equal.
    rewrite <- (map_nth (fun row => nth k row (q 0)) A [] i). destruct k; reflexivity.
  - intros k Hk. apply sum_axes, Hk.
  - intros i Hi. rewrite stage_axes, Nat.sub_0_r. cbn [Nat.ltb Nat.leb]. unfold entry, ones.
    rewrite (nth_indep _ (q 0) (q 1)) by (rewrite repeat_length; exact Hi). rewrite nth_repeat. apply value_one.
  - intros u v i Hi. rewrite !stage_axes, Nat.sub_0_r. cbn [Nat.ltb Nat.leb]. apply entry_pointwise.
Qed.

Definition table_order (A : list (list coefficient)) (b : list coefficient) : nat -> tree -> bool :=
  order_verdict (columns A (length b)) b (ones (length b)) pointwise.
Theorem table_order_is A b p t : table_order A b p t = true -> order_is (table A b) p.
Proof. apply order_is_decided with (1 := table_model A b). Qed.

Definition table_function (A : list (list coefficient)) (b : list coefficient) :
  nat -> list coefficient -> list coefficient -> list coefficient -> bool :=
  function_verdict (columns A (length b)) b (ones (length b)).
Theorem table_function_is A b n G P Q : table_function A b n G P Q = true -> stability_function (table A b) P Q.
Proof. apply function_is_checked with (1 := table_model A b). Qed.

(** x^s is N(x): remainders have fewer than s coefficients. *)
Definition reduced (N : list coefficient) (p : list coefficient) : list coefficient :=
  match skipn (length N) p with
  | [e] => vplus (firstn (length N) p) (scaled e N)
  | _ => p
  end.
Fixpoint times_modulo (N u v : list coefficient) : list coefficient :=
  match u with [] => [] | x :: u => vplus (scaled x v) (reduced N (q 0 :: times_modulo N u v)) end.
Definition powers (c : nat -> F) (k i : nat) : F := power (c i) k.

Lemma polynomial_split n : forall p x,
  polynomial p x = polynomial (firstn n p) x + power x n * polynomial (skipn n p) x.
Proof. induction n; intros [|e p] x; simpl; try ring. rewrite (IHn p x); ring. Qed.
Lemma polynomial_reduced N p x : power x (length N) = polynomial N x -> polynomial (reduced N p) x = polynomial p x.
Proof.
  intro R. unfold reduced. rewrite (polynomial_split (length N) p) at 1.
  destruct (skipn (length N) p) as [|e [|f r]] eqn:E.
  - rewrite (polynomial_split (length N) p x), E; reflexivity.
  - rewrite polynomial_plus, polynomial_scaled, R. simpl. ring.
  - rewrite (polynomial_split (length N) p x), E; reflexivity.
Qed.
Lemma polynomial_times N u v x : power x (length N) = polynomial N x ->
  polynomial (times_modulo N u v) x = polynomial u x * polynomial v x.
Proof.
  intro R. induction u as [|e u IH]; simpl; [ring|].
  rewrite polynomial_plus, polynomial_scaled, polynomial_reduced by exact R. simpl. rewrite value_zero, IH; ring.
Qed.
Lemma stage_powers c v i : forall k, stage_from (powers c) k v i = power (c i) k * polynomial v (c i).
Proof. induction v as [|e v IH]; intro k; simpl; [ring|]. rewrite IH. unfold powers. simpl. ring. Qed.

Lemma acts_model T c N alpha beta : length alpha = length beta -> length N = length beta ->
  acts T c N alpha beta -> model T (powers c) alpha beta [q 1] (times_modulo N).
Proof.
  intros La Ln [S HN HA Hb]. rewrite S in *.
  split; unfold stage; try rewrite S; try assumption.
  - intros i k Hi Hk. rewrite stage_powers. unfold powers. rewrite HA by assumption. simpl. ring.
  - intros i Hi. rewrite stage_powers. simpl. rewrite value_one. ring.
  - intros u v i Hi. rewrite !stage_powers. simpl. rewrite polynomial_times; [ring|]. rewrite Ln. apply HN, Hi.
Qed.

Definition acts_function (N : list coefficient) (alpha : list (list coefficient)) (beta : list coefficient) (n : nat)
           (G P Q : list coefficient) : bool :=
  ((length alpha =? length beta) && (length N =? length beta)) && function_verdict alpha beta [q 1] n G P Q.
Theorem acts_function_is T c N alpha beta n G P Q :
  acts T c N alpha beta -> acts_function N alpha beta n G P Q = true -> stability_function T P Q.
Proof.
  unfold acts_function. intros H E. apply andb_prop in E. destruct E as [L E]. apply andb_prop in L. destruct L as [L L'].
  apply Nat.eqb_eq in L, L'. exact (function_is_checked (acts_model L L' H) n G P Q E).
Qed.

(** Collocation: the nodes, B(s) and C(s) are the whole definition. *)
Record collocation (T : tableau) (c : nat -> F) (N : list coefficient) : Prop := {
  c_stages : stages T = length N;
  c_nodes : forall i, i < stages T -> power (c i) (stages T) = polynomial N (c i);
  c_C : forall i k, i < stages T -> k < stages T ->
    whole (Z.of_nat (S k)) * sum (stages T) (fun j => a T i j * power (c j) k) = power (c i) (S k);
  c_B : forall k, k < stages T -> whole (Z.of_nat (S k)) * sum (stages T) (fun j => b T j * power (c j) k) = 1 }.

Definition one_over (n : nat) : coefficient := q (1 # Pos.of_nat n).
Definition monomial (e : coefficient) (n : nat) : list coefficient := repeat (q 0) n ++ [e].
Definition integral_of (N : list coefficient) (k : nat) : list coefficient :=
  reduced N (monomial (one_over (S k)) (S k)).
Definition integrals (N : list coefficient) := map (integral_of N) (seq 0 (length N)).
Definition inverses (s : nat) := map (fun k => one_over (S k)) (seq 0 s).

Lemma polynomial_monomial e n x : polynomial (monomial e n) x = value e * power x n.
Proof. unfold monomial. induction n; simpl; [ring|]. rewrite IHn, value_zero; ring. Qed.
Lemma one_over_inverse n x y : whole (Z.of_nat (S n)) * x = y -> x = value (one_over (S n)) * y.
Proof.
  intros <-. unfold one_over, whole. rewrite value_q.
  transitivity (rat F ((1 # Pos.of_nat (S n)) * inject_Z (Z.of_nat (S n))) * x); [|rewrite rat_mul; ring].
  rewrite (rat_eq F (y := 1%Q)); [rewrite rat_one; ring|].
  unfold Qeq, inject_Z, Qmult; cbn [Qnum Qden]. replace (Z.of_nat (S n)) with (Zpos (Pos.of_nat (S n))) by (rewrite <- positive_nat_Z, Nat2Pos.id; lia). lia.
Qed.
Lemma collocation_acts T c N : collocation T c N -> acts T c N (integrals N) (inverses (length N)).
Proof.
  intros [S HN HC HB]. unfold integrals, inverses. split.
  - rewrite map_length, seq_length. exact S.
  - exact HN.
  - intros i k Hi Hk. rewrite nth_seq by lia. unfold integral_of.
    rewrite polynomial_reduced by (rewrite <- S; apply HN, Hi). rewrite polynomial_monomial.
    apply one_over_inverse, HC; assumption.
  - intros k Hk. rewrite nth_seq by lia. rewrite (one_over_inverse _ _ (HB k Hk)). ring.
Qed.

Lemma one_over_whole k : 1 = value (one_over (S k)) * whole (Z.of_nat (S k)).
Proof. apply one_over_inverse; ring. Qed.
Lemma acts_collocation T c N : acts T c N (integrals N) (inverses (length N)) -> collocation T c N.
Proof.
  intros [S HN HA HB]. unfold integrals, inverses in *. rewrite map_length, seq_length in S. split; try assumption.
  - intros i k Hi Hk. rewrite HA by assumption. rewrite nth_seq by lia. unfold integral_of.
    rewrite polynomial_reduced by (rewrite <- S; apply HN, Hi). rewrite polynomial_monomial.
    transitivity (value (one_over (Datatypes.S k)) * whole (Z.of_nat (Datatypes.S k)) * power (c i) (Datatypes.S k)); [ring|].
    rewrite <- one_over_whole. ring.
  - intros k Hk. rewrite HB by assumption. rewrite nth_seq by lia. rewrite (one_over_whole k). ring.
Qed.

(** ** 8. Orders of families: Butcher's simplifying assumptions

    B(p), C(q) and D(r) give the order p where p <= q + r + 1 and p <= 2 q + 2 (Hairer-Norsett-Wanner I.II.7): a tree has at
    most one branch of more than q nodes. C(q) makes powers of c of the others, and D(r) takes that one off. *)

Definition quadrature (T : tableau) (f : nat -> F) : F := sum (stages T) (fun i => b T i * f i).
Definition applied (T : tableau) (f : nat -> F) (i : nat) : F := sum (stages T) (fun j => a T i j * f j).
Definition has_B (T : tableau) (c : nat -> F) (p : nat) : Prop := forall k, k < p ->
  whole (Z.of_nat (S k)) * quadrature T (fun i => power (c i) k) = 1.
Definition has_C (T : tableau) (c : nat -> F) (q : nat) : Prop := forall k i, k < q -> i < stages T ->
  whole (Z.of_nat (S k)) * applied T (fun j => power (c j) k) i = power (c i) (S k).
(** Of one stage vector f. (D(r) in the books is this of all of them.) *)
Definition has_D (T : tableau) (c : nat -> F) (r : nat) (f : nat -> F) : Prop := forall k, k < r ->
  whole (Z.of_nat (S k)) * quadrature T (fun i => power (c i) k * applied T f i)
  + quadrature T (fun i => power (c i) (S k) * f i) = quadrature T f.

Lemma power_add x k n : power x (k + n)%nat = power x k * power x n.
Proof. induction k; cbn [power Nat.add]; [ring|]. rewrite IHk. ring. Qed.
Lemma whole_add x y : whole (x + y)%Z = whole x + whole y.
Proof. unfold whole. rewrite inject_Z_plus. apply rat_add. Qed.
Lemma whole_cancel n x y : whole (Z.of_nat (S n)) * x = whole (Z.of_nat (S n)) * y -> x = y.
Proof.
  intro E. set (r := rat F (1 # Pos.of_nat (S n))).
  assert (I : r * whole (Z.of_nat (S n)) = 1).
  { unfold r, whole. rewrite <- rat_mul, <- rat_one. apply rat_eq.
    unfold Qeq, inject_Z, Qmult; cbn [Qnum Qden].
    replace (Z.of_nat (S n)) with (Zpos (Pos.of_nat (S n))) by (rewrite <- positive_nat_Z, Nat2Pos.id; lia). lia. }
  transitivity (r * whole (Z.of_nat (S n)) * x); [rewrite I; ring|].
  transitivity (r * (whole (Z.of_nat (S n)) * x)); [ring|]. rewrite E.
  transitivity (r * whole (Z.of_nat (S n)) * y); [ring|]. rewrite I; ring.
Qed.

Section Simplifying.
Variables (T : tableau) (c : nat -> F) (p q r : nat).
Hypothesis B : has_B T c p.
Hypothesis C : has_C T c q.
Hypothesis D : forall u, has_D T c r (phi T u).
Definition scaled_phi (t : tree) (i : nat) : F := whole (branches t) * phi T t i.
Lemma quadrature_ext f g : (forall i, i < stages T -> f i = g i) -> quadrature T f = quadrature T g.
Proof. intro H. apply sum_ext. intros i Hi. rewrite H by exact Hi. reflexivity. Qed.
Lemma quadrature_scale x f : quadrature T (fun i => x * f i) = x * quadrature T f.
Proof. unfold quadrature. rewrite <- sum_scale. apply sum_ext. intros; ring. Qed.
Lemma applied_ext f g i : (forall i, i < stages T -> f i = g i) -> applied T f i = applied T g i.
Proof. intro H. apply sum_ext. intros j Hj. rewrite H by exact Hj. reflexivity. Qed.
Lemma applied_scale x f i : applied T (fun j => x * f j) i = x * applied T f i.
Proof. unfold applied. rewrite <- sum_scale. apply sum_ext. intros; ring. Qed.
Lemma scaled_graft t u i : scaled_phi (graft t u) i =
  scaled_phi t i * (whole (Z.of_nat (size u)) * applied T (scaled_phi u) i).
Proof.
  unfold scaled_phi. rewrite applied_scale. cbn [branches phi]. rewrite !whole_mul. unfold applied. ring.
Qed.

(** A power of c; or a power of c times one branch with more than q nodes; or a tree too large for that. *)
Lemma one_large_branch t :
  (forall i, i < stages T -> scaled_phi t i = power (c i) (size t - 1)%nat) \/
  (exists k u, (size t = S k + size u)%nat /\ q < size u /\ forall i, i < stages T ->
     scaled_phi t i = power (c i) k * (whole (Z.of_nat (size u)) * applied T (scaled_phi u) i)) \/
  (2 * q + 2 < size t)%nat.
Proof.
  induction t as [|t IHt u IHu].
  - left. intros i _. unfold scaled_phi. cbn. rewrite whole_one. ring.
  - pose proof (size_positive t). pose proof (size_positive u). cbn [size].
    destruct (le_lt_dec (size u) q) as [L|L].
    + assert (E : forall i, i < stages T -> whole (Z.of_nat (size u)) * applied T (scaled_phi u) i = power (c i) (size u)).
      { intros i Hi. destruct IHu as [U|[[k [v [S [Q _]]]]|U]]; try lia.
        rewrite (@applied_ext _ _ i U). assert (X : size u - 1 < q) by lia.
        apply (C X) in Hi. replace (S (size u - 1)) with (size u) in Hi by lia. exact Hi. }
      destruct IHt as [U|[[k [v [S [Q U]]]]|U]].
      * left. intros i Hi. rewrite scaled_graft, E, U, <- power_add by exact Hi. f_equal. lia.
      * right; left. exists (k + size u)%nat, v. repeat split; try lia.
        intros i Hi. rewrite scaled_graft, E, U, power_add by exact Hi. ring.
      * right; right. lia.
    + destruct IHt as [U|[[k [v [S [Q U]]]]|U]]; try (right; right; lia).
      right; left. exists (size t - 1)%nat, u. repeat split; try lia.
      intros i Hi. rewrite scaled_graft, U by exact Hi. ring.
Qed.

(** m leaves are grafted besides: so that D(r) can be used again. *)
Lemma weight_with_leaves : (p <= q + r + 1)%nat -> (p <= 2 * q + 2)%nat -> forall n t m, size t <= n -> (size t + m <= p)%nat ->
  whole (Z.of_nat (size t + m)%nat) * quadrature T (fun i => power (c i) m * scaled_phi t i) = 1.
Proof.
  intros P P'. induction n as [|n IH]; intros t m N L; pose proof (size_positive t); [lia|].
  destruct (one_large_branch t) as [U|[[k [u [S [Q U]]]]|U]]; [| |lia].
  - rewrite (@quadrature_ext _ (fun i => power (c i) (size t + m - 1)%nat)).
    + assert (X : size t + m - 1 < p) by lia. apply B in X. replace (S (size t + m - 1)) with (size t + m)%nat in X by lia. exact X.
    + intros i Hi. rewrite U, <- power_add by exact Hi. f_equal. lia.
  - set (l := (m + k)%nat). set (x := quadrature T (fun i => power (c i) l * applied T (scaled_phi u) i)).
    rewrite (@quadrature_ext _ (fun i => whole (Z.of_nat (size u)) * (power (c i) l * applied T (scaled_phi u) i))).
    2: { intros i Hi. rewrite U by exact Hi. unfold l. rewrite power_add. ring. }
    rewrite quadrature_scale. fold x.
    pose proof (IH u 0%nat ltac:(lia) ltac:(lia)) as E. pose proof (IH u (Datatypes.S l) ltac:(lia) ltac:(lia)) as E'.
    rewrite Nat.add_0_r in E. rewrite (@quadrature_ext _ (scaled_phi u)) in E by (intros; cbn [power]; ring).
    assert (X : whole (Z.of_nat (Datatypes.S l)) * x + quadrature T (fun i => power (c i) (Datatypes.S l) * scaled_phi u i)
                = quadrature T (scaled_phi u)).
    { unfold x, scaled_phi. rewrite quadrature_scale, <- (D u (k := l)) by lia.
      rewrite (@quadrature_ext _ (fun i => whole (branches u) * (power (c i) l * applied T (phi T u) i))).
      2: { intros i _. rewrite applied_scale. ring. }
      rewrite (@quadrature_ext (fun i => power (c i) (Datatypes.S l) * _)
                 (fun i => whole (branches u) * (power (c i) (Datatypes.S l) * phi T u i))) by (intros; ring).
      rewrite !quadrature_scale. ring. }
    replace (size t + m)%nat with (size u + Datatypes.S l)%nat by lia.
    apply (@whole_cancel l). set (y := quadrature T (fun i => power (c i) (Datatypes.S l) * scaled_phi u i)) in *.
    rewrite <- X in E. rewrite Nat2Z.inj_add, whole_add in *.
    set (g := whole (Z.of_nat (size u))) in *. set (h := whole (Z.of_nat (Datatypes.S l))) in *.
    (* g (h x + y) = 1 and (g + h) y = 1, so that (g + h) g h x = h *)
    transitivity ((g + h) * (g * (h * x + y)) + opp F (g * ((g + h) * y))); [ring|]. rewrite E, E'. ring.
Qed.
Theorem simplifying_order : (p <= q + r + 1)%nat -> (p <= 2 * q + 2)%nat -> has_order T p.
Proof.
  intros P P' t L. unfold condition. pose proof (@weight_with_leaves P P' (size t) t 0%nat) as W.
  rewrite Nat.add_0_r in W. rewrite <- W by lia. clear W.
  rewrite (@quadrature_ext _ (fun i => whole (branches t) * phi T t i)) by (intros; cbn [power]; unfold scaled_phi; ring).
  rewrite quadrature_scale. unfold gamma, weight. rewrite whole_mul. unfold quadrature. ring.
Qed.
End Simplifying.

(** How B(p), C(q) and D(r) are computed where T acts on the powers of c by alpha and beta. *)
Lemma length_vplus u : forall v n, length u <= n -> length v <= n -> length (vplus u v) <= n.
Proof.
  induction u as [|x u IH]; intros [|y v] [|n] L L'; simpl in *; try lia. specialize (IH v n). lia.
Qed.
Lemma length_scaled x v : length (scaled x v) <= length v.
Proof. unfold scaled. destruct (null x); [simpl; lia|]. rewrite map_length. lia. Qed.
Lemma length_reduced N p : length p <= S (length N) -> length (reduced N p) <= length N.
Proof.
  intro L. unfold reduced. pose proof (skipn_length (length N) p) as K.
  destruct (skipn (length N) p) as [|e [|f l]]; simpl in K; try lia.
  apply length_vplus; [rewrite firstn_length; lia|]. apply length_scaled.
Qed.
Lemma length_times N u v : length v <= length N -> length (times_modulo N u v) <= length N.
Proof.
  intro L. induction u as [|x u IH]; cbn [times_modulo]; [simpl; lia|].
  apply length_vplus; [pose proof (length_scaled x v); lia|]. apply length_reduced. simpl. lia.
Qed.
Lemma length_combination n v : forall rows, forallb (fun row => length row <=? n) rows = true ->
  length (combination v rows) <= n.
Proof.
  induction v as [|x v IH]; intros [|row rows] H; cbn [combination]; try (simpl; lia).
  cbn [forallb] in H. apply andb_prop in H. destruct H as [H H']. apply Nat.leb_le in H.
  apply length_vplus; [pose proof (length_scaled x row); lia|]. apply IH, H'.
Qed.

Lemma skipn_nth (X : Type) (x : X) l : forall k, k < length l -> skipn k l = nth k l x :: skipn (S k) l.
Proof.
  induction l as [|y l IH]; intros [|k] K; cbn [length] in K; try lia; [reflexivity|].
  change (skipn (S k) (y :: l)) with (skipn k l). rewrite IH by lia. reflexivity.
Qed.
Lemma quadrature_combination T x f g : quadrature T (fun i => x * f i + g i) = x * quadrature T f + quadrature T g.
Proof. unfold quadrature. rewrite <- sum_scale, <- sum_add. apply sum_ext. intros; ring. Qed.
Lemma has_D_combination T c r x f g h : has_D T c r f -> has_D T c r g ->
  (forall i, i < stages T -> h i = x * f i + g i) -> has_D T c r h.
Proof.
  intros Df Dg E k K. rewrite (@quadrature_ext T h (fun i => x * f i + g i)) by exact E.
  rewrite (@quadrature_ext T (fun i => power (c i) (S k) * h i)
             (fun i => x * (power (c i) (S k) * f i) + power (c i) (S k) * g i)) by (intros; rewrite E by assumption; ring).
  rewrite (@quadrature_ext T (fun i => power (c i) k * applied T h i)
             (fun i => x * (power (c i) k * applied T f i) + power (c i) k * applied T g i)).
  2: { intros i _. rewrite (@applied_ext T h (fun i => x * f i + g i)) by exact E. unfold applied.
       rewrite (@sum_ext _ _ (fun j => x * (a T i j * f j) + a T i j * g j)) by (intros; ring).
       rewrite sum_add, sum_scale. ring. }
  rewrite !quadrature_combination, <- (Df k K), <- (Dg k K). ring.
Qed.

Lemma has_D_zero T c r f : (forall i, i < stages T -> f i = 0) -> has_D T c r f.
Proof.
  intros Z k K. unfold quadrature, applied.
  rewrite (@sum_ext _ (fun i => b T i * f i) (fun i => b T i * 0)) by (intros; rewrite Z by assumption; ring).
  rewrite (@sum_ext _ (fun i => b T i * (power (c i) (S k) * f i)) (fun i => b T i * 0))
    by (intros; rewrite Z by assumption; ring).
  rewrite (@sum_ext _ (fun i => b T i * (power (c i) k * _)) (fun i => b T i * 0)).
  - rewrite !sum_nothing. ring.
  - intros i _. rewrite (@sum_ext _ _ (fun j => a T i j * 0)) by (intros; rewrite Z by assumption; ring).
    rewrite sum_nothing. ring.
Qed.

Section Moments.
Variables (T : tableau) (c : nat -> F) (N : list coefficient) (alpha : list (list coefficient)) (beta : list coefficient).
Hypothesis H : acts T c N alpha beta.
Hypothesis La : length alpha = length beta.
Hypothesis Ln : length N = length beta.
Lemma nodal_power i : i < stages T -> power (c i) (length N) = polynomial N (c i).
Proof. rewrite Ln, <- (number_of_stages H). apply (on_nodes H). Qed.
Lemma quadrature_polynomial v : length v <= length beta ->
  quadrature T (fun i => polynomial v (c i)) = value (product v beta).
Proof.
  intro L. rewrite <- (stage_product (acts_model La Ln H)) by exact L.
  apply sum_ext. intros i _. unfold stage. rewrite stage_powers. cbn [power]. ring.
Qed.
Lemma applied_polynomial v i : length v <= length beta -> i < stages T ->
  applied T (fun j => polynomial v (c j)) i = polynomial (combination v alpha) (c i).
Proof.
  intros L Hi. transitivity (stage (powers c) (combination v alpha) i).
  - rewrite <- (stage_combination (acts_model La Ln H)) by assumption.
    apply sum_ext. intros j _. unfold stage. rewrite stage_powers. cbn [power]. ring.
  - unfold stage. rewrite stage_powers. cbn [power]. ring.
Qed.

(** b^T (c^k p(c)) for k = 0, 1, ... *)
Fixpoint moments (p : list coefficient) (n : nat) : list coefficient :=
  match n with O => [] | S n => product p beta :: moments (reduced N (q 0 :: p)) n end.
Lemma moments_length n : forall p, length (moments p n) = n.
Proof. induction n; intro p; cbn [moments length]; [reflexivity|]. rewrite IHn; reflexivity. Qed.
Lemma moments_value n : forall p k, length p <= length N -> k < n ->
  value (nth k (moments p n) (q 0)) = quadrature T (fun i => power (c i) k * polynomial p (c i)).
Proof.
  induction n; intros p [|k] L K; try lia; cbn [moments nth].
  - rewrite <- quadrature_polynomial by lia. apply quadrature_ext. intros; cbn [power]; ring.
  - rewrite IHn by (try lia; apply length_reduced; simpl; lia).
    apply quadrature_ext. intros i Hi. rewrite polynomial_reduced by (apply nodal_power, Hi).
    cbn [polynomial power]. rewrite value_zero. ring.
Qed.
Definition times_whole (k : nat) (x : coefficient) : coefficient := times (q (inject_Z (Z.of_nat k))) x.
Definition B_holds (mu : list coefficient) (p : nat) : bool :=
  (p <=? length mu) && forallb (fun k => null (plus (times_whole (S k) (nth k mu (q 0))) (q (-1)))) (seq 0 p).
Definition C_holds (q' : nat) : bool :=
  (q' <=? length beta)
  && forallb (fun k => forallb null (vplus (nth k alpha []) (scaled (q (-1)) (integral_of N k)))) (seq 0 q').
Definition D_holds (mu : list coefficient) (r : nat) : bool :=
  (r + length beta <=? length mu)
  && forallb (fun k => forallb (fun l => null
       (plus (plus (times_whole (S k) (product (nth l alpha []) (skipn k mu))) (nth (S k + l) mu (q 0)))
             (times (q (-1)) (nth l mu (q 0))))) (seq 0 (length beta))) (seq 0 r).
Definition rows_short : bool := forallb (fun row => length row <=? length beta) alpha.

Variable n : nat.
Notation mu := (moments [q 1] n).
Hypothesis Positive : 0 < length beta.
Lemma moment_value k : k < n -> value (nth k mu (q 0)) = quadrature T (fun i => power (c i) k).
Proof.
  intro K. rewrite moments_value by (simpl; lia). apply quadrature_ext. intros. cbn [polynomial]. rewrite value_one. ring.
Qed.
Lemma product_moments v : forall k, k + length v <= n ->
  value (product v (skipn k mu)) = quadrature T (fun i => power (c i) k * polynomial v (c i)).
Proof.
  induction v as [|e v IH]; intros k L; cbn [length] in L.
  - cbn [product polynomial]. rewrite value_zero. unfold quadrature. symmetry.
    rewrite (@sum_ext _ _ (fun i => b T i * 0)) by (intros; ring). apply sum_nothing.
  - rewrite (@skipn_nth _ (q 0) mu k) by (rewrite moments_length; lia). cbn [product polynomial].
    rewrite value_plus, value_times, IH, moment_value by lia. cbn [power].
    rewrite <- quadrature_scale. unfold quadrature. rewrite <- sum_add. apply sum_ext. intros; ring.
Qed.

Hypothesis Short : rows_short = true.
Lemma row_short k : length (nth k alpha []) <= length beta.
Proof.
  unfold rows_short in Short. rewrite forallb_forall in Short.
  destruct (nth_in_or_default k alpha []) as [I|E]; [apply Nat.leb_le, Short, I|rewrite E; simpl; lia].
Qed.
Lemma null_minus_one x y : null (plus x (times (q (-1)) y)) = true -> value x = value y.
Proof.
  intro E. apply value_null in E. rewrite value_plus, value_times, value_q in E.
  change (-1)%Q with (- (1))%Q in E. rewrite rat_opp, rat_one in E.
  transitivity (value x + opp F 1 * value y + value y); [ring|]. rewrite E; ring.
Qed.
Lemma times_whole_value k x : value (times_whole k x) = whole (Z.of_nat k) * value x.
Proof. unfold times_whole. rewrite value_times, value_q. reflexivity. Qed.
Lemma B_is_checked p : B_holds mu p = true -> has_B T c p.
Proof.
  unfold B_holds. rewrite moments_length. intros E k K. apply andb_prop in E. destruct E as [L E]. apply Nat.leb_le in L.
  rewrite forallb_forall in E. specialize (E k). rewrite <- moment_value by lia.
  rewrite <- times_whole_value. assert (X : In k (seq 0 p)) by (apply in_seq; lia). apply E, value_null in X.
  rewrite value_plus, value_q in X. change (-1)%Q with (- (1))%Q in X. rewrite rat_opp, rat_one in X.
  transitivity (value (times_whole (S k) (nth k mu (q 0))) + opp F 1 + 1); [ring|]. rewrite X; ring.
Qed.
Lemma C_is_checked q' : C_holds q' = true -> has_C T c q'.
Proof.
  unfold C_holds. intros E k i K Hi. apply andb_prop in E. destruct E as [L E]. apply Nat.leb_le in L.
  rewrite forallb_forall in E. specialize (E k). assert (X : In k (seq 0 q')) by (apply in_seq; lia).
  apply E in X. apply (@polynomial_null _ (c i)) in X. rewrite polynomial_plus, polynomial_scaled, value_q in X.
  change (-1)%Q with (- (1))%Q in X. rewrite rat_opp, rat_one in X. unfold applied.
  assert (K' : k < stages T) by (rewrite (number_of_stages H); lia). rewrite (on_stages H Hi K').
  assert (Y : polynomial (integral_of N k) (c i) = value (one_over (S k)) * power (c i) (S k)).
  { unfold integral_of. rewrite polynomial_reduced by (apply nodal_power, Hi). apply polynomial_monomial. }
  transitivity (whole (Z.of_nat (S k)) * value (one_over (S k)) * power (c i) (S k)).
  - rewrite <- (Rmul_assoc (is_ring F)), <- Y. f_equal.
    transitivity (polynomial (nth k alpha []) (c i) + opp F 1 * polynomial (integral_of N k) (c i)
                  + polynomial (integral_of N k) (c i)); [ring|]. rewrite X; ring.
  - replace (whole (Z.of_nat (S k)) * value (one_over (S k))) with 1; [ring|]. rewrite (one_over_whole k). ring.
Qed.

(** D(r) of all polynomials in c from that of the powers, and the stage vectors of trees are such polynomials. *)
Lemma D_is_checked r : D_holds mu r = true -> forall v k, k + length v <= length beta ->
  has_D T c r (fun i => power (c i) k * polynomial v (c i)).
Proof.
  unfold D_holds. rewrite moments_length. intro E. apply andb_prop in E. destruct E as [L E]. apply Nat.leb_le in L.
  assert (P : forall l, l < length beta -> has_D T c r (fun i => power (c i) l)).
  { intros l Hl k K. rewrite forallb_forall in E. specialize (E k ltac:(apply in_seq; lia)).
    rewrite forallb_forall in E. specialize (E l ltac:(apply in_seq; lia)).
    apply null_minus_one in E. rewrite value_plus, times_whole_value in E.
    rewrite product_moments in E by (pose proof (row_short l); lia). rewrite !moment_value in E by lia.
    rewrite <- E. f_equal; [f_equal|]; apply quadrature_ext; intros i Hi; [|rewrite power_add; ring].
    f_equal. apply (on_stages H); [exact Hi|]. rewrite (number_of_stages H). exact Hl. }
  induction v as [|e v IH]; intros l Hl; cbn [length] in Hl.
  - apply has_D_zero. intros; cbn [polynomial]; ring.
  - apply has_D_combination with (x := value e) (f := fun i => power (c i) l)
      (g := fun i => power (c i) (S l) * polynomial v (c i)); [apply P; lia|apply IH; lia|].
    intros; cbn [polynomial power]; ring.
Qed.
Lemma phi_polynomial t : exists v, length v <= length beta /\ forall i, i < stages T -> phi T t i = polynomial v (c i).
Proof.
  induction t as [|t [v [Lv V]] u [w [Lw W]]].
  - exists [q 1]. split; [simpl; lia|]. intros i _. cbn [phi polynomial]. rewrite value_one. ring.
  - exists (times_modulo N v (combination w alpha)). split.
    + rewrite <- Ln. apply length_times. rewrite Ln. apply length_combination, Short.
    + intros i Hi. rewrite polynomial_times by (apply nodal_power, Hi). cbn [phi]. rewrite V by exact Hi. f_equal.
      rewrite <- applied_polynomial by assumption. apply applied_ext, W.
Qed.
Lemma D_of_trees r : D_holds mu r = true -> forall t, has_D T c r (phi T t).
Proof.
  intros E t. destruct (phi_polynomial t) as [v [L V]].
  apply has_D_combination with (x := 0) (f := fun i => power (c i) 0 * polynomial v (c i))
    (g := fun i => power (c i) 0 * polynomial v (c i)); try (apply D_is_checked; assumption).
  intros i Hi. rewrite V by exact Hi. cbn [power]. ring.
Qed.
End Moments.

(** B(p), C(r) and D(e), and a tree of p + 1 nodes that fails. *)
Definition acts_order (N : list coefficient) (alpha : list (list coefficient)) (beta : list coefficient)
           (p r e : nat) (t : tree) : bool :=
  let mu := moments N beta [q 1] (p + e + length beta) in
  ((length alpha =? length beta) && (length N =? length beta) && (0 <? length beta) && rows_short alpha beta)
  && (B_holds mu p && C_holds N alpha beta r && D_holds alpha beta mu e)
  && ((p <=? r + e + 1)%nat && (p <=? 2 * r + 2)%nat)
  && ((size t =? S p) && fails alpha beta [q 1] (times_modulo N) t).
Theorem acts_order_is T c N alpha beta p r e t :
  acts T c N alpha beta -> acts_order N alpha beta p r e t = true -> order_is T p.
Proof.
  unfold acts_order. intros H E. repeat match goal with X : _ && _ = true |- _ => apply andb_prop in X; destruct X end.
  repeat match goal with
    | X : (_ =? _) = true |- _ => apply Nat.eqb_eq in X
    | X : (_ <? _) = true |- _ => apply Nat.ltb_lt in X
    | X : (_ <=? _) = true |- _ => apply Nat.leb_le in X
  end.
  split.
  - apply simplifying_order with (c := c) (q := r) (r := e); try assumption.
    + eapply B_is_checked; eassumption.
    + eapply C_is_checked; eassumption.
    + eapply D_of_trees; eassumption.
  - exists t. split; [assumption|]. refine (failure_is_checked (acts_model _ _ H) _); assumption.
Qed.
End Statements.

(** ** 9. Stability, over the real numbers of Coq's library (whose axioms these theorems use; those on orders use none) *)

From Coq Require Import Reals Qreals Lra Psatz.

Section Reals.
Variable d : Q.
Hypothesis d_positive : (0 <= d)%Q.
Open Scope R_scope.

Lemma Q2R_root : sqrt (Q2R d) * sqrt (Q2R d) = Q2R d.
Proof. apply sqrt_sqrt. replace 0 with (Q2R 0) by (unfold Q2R; simpl; lra). apply Qle_Rle, d_positive. Qed.
Lemma Q2R_one : Q2R 1 = 1.
Proof. unfold Q2R; simpl; lra. Qed.
Definition reals : field d :=
  {| K := R; zero := 0; one := 1; add := Rplus; mul := Rmult; sub := Rminus; opp := Ropp; is_ring := RTheory;
     one_is_not_zero := R1_neq_R0; rat := Q2R; rat_eq := Qeq_eqR; rat_one := Q2R_one; rat_add := Q2R_plus;
     rat_mul := Q2R_mult; root := sqrt (Q2R d); root_square := Q2R_root |}.
Notation val := (@value d reals : coefficient -> R).

Lemma val_plus x y : val (plus x y) = val x + val y.
Proof. exact (@value_plus d reals x y). Qed.
Lemma val_times x y : val (times d x y) = val x * val y.
Proof. exact (@value_times d reals x y). Qed.
Definition minus (x y : coefficient) : coefficient := plus x (times d (q (-1)) y).
Lemma val_minus x y : val (minus x y) = val x - val y.
Proof. unfold minus. rewrite val_plus, val_times, (value_q reals). simpl. unfold Q2R; simpl. lra. Qed.

(** The sign of x + y sqrt(d). *)
Definition not_negative (e : coefficient) : bool :=
  let (x, y) := e in
  if Qle_bool 0 y then Qle_bool 0 x || Qle_bool (x * x) (d * (y * y))
  else Qle_bool 0 x && Qle_bool (d * (y * y)) (x * x).
Lemma Qle_bool_R x y : Qle_bool x y = true -> Q2R x <= Q2R y.
Proof. intro H. apply Qle_Rle, Qle_bool_iff, H. Qed.
Lemma not_negative_sound e : not_negative e = true -> 0 <= val e.
Proof.
  destruct e as [x y]. unfold not_negative, value; cbn [fst snd add mul rat root reals].
  pose proof Q2R_root as S. pose proof (sqrt_pos (Q2R d)) as P. set (r := sqrt (Q2R d)) in *.
  assert (Z : Q2R 0 = 0) by (unfold Q2R; simpl; lra).
  destruct (Qle_bool 0 y) eqn:Y.
  - apply Qle_bool_R in Y. rewrite Z in Y. intro H. apply orb_prop in H. destruct H as [H|H]; apply Qle_bool_R in H.
    + rewrite Z in H. nra.
    + rewrite !Q2R_mult, <- S in H. destruct (Rle_or_lt 0 (Q2R x + Q2R y * r)) as [L|L]; [exact L|exfalso].
      assert (0 <= Q2R y * r) by nra. nra.
  - assert (Y' : Q2R y < 0).
    { rewrite <- Z. apply Qlt_Rlt, Qnot_le_lt. intro L. apply Qle_bool_iff in L. congruence. }
    intro H. apply andb_prop in H. destruct H as [H H']. apply Qle_bool_R in H, H'. rewrite Z in H.
    rewrite !Q2R_mult, <- S in H'. destruct (Rle_or_lt 0 (Q2R x + Q2R y * r)) as [L|L]; [exact L|exfalso].
    assert (Q2R y * r <= 0) by nra. nra.
Qed.
Definition positive (e : coefficient) : bool := not_negative e && not_null d e.
Lemma positive_sound e : positive e = true -> 0 < val e.
Proof.
  intro H. apply andb_prop in H. destruct H as [H N]. apply not_negative_sound in H.
  apply (value_not_null reals) in N. destruct H as [H|H]; [exact H|]. exfalso; apply N; symmetry; exact H.
Qed.

(** A polynomial at x + iy. *)
Fixpoint at_complex (p : list coefficient) (x y : R) : R * R :=
  match p with
  | [] => (0, 0)
  | e :: p => let (u, v) := at_complex p x y in (val e + (x * u - y * v), x * v + y * u)
  end.
Definition modulus_squared (p : list coefficient) (x y : R) : R :=
  let (u, v) := at_complex p x y in u * u + v * v.

(** |P/Q| <= 1 on the closed left half-plane, where Q has no root. *)
Definition a_stable (P Q : list coefficient) : Prop :=
  forall x y, x <= 0 -> 0 < modulus_squared Q x y /\ modulus_squared P x y <= modulus_squared Q x y.
(** And the degree of P is below that of Q: R(infinity) = 0. *)
Definition l_stable (P Q : list coefficient) : Prop :=
  a_stable P Q /\ (length P < length Q)%nat /\ val (last Q (q 0)) <> 0.
Definition exceeds_one (P Q : list coefficient) : Prop :=
  exists x y, x <= 0 /\ modulus_squared Q x y < modulus_squared P x y.
Lemma exceeds_one_refutes P Q : exceeds_one P Q -> ~ a_stable P Q.
Proof. intros [x [y [X L]]] H. destruct (H x y X). lra. Qed.

(** Polynomials in u and y, for z = -u + iy: the coefficient of u^j is a polynomial in y. *)
Definition poly2 := list (list coefficient).
Fixpoint at_y (p : list coefficient) (y : R) : R :=
  match p with [] => 0 | e :: p => val e + y * at_y p y end.
Fixpoint at_u_y (p : poly2) (u y : R) : R :=
  match p with [] => 0 | c :: p => at_y c y + u * at_u_y p u y end.
Fixpoint plus2 (p r : poly2) : poly2 :=
  match p, r with [], _ => r | _, [] => p | c :: p, e :: r => vplus c e :: plus2 p r end.
Definition minus1 := q (-1).
Definition opposite2 (p : poly2) : poly2 := map (scaled d minus1) p.
Definition times_y (p : poly2) : poly2 := map (fun c => q 0 :: c) p.
Fixpoint times2 (p r : poly2) : poly2 :=
  match p with [] => [] | c :: p => plus2 (map (times1 d c) r) ([] :: times2 p r) end.

Lemma val_0 : val (q 0) = 0.
Proof. exact (value_zero reals). Qed.
Lemma val_minus1 : val minus1 = -1.
Proof. unfold minus1. rewrite (value_q reals). simpl. unfold Q2R; simpl; lra. Qed.
Lemma at_y_plus p : forall r y, at_y (vplus p r) y = at_y p y + at_y r y.
Proof.
  induction p as [|e p IH]; intros [|f r] y; cbn [vplus at_y]; try lra. rewrite val_plus, IH. lra.
Qed.
Lemma at_y_scaled e p y : at_y (scaled d e p) y = val e * at_y p y.
Proof.
  unfold scaled. destruct (null e) eqn:E; [rewrite (value_null reals _ E); cbn [at_y zero reals]; lra|].
  induction p as [|f p IH]; cbn [map at_y]; [lra|]. rewrite val_times, IH. lra.
Qed.
Lemma at_y_times p : forall r y, at_y (times1 d p r) y = at_y p y * at_y r y.
Proof.
  induction p as [|e p IH]; intros r y; cbn [times1 at_y]; [lra|].
  rewrite at_y_plus, at_y_scaled. cbn [at_y]. rewrite val_0, IH. lra.
Qed.
Lemma at_plus2 p : forall r u y, at_u_y (plus2 p r) u y = at_u_y p u y + at_u_y r u y.
Proof.
  induction p as [|e p IH]; intros [|f r] u y; cbn [plus2 at_u_y]; try lra. rewrite at_y_plus, IH. lra.
Qed.
Lemma at_opposite2 p u y : at_u_y (opposite2 p) u y = - at_u_y p u y.
Proof.
  unfold opposite2. induction p as [|e p IH]; cbn [map at_u_y]; [lra|].
  rewrite at_y_scaled, val_minus1, IH. lra.
Qed.
Lemma at_times_y p u y : at_u_y (times_y p) u y = y * at_u_y p u y.
Proof.
  unfold times_y. induction p as [|e p IH]; cbn [map at_u_y at_y]; [lra|]. rewrite val_0, IH. lra.
Qed.
Lemma at_times2 p : forall r u y, at_u_y (times2 p r) u y = at_u_y p u y * at_u_y r u y.
Proof.
  induction p as [|c p IH]; intros r u y; cbn [times2 at_u_y]; [lra|].
  rewrite at_plus2. cbn [at_u_y at_y]. rewrite IH.
  assert (S : at_u_y (map (times1 d c) r) u y = at_y c y * at_u_y r u y).
  { clear. induction r as [|e r IH]; cbn [map at_u_y]; [lra|]. rewrite at_y_times, IH. lra. }
  rewrite S. lra.
Qed.

Fixpoint parts (p : list coefficient) : poly2 * poly2 :=
  match p with
  | [] => ([], [])
  | e :: p => let (re, im) := parts p in
      (plus2 [[e]] (plus2 ([] :: opposite2 re) (opposite2 (times_y im))),
       plus2 ([] :: opposite2 im) (times_y re))
  end.
Definition square2 (p : list coefficient) : poly2 :=
  let (re, im) := parts p in plus2 (times2 re re) (times2 im im).
Lemma at_parts p u y :
  at_complex p (- u) y = (at_u_y (fst (parts p)) u y, at_u_y (snd (parts p)) u y).
Proof.
  induction p as [|e p IH]; cbn [at_complex parts fst snd at_u_y]; [reflexivity|].
  rewrite IH. destruct (parts p) as [re im]; cbn [fst snd].
  rewrite !at_plus2. cbn [at_u_y at_y]. rewrite !at_opposite2, !at_times_y. f_equal; lra.
Qed.
Lemma at_square2 p u y : at_u_y (square2 p) u y = modulus_squared p (- u) y.
Proof.
  unfold square2, modulus_squared. rewrite at_parts. destruct (parts p) as [re im]; cbn [fst snd].
  rewrite at_plus2, !at_times2. reflexivity.
Qed.

(** Even in y, and no coefficient negative. *)
Fixpoint even_not_negative (p : list coefficient) : bool :=
  match p with
  | [] => true
  | [e] => not_negative e
  | e :: f :: p => not_negative e && (null f && even_not_negative p)
  end.
Lemma even_not_negative_sound n : forall p, (length p <= n)%nat -> even_not_negative p = true -> forall y, 0 <= at_y p y.
Proof.
  induction n as [|n IH]; intros [|e [|f p]] L H y; cbn [length at_y even_not_negative] in *; try lia; try lra.
  - apply not_negative_sound in H. lra.
  - apply andb_prop in H. destruct H as [H H']. apply andb_prop in H'. destruct H' as [N H'].
    apply not_negative_sound in H. pose proof (value_null reals _ N) as N'. cbn [zero reals] in N'. rewrite N'.
    assert (0 <= at_y p y) by (apply IH; [lia|exact H']). nra.
Qed.
Definition not_negative2 (p : poly2) : bool := forallb even_not_negative p.
Lemma not_negative2_sound p u y : not_negative2 p = true -> 0 <= u -> 0 <= at_u_y p u y.
Proof.
  intros H U. induction p as [|c p IH]; cbn [at_u_y]; [lra|]. cbn [not_negative2 forallb] in H.
  apply andb_prop in H. destruct H as [H H'].
  pose proof (@even_not_negative_sound (length c) c (le_n _) H y). specialize (IH H'). nra.
Qed.

(** |Q|^2 - 1 and |Q|^2 - |P|^2 have no negative coefficient: so it is for most methods. *)
Lemma a_stable_from (e : coefficient) P Q : 0 < val e ->
  (forall u y, 0 <= u -> 0 <= at_u_y (plus2 [[times d minus1 e]] (square2 Q)) u y) ->
  (forall u y, 0 <= u -> 0 <= at_u_y (plus2 (square2 Q) (opposite2 (square2 P))) u y) -> a_stable P Q.
Proof.
  intros E H H' x y X. replace x with (- - x) by lra. rewrite <- !at_square2.
  specialize (H (- x) y). specialize (H' (- x) y). rewrite at_plus2 in H, H'. rewrite at_opposite2 in H'.
  cbn [at_u_y at_y] in H. rewrite val_times, val_minus1 in H. split; lra.
Qed.
Definition a_verdict (P Q : list coefficient) : bool :=
  not_negative2 (plus2 [[times d minus1 (q 1)]] (square2 Q)) && not_negative2 (plus2 (square2 Q) (opposite2 (square2 P))).
Theorem a_stable_is_checked P Q : a_verdict P Q = true -> a_stable P Q.
Proof.
  unfold a_verdict. intro H. apply andb_prop in H. destruct H as [H H']. apply (@a_stable_from (q 1)).
  - rewrite (value_one reals). cbn. lra.
  - intros u y. apply not_negative2_sound, H.
  - intros u y. apply not_negative2_sound, H'.
Qed.

(** Where they have: sums of squares, |Q|^2 - |P|^2 = sum of D |h(z)|^2 + u sum of D |k(z)|^2 with D >= 0; and the same of
    |Q|^2 - e for some e > 0. *)
Definition squares := list (coefficient * list coefficient).
Definition weights_not_negative (sq : squares) : bool := forallb (fun p => not_negative (fst p)) sq.
Fixpoint moduli (sq : squares) : poly2 :=
  match sq with [] => [] | (D, h) :: sq => plus2 (map (scaled d D) (square2 h)) (moduli sq) end.
Definition is_squares (p : poly2) (on_axis inside : squares) : bool :=
  weights_not_negative (on_axis ++ inside)
  && forallb (forallb null) (plus2 p (opposite2 (plus2 (moduli on_axis) ([] :: moduli inside)))).
Lemma moduli_not_negative sq u y : weights_not_negative sq = true -> 0 <= at_u_y (moduli sq) u y.
Proof.
  induction sq as [|[D h] sq IH]; cbn [moduli weights_not_negative forallb fst at_u_y]; intro H; [lra|].
  apply andb_prop in H. destruct H as [H H']. apply not_negative_sound in H. specialize (IH H').
  rewrite at_plus2. assert (S : at_u_y (map (scaled d D) (square2 h)) u y = val D * at_u_y (square2 h) u y).
  { clear. induction (square2 h) as [|e p IH]; cbn [map at_u_y]; [lra|]. rewrite at_y_scaled, IH. lra. }
  rewrite S, at_square2. assert (0 <= modulus_squared h (- u) y).
  { unfold modulus_squared. destruct (at_complex h (- u) y). nra. }
  nra.
Qed.
Lemma null2_zero p u y : forallb (forallb null) p = true -> at_u_y p u y = 0.
Proof.
  induction p as [|c p IH]; cbn [forallb at_u_y]; intro H; [reflexivity|]. apply andb_prop in H. destruct H as [H H'].
  rewrite IH by exact H'. assert (Z : at_y c y = 0); [|lra]. clear - H. induction c as [|e c IH]; cbn [forallb at_y] in *; [reflexivity|].
  apply andb_prop in H. destruct H as [H H']. apply (value_null reals) in H. cbn [zero reals] in H. rewrite H, IH by exact H'. lra.
Qed.
Lemma is_squares_sound p on_axis inside u y : is_squares p on_axis inside = true -> 0 <= u -> 0 <= at_u_y p u y.
Proof.
  unfold is_squares, weights_not_negative. intros H U. apply andb_prop in H. destruct H as [H E]. rewrite forallb_app in H.
  apply andb_prop in H. destruct H as [H H']. apply (moduli_not_negative _ u y) in H, H'.
  apply (null2_zero _ u y) in E. rewrite at_plus2, at_opposite2, at_plus2 in E. cbn [at_u_y at_y] in E. nra.
Qed.
Definition a_verdict_by_squares (P Q : list coefficient) (on_axis inside : squares) (e : coefficient) (on_axis' inside' : squares) : bool :=
  positive e && is_squares (plus2 (square2 Q) (opposite2 (square2 P))) on_axis inside
  && is_squares (plus2 [[times d minus1 e]] (square2 Q)) on_axis' inside'.
Theorem a_stable_by_squares P Q on_axis inside e on_axis' inside' :
  a_verdict_by_squares P Q on_axis inside e on_axis' inside' = true -> a_stable P Q.
Proof.
  unfold a_verdict_by_squares. intro H. apply andb_prop in H. destruct H as [H H']. apply andb_prop in H. destruct H as [E H].
  apply positive_sound in E. apply (@a_stable_from e P Q E); intros u y; eapply is_squares_sound; eassumption.
Qed.
Definition l_verdict (P Q : list coefficient) : bool := (length P <? length Q)%nat && not_null d (last Q (q 0)).
Theorem l_stable_is_checked P Q : a_stable P Q -> l_verdict P Q = true -> l_stable P Q.
Proof.
  unfold l_verdict. intros A H. apply andb_prop in H. destruct H as [L N].
  split; [exact A|]. split; [apply Nat.ltb_lt, L|exact (value_not_null reals _ N)].
Qed.

(** A point where |R| > 1. *)
Fixpoint at_point (p : list coefficient) (x y : coefficient) : coefficient * coefficient :=
  match p with
  | [] => (q 0, q 0)
  | e :: p => let (u, v) := at_point p x y in
      (plus e (minus (times d x u) (times d y v)), plus (times d x v) (times d y u))
  end.
Definition square_at (p : list coefficient) (x y : coefficient) : coefficient :=
  let (u, v) := at_point p x y in plus (times d u u) (times d v v).
Lemma at_point_sound p x y : at_complex p (val x) (val y) = (val (fst (at_point p x y)), val (snd (at_point p x y))).
Proof.
  induction p as [|e p IH]; cbn [at_complex at_point fst snd]; [rewrite val_0; reflexivity|].
  rewrite IH. destruct (at_point p x y) as [u v]; cbn [fst snd].
  rewrite !val_plus, !val_minus, !val_times. reflexivity.
Qed.
Lemma square_at_sound p x y : modulus_squared p (val x) (val y) = val (square_at p x y).
Proof.
  unfold modulus_squared, square_at. rewrite at_point_sound. destruct (at_point p x y) as [u v]; cbn [fst snd].
  rewrite val_plus, !val_times. reflexivity.
Qed.
Definition exceeds_verdict (P Q : list coefficient) (x y : coefficient) : bool :=
  not_negative (minus (q 0) x) && positive (minus (square_at P x y) (square_at Q x y)).
Theorem exceeds_is_checked P Q x y : exceeds_verdict P Q x y = true -> exceeds_one P Q.
Proof.
  unfold exceeds_verdict. intro H. apply andb_prop in H. destruct H as [X H].
  apply not_negative_sound in X. apply positive_sound in H. rewrite val_minus in X, H. rewrite val_0 in X.
  exists (val x), (val y). rewrite !square_at_sound. split; lra.
Qed.

(** ** 10. Algebraic stability and symplecticity: the matrix M *)

Notation total := (@sum d reals : nat -> (nat -> R) -> R).
Variable T : tableau reals.
Notation s := (stages T).
Definition m (i j : nat) : R := b T i * a T i j + b T j * a T j i - b T i * b T j.
Definition form (g : nat -> nat -> R) (v w : nat -> R) : R :=
  total s (fun i => total s (fun j => v i * g i j * w j)).
Definition algebraically_stable : Prop :=
  (forall i, (i < s)%nat -> 0 <= b T i) /\ forall v, 0 <= form m v v.
Definition not_algebraically_stable : Prop :=
  (exists i, (i < s)%nat /\ b T i < 0) \/ exists v, form m v v < 0.
Definition symplectic : Prop := forall i j, (i < s)%nat -> (j < s)%nat -> m i j = 0.
Lemma not_algebraically_stable_refutes : not_algebraically_stable -> ~ algebraically_stable.
Proof.
  intros [[i [L N]]|[v N]] [B M]; [specialize (B i L)|specialize (M v)]; lra.
Qed.

Lemma total_ext n f g : (forall i, (i < n)%nat -> f i = g i) -> total n f = total n g.
Proof. exact (@sum_ext d reals n f g). Qed.
Lemma total_add n f g : total n (fun i => f i + g i) = total n f + total n g.
Proof. exact (@sum_add d reals n f g). Qed.
Lemma total_scale n x f : total n (fun i => x * f i) = x * total n f.
Proof. exact (@sum_scale d reals n x f). Qed.
Lemma total_S n f : total (S n) f = total n f + f n.
Proof. reflexivity. Qed.
Lemma total_zero n f : (forall i, (i < n)%nat -> f i = 0) -> total n f = 0.
Proof.
  intro H. induction n; [reflexivity|]. rewrite total_S, H, IHn by auto. lra.
Qed.
Lemma total_swap n k f : total n (fun i => total k (fun j => f i j)) = total k (fun j => total n (fun i => f i j)).
Proof.
  induction n.
  - symmetry. apply total_zero. reflexivity.
  - rewrite total_S, IHn, <- total_add. apply total_ext. reflexivity.
Qed.

Section Basis.
Variable B : nat -> nat -> R.
Variable n : nat.
Definition combined (k : nat) (x : nat -> R) (i : nat) : R := total k (fun k => x k * B k i).
Definition spans : Prop := forall v, exists x, forall i, (i < s)%nat -> v i = combined n x i.

Lemma form_ext g v v' w w' : (forall i, (i < s)%nat -> v i = v' i) -> (forall i, (i < s)%nat -> w i = w' i) ->
  form g v w = form g v' w'.
Proof.
  intros H H'. apply total_ext. intros i Hi. apply total_ext. intros j Hj. rewrite H, H' by assumption. reflexivity.
Qed.
Lemma form_left g w x k : form g (combined k x) w = total k (fun k => x k * form g (B k) w).
Proof.
  unfold form, combined. induction k.
  - apply total_zero. intros i _. apply total_zero. intros j _. cbn [sum zero reals]; ring.
  - rewrite total_S, <- IHk, <- total_scale, <- total_add. apply total_ext. intros i _.
    rewrite <- total_scale, <- total_add. apply total_ext. intros j _. rewrite total_S. lra.
Qed.
Lemma form_right g v x k : form g v (combined k x) = total k (fun k => x k * form g v (B k)).
Proof.
  unfold form, combined. induction k.
  - apply total_zero. intros i _. apply total_zero. intros j _. cbn [sum zero reals]; ring.
  - rewrite total_S, <- IHk, <- total_scale, <- total_add. apply total_ext. intros i _.
    rewrite <- total_scale, <- total_add. apply total_ext. intros j _. rewrite total_S. lra.
Qed.

(** A form that is a sum of D times a square of L x is not negative where D is not. *)
Definition at_place (l : list coefficient) (k : nat) : coefficient := nth k l (q 0).
Fixpoint entry_of (sq : squares) (k l : nat) : coefficient :=
  match sq with
  | [] => q 0
  | (D, L) :: sq => plus (times d D (times d (at_place L k) (at_place L l))) (entry_of sq k l)
  end.
Definition equals (sq : squares) (g : nat -> nat -> coefficient) : bool :=
  forallb (fun k => forallb (fun l => null (minus (entry_of sq k l) (g k l))) (seq 0 n)) (seq 0 n).
Lemma null_minus x y : null (minus x y) = true -> val x = val y.
Proof. intro H. apply (value_null reals) in H. rewrite val_minus in H. cbn [zero reals] in H. lra. Qed.
Lemma for_all (f : nat -> bool) k : forallb f (seq 0 n) = true -> (k < n)%nat -> f k = true.
Proof. intros H L. rewrite forallb_forall in H. apply H, in_seq. lia. Qed.
Lemma squares_not_negative sq x : weights_not_negative sq = true ->
  0 <= total n (fun k => x k * total n (fun l => x l * val (entry_of sq k l))).
Proof.
  induction sq as [|[D L] sq IH]; cbn [weights_not_negative forallb entry_of fst]; intro H.
  - apply Req_le. symmetry. apply total_zero. intros k _. rewrite (total_zero (n := n)); [lra|].
    intros l _. rewrite val_0. lra.
  - apply andb_prop in H. destruct H as [H H']. specialize (IH H'). apply not_negative_sound in H.
    set (z := total n (fun k => x k * val (at_place L k))).
    replace (total n _) with (val D * (z * z)
      + total n (fun k => x k * total n (fun l => x l * val (entry_of sq k l)))); [nra|].
    unfold z at 1. rewrite <- (Rmult_comm z), <- (Rmult_assoc (val D)), <- total_scale, <- total_add.
    apply total_ext. intros k _. unfold z.
    replace (val D * total n (fun k0 => x k0 * val (at_place L k0)) * (x k * val (at_place L k)))
      with (x k * ((val D * val (at_place L k)) * total n (fun k0 => x k0 * val (at_place L k0)))) by ring.
    rewrite <- Rmult_plus_distr_l, <- total_scale, <- total_add. f_equal. apply total_ext. intros l _.
    rewrite val_plus, !val_times. ring.
Qed.
Lemma form_not_negative g (entries : nat -> nat -> coefficient) sq :
  spans -> (forall k l, (k < n)%nat -> (l < n)%nat -> form g (B k) (B l) = val (entries k l)) ->
  equals sq entries = true -> weights_not_negative sq = true -> forall v, 0 <= form g v v.
Proof.
  intros S G E P v. destruct (S v) as [x X]. rewrite (@form_ext g _ _ _ _ X X), form_left.
  rewrite (@total_ext n _ (fun k => x k * total n (fun l => x l * val (entry_of sq k l)))).
  - apply squares_not_negative, P.
  - intros k Hk. f_equal. rewrite form_right. apply total_ext. intros l Hl. f_equal.
    rewrite G by assumption. symmetry. apply null_minus.
    exact (for_all _ (for_all _ E Hk) Hl).
Qed.

Variables (alpha : list (list coefficient)) (beta unit : list coefficient)
          (times_in : list coefficient -> list coefficient -> list coefficient).
Hypothesis M : model T B alpha beta unit times_in.
Hypothesis N : n = length beta.
Hypothesis Span : spans.

Definition axis (k : nat) : list coefficient := monomial (q 1) k.
Definition weigh (v : list coefficient) : coefficient := product d v beta.
Definition pairing (k l : nat) : list coefficient := times_in (axis k) (nth l alpha []).
Definition m_entry (k l : nat) : coefficient :=
  minus (plus (weigh (pairing k l)) (weigh (pairing l k))) (times d (at_place beta k) (at_place beta l)).
Definition g_entry (k l : nat) : coefficient := weigh (times_in (axis k) (axis l)).
Definition all_pairs (f : nat -> nat -> bool) : bool := forallb (fun k => forallb (f k) (seq 0 n)) (seq 0 n).
Definition pairings_short : bool :=
  all_pairs (fun k l => short beta (pairing k l) && short beta (times_in (axis k) (axis l))).
Lemma all_pairs_at f k l : all_pairs f = true -> (k < n)%nat -> (l < n)%nat -> f k l = true.
Proof. intros H Hk Hl. exact (for_all _ (for_all _ H Hk) Hl). Qed.

Lemma axis_stage k i : @stage d reals B (axis k) i = B k i.
Proof.
  unfold axis, stage, monomial. enough (G : forall r, @stage_from d reals B r (repeat (q 0) k ++ [q 1]) i = B (r + k)%nat i) by apply G.
  induction k; intro r; cbn [repeat app stage_from].
  - rewrite (value_one reals), Nat.add_0_r. cbn. lra.
  - rewrite IHk, val_0. replace (S r + k)%nat with (r + S k)%nat by lia. cbn. lra.
Qed.
Lemma axes_in_stages k i : (k < n)%nat -> (i < s)%nat ->
  total s (fun j => a T i j * B k j) = @stage d reals B (nth k alpha []) i.
Proof. intros Hk Hi. apply (acts_on_stages M); lia. Qed.
Lemma pairing_value k l : pairings_short = true -> (k < n)%nat -> (l < n)%nat ->
  total s (fun i => b T i * (B k i * total s (fun j => a T i j * B l j))) = val (weigh (pairing k l)).
Proof.
  intros H Hk Hl. unfold weigh. apply (all_pairs_at _ H Hk) in Hl as S. apply andb_prop in S. destruct S as [S _].
  apply Nat.leb_le in S. rewrite <- (stage_product M) by exact S.
  apply total_ext. intros i Hi. unfold pairing. rewrite (has_product M) by exact Hi.
  rewrite axis_stage, axes_in_stages by assumption. reflexivity.
Qed.
Lemma m_value k l : pairings_short = true -> (k < n)%nat -> (l < n)%nat -> form m (B k) (B l) = val (m_entry k l).
Proof.
  intros H Hk Hl. unfold m_entry. rewrite val_minus, val_plus, val_times, <- !pairing_value by assumption.
  unfold at_place. rewrite <- (acts_on_weights M (k := k)), <- (acts_on_weights M (k := l)) by lia.
  unfold form, m. 
  change (add reals) with Rplus. change (mul reals) with Rmult.
  replace (total s (fun i => b T i * (B l i * total s (fun j => a T i j * B k j))))
    with (total s (fun i => total s (fun j => B k i * (b T j * a T j i) * B l j))).
  2: { rewrite total_swap. apply total_ext. intros i _. rewrite <- Rmult_assoc, <- total_scale. apply total_ext. intros j _. ring. }
  set (z := total s (fun j => b T j * B l j)). 
  replace (total s (fun j => b T j * B k j) * z) with (total s (fun i => (b T i * B k i) * z)).
  2: { rewrite (Rmult_comm _ z), <- total_scale. apply total_ext. intros; ring. }
  unfold Rminus. rewrite <- total_add.
  replace (- total s (fun i => b T i * B k i * z)) with (total s (fun i => (-1) * (b T i * B k i * z)))
    by (rewrite total_scale; ring).
  rewrite <- total_add. apply total_ext. intros i _. unfold z.
  replace (b T i * (B k i * total s (fun j => a T i j * B l j))) with (total s (fun j => (b T i * B k i) * (a T i j * B l j)))
    by (rewrite total_scale; ring).
  replace (-1 * (b T i * B k i * total s (fun j => b T j * B l j)))
    with (total s (fun j => (- (b T i * B k i)) * (b T j * B l j))) by (rewrite total_scale; ring).
  rewrite <- !total_add. apply total_ext. intros j _. ring.
Qed.

(** b as a form: b^T (v w). *)
Definition diagonal (i j : nat) : R := if (i =? j)%nat then b T i else 0.
Lemma diagonal_form v w : form diagonal v w = total s (fun i => b T i * (v i * w i)).
Proof.
  apply total_ext. intros i Hi. unfold diagonal.
  enough (G : forall k, total k (fun j => v i * (if (i =? j)%nat then b T i else 0) * w j)
                        = if (i <? k)%nat then b T i * (v i * w i) else 0).
  { rewrite G. destruct (Nat.ltb_spec i s); [reflexivity|lia]. }
  induction k; [reflexivity|]. rewrite total_S, IHk.
  destruct (Nat.ltb_spec i k), (Nat.ltb_spec i (S k)), (Nat.eqb_spec i k); try lia; subst; ring.
Qed.
Lemma g_value k l : pairings_short = true -> (k < n)%nat -> (l < n)%nat -> form diagonal (B k) (B l) = val (g_entry k l).
Proof.
  intros H Hk Hl. rewrite diagonal_form. unfold g_entry, weigh. apply (all_pairs_at _ H Hk) in Hl as S. apply andb_prop in S.
  destruct S as [_ S]. apply Nat.leb_le in S. rewrite <- (stage_product M) by exact S.
  apply total_ext. intros i Hi. rewrite (has_product M) by exact Hi. rewrite !axis_stage. reflexivity.
Qed.
Lemma diagonal_not_negative : (forall v, 0 <= form diagonal v v) -> forall i, (i < s)%nat -> 0 <= b T i.
Proof.
  intros H i Hi. specialize (H (fun j => if (i =? j)%nat then 1 else 0)). rewrite diagonal_form in H.
  enough (E : total s (fun j => b T j * ((if (i =? j)%nat then 1 else 0) * (if (i =? j)%nat then 1 else 0))) = b T i) by lra.
  enough (G : forall k, total k (fun j => b T j * ((if (i =? j)%nat then 1 else 0) * (if (i =? j)%nat then 1 else 0)))
                        = if (i <? k)%nat then b T i else 0).
  { rewrite G. destruct (Nat.ltb_spec i s); [reflexivity|lia]. }
  induction k; [reflexivity|]. rewrite total_S, IHk.
  destruct (Nat.ltb_spec i k), (Nat.ltb_spec i (S k)), (Nat.eqb_spec i k); try lia; subst; ring.
Qed.

Definition algebraic_verdict (of_b of_m : squares) : bool :=
  pairings_short && (weights_not_negative (of_b ++ of_m) && (equals of_b g_entry && equals of_m m_entry)).
Theorem algebraic_is_checked of_b of_m : algebraic_verdict of_b of_m = true -> algebraically_stable.
Proof.
  unfold algebraic_verdict. intro H. apply andb_prop in H. destruct H as [S H]. apply andb_prop in H.
  destruct H as [P E]. unfold weights_not_negative in P. rewrite forallb_app in P. apply andb_prop in P, E. destruct P as [P P'], E as [E E']. split.
  - apply diagonal_not_negative. apply form_not_negative with (1 := Span) (entries := g_entry) (sq := of_b); try assumption.
    intros; apply g_value; assumption.
  - apply form_not_negative with (1 := Span) (entries := m_entry) (sq := of_m); try assumption.
    intros; apply m_value; assumption.
Qed.

Definition symplectic_verdict : bool := pairings_short && all_pairs (fun k l => null (m_entry k l)).
Lemma delta_form g i j : (i < s)%nat -> (j < s)%nat ->
  form g (fun k => if (i =? k)%nat then 1 else 0) (fun k => if (j =? k)%nat then 1 else 0) = g i j.
Proof.
  intros Hi Hj. unfold form.
  assert (I : forall k, total s (fun l => (if (i =? k)%nat then 1 else 0) * g k l * (if (j =? l)%nat then 1 else 0))
              = (if (i =? k)%nat then 1 else 0) * g k j).
  { intro k. enough (G : forall r, total r (fun l => (if (i =? k)%nat then 1 else 0) * g k l * (if (j =? l)%nat then 1 else 0))
                        = if (j <? r)%nat then (if (i =? k)%nat then 1 else 0) * g k j else 0).
    { rewrite G. destruct (Nat.ltb_spec j s); [reflexivity|lia]. }
    induction r; [reflexivity|]. rewrite total_S, IHr.
    destruct (Nat.ltb_spec j r), (Nat.ltb_spec j (S r)), (Nat.eqb_spec j r); try lia; subst; ring. }
  rewrite (@total_ext s _ _ (fun k _ => I k)).
  enough (G : forall r, total r (fun k => (if (i =? k)%nat then 1 else 0) * g k j) = if (i <? r)%nat then g i j else 0).
  { rewrite G. destruct (Nat.ltb_spec i s); [reflexivity|lia]. }
  induction r; [reflexivity|]. rewrite total_S, IHr.
  destruct (Nat.ltb_spec i r), (Nat.ltb_spec i (S r)), (Nat.eqb_spec i r); try lia; subst; ring.
Qed.
Theorem symplectic_is_checked : symplectic_verdict = true -> symplectic.
Proof.
  unfold symplectic_verdict. intros H i j Hi Hj. apply andb_prop in H. destruct H as [S H].
  rewrite <- (delta_form m Hi Hj).
  destruct (Span (fun k => if (i =? k)%nat then 1 else 0)) as [x X].
  destruct (Span (fun k => if (j =? k)%nat then 1 else 0)) as [y Y].
  rewrite (@form_ext m _ _ _ _ X Y), form_left. apply total_zero. intros k Hk. rewrite form_right, (total_zero (n := n)); [ring|].
  intros l Hl. rewrite m_value by assumption. rewrite (value_null reals _ (all_pairs_at _ H Hk Hl)). cbn [zero reals]. ring.
Qed.

(** A combination of the basis on which M is negative: with the entries x. *)
Fixpoint total_entries (r : nat) (f : nat -> coefficient) : coefficient :=
  match r with O => q 0 | S r => plus (total_entries r f) (f r) end.
Lemma total_entries_value f r : val (total_entries r f) = total r (fun k => val (f k)).
Proof. induction r; [exact val_0|]. cbn [total_entries]. rewrite val_plus, IHr. reflexivity. Qed.
Definition form_at (g : nat -> nat -> coefficient) (x : list coefficient) : coefficient :=
  total_entries n (fun k => times d (at_place x k) (total_entries n (fun l => times d (at_place x l) (g k l)))).
Lemma form_at_value g entries x :
  (forall k l, (k < n)%nat -> (l < n)%nat -> form g (B k) (B l) = val (entries k l)) ->
  form g (combined n (fun k => val (at_place x k))) (combined n (fun k => val (at_place x k))) = val (form_at entries x).
Proof.
  intro G. rewrite form_left. unfold form_at. rewrite total_entries_value. apply total_ext. intros k Hk.
  rewrite val_times, form_right, total_entries_value. f_equal. apply total_ext. intros l Hl.
  rewrite val_times, G by assumption. reflexivity.
Qed.
Definition m_negative_verdict (x : list coefficient) : bool :=
  pairings_short && positive (minus (q 0) (form_at m_entry x)).
Theorem m_negative_is_checked x : m_negative_verdict x = true -> not_algebraically_stable.
Proof.
  unfold m_negative_verdict. intro H. apply andb_prop in H. destruct H as [S H]. apply positive_sound in H.
  rewrite val_minus, val_0 in H. right. exists (combined n (fun k => val (at_place x k))).
  rewrite (@form_at_value m m_entry) by (intros; apply m_value; assumption). lra.
Qed.
Definition b_negative_verdict (x : list coefficient) : bool :=
  pairings_short && positive (minus (q 0) (form_at g_entry x)).
Theorem b_negative_is_checked x : b_negative_verdict x = true -> not_algebraically_stable.
Proof.
  unfold b_negative_verdict. intro H. apply andb_prop in H. destruct H as [S H]. apply positive_sound in H.
  rewrite val_minus, val_0, <- (@form_at_value diagonal g_entry) in H by (intros; apply g_value; assumption).
  left. set (v := combined n (fun k => val (at_place x k))) in *. rewrite diagonal_form in H.
  assert (P : forall r, (exists i, (i < r)%nat /\ b T i < 0) \/ 0 <= total r (fun i => b T i * (v i * v i))).
  { induction r; [right; cbn; lra|]. destruct IHr as [[i [L I]]|I]; [left; exists i; split; [lia|exact I]|].
    destruct (Rlt_or_le (b T r) 0) as [L|L]; [left; exists r; split; [lia|exact L]|]. right. rewrite total_S. nra. }
  destruct (P s) as [E|E]; [exact E|lra].
Qed.
End Basis.
End Reals.

(** ** 11. The same for both kinds of tableaux *)

Section Kinds.
Variable d : Q.
Hypothesis d_positive : (0 <= d)%Q.
Open Scope R_scope.
Notation Re := (reals d_positive).
Notation total := (@sum d Re : nat -> (nat -> R) -> R).

(** Tables. *)
Lemma table_spans A b : spans (table Re A b) (@axes d Re) (length b).
Proof.
  intro v. exists v. intros i Hi. cbn [stages table] in Hi. unfold combined. rewrite <- (@sum_axes d Re (length b) v i Hi).
  apply total_ext. intros k _. unfold axes. rewrite Nat.eqb_sym. reflexivity.
Qed.
Definition table_algebraic (A : list (list coefficient)) (b : list coefficient) : squares -> squares -> bool :=
  algebraic_verdict d (length b) (columns A (length b)) b (pointwise d).
Theorem table_algebraic_is A b of_b of_m :
  table_algebraic A b of_b of_m = true -> algebraically_stable (table Re A b).
Proof. apply algebraic_is_checked with (1 := table_model Re A b) (2 := eq_refl) (3 := table_spans A b). Qed.
Definition table_m_negative (A : list (list coefficient)) (b x : list coefficient) : bool :=
  m_negative_verdict d (length b) (columns A (length b)) b (pointwise d) x.
Theorem table_m_negative_is A b x :
  table_m_negative A b x = true -> not_algebraically_stable (table Re A b).
Proof. apply m_negative_is_checked with (1 := table_model Re A b) (2 := eq_refl). Qed.
Definition table_b_negative (A : list (list coefficient)) (b x : list coefficient) : bool :=
  b_negative_verdict d (length b) (columns A (length b)) b (pointwise d) x.
Theorem table_b_negative_is A b x :
  table_b_negative A b x = true -> not_algebraically_stable (table Re A b).
Proof. exact (b_negative_is_checked (table_model Re A b) eq_refl x). Qed.
Definition table_symplectic (A : list (list coefficient)) (b : list coefficient) : bool :=
  symplectic_verdict d (length b) (columns A (length b)) b (pointwise d).
Theorem table_symplectic_is A b : table_symplectic A b = true -> symplectic (table Re A b).
Proof. apply symplectic_is_checked with (1 := table_model Re A b) (2 := eq_refl) (3 := table_spans A b). Qed.

(** Polynomials in distinct nodes: every stage vector is one (Newton's interpolation). *)
Definition distinct (n : nat) (c : nat -> R) : Prop := forall i j, (i < n)%nat -> (j < n)%nat -> c i = c j -> i = j.
Notation pow := (@power d Re : R -> nat -> R).
Definition poly (n : nat) (x : nat -> R) (t : R) : R := total n (fun k => x k * pow t k).
Definition shifted (x : nat -> R) (k : nat) : R := match k with O => 0 | S k => x k end.
Definition cut (n : nat) (x : nat -> R) (k : nat) : R := if (k <? n)%nat then x k else 0.
Lemma poly_shifted n x t : poly (S n) (shifted x) t = t * poly n x t.
Proof.
  unfold poly. induction n.
  - cbn. ring.
  - rewrite total_S, IHn, total_S. change (pow t (S n)) with (t * pow t n). cbn [shifted]. ring.
Qed.
Lemma poly_cut n x t : poly (S n) (cut n x) t = poly n x t.
Proof.
  unfold poly, cut. rewrite total_S, Nat.ltb_irrefl. rewrite Rmult_0_l, Rplus_0_r.
  apply total_ext. intros k H. destruct (Nat.ltb_spec k n); [reflexivity|lia].
Qed.
Lemma poly_combined n x y l t : poly n (fun k => x k + l * y k) t = poly n x t + l * poly n y t.
Proof. unfold poly. rewrite <- total_scale, <- total_add. apply total_ext. intros; ring. Qed.
Fixpoint nodal (c : nat -> R) (n : nat) (t : R) : R :=
  match n with O => 1 | S n => (t - c n) * nodal c n t end.
Lemma nodal_poly c n : exists y, forall t, poly (S n) y t = nodal c n t.
Proof.
  induction n as [|n [y Y]].
  - exists (fun _ => 1). intro t. cbn. ring.
  - exists (fun k => shifted y k + - c n * cut (S n) y k). intro t.
    rewrite poly_combined, poly_shifted, poly_cut, Y. cbn [nodal]. ring.
Qed.
Lemma nodal_zero c n i : (i < n)%nat -> nodal c n (c i) = 0.
Proof.
  induction n; intro H; [lia|]. cbn [nodal]. destruct (Nat.eq_dec i n) as [->|E]; [ring|]. rewrite IHn by lia. ring.
Qed.
Lemma nodal_not_zero c n t : (forall i, (i < n)%nat -> t <> c i) -> nodal c n t <> 0.
Proof.
  induction n; intro H; cbn [nodal]; [lra|]. apply Rmult_integral_contrapositive_currified; [|apply IHn; auto].
  intro E. apply (H n); [lia|lra].
Qed.
Lemma interpolation n c v : distinct n c -> exists x, forall i, (i < n)%nat -> v i = poly n x (c i).
Proof.
  induction n as [|n IH]; intro D; [exists (fun _ => 0); intros; lia|].
  destruct IH as [x X]. { intros i j Hi Hj. apply D; lia. }
  destruct (nodal_poly c n) as [y Y].
  assert (W : nodal c n (c n) <> 0).
  { apply nodal_not_zero. intros i Hi E. apply (D n i) in E; lia. }
  exists (fun k => cut n x k + (v n - poly n x (c n)) / nodal c n (c n) * y k). intros i Hi.
  rewrite poly_combined, poly_cut, Y. destruct (Nat.eq_dec i n) as [->|E]; [field; exact W|].
  rewrite (@nodal_zero c n i) by lia. rewrite X by lia. ring.
Qed.
(** A polynomial with n coefficients and n different zeros is 0, so that Lagrange's interpolation gives a polynomial back. *)
Lemma division n (r : R) : forall g : nat -> R, exists (h : nat -> R) (e : R), forall k, (k < S n)%nat ->
  g k = shifted h k + - r * cut n h k + (if (k =? 0)%nat then e else 0).
Proof.
  induction n; intro g.
  - exists (fun _ => 0), (g 0%nat). intros [|k] K; [cbn; lra|lia].
  - destruct (IHn (fun k => if (k =? n)%nat then g n + r * g (S n) else g k)) as [h [e H]].
    exists (fun k => if (k =? n)%nat then g (S n) else h k), e. intros k K. unfold cut in *.
    destruct (Nat.eq_dec k (S n)) as [->|E].
    + cbn [shifted Nat.eqb]. rewrite Nat.eqb_refl, Nat.ltb_irrefl. cbn. lra.
    + specialize (H k ltac:(lia)).
      replace (shifted (fun k => if (k =? n)%nat then g (S n) else h k) k) with (shifted h k).
      2: { destruct k as [|k]; cbn [shifted]; [reflexivity|]. destruct (Nat.eqb_spec k n); [lia|reflexivity]. }
      destruct (Nat.ltb_spec k (S n)); [|lia]. destruct (Nat.eqb_spec k n) as [E'|E'].
      * rewrite E' in *. rewrite Nat.ltb_irrefl in H. lra.
      * destruct (Nat.ltb_spec k n); [|lia]. exact H.
Qed.
Lemma poly_first n e t : poly (S n) (fun k => if (k =? 0)%nat then e else 0) t = e.
Proof.
  unfold poly. induction n; [cbn; lra|]. rewrite total_S, IHn. cbn. lra.
Qed.
Lemma poly_ext n x y t : (forall k, (k < n)%nat -> x k = y k) -> poly n x t = poly n y t.
Proof. intro H. apply total_ext. intros k K. rewrite H by exact K. reflexivity. Qed.
Lemma zero_polynomial n c : distinct n c -> forall g, (forall i, (i < n)%nat -> poly n g (c i) = 0) ->
  forall k, (k < n)%nat -> g k = 0.
Proof.
  induction n as [|n IH]; intros D g Z k K; [lia|].
  destruct (division n (c n) g) as [h [e H]].
  assert (V : forall t, poly (S n) g t = (t - c n) * poly n h t + e).
  { intro t. rewrite (@poly_ext (S n) g (fun k => 1 * (shifted h k + - c n * cut n h k) + 1 * (if (k =? 0)%nat then e else 0)))
      by (intros l L; rewrite (H l L); ring).
    rewrite (@poly_ext (S n) _ (fun k => (shifted h k + - c n * cut n h k) + 1 * (if (k =? 0)%nat then e else 0))) by (intros; ring).
    rewrite (poly_combined (S n) (fun k => shifted h k + - c n * cut n h k)), poly_combined, poly_shifted, poly_cut, poly_first. ring. }
  assert (E : e = 0). { pose proof (Z n ltac:(lia)) as X. rewrite V in X. lra. }
  assert (Hz : forall l, (l < n)%nat -> h l = 0).
  { apply IH; [intros i j Hi Hj; apply D; lia|]. intros i Hi. pose proof (Z i ltac:(lia)) as X. rewrite V, E in X.
    assert (c i <> c n) by (intro Y; apply D in Y; lia).
    apply Rmult_eq_reg_l with (c i - c n); lra. }
  rewrite (H k K), E. unfold cut. replace (shifted h k) with 0 by (destruct k as [|k]; cbn [shifted]; [reflexivity|rewrite Hz by lia; reflexivity]).
  destruct (Nat.ltb_spec k n); [rewrite (Hz k) by assumption|]; destruct (k =? 0)%nat; lra.
Qed.
Lemma finite_choice (X : Type) (x : X) n (P : nat -> X -> Prop) : (forall j, (j < n)%nat -> exists y, P j y) ->
  exists f, forall j, (j < n)%nat -> P j (f j).
Proof.
  induction n as [|n IH]; intro H; [exists (fun _ => x); intros; lia|].
  destruct IH as [f F]; [intros; apply H; lia|]. destruct (H n ltac:(lia)) as [y Y].
  exists (fun j => if (j =? n)%nat then y else f j). intros j J. destruct (Nat.eqb_spec j n) as [->|E]; [exact Y|apply F; lia].
Qed.
Lemma lagrange n c : distinct n c -> exists L : nat -> nat -> R, forall k l, (k < n)%nat -> (l < n)%nat ->
  total n (fun j => L j k * pow (c j) l) = if (k =? l)%nat then 1 else 0.
Proof.
  intro D. destruct (@finite_choice (nat -> R) (fun _ => 0) n (fun j x => forall i, (i < n)%nat ->
    poly n x (c i) = if (i =? j)%nat then 1 else 0)) as [L HL].
  { intros j _. destruct (interpolation (fun i => if (i =? j)%nat then 1 else 0) D) as [x X]. exists x. intros i Hi. symmetry. apply X, Hi. }
  exists L. intros k l Hk Hl.
  set (g := fun k => total n (fun j => L j k * pow (c j) l) - if (k =? l)%nat then 1 else 0).
  enough (G : g k = 0) by (unfold g in G; lra). apply (@zero_polynomial n c D g); [|exact Hk]. intros i Hi.
  unfold g, poly.
  rewrite (@total_ext d d_positive n _ (fun k => total n (fun j => pow (c j) l * (L j k * pow (c i) k)) + - ((if (k =? l)%nat then 1 else 0) * pow (c i) k))).
  2: { intros r _. rewrite (@total_ext d d_positive n (fun j => pow (c j) l * _) (fun j => pow (c i) r * (L j r * pow (c j) l))) by (intros; ring).
       rewrite total_scale. ring. }
  rewrite total_add, total_swap.
  rewrite (@total_ext d d_positive n (fun j => total n _) (fun j => pow (c j) l * (if (i =? j)%nat then 1 else 0))).
  2: { intros j Hj. rewrite total_scale. f_equal. exact (HL j Hj i Hi). }
  assert (S1 : forall v (f : nat -> R) p, (p < v)%nat -> total v (fun j => f j * (if (p =? j)%nat then 1 else 0)) = f p).
  { intros v f p. induction v; intro Hp; [lia|]. rewrite total_S. destruct (Nat.eqb_spec p v) as [->|E].
    - rewrite total_zero; [lra|]. intros r Hr. destruct (Nat.eqb_spec v r); [lia|lra].
    - rewrite IHv by lia. lra. }
  rewrite S1 by exact Hi.
  rewrite (@total_ext d d_positive n (fun k => - _) (fun k => (- pow (c i) k) * (if (l =? k)%nat then 1 else 0))).
  2: { intros r _. rewrite (Nat.eqb_sym r l). destruct (l =? r)%nat; lra. }
  rewrite S1 by exact Hl. lra.
Qed.
Lemma powers_span (T : tableau Re) c : distinct (stages T) c -> spans T (@powers d Re c) (stages T).
Proof. intros D v. exact (interpolation (n := stages T) (c := c) v D). Qed.

Section Polynomials.
Variable T : tableau Re.
Variable c : nat -> R.
Variables (N : list coefficient) (alpha : list (list coefficient)) (beta : list coefficient).
Hypothesis H : acts T c N alpha beta.
Hypothesis D : distinct (stages T) c.
Definition lengths : bool := (length alpha =? length beta)%nat && (length N =? length beta)%nat.
Lemma lengths_model : lengths = true -> model T (@powers d Re c) alpha beta [q 1] (times_modulo d N).
Proof.
  unfold lengths. intro L. apply andb_prop in L. destruct L as [L L']. apply Nat.eqb_eq in L, L'.
  exact (acts_model L L' H).
Qed.
Lemma lengths_span : spans T (@powers d Re c) (length beta).
Proof. rewrite <- (number_of_stages H). apply powers_span, D. Qed.
Definition acts_algebraic (of_b of_m : squares) : bool :=
  lengths && algebraic_verdict d (length beta) alpha beta (times_modulo d N) of_b of_m.
Theorem acts_algebraic_is of_b of_m : acts_algebraic of_b of_m = true -> algebraically_stable T.
Proof.
  intro E. apply andb_prop in E. destruct E as [L E].
  exact (algebraic_is_checked (lengths_model L) eq_refl lengths_span _ _ E).
Qed.
Definition acts_m_negative (x : list coefficient) : bool :=
  lengths && m_negative_verdict d (length beta) alpha beta (times_modulo d N) x.
Theorem acts_m_negative_is x : acts_m_negative x = true -> not_algebraically_stable T.
Proof.
  intro E. apply andb_prop in E. destruct E as [L E]. exact (m_negative_is_checked (lengths_model L) eq_refl _ E).
Qed.
Definition acts_b_negative (x : list coefficient) : bool :=
  lengths && b_negative_verdict d (length beta) alpha beta (times_modulo d N) x.
Theorem acts_b_negative_is x : acts_b_negative x = true -> not_algebraically_stable T.
Proof.
  intro E. apply andb_prop in E. destruct E as [L E]. exact (b_negative_is_checked (lengths_model L) eq_refl _ E).
Qed.
Definition acts_symplectic : bool := lengths && symplectic_verdict d (length beta) alpha beta (times_modulo d N).
Theorem acts_symplectic_is : acts_symplectic = true -> symplectic T.
Proof.
  intro E. apply andb_prop in E. destruct E as [L E].
  exact (symplectic_is_checked (lengths_model L) eq_refl lengths_span E).
Qed.
End Polynomials.
End Kinds.

(** ** 12. Stiff accuracy and symmetry of tables *)

Open Scope nat_scope.
Section Structure.
Variable d : Q.
Variable F : field d.
(** The last stage is the step: y_1 = Y_s. *)
Definition stiffly_accurate (T : tableau F) : Prop :=
  exists i, stages T = S i /\ forall j, j < stages T -> a T i j = b T j.
(** The method is its own adjoint. *)
Definition symmetric (T : tableau F) : Prop := forall i j, i < stages T -> j < stages T ->
  b T (stages T - 1 - j) = b T j /\ add F (a T (stages T - 1 - i) (stages T - 1 - j)) (a T i j) = b T j.
Definition equal (x y : coefficient) : bool := null (minus d x y).
Lemma equal_value x y : equal x y = true -> value F x = value F y.
Proof.
  unfold equal, minus. intro E. apply (value_null F) in E. rewrite value_plus, value_times, value_q in E.
  change (-1)%Q with (- (1))%Q in E. rewrite rat_opp, rat_one in E.
  Add Ring F_ring' : (is_ring F).
  transitivity (add F (add F (value F x) (mul F (opp F (one F)) (value F y))) (value F y)); [ring|]. rewrite E; ring.
Qed.
Definition cell (A : list (list coefficient)) (i j : nat) : coefficient := nth j (nth i A []) (q 0).
Definition table_stiff (A : list (list coefficient)) (b : list coefficient) : bool :=
  (0 <? length b) && forallb (fun j => equal (cell A (length b - 1) j) (nth j b (q 0))) (seq 0 (length b)).
Theorem table_stiff_is A b : table_stiff A b = true -> stiffly_accurate (table F A b).
Proof.
  unfold table_stiff. intro E. apply andb_prop in E. destruct E as [L E]. apply Nat.ltb_lt in L.
  exists (length b - 1). cbn [stages table]. split; [lia|]. intros j Hj. rewrite forallb_forall in E.
  apply equal_value, (E j), in_seq. lia.
Qed.
Definition table_symmetric (A : list (list coefficient)) (b : list coefficient) : bool :=
  let n := length b in
  forallb (fun i => forallb (fun j =>
    equal (nth (n - 1 - j) b (q 0)) (nth j b (q 0)) &&
    equal (plus (cell A (n - 1 - i) (n - 1 - j)) (cell A i j)) (nth j b (q 0))) (seq 0 n)) (seq 0 n).
Theorem table_symmetric_is A b : table_symmetric A b = true -> symmetric (table F A b).
Proof.
  unfold table_symmetric. intros E i j Hi Hj. cbn [stages table] in *. rewrite forallb_forall in E.
  specialize (E i (proj2 (in_seq _ _ _) (conj (Nat.le_0_l i) Hi))). rewrite forallb_forall in E.
  specialize (E j (proj2 (in_seq _ _ _) (conj (Nat.le_0_l j) Hj))). apply andb_prop in E. destruct E as [E E'].
  apply equal_value in E, E'. split; [exact E|]. rewrite value_plus in E'. exact E'.
Qed.
End Structure.

(** ** 13. The nodes: real, distinct, in [0, 1] *)

From Coq Require Import Ranalysis.
Section Nodes.
Variable d : Q.
Hypothesis d_positive : (0 <= d)%Q.
Open Scope R_scope.
Notation Re := (reals d_positive).
Notation total := (@sum d Re : nat -> (nat -> R) -> R).
Notation pow := (@power d Re : R -> nat -> R).
(** x^s - N has as many different zeros in [0, 1] as its degree: all that it has. *)
Definition has_nodes (N : list coefficient) : Prop := exists c : nat -> R,
  distinct (length N) c /\ forall i, (i < length N)%nat ->
    0 <= c i <= 1 /\ power Re (c i) (length N) = polynomial Re N (c i).
Definition whole_of (N : list coefficient) : list coefficient := map (times d (q (-1))) N ++ [q 1].
Fixpoint at_rational (p : list coefficient) (x : Q) : coefficient :=
  match p with [] => q 0 | e :: p => plus e (times d (q x) (at_rational p x)) end.
(** Brackets one right of the other, at whose ends the polynomial has not the same sign. *)
Fixpoint brackets (p : list coefficient) (before : Q) (l : list (Q * Q)) : bool :=
  match l with
  | [] => true
  | (x, y) :: l =>
    negb (Qle_bool x before) && Qle_bool 0 x && Qle_bool x y && Qle_bool y 1
    && not_negative d (minus d (q 0) (times d (at_rational p x) (at_rational p y))) && brackets p y l
  end.
Definition nodes_verdict (N : list coefficient) (l : list (Q * Q)) : bool :=
  (length l =? length N)%nat && brackets (whole_of N) (-1) l.

Lemma at_rational_value p x : value Re (at_rational p x) = polynomial Re p (Q2R x).
Proof.
  induction p as [|e p IH]; cbn [at_rational polynomial]; [apply (value_zero Re)|].
  rewrite value_plus, value_times, IH, (value_q Re). reflexivity.
Qed.
Lemma polynomial_continuous p : continuity (fun t => polynomial Re p t : R).
Proof.
  induction p as [|e p IH]; cbn [polynomial].
  - apply continuity_const; intros x y; reflexivity.
  - apply (continuity_plus (fun _ => value Re e : R) (fun t => t * polynomial Re p t)).
    + apply continuity_const; intros x y; reflexivity.
    + apply (continuity_mult (fun t => t) (fun t => polynomial Re p t : R)); [|exact IH].
      apply derivable_continuous, derivable_id.
Qed.
Lemma brackets_zeros p l : forall before, brackets p before l = true -> exists c : nat -> R,
  (forall i, (i < length l)%nat -> Q2R before < c i /\ 0 <= c i <= 1 /\ polynomial Re p (c i) = 0) /\
  (forall i j, (i < j < length l)%nat -> c i < c j).
Proof.
  induction l as [|[x y] l IH]; intros before H; cbn [brackets] in H.
  - exists (fun _ => 0). split; intros; cbn in *; lia.
  - apply andb_prop in H. destruct H as [H R']. apply andb_prop in H. destruct H as [H S].
    apply andb_prop in H. destruct H as [H Y]. apply andb_prop in H. destruct H as [H L].
    apply andb_prop in H. destruct H as [B X]. apply Qle_bool_R in X, L, Y.
    assert (B' : Q2R before < Q2R x).
    { apply Qlt_Rlt, Qnot_le_lt. intro E. apply Qle_bool_iff in E. rewrite E in B. discriminate. }
    apply (not_negative_sound d_positive) in S. rewrite val_minus, val_times in S.
    rewrite !at_rational_value, (value_zero Re) in S. cbn [zero reals] in S.
    replace (Q2R 0) with 0 in X by (unfold Q2R; simpl; lra). replace (Q2R 1) with 1 in Y by (unfold Q2R; simpl; lra).
    destruct (IVT_cor _ (Q2R x) (Q2R y) (polynomial_continuous p) L) as [r [[A A'] Z]]; [lra|].
    destruct (IH y R') as [c [C C']].
    exists (fun k => match k with O => r | S k => c k end). split.
    + intros [|i] Hi; [repeat split; lra|]. destruct (C i) as [C1 [C2 C3]]; [cbn in Hi; lia|].
      repeat split; lra.
    + intros [|i] [|j] Hij; cbn [length] in Hij; try lia.
      * destruct (C j) as [C1 _]; [lia|]. lra.
      * apply C'. lia.
Qed.
Lemma whole_of_value N t : polynomial Re (whole_of N) t = power Re t (length N) - polynomial Re N t.
Proof.
  unfold whole_of. induction N as [|e N IH]; cbn [map app polynomial length power].
  - rewrite (value_one Re). cbn. lra.
  - rewrite IH, value_times, (value_q Re). cbn [add mul rat reals]. replace (Q2R (-1)) with (-1) by (unfold Q2R; simpl; lra). lra.
Qed.
Theorem nodes_are_checked N l : nodes_verdict N l = true -> has_nodes N.
Proof.
  unfold nodes_verdict. intro H. apply andb_prop in H. destruct H as [L H]. apply Nat.eqb_eq in L.
  destruct (brackets_zeros _ _ _ H) as [c [C C']]. rewrite L in *. exists c. split.
  - intros i j Hi Hj E. destruct (Nat.lt_trichotomy i j) as [G|[G|G]]; [|exact G|].
    + specialize (C' i j ltac:(lia)). lra.
    + specialize (C' j i ltac:(lia)). lra.
  - intros i Hi. destruct (C i Hi) as [_ [C2 C3]]. split; [exact C2|]. rewrite whole_of_value in C3. lra.
Qed.
(** Such tableaux exist, so that what is stated of all of them is said of one at least: rows are combinations of Lagrange's
    polynomials. *)
Theorem acts_exists N alpha beta : has_nodes N -> length N = length beta ->
  exists (T : tableau Re) (c : nat -> R), acts T c N alpha beta /\ distinct (stages T) c
    /\ forall i, (i < stages T)%nat -> 0 <= c i <= 1.
Proof.
  intros [c [D H]] E. destruct (lagrange d_positive D) as [L HL]. set (n := length N) in *.
  pose (p := fun k i => polynomial Re (nth k alpha []) (c i) : R). pose (w := fun k => value Re (nth k beta (q 0)) : R).
  exists {| stages := n; a := fun i j => total n (fun k => p k i * L j k) : Re; b := fun j => total n (fun k => w k * L j k) : Re |}, c.
  assert (S1 : forall (f : nat -> R) l, (l < n)%nat -> total n (fun j => total n (fun k => f k * L j k) * pow (c j) l) = f l).
  { intros f l Hl. rewrite (@total_ext d d_positive n _ (fun j => total n (fun k => f k * (L j k * pow (c j) l)))).
    2: { intros j _. rewrite (Rmult_comm _ (pow (c j) l)), <- total_scale. apply total_ext. intros; ring. }
    rewrite total_swap. rewrite (@total_ext d d_positive n _ (fun k => f k * (if (l =? k)%nat then 1 else 0))).
    2: { intros k Hk. rewrite total_scale, HL by assumption. rewrite Nat.eqb_sym. reflexivity. }
    assert (S2 : forall v, (l < v)%nat -> total v (fun k => f k * (if (l =? k)%nat then 1 else 0)) = f l); [|apply S2, Hl].
    induction v; intro Hm; [lia|]. rewrite total_S. destruct (Nat.eqb_spec l v) as [->|Em].
    - rewrite total_zero; [lra|]. intros r Hr. destruct (Nat.eqb_spec v r); [lia|lra].
    - rewrite IHv by lia. lra. }
  split; [|split; [exact D|intros i Hi; apply H, Hi]]. split; cbn [stages a b].
  - exact E.
  - intros i Hi. apply H, Hi.
  - intros i k Hi Hk. exact (S1 (fun k => p k i) k Hk).
  - intros k Hk. exact (S1 w k Hk).
Qed.
Theorem collocation_exists N : has_nodes N ->
  exists (T : tableau Re) (c : nat -> R), collocation T c N /\ distinct (stages T) c
    /\ forall i, (i < stages T)%nat -> 0 <= c i <= 1.
Proof.
  intro H. destruct (@acts_exists N (integrals d N) (inverses (length N)) H) as [T [c [A [D I]]]].
  { unfold inverses. rewrite map_length, seq_length. reflexivity. }
  exists T, c. split; [exact (acts_collocation A)|split; assumption].
Qed.
End Nodes.
Open Scope nat_scope.
