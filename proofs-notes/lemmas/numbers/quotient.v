(* Lemmas quick-quotient (proofs-notes/rounding-of-forces.md, 9) and crossing-in-double-double (proofs-notes/rounding.md),
   what both need of a quotient of doubles: its remainder is a double, and what is computed of it is exact but for
   underflow. fast/crossing_body.hpp, remainder; fast/number_pair.hpp, operator/. *)

From Coq Require Import Reals Psatz ZArith.
From Flocq Require Import Core Relative Div_sqrt_error Sterbenz.
From Groundtruth Require Import doubles pair_product.
Open Scope R_scope.

Definition in_flx := generic_format radix2 (FLX_exp 53).

Lemma difference_size : forall x y, Rabs (x - y) <= Rabs x + Rabs y.
Proof. intros x y. unfold Rminus. rewrite <- (Rabs_Ropp y). apply Rabs_triang. Qed.

Lemma double_is_multiple : forall x, is_double x -> exists n, x = IZR n * bpow radix2 (-1074).
Proof.
  intros x Dx. destruct (FLT_format_generic radix2 (-1074) 53 x Dx) as [[n e] -> _ low]. simpl in low.
  exists (n * 2 ^ (e + 1074))%Z. unfold F2R; cbn [Fnum Fexp]. rewrite mult_IZR, (IZR_Zpower radix2) by lia.
  rewrite Rmult_assoc, <- bpow_plus. do 2 f_equal. lia.
Qed.

Lemma multiple_is_double : forall x n, in_flx x -> x = IZR n * bpow radix2 (-1074) -> is_double x.
Proof.
  intros x n flx multiple. destruct (Rle_or_lt (bpow radix2 (-1074 + 53 - 1)) (Rabs x)) as [normal | small].
  - now apply generic_format_FLT_FLX.
  - apply generic_format_FLT. exists (Float radix2 n (-1074)); [exact multiple | | simpl; lia]. simpl.
    apply lt_IZR. rewrite abs_IZR.
    rewrite multiple, Rabs_mult, (Rabs_pos_eq (bpow radix2 (-1074))) in small by apply bpow_ge_0.
    change (-1074 + 53 - 1)%Z with (52 + -1074)%Z in small. rewrite bpow_plus in small.
    apply Rmult_lt_reg_r in small; [| apply bpow_gt_0]. apply Rlt_trans with (1 := small). simpl. lra.
Qed.

Lemma product_is_multiple : forall q b, in_flx q -> in_flx b -> bpow radix2 (-968) <= Rabs (q * b) ->
  exists n, q * b = IZR n * bpow radix2 (-1074).
Proof.
  intros q b Fq Fb large.
  assert (q <> 0 /\ b <> 0) as (some_q & some_b).
  { pose proof (bpow_gt_0 radix2 (-968)). split; intros zero; rewrite zero, ?Rmult_0_l, ?Rmult_0_r, Rabs_R0 in large; lra. }
  pose proof (bpow_mag_gt radix2 q) as upper_q. pose proof (bpow_mag_gt radix2 b) as upper_b.
  assert (-968 < mag radix2 q + mag radix2 b)%Z as exponents.
  { apply (lt_bpow radix2). apply Rle_lt_trans with (1 := large). rewrite Rabs_mult, bpow_plus.
    apply Rmult_lt_compat; trivial; apply Rabs_pos. }
  rewrite Fq, Fb. unfold F2R, cexp, FLX_exp; cbn [Fnum Fexp]. set (m := Ztrunc _); set (k := Ztrunc _).
  set (e := (mag radix2 q - 53 + (mag radix2 b - 53))%Z).
  exists (m * k * 2 ^ (e + 1074))%Z. rewrite !mult_IZR, (IZR_Zpower radix2) by (unfold e; lia).
  replace (IZR m * IZR k * bpow radix2 (e + 1074) * bpow radix2 (-1074)) with (IZR m * IZR k * (bpow radix2 (e + 1074) * bpow radix2 (-1074))) by ring.
  rewrite <- bpow_plus. replace (e + 1074 + -1074)%Z with e by lia. unfold e. rewrite bpow_plus. ring.
Qed.

Lemma quotient_is_near : forall a b, b <> 0 -> bpow radix2 (-1022) <= Rabs (a / b) -> Rabs (fl (a / b) - a / b) <= u * Rabs (a / b).
Proof.
  intros a b some large. unfold fl. rewrite round_FLT_FLX by exact large.
  pose proof (relative_error_N_FLX radix2 53 ltac:(easy) (fun z => negb (Z.even z)) (a / b)) as near.
  apply Rle_trans with (1 := near). apply Rmult_le_compat_r; [apply Rabs_pos |]. unfold u; simpl; lra.
Qed.

Lemma remainder_is_near : forall a b, b <> 0 -> bpow radix2 (-1022) <= Rabs (a / b) ->
  Rabs (a - fl (a / b) * b) <= u * Rabs a.
Proof.
  intros a b some large. pose proof (quotient_is_near a b some large) as near.
  replace (a - fl (a / b) * b) with (- ((fl (a / b) - a / b) * b)) by (field; assumption).
  rewrite Rabs_Ropp, Rabs_mult. apply Rle_trans with (u * Rabs (a / b) * Rabs b).
  - apply Rmult_le_compat_r; [apply Rabs_pos | assumption].
  - right. rewrite Rmult_assoc, <- Rabs_mult. do 2 f_equal. field. assumption.
Qed.

Theorem remainder_is_double : forall a b, is_double a -> is_double b -> b <> 0 ->
  bpow radix2 (-967) <= Rabs a -> bpow radix2 (-1022) <= Rabs (a / b) -> is_double (a - fl (a / b) * b).
Proof.
  intros a b Da Db some large_a large.
  assert (in_flx a) as Fa by now apply (generic_format_FLX_FLT radix2 (-1074)).
  assert (in_flx b) as Fb by now apply (generic_format_FLX_FLT radix2 (-1074)).
  pose proof (remainder_is_near a b some large) as near.
  assert (fl (a / b) = round radix2 (FLX_exp 53) ZnearestE (a / b)) as flx by now apply round_FLT_FLX.
  assert (in_flx (fl (a / b))) as Fq by (rewrite flx; apply generic_format_round; [now apply FLX_exp_valid | apply valid_rnd_N]).
  assert (in_flx (a - fl (a / b) * b)) as Fr.
  { rewrite flx. apply div_error_FLX; trivial; [reflexivity | apply valid_rnd_N]. }
  destruct (double_is_multiple a Da) as (n & of_a).
  destruct (product_is_multiple (fl (a / b)) b Fq Fb) as (m & of_product).
  { apply Rle_trans with (Rabs a / 2).
    - change (-968)%Z with (-967 + -1)%Z. rewrite bpow_plus. simpl (bpow radix2 (-1)). lra.
    - assert (Rabs a <= Rabs (fl (a / b) * b) + Rabs (a - fl (a / b) * b)).
      { replace a with (fl (a / b) * b + (a - fl (a / b) * b)) at 1 by ring. apply Rabs_triang. }
      pose proof (Rabs_pos a). unfold u in *; lra. }
  apply multiple_is_double with (n - m)%Z; trivial. rewrite minus_IZR, Rmult_minus_distr_r, <- of_a, <- of_product. reflexivity.
Qed.

(* (a - p) - lost, where p = fl(q b) and `lost` is what that loses, fused or Dekker's. *)
Theorem remainder_is_computed : forall a b lost, is_double a -> is_double b -> is_double lost -> b <> 0 ->
  bpow radix2 (-1022) <= Rabs (a / b) -> let q := fl (a / b) in let p := fl (q * b) in
  Rabs (lost - (q * b - p)) <= 7 * tiny -> Rabs (fl (fl (a - p) - lost) - (a - q * b)) <= 32 * tiny.
Proof.
  intros a b lost Da Db Dl some large q p lost_near. pose proof tiny_positive.
  assert (is_double q) as Dq by apply fl_is_double. assert (is_double p) as Dp by apply fl_is_double.
  pose proof (remainder_is_near a b some large) as r_near; fold q in r_near.
  pose proof (fl_error (q * b)) as p_near; fold p in p_near.
  assert (is_double (- p)) as Dnp by now apply generic_format_opp.
  assert (is_double (- lost)) as Dnl by now apply generic_format_opp.
  pose proof (sum_error a (- p) Da Dnp) as d_near; change (a + - p) with (a - p) in d_near.
  assert (is_double (fl (a - p))) as Dd by apply fl_is_double.
  pose proof (sum_error (fl (a - p)) (- lost) Dd Dnl) as s_near; change (fl (a - p) + - lost) with (fl (a - p) - lost) in s_near.
  set (r := a - q * b) in *.
  assert (Rabs (q * b) <= (1 + u) * Rabs a).
  { replace (q * b) with (a - r) by (unfold r; ring). apply Rle_trans with (1 := difference_size _ _). lra. }
  pose proof (Rabs_pos a).
  assert (u * Rabs (q * b) <= u * ((1 + u) * Rabs a)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  destruct (Rle_or_lt (bpow radix2 (-967)) (Rabs a)) as [big | small].
  - (* exact: Sterbenz, and the remainder is a double *)
    assert (is_double r) as Dr by now apply remainder_is_double.
    assert (tiny <= / 1000 * Rabs a) as tiny_a.
    { apply Rle_trans with (/ 1000 * bpow radix2 (-967)); [| lra].
      unfold tiny. change (-1075)%Z with (-108 + -967)%Z. rewrite bpow_plus.
      apply Rmult_le_compat_r; [apply bpow_ge_0 | simpl; lra]. }
    assert (fl (a - p) = a - p) as exact.
    { apply fl_of_double.
      apply within in r_near; apply within in p_near; unfold r, u in *.
      destruct (Rle_or_lt 0 a) as [pos | neg].
      - rewrite (Rabs_pos_eq a) in * by assumption.
        apply sterbenz; trivial; [now apply FLT_exp_valid | apply FLT_exp_monotone |]. split; lra.
      - rewrite (Rabs_left a) in * by assumption.
        replace (a - p) with (- (- a - - p)) by ring. apply generic_format_opp.
        apply sterbenz; [now apply FLT_exp_valid | apply FLT_exp_monotone | now apply generic_format_opp | assumption |]. split; lra. }
    rewrite exact in *.
    assert (Rabs (a - p - lost - r) <= 7 * tiny) as offset.
    { replace (a - p - lost - r) with (- (lost - (q * b - p))) by (unfold r; ring). now rewrite Rabs_Ropp. }
    assert (is_double (fl (a - p - lost))) by apply fl_is_double.
    (* nearest to something within 7 tiny of a double r: within 14 tiny of r *)
    assert (Rabs (fl (a - p - lost) - (a - p - lost)) <= Rabs (r - (a - p - lost))) as nearest.
    { apply round_N_pt; [now apply FLT_exp_valid | assumption]. }
    rewrite (Rabs_minus_sym r) in nearest.
    replace (fl (a - p - lost) - r) with ((fl (a - p - lost) - (a - p - lost)) + (a - p - lost - r)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). lra.
  - (* all that is lost is below 2^-1073 *)
    assert (u * u * Rabs a <= 4 * tiny) as second.
    { apply Rle_trans with (u * u * bpow radix2 (-967)); [apply Rmult_le_compat_l; [unfold u |]; lra |].
      right. assert (u = bpow radix2 (-53)) as -> by reflexivity. unfold tiny.
      replace 4 with (bpow radix2 2) by reflexivity. rewrite <- !bpow_plus. reflexivity. }
    assert (Rabs (a - p) <= 2 * u * Rabs a + u * u * Rabs a + tiny) as size_d.
    { replace (a - p) with (r - (p - q * b)) by (unfold r; ring).
      apply Rle_trans with (1 := difference_size _ _). unfold u in *; lra. }
    assert (u * Rabs (a - p) <= u * (2 * u * Rabs a + u * u * Rabs a + tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    assert (u * (2 * u * Rabs a + u * u * Rabs a + tiny) <= 10 * tiny).
    { replace (u * (2 * u * Rabs a + u * u * Rabs a + tiny)) with (2 * (u * u * Rabs a) + u * (u * u * Rabs a) + u * tiny) by ring.
      unfold u in *; lra. }
    assert (Rabs (fl (a - p) - lost - r) <= 17 * tiny) as offset.
    { replace (fl (a - p) - lost - r) with ((fl (a - p) - (a - p)) - (lost - (q * b - p))) by (unfold r; ring).
      apply Rle_trans with (1 := difference_size _ _). lra. }
    assert (Rabs (fl (a - p) - lost) <= u * Rabs a + 17 * tiny).
    { replace (fl (a - p) - lost) with ((fl (a - p) - lost - r) + r) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
    assert (u * Rabs (fl (a - p) - lost) <= u * (u * Rabs a + 17 * tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    replace (fl (fl (a - p) - lost) - r) with ((fl (fl (a - p) - lost) - (fl (a - p) - lost)) + (fl (a - p) - lost - r)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _).
    replace (u * (u * Rabs a + 17 * tiny)) with (u * u * Rabs a + u * (17 * tiny)) in * by ring. unfold u in *; lra.
Qed.

(* Where the quotient itself is subnormal, or whatever it is. *)
Theorem remainder_is_computed_anyway : forall a b lost, is_double a -> is_double b -> is_double lost -> b <> 0 ->
  let q := fl (a / b) in let p := fl (q * b) in
  Rabs (lost - (q * b - p)) <= 7 * tiny -> Rabs (fl (fl (a - p) - lost) - (a - q * b)) <= 32 * tiny + tiny * Rabs b.
Proof.
  intros a b lost Da Db Dl some q p lost_near. pose proof tiny_positive. pose proof (Rabs_pos b).
  assert (0 <= tiny * Rabs b) by (apply Rmult_le_pos; lra).
  destruct (Rle_or_lt (bpow radix2 (-1022)) (Rabs (a / b))) as [normal | subnormal].
  { apply Rle_trans with (32 * tiny); [| lra]. now apply remainder_is_computed. }
  assert (is_double q) as Dq by apply fl_is_double. assert (is_double p) as Dp by apply fl_is_double.
  assert (is_double (- p)) as Dnp by now apply generic_format_opp.
  assert (is_double (- lost)) as Dnl by now apply generic_format_opp.
  assert (is_double (fl (a - p))) as Dd by apply fl_is_double.
  pose proof (fl_error (a / b)) as q_near; fold q in q_near.
  pose proof (fl_error (q * b)) as p_near; fold p in p_near.
  pose proof (sum_error a (- p) Da Dnp) as d_near; change (a + - p) with (a - p) in d_near.
  pose proof (sum_error (fl (a - p)) (- lost) Dd Dnl) as s_near; change (fl (a - p) + - lost) with (fl (a - p) - lost) in s_near.
  set (B := tiny * Rabs b) in *. set (r := a - q * b) in *.
  assert (u * bpow radix2 (-1022) = tiny) as scale
    by (assert (u = bpow radix2 (-53)) as -> by reflexivity; unfold tiny; rewrite <- bpow_plus; reflexivity).
  assert (u * Rabs (a / b) <= tiny) by (rewrite <- scale; apply Rmult_le_compat_l; [unfold u |]; lra).
  assert (Rabs r <= 2 * B) as r_size.
  { replace r with (- ((q - a / b) * b)) by (unfold r; field; assumption). rewrite Rabs_Ropp, Rabs_mult.
    replace (2 * B) with (2 * tiny * Rabs b) by (unfold B; ring). apply Rmult_le_compat_r; [apply Rabs_pos | lra]. }
  assert (u * Rabs a <= B) as a_size.
  { replace a with (a / b * b) by (field; assumption). rewrite Rabs_mult, <- Rmult_assoc. unfold B. now apply Rmult_le_compat_r. }
  assert (Rabs (q * b) <= Rabs a + 2 * B).
  { replace (q * b) with (a - r) by (unfold r; ring). apply Rle_trans with (1 := difference_size _ _). lra. }
  assert (u * Rabs (q * b) <= u * (Rabs a + 2 * B)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (0 <= B) by assumption.
  assert (Rabs (a - p) <= 4 * B + tiny) as size_d.
  { replace (a - p) with (r - (p - q * b)) by (unfold r; ring).
    apply Rle_trans with (1 := difference_size _ _). unfold u in *; lra. }
  assert (u * Rabs (a - p) <= u * (4 * B + tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (Rabs (fl (a - p) - lost - r) <= u * (4 * B + tiny) + 7 * tiny) as offset.
  { replace (fl (a - p) - lost - r) with ((fl (a - p) - (a - p)) - (lost - (q * b - p))) by (unfold r; ring).
    apply Rle_trans with (1 := difference_size _ _). lra. }
  assert (Rabs (fl (a - p) - lost) <= 3 * B + 8 * tiny).
  { replace (fl (a - p) - lost) with ((fl (a - p) - lost - r) + r) by ring. apply Rle_trans with (1 := Rabs_triang _ _). unfold u in *; lra. }
  assert (u * Rabs (fl (a - p) - lost) <= u * (3 * B + 8 * tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  replace (fl (fl (a - p) - lost) - r) with ((fl (fl (a - p) - lost) - (fl (a - p) - lost)) + (fl (a - p) - lost - r)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). unfold u in *; lra.
Qed.

(* The same by one fused operation. *)
Theorem fused_remainder : forall a b, is_double a -> is_double b -> b <> 0 ->
  let q := fl (a / b) in Rabs (fl (a - q * b) - (a - q * b)) <= 32 * tiny + tiny * Rabs b.
Proof.
  intros a b Da Db some q. pose proof tiny_positive. pose proof (Rabs_pos b). pose proof (Rabs_pos a).
  assert (0 <= tiny * Rabs b) by (apply Rmult_le_pos; lra).
  pose proof (fl_error (a - q * b)) as near. set (r := a - q * b) in *.
  destruct (Rle_or_lt (bpow radix2 (-1022)) (Rabs (a / b))) as [normal | subnormal].
  - pose proof (remainder_is_near a b some normal) as r_near. fold q r in r_near.
    destruct (Rle_or_lt (bpow radix2 (-967)) (Rabs a)) as [big | small].
    + assert (is_double r) as Dr by now apply remainder_is_double. rewrite (fl_of_double r Dr), Rminus_diag_eq, Rabs_R0 by reflexivity. lra.
    + assert (u * Rabs r <= u * (u * Rabs a)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
      assert (u * u * Rabs a <= 4 * tiny) as second.
      { apply Rle_trans with (u * u * bpow radix2 (-967)); [apply Rmult_le_compat_l; [unfold u |]; lra |].
        right. assert (u = bpow radix2 (-53)) as -> by reflexivity. unfold tiny.
        replace 4 with (bpow radix2 2) by reflexivity. rewrite <- !bpow_plus. reflexivity. }
      lra.
  - pose proof (fl_error (a / b)) as q_near; fold q in q_near.
    assert (u * bpow radix2 (-1022) = tiny) as scale
      by (assert (u = bpow radix2 (-53)) as -> by reflexivity; unfold tiny; rewrite <- bpow_plus; reflexivity).
    assert (u * Rabs (a / b) <= tiny) by (rewrite <- scale; apply Rmult_le_compat_l; [unfold u |]; lra).
    assert (Rabs r <= 2 * (tiny * Rabs b)) as r_size.
    { replace r with (- ((q - a / b) * b)) by (unfold r; field; assumption). rewrite Rabs_Ropp, Rabs_mult.
      replace (2 * (tiny * Rabs b)) with (2 * tiny * Rabs b) by ring. apply Rmult_le_compat_r; [apply Rabs_pos | lra]. }
    assert (u * Rabs r <= u * (2 * (tiny * Rabs b))) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    set (B := tiny * Rabs b) in *. unfold u in *; lra.
Qed.

Theorem inverse_is_near : forall b, b <> 0 -> Rabs b <= bpow radix2 1000 -> Rabs (fl (1 / b) * b - 1) <= 2 * u.
Proof.
  intros b some small. pose proof (fl_error (1 / b)) as near. pose proof tiny_positive.
  replace (fl (1 / b) * b - 1) with ((fl (1 / b) - 1 / b) * b) by (field; assumption). rewrite Rabs_mult.
  apply Rle_trans with ((u * Rabs (1 / b) + tiny) * Rabs b); [apply Rmult_le_compat_r; [apply Rabs_pos | assumption] |].
  assert (Rabs (1 / b) * Rabs b = 1) as one by (rewrite <- Rabs_mult; replace (1 / b * b) with 1 by (field; assumption); apply Rabs_R1).
  assert (tiny * Rabs b <= u).
  { apply Rle_trans with (tiny * bpow radix2 1000); [apply Rmult_le_compat_l; lra |].
    unfold tiny. rewrite <- bpow_plus. replace u with (bpow radix2 (-53)) by reflexivity. apply bpow_le. lia. }
  replace ((u * Rabs (1 / b) + tiny) * Rabs b) with (u * (Rabs (1 / b) * Rabs b) + tiny * Rabs b) by ring. rewrite one. lra.
Qed.

Print Assumptions remainder_is_double.
Print Assumptions remainder_is_computed.
Print Assumptions remainder_is_computed_anyway.
Print Assumptions fused_remainder.
Print Assumptions inverse_is_near.
