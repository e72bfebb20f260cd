(* Lemma box-slabs (proofs-notes/rounding.md): what the index passes by is not met. Along one axis, for the range's exact
   ends and with all roundings, to doubles (fast/box_probe.hpp) and to floats (fast/search_kernels_body.hpp,
   BoxMeeter): a box that holds the point at s is met no later than s on its near side, no sooner on its far side. Nothing
   overflows where coordinates are below 2^60, but for far positions, which may then be infinite. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles floats.
Open Scope R_scope.

Definition delta := / 1048576. (* 0x1p-20 *)
(* 1e-20 and 1e-30 of the code are doubles near them. *)
Definition least_pad := / 100000000000000000000.
Definition shortest := / 1000000000000000000000000000000.

(* The inverse of a way that is not short. *)
Lemma inverse_is_near : forall way, shortest <= way -> way <= bpow radix2 62 ->
  Rabs (to_float (fl (1 / way)) * way - 1) <= 2 * v.
Proof.
  intros way some long. assert (0 < way) by (unfold shortest in *; lra).
  pose proof (fl_error (1 / way)) as one. pose proof (float_error (fl (1 / way))) as two.
  pose proof tiny_positive. pose proof small_is_small.
  set (i := 1 / way) in *. assert (i * way = 1) as whole by (unfold i; field; lra).
  assert (0 < i) by (unfold i; apply Rdiv_lt_0_compat; lra).
  rewrite (Rabs_pos_eq i) in one by lra. apply within in one.
  assert (tiny <= u * i) as tiny_i.
  { apply Rmult_le_reg_r with way; [assumption |]. rewrite Rmult_assoc, whole, Rmult_1_r.
    apply Rle_trans with (tiny * bpow radix2 62); [apply Rmult_le_compat_l; lra |].
    unfold tiny. rewrite <- bpow_plus. replace u with (bpow radix2 (-53)) by reflexivity. apply bpow_le. lia. }
  assert (small <= u * i) as small_i.
  { apply Rmult_le_reg_r with way; [assumption |]. rewrite Rmult_assoc, whole, Rmult_1_r.
    apply Rle_trans with (small * bpow radix2 62); [apply Rmult_le_compat_l; lra |].
    unfold small. rewrite <- bpow_plus. replace u with (bpow radix2 (-53)) by reflexivity. apply bpow_le. lia. }
  assert (0 <= fl i) by (unfold u in *; lra). rewrite (Rabs_pos_eq (fl i)) in two by assumption. apply within in two.
  replace (to_float (fl i) * way - 1) with ((to_float (fl i) - i) * way) by (rewrite Rmult_minus_distr_r, whole; ring).
  rewrite Rabs_mult, (Rabs_pos_eq way) by lra.
  apply Rle_trans with (2 * v * i * way); [| rewrite (Rmult_assoc (2 * v)), whole; lra].
  apply Rmult_le_compat_r; [lra |]. apply Rabs_le. unfold u, v in *; lra.
Qed.

Section Axis.

(* The range's ends on an axis that it ascends: as doubles, and exact. *)
Variables from last F T e c : R.
Hypotheses (Dfrom : is_double from) (Dlast : is_double last) (e_pos : 0 <= e <= 1).
Hypotheses (from_near : Rabs (from - F) <= e) (last_near : Rabs (last - T) <= e).
Hypotheses (from_usable : Rabs from <= bpow radix2 60) (last_usable : Rabs last <= bpow radix2 60).
Let way := fl (last - from).
Hypothesis ascending : 0 <= way.
Hypotheses (Dc : is_double c) (c_near : 99 / 100 * least_pad <= c <= 101 / 100 * least_pad) (D8e : is_double (8 * e)).
Let pad := fl (fl (fl (bpow radix2 (-20) * fl (Rabs from + Rabs way)) + 8 * e) + c).
Let near_origin := to_float (fl (from + pad)).
Let far_origin := to_float (fl (from - pad)).
(* 1 / way, or 1e30 where that is shorter than 1e-30 (give or take a little, as the code's constant is rounded). *)
Variable inverse : R.
Hypotheses (Dinverse : is_float inverse) (inverse_pos : 0 < inverse).
Hypothesis inverse_of_short : way <= shortest -> 9 / 10 * / shortest <= inverse.
Hypothesis inverse_of_long : shortest <= way -> Rabs (inverse * way - 1) <= 2 * v.

Lemma way_is_near : Rabs (way - (last - from)) <= 2 * u * way /\ way <= bpow radix2 62.
Proof.
  assert (is_double (- from)) as Dm by now apply generic_format_opp.
  pose proof (sum_error last (- from) Dlast Dm) as near. change (last + - from) with (last - from) in near. fold way in near.
  assert (Rabs (last - from) <= way + Rabs (way - (last - from))).
  { rewrite <- (Rabs_pos_eq way) at 1 by assumption. replace (last - from) with (way - (way - (last - from))) at 1 by ring.
    unfold Rminus at 1. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp. lra. }
  assert (Rabs (last - from) <= 2 * bpow radix2 60).
  { unfold Rminus. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp. lra. }
  split; [unfold u in *; lra |].
  replace (bpow radix2 62) with (4 * bpow radix2 60) by (change 62%Z with (2 + 60)%Z; rewrite bpow_plus; reflexivity).
  apply within in near. pose proof (Rle_abs (last - from)). pose proof (bpow_gt_0 radix2 60). unfold u in *; lra.
Qed.

Lemma pad_is_enough : 999 / 1000 * (delta * (Rabs from + way) + 8 * e + c) <= pad.
Proof.
  pose proof tiny_positive. pose proof (Rabs_pos from). assert (0 < c) by (unfold least_pad in *; lra).
  assert (is_double (Rabs from)) as Da by now apply generic_format_abs.
  assert (is_double (Rabs way)) as Dw by (apply generic_format_abs, fl_is_double).
  pose proof (sum_at_least (Rabs from) (Rabs way) (Rabs from + way) Da Dw) as s.
  rewrite (Rabs_pos_eq way) in * by assumption. specialize (s ltac:(lra)).
  pose proof (product_at_least (bpow radix2 (-20)) (fl (Rabs from + way)) ltac:(apply bpow_ge_0) ltac:(unfold u in *; lra)) as p.
  assert (bpow radix2 (-20) = delta) as d by (unfold delta; simpl; lra). rewrite d in p.
  assert (tiny <= / 1000000 * c).
  { apply Rle_trans with (/ 1000000 * (99 / 100 * least_pad)); [| lra]. unfold tiny, least_pad. apply Rle_trans with (bpow radix2 (-150)); [apply bpow_le; lia |].
    simpl; lra. }
  assert (delta * (Rabs from + way) * (1 - 3 * u) - tiny <= fl (delta * fl (Rabs from + way))) as p'.
  { apply Rle_trans with (2 := p). unfold delta, u in *. lra. }
  set (A := delta * (Rabs from + way)) in *. assert (0 <= A) by (unfold A, delta; lra).
  unfold pad. rewrite d, (Rabs_pos_eq way) by assumption. set (B := fl (delta * fl (Rabs from + way))) in *.
  assert (is_double B) as DB by apply fl_is_double.
  assert (0 <= B) as B_pos.
  { unfold B. rewrite <- (fl_of_double 0) by apply generic_format_0. apply fl_monotone. apply Rmult_le_pos; unfold delta, u in *; lra. }
  pose proof (sum_at_least B (8 * e) (B + 8 * e) DB D8e ltac:(lra)) as q.
  pose proof (sum_at_least (fl (B + 8 * e)) c (fl (B + 8 * e) + c) (fl_is_double _) Dc ltac:(unfold u in *; lra)) as r.
  unfold u in *; lra.
Qed.

Lemma origins_are_apart : from + 9 / 10 * pad <= near_origin /\ far_origin <= from - 9 / 10 * pad.
Proof.
  pose proof pad_is_enough as enough. pose proof (Rabs_pos from). pose proof tiny_positive. pose proof small_is_small.
  assert (is_double pad) as Dp by apply fl_is_double. assert (is_double (- pad)) as Dm by now apply generic_format_opp.
  assert (0 < c) by (unfold least_pad in *; lra).
  assert (Rabs from <= 1050000 * pad) as from_pad by (unfold delta in *; lra).
  assert (small <= / 1000000 * pad) by (unfold least_pad, delta in *; lra).
  apply within in from_pad.
  split.
  - pose proof (sum_error from pad Dfrom Dp) as one. pose proof (float_error (fl (from + pad))) as two.
    assert (Rabs (from + pad) <= 1050001 * pad) as s by (apply Rabs_le; lra).
    assert (u * Rabs (from + pad) <= u * (1050001 * pad)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    apply within in one. apply within in s.
    assert (Rabs (fl (from + pad)) <= 1050002 * pad) as s' by (apply Rabs_le; unfold u in *; lra).
    assert (v * Rabs (fl (from + pad)) <= v * (1050002 * pad)) by (apply Rmult_le_compat_l; [unfold v; lra | assumption]).
    apply within in two. unfold near_origin. unfold u, v in *; lra.
  - pose proof (sum_error from (- pad) Dfrom Dm) as one. change (from + - pad) with (from - pad) in one.
    pose proof (float_error (fl (from - pad))) as two.
    assert (Rabs (from - pad) <= 1050001 * pad) as s by (apply Rabs_le; lra).
    assert (u * Rabs (from - pad) <= u * (1050001 * pad)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    apply within in one. apply within in s.
    assert (Rabs (fl (from - pad)) <= 1050002 * pad) as s' by (apply Rabs_le; unfold u in *; lra).
    assert (v * Rabs (fl (from - pad)) <= v * (1050002 * pad)) by (apply Rmult_le_compat_l; [unfold v; lra | assumption]).
    apply within in two. unfold far_origin. unfold u, v in *; lra.
Qed.

(* The point at s, along the axis. *)
Variable s : R.
Hypothesis s_in_range : 0 <= s <= 1.
Let P := F + s * (T - F).

Lemma point_is_near : from + s * way - e - 2 * u * way <= P <= from + s * way + e + 2 * u * way.
Proof.
  destruct way_is_near as (near & _). apply within in near. apply within in from_near. apply within in last_near.
  set (w := last - from) in *.
  assert (P = (1 - s) * F + s * T) as -> by (unfold P; ring).
  assert ((1 - s) * (from - e) <= (1 - s) * F <= (1 - s) * (from + e)) by (split; apply Rmult_le_compat_l; lra).
  assert (s * (last - e) <= s * T <= s * (last + e)) by (split; apply Rmult_le_compat_l; lra).
  assert (s * (way - 2 * u * way) <= s * w <= s * (way + 2 * u * way)) by (split; apply Rmult_le_compat_l; lra).
  assert (0 <= s * (2 * u * way) <= 2 * u * way).
  { assert (0 <= 2 * u * way) by (unfold u; lra). split; [now apply Rmult_le_pos |].
    rewrite <- (Rmult_1_l (2 * u * way)) at 2. apply Rmult_le_compat_r; lra. }
  replace (s * last) with (s * from + s * w) in * by (unfold w; ring).
  unfold w in *. lra.
Qed.

Theorem near_side_is_met_no_later : forall side, is_float side -> side <= P ->
  let near := to_float (to_float (side - near_origin) * inverse) in near <= 0 \/ near <= s - / 2097152.
Proof.
  intros side Dside below near. pose proof pad_is_enough as enough. destruct origins_are_apart as (apart & _).
  pose proof point_is_near as (_ & at_most). destruct way_is_near as (_ & long). pose proof (Rabs_pos from). pose proof small_is_small.
  assert (is_float (- near_origin)) as Do by (apply generic_format_opp, to_float_is_float).
  pose proof (float_sum_error side (- near_origin) Dside Do) as d_near. change (side + - near_origin) with (side - near_origin) in d_near.
  destruct (Rle_or_lt (side - near_origin) 0) as [before | after].
  { left. apply to_float_sign. assert (to_float (side - near_origin) <= 0) by now apply to_float_sign. nra. }
  right. assert (0 <= s * way) by (apply Rmult_le_pos; lra).
  assert (s * way <= way) by (rewrite <- (Rmult_1_l way) at 2; apply Rmult_le_compat_r; lra).
  set (d := side - near_origin) in *.
  assert (d <= s * way - 8 / 10 * delta * way - 8 / 10 * c) as d_size by (unfold d, delta, u in *; lra).
  destruct (Rle_or_lt way shortest) as [short | not_short].
  { exfalso. unfold shortest, least_pad, delta in *; lra. }
  specialize (inverse_of_long ltac:(lra)). apply within in inverse_of_long.
  rewrite (Rabs_pos_eq d) in d_near by lra. apply within in d_near.
  assert (0 <= to_float d) by (apply to_float_sign; lra).
  assert (d * inverse <= (s - 8 / 10 * delta) * (1 + 2 * v)) as product.
  { apply Rle_trans with ((s - 8 / 10 * delta) * way * inverse).
    - apply Rmult_le_compat_r; [lra |]. assert (0 < c) by (unfold least_pad in *; lra). lra.
    - rewrite Rmult_assoc. apply Rmult_le_compat_l; [| lra].
      assert (0 < (s - 8 / 10 * delta) * way) as positive by (unfold least_pad in *; lra).
      apply Rnot_lt_le. intros negative. nra. }
  assert (to_float d * inverse <= d * (1 + v) * inverse) by (apply Rmult_le_compat_r; lra).
  assert (0 <= to_float d * inverse) by (apply Rmult_le_pos; lra).
  pose proof (float_error (to_float d * inverse)) as last_. rewrite (Rabs_pos_eq (to_float d * inverse)) in last_ by assumption.
  apply within in last_. fold near in last_.
  replace (d * (1 + v) * inverse) with (d * inverse * (1 + v)) in * by ring.
  unfold delta, v in *; lra.
Qed.

Theorem far_side_is_met_no_sooner : forall side, is_float side -> P <= side ->
  s <= to_float (to_float (side - far_origin) * to_float (inverse * (1 + delta))).
Proof.
  intros side Dside above. pose proof pad_is_enough as enough. destruct origins_are_apart as (_ & apart).
  pose proof point_is_near as (at_least & _). destruct way_is_near as (_ & long). pose proof (Rabs_pos from). pose proof small_is_small.
  assert (is_float (- far_origin)) as Do by (apply generic_format_opp, to_float_is_float).
  pose proof (float_sum_error side (- far_origin) Dside Do) as d_near. change (side + - far_origin) with (side - far_origin) in d_near.
  assert (0 <= s * way) by (apply Rmult_le_pos; lra).
  set (g := side - far_origin) in *.
  assert (0 < c) by (unfold least_pad in *; lra).
  assert (s * way + 8 / 10 * delta * way + 8 / 10 * c <= g) as g_size by (unfold g, delta, u in *; lra).
  assert (0 <= delta * way) by (apply Rmult_le_pos; [unfold delta |]; lra).
  rewrite (Rabs_pos_eq g) in d_near by lra. apply within in d_near.
  assert (0 <= to_float g) by (apply to_float_sign; lra).
  (* stretched is no less than the inverse *)
  assert (inverse <= to_float (inverse * (1 + delta))) as stretched.
  { rewrite <- (round_generic radix2 (FLT_exp (-149) 24) ZnearestE inverse Dinverse) at 1.
    apply round_le; [now apply FLT_exp_valid | apply valid_rnd_N |].
    rewrite <- (Rmult_1_r inverse) at 1. apply Rmult_le_compat_l; [lra | unfold delta; lra]. }
  set (i := to_float (inverse * (1 + delta))) in *.
  assert (0 <= g * (1 - v)) by (apply Rmult_le_pos; unfold v; lra).
  assert (g * (1 - v) * inverse <= to_float g * i) by (apply Rmult_le_compat; lra).
  assert (0 <= g * (1 - v) * inverse) by (apply Rmult_le_pos; lra).
  pose proof (float_error (to_float g * i)) as last_. rewrite (Rabs_pos_eq (to_float g * i)) in last_ by lra. apply within in last_.
  destruct (Rle_or_lt way shortest) as [short | not_short].
  - specialize (inverse_of_short short).
    assert (8 / 10 * c * (1 - v) * (9 / 10 * / shortest) <= g * (1 - v) * inverse) as many.
    { apply Rmult_le_compat; [unfold v; lra | unfold shortest; lra | | assumption]. apply Rmult_le_compat_r; [unfold v |]; lra. }
    assert (1000 <= 8 / 10 * c * (1 - v) * (9 / 10 * / shortest)).
    { unfold shortest, least_pad, v in *. rewrite Rinv_inv. lra. }
    unfold v in *; lra.
  - specialize (inverse_of_long ltac:(lra)). apply within in inverse_of_long.
    assert ((s + 8 / 10 * delta) * (1 - 2 * v) <= g * inverse) as product.
    { apply Rle_trans with ((s + 8 / 10 * delta) * (way * inverse)).
      - apply Rmult_le_compat_l; [unfold delta |]; lra.
      - rewrite <- Rmult_assoc. apply Rmult_le_compat_r; lra. }
    replace (g * (1 - v) * inverse) with (g * inverse * (1 - v)) in * by ring.
    unfold delta, v in *; lra.
Qed.
End Axis.

(* An axis that the range descends is the same with every sign changed: near and far are what they were. *)
Theorem positions_are_mirrored : forall side origin inverse,
  to_float (to_float (side - origin) * inverse) = to_float (to_float (- side - - origin) * - inverse).
Proof.
  intros side origin inverse. replace (- side - - origin) with (- (side - origin)) by ring.
  unfold to_float at 4. rewrite round_NE_opp. fold (to_float (side - origin)). f_equal. ring.
Qed.

Print Assumptions inverse_is_near.
Print Assumptions near_side_is_met_no_later.
Print Assumptions far_side_is_met_no_sooner.
Print Assumptions positions_are_mirrored.
