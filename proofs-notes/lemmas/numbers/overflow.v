(* Lemma clip-interval (proofs-notes/rounding.md), its "range of doubles": with IEEE's binary64, largest number and infinities
   included, a usable error bound means that nothing has overflowed that counts, so that delta_error.v and clip_interval.v,
   which know no largest double, say what the kernels compute. fast/cell.hpp, error_bound; fast/cell.cpp, open_leaf. *)

From Coq Require Import Reals Psatz Bool.
From Flocq Require Import Core IEEE754.BinarySingleNaN.
From Groundtruth Require Import doubles delta_error clip_interval.
Open Scope R_scope.

Notation double := (binary_float 53 1024).
#[local] Instance some_bits : Prec_gt_0 53 := eq_refl.
#[local] Instance some_range : Prec_lt_emax 53 1024 := eq_refl.

Definition add : double -> double -> double := Bplus mode_NE.
Definition sub : double -> double -> double := Bminus mode_NE.
Definition mul : double -> double -> double := Bmult mode_NE.
Definition div : double -> double -> double := Bdiv mode_NE.
Definition finite (x : double) := is_finite x = true.
Notation value := (@B2R 53 1024).

Lemma infinity_is_not_finite : forall (x : double) s, B2SF x = SpecFloat.S754_infinity s -> ~ finite x.
Proof. intros x s e f. destruct x; simpl in *; discriminate. Qed.

Lemma value_is_double : forall x : double, is_double (value x).
Proof. intros x. exact (generic_format_B2R 53 1024 x). Qed.

(* Finite results come from finite numbers, and are what the lemmas say. *)
Lemma finite_sum : forall x y, finite (add x y) -> finite x /\ finite y /\ value (add x y) = fl (value x + value y).
Proof.
  intros x y f. assert (finite x /\ finite y) as (fx & fy).
  { unfold finite in *. destruct x as [ | [ | ] | | ], y as [ | [ | ] | | ]; simpl in *; auto; discriminate. }
  pose proof (Bplus_correct 53 1024 _ _ mode_NE x y fx fy) as c. destruct (Rlt_bool _ _); [tauto |].
  destruct c as (c & _). now apply infinity_is_not_finite in c.
Qed.

Lemma finite_product : forall x y, finite (mul x y) -> finite x /\ finite y /\ value (mul x y) = fl (value x * value y).
Proof.
  intros x y f. assert (finite x /\ finite y) as (fx & fy).
  { unfold finite in *. destruct x, y; simpl in *; auto; discriminate. }
  pose proof (Bmult_correct 53 1024 _ _ mode_NE x y) as c. destruct (Rlt_bool _ _); [tauto |].
  now apply infinity_is_not_finite in c.
Qed.

(* And results that are not too large are finite. *)
Lemma below_largest : forall x k, (-1074 <= k < 1024)%Z -> Rabs x <= bpow radix2 k -> Rlt_bool (Rabs (fl x)) (bpow radix2 1024) = true.
Proof.
  intros x k range le. apply Rlt_bool_true. apply Rle_lt_trans with (bpow radix2 k); [| apply bpow_lt; lia].
  apply abs_round_le_generic; [now apply FLT_exp_valid | apply valid_rnd_N | now apply power_is_double | assumption].
Qed.

Lemma sum_within : forall x y k, finite x -> finite y -> (-1074 <= k < 1024)%Z -> Rabs (value x + value y) <= bpow radix2 k ->
  finite (add x y) /\ value (add x y) = fl (value x + value y).
Proof.
  intros x y k fx fy range le. pose proof (Bplus_correct 53 1024 _ _ mode_NE x y fx fy) as c.
  change (Rabs (round _ _ _ _)) with (Rabs (fl (value x + value y))) in c. rewrite (below_largest _ k range le) in c. tauto.
Qed.

Lemma difference_within : forall x y k, finite x -> finite y -> (-1074 <= k < 1024)%Z -> Rabs (value x - value y) <= bpow radix2 k ->
  finite (sub x y) /\ value (sub x y) = fl (value x - value y).
Proof.
  intros x y k fx fy range le. pose proof (Bminus_correct 53 1024 _ _ mode_NE x y fx fy) as c.
  change (Rabs (round _ _ _ _)) with (Rabs (fl (value x - value y))) in c. rewrite (below_largest _ k range le) in c. tauto.
Qed.

Lemma product_within : forall x y k, finite x -> finite y -> (-1074 <= k < 1024)%Z -> Rabs (value x * value y) <= bpow radix2 k ->
  finite (mul x y) /\ value (mul x y) = fl (value x * value y).
Proof.
  intros x y k fx fy range le. pose proof (Bmult_correct 53 1024 _ _ mode_NE x y) as c.
  change (Rabs (round _ _ _ _)) with (Rabs (fl (value x * value y))) in c. rewrite (below_largest _ k range le) in c.
  unfold finite in *. rewrite fx, fy in c. tauto.
Qed.

(* Magnitudes, or not a number: sums and products of them are never below 0, so that "less than" excludes all but the finite. *)
Definition a_size (x : double) := is_nan x = true \/ Bsign x = false.

Lemma size_of_infinity : forall (x : double), B2SF x = SpecFloat.S754_infinity false -> a_size x.
Proof. intros x e. right. destruct x; simpl in *; try discriminate; now injection e. Qed.

Lemma size_value : forall x, Bsign x = false -> 0 <= value x.
Proof. intros x s. destruct x; simpl in *; try lra. subst. now apply F2R_ge_0. Qed.

Lemma size_sum : forall x y, a_size x -> a_size y -> a_size (add x y).
Proof.
  intros x y [nx | sx] [ny | sy]; try (left; destruct x, y; simpl in *; discriminate || reflexivity).
  destruct (is_finite x) eqn:fx, (is_finite y) eqn:fy.
  - pose proof (Bplus_correct 53 1024 _ _ mode_NE x y fx fy) as c. pose proof (size_value x sx). pose proof (size_value y sy).
    destruct (Rlt_bool _ _).
    + destruct c as (_ & _ & c). right. unfold add. rewrite c, sx. destruct (Rcompare_spec (value x + value y) 0); trivial. lra.
    + destruct c as (c & _). rewrite sx in c. now apply size_of_infinity.
  - right. destruct x, y; simpl in *; subst; discriminate || reflexivity.
  - right. destruct x, y; simpl in *; subst; discriminate || reflexivity.
  - destruct x, y; simpl in *; subst; discriminate || (right; reflexivity) || (left; reflexivity).
Qed.

Lemma size_product : forall x y, a_size x -> a_size y -> a_size (mul x y).
Proof.
  intros x y [nx | sx] [ny | sy]; try (left; destruct x, y; simpl in *; discriminate || reflexivity).
  pose proof (Bmult_correct 53 1024 _ _ mode_NE x y) as c. fold (mul x y) in c. rewrite sx, sy in c. destruct (Rlt_bool _ _).
  - destruct c as (_ & _ & c). destruct (is_nan (mul x y)) eqn:e; [now left | right; now apply c].
  - now apply size_of_infinity.
Qed.

Lemma less_is_finite : forall x b, a_size x -> finite b -> Bltb x b = true -> finite x /\ value x < value b.
Proof.
  intros x b s fb less. assert (finite x) as fx.
  { unfold finite in *. destruct s as [n | s], x as [ | [ | ] | | ], b; simpl in *; discriminate || reflexivity. }
  split; [assumption |]. rewrite (Bltb_correct 53 1024 x b fx fb) in less. revert less. now case Rlt_bool_spec.
Qed.

Section Bound.

(* Probe::error_bound; the constants are doubles. *)
Variables per_size_ per_error_ floor_ per_floor_ greatest N D X e : double.
Hypotheses (c1 : value per_size_ = per_size) (c2 : value per_error_ = per_coordinate_error) (c3 : value floor_ = error_floor)
  (c4 : value per_floor_ = error_per_normal_floor) (c5 : value greatest = greatest_usable_error) (greatest_finite : finite greatest).
Hypotheses (s1 : a_size per_size_) (s2 : a_size per_error_) (s3 : a_size floor_) (s4 : a_size per_floor_).
Hypotheses (sN : a_size N) (sD : a_size D) (sX : a_size X) (se : a_size e).

Let E := add (mul N (add (mul per_size_ X) (add (mul per_error_ e) per_floor_))) (add (mul per_size_ D) floor_).

Theorem usable_error_did_not_overflow : Bltb E greatest = true ->
  (finite N /\ finite D /\ finite X /\ finite e) /\ finite E /\ value E = error_bound (value N) (value D) (value X) (value e)
  /\ value E < greatest_usable_error.
Proof.
  intros usable. assert (a_size E) as sE by (repeat (apply size_sum || apply size_product); assumption).
  destruct (less_is_finite E greatest sE greatest_finite usable) as (fE & less). rewrite c5 in less.
  destruct (finite_sum _ _ fE) as (f1 & f2 & v). destruct (finite_product _ _ f1) as (fN & f3 & v1). destruct (finite_sum _ _ f2) as (f4 & f5 & v2).
  destruct (finite_product _ _ f4) as (_ & fD & v4). destruct (finite_sum _ _ f3) as (f6 & f7 & v3). destruct (finite_product _ _ f6) as (_ & fX & v6).
  destruct (finite_sum _ _ f7) as (f8 & _ & v7). destruct (finite_product _ _ f8) as (_ & fe & v8).
  repeat split; try assumption. unfold E. rewrite v, v1, v2, v3, v4, v6, v7, v8, c1, c2, c3, c4. reflexivity.
Qed.

(* Then sizes are far from the largest double. *)
Lemma usable_sizes : value E = error_bound (value N) (value D) (value X) (value e) -> value E < greatest_usable_error ->
  0 <= value N -> 0 <= value D -> 0 <= value X -> 0 <= value e -> value N * value X + value D <= bpow radix2 949.
Proof.
  intros v less HN HD HX He. pose proof (error_bound_at_least _ _ _ _ HN HD HX He) as least. rewrite v in less.
  assert (0 <= value N * value e) by now apply Rmult_le_pos. assert (0 < error_floor) by apply bpow_gt_0. unfold greatest_usable_error in less.
  change 949%Z with (900 + 49)%Z. rewrite bpow_plus. assert (bpow radix2 49 = 562949953421312) as -> by (simpl; lra).
  pose proof (bpow_gt_0 radix2 900). unfold u in *; lra.
Qed.
End Bound.

Lemma fl_within : forall x k, (-1074 <= k)%Z -> Rabs x <= bpow radix2 k -> Rabs (fl x) <= bpow radix2 k.
Proof. intros. apply abs_round_le_generic; [now apply FLT_exp_valid | apply valid_rnd_N | now apply power_is_double | assumption]. Qed.

Lemma doubled : forall k, bpow radix2 (k + 1) = 2 * bpow radix2 k.
Proof. intros. rewrite bpow_plus. change (bpow radix2 1) with 2. ring. Qed.

Section Delta.

Variables n1 n2 n3 d x1 x2 x3 : double.
Variables N D X : R.
Hypotheses (fn1 : finite n1) (fn2 : finite n2) (fn3 : finite n3) (fd : finite d) (fx1 : finite x1) (fx2 : finite x2) (fx3 : finite x3).
Hypotheses (N_is : Rabs (value n1) + Rabs (value n2) + Rabs (value n3) <= N) (D_is : Rabs (value d) <= D).
Hypotheses (X1 : Rabs (value x1) <= X) (X2 : Rabs (value x2) <= X) (X3 : Rabs (value x3) <= X).
Hypothesis sizes : N * X + D <= bpow radix2 949.

Let a := sub (add (add (mul n1 x1) (mul n2 x2)) (mul n3 x3)) d.

Theorem delta_does_not_overflow :
  finite a /\ value a = computed_delta (value n1) (value n2) (value n3) (value d) (value x1) (value x2) (value x3) /\ Rabs (value a) <= bpow radix2 952.
Proof.
  pose proof (Rabs_pos (value n1)). pose proof (Rabs_pos (value n2)). pose proof (Rabs_pos (value n3)). pose proof (Rabs_pos (value x1)). pose proof (Rabs_pos (value d)).
  assert (0 <= N * X) by (apply Rmult_le_pos; lra).
  assert (forall n x, Rabs (value n) <= N -> Rabs (value x) <= X -> Rabs (value n * value x) <= bpow radix2 949) as product.
  { intros n x Hn Hx. rewrite Rabs_mult. apply Rle_trans with (N * X); [apply Rmult_le_compat; trivial; apply Rabs_pos | lra]. }
  destruct (product_within n1 x1 949 fn1 fx1 ltac:(lia) (product n1 x1 ltac:(lra) X1)) as (f1 & v1).
  destruct (product_within n2 x2 949 fn2 fx2 ltac:(lia) (product n2 x2 ltac:(lra) X2)) as (f2 & v2).
  destruct (product_within n3 x3 949 fn3 fx3 ltac:(lia) (product n3 x3 ltac:(lra) X3)) as (f3 & v3).
  pose proof (fl_within _ 949 ltac:(lia) (product n1 x1 ltac:(lra) X1)) as p1. pose proof (fl_within _ 949 ltac:(lia) (product n2 x2 ltac:(lra) X2)) as p2.
  pose proof (fl_within _ 949 ltac:(lia) (product n3 x3 ltac:(lra) X3)) as p3. rewrite <- v1 in p1. rewrite <- v2 in p2. rewrite <- v3 in p3.
  pose proof (doubled 949) as e1. pose proof (doubled 950) as e2. pose proof (doubled 951) as e3. simpl Z.add in e1, e2, e3. pose proof (bpow_gt_0 radix2 949).
  assert (Rabs (value (mul n1 x1) + value (mul n2 x2)) <= bpow radix2 950) as q1 by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  destruct (sum_within _ _ 950 f1 f2 ltac:(lia) q1) as (f4 & v4). pose proof (fl_within _ 950 ltac:(lia) q1) as q1'. rewrite <- v4 in q1'.
  assert (Rabs (value (add (mul n1 x1) (mul n2 x2)) + value (mul n3 x3)) <= bpow radix2 951) as q2 by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  destruct (sum_within _ _ 951 f4 f3 ltac:(lia) q2) as (f5 & v5). pose proof (fl_within _ 951 ltac:(lia) q2) as q2'. rewrite <- v5 in q2'.
  assert (Rabs (value (add (add (mul n1 x1) (mul n2 x2)) (mul n3 x3)) - value d) <= bpow radix2 952) as q3.
  { unfold Rminus. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp. lra. }
  destruct (difference_within _ _ 952 f5 fd ltac:(lia) q3) as (f6 & v6). pose proof (fl_within _ 952 ltac:(lia) q3) as q3'. rewrite <- v6 in q3'.
  fold a in f6, v6, q3'. repeat split; try assumption. rewrite v6, v5, v4, v1, v2, v3. reflexivity.
Qed.
End Delta.

(* open_leaf: its slope, inverse and margin are finite; the middle may be infinite, beyond [0, 1] on its side. *)
Theorem crossing_overflows_on_its_side : forall a b E one, finite a -> finite b -> finite E -> finite one -> value one = 1 ->
  Rabs (value a) <= bpow radix2 952 -> Rabs (value b) <= bpow radix2 952 -> error_floor / 2 <= value E < greatest_usable_error ->
  let w := sub a b in 2 * value E < Rabs (value w) ->
  let inverse := div one w in let middle := mul a inverse in
  (finite w /\ value w = slope (value a) (value b)) /\ (finite inverse /\ value inverse = fl (1 / value w)) /\
  (finite (mul E inverse) /\ value (mul E inverse) = fl (value E * value inverse)) /\
  (finite middle /\ value middle = fl (value a * value inverse) \/
   bpow radix2 1024 <= Rabs (fl (value a * value inverse)) /\ B2SF middle = SpecFloat.S754_infinity (xorb (Bsign a) (Bsign inverse))).
Proof.
  intros a b E one fa fb fE f1 v1 Ha Hb HE w steep inverse middle. pose proof (doubled 952) as e1. simpl Z.add in e1.
  assert (Rabs (value a - value b) <= bpow radix2 953) as s by (unfold Rminus; apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp; lra).
  destruct (difference_within a b 953 fa fb ltac:(lia) s) as (fw & vw). fold w in fw, vw. pose proof (fl_within _ 953 ltac:(lia) s) as w_size. rewrite <- vw in w_size.
  assert (0 < error_floor) by apply bpow_gt_0. assert (0 < Rabs (value w)) by lra. assert (value w <> 0) as some by (intros zero; rewrite zero, Rabs_R0 in *; lra).
  assert (Rabs (1 / value w) * Rabs (value w) = 1) as whole by (rewrite <- Rabs_mult; replace (1 / value w * value w) with 1 by (field; assumption); apply Rabs_R1).
  assert (Rabs (1 / value w) <= bpow radix2 960) as i_size.
  { apply Rmult_le_reg_r with (Rabs (value w)); [assumption |]. rewrite whole. apply Rle_trans with (bpow radix2 960 * error_floor).
    - unfold error_floor. rewrite <- bpow_plus. simpl; lra.
    - apply Rmult_le_compat_l; [apply bpow_ge_0 | lra]. }
  pose proof (Bdiv_correct 53 1024 _ _ mode_NE one w some) as c. change (Rabs (round _ _ _ _)) with (Rabs (fl (value one / value w))) in c.
  rewrite v1 in c. rewrite (below_largest _ 960 ltac:(lia) i_size) in c. destruct c as (vi & fi & _).
  change (Bdiv mode_NE one w) with inverse in vi, fi. unfold finite in f1. rewrite f1 in fi. change (value inverse = fl (1 / value w)) in vi.
  assert (Rabs (value E * value inverse) <= bpow radix2 0) as m_size.
  { rewrite Rabs_mult, (Rabs_pos_eq (value E)) by lra. pose proof (fl_error (1 / value w)) as near. rewrite <- vi in near. pose proof tiny_positive.
    assert (Rabs (value inverse) <= (1 + u) * Rabs (1 / value w) + tiny) as r.
    { replace (value inverse) with ((value inverse - 1 / value w) + 1 / value w) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
    apply Rle_trans with (/ 2 * Rabs (value w) * ((1 + u) * Rabs (1 / value w) + tiny)); [apply Rmult_le_compat; try apply Rabs_pos; lra |].
    replace (/ 2 * Rabs (value w) * ((1 + u) * Rabs (1 / value w) + tiny)) with (/ 2 * ((1 + u) * (Rabs (1 / value w) * Rabs (value w)) + Rabs (value w) * tiny)) by ring.
    rewrite whole. assert (Rabs (value w) * tiny <= bpow radix2 953 * tiny) as small by (apply Rmult_le_compat_r; lra).
    assert (bpow radix2 953 * tiny <= / 2) by (unfold tiny; rewrite <- bpow_plus; change (/ 2) with (bpow radix2 (-1)); apply bpow_le; lia).
    change (bpow radix2 0) with 1. unfold u; lra. }
  pose proof (product_within E inverse 0 fE fi ltac:(lia) m_size).
  split; [| split; [| split]]; try (split; assumption); try assumption.
  pose proof (Bmult_correct 53 1024 _ _ mode_NE a inverse) as c. change (Rabs (round _ _ _ _)) with (Rabs (fl (value a * value inverse))) in c.
  change (Bmult mode_NE a inverse) with middle in c. unfold finite in *. rewrite fa, fi in c.
  destruct (Rlt_bool_spec (Rabs (fl (value a * value inverse))) (bpow radix2 1024)); [left; tauto | right; split; assumption].
Qed.

Print Assumptions usable_error_did_not_overflow.
Print Assumptions usable_sizes.
Print Assumptions delta_does_not_overflow.
Print Assumptions crossing_overflows_on_its_side.
