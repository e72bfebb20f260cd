(* Lemma pair-operations (proofs-notes/rounding-of-forces.md, section 2): the root of a pair is within 2^-102 of its
   result. fast/number_pair.hpp, sqrt. Where underflow is kept away, as the windows of that note do. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles pair_sum quotient quick_pairs pair_quotient.
Open Scope R_scope.

Section Root.

Variables ah al lost : R.
Hypotheses (Dah : is_double ah) (Dal : is_double al) (Dlost : is_double lost) (a_pos : 0 < ah) (a_tidy : Rabs al <= u * ah).
Let first := fl (sqrt ah).
Let p := fl (first * first).
Hypothesis lost_near : Rabs (lost - (first * first - p)) <= 7 * tiny.
Hypotheses (no_underflow : tiny <= u * u * u * ah) (none_of_roots : tiny <= u * u * u * sqrt ah).

(* a - first * first, of which tidy takes the sum for its high part. *)
Let s := fl (ah + - p).
Let t := fl (rest ah (- p) + fl (al + - lost)).
Let high := fl (s + t).
Let c := fl (high / (2 * first)).

Theorem pair_root_error : Rabs (first + c - sqrt (ah + al)) <= pair_unit * sqrt (ah + al).
Proof.
  set (H := ah) in *. pose proof tiny_positive. assert (0 < u) by (unfold u; lra).
  set (r := sqrt H) in *. assert (0 < r) as r_pos by now apply sqrt_lt_R0.
  assert (r * r = H) as r_square by (apply sqrt_sqrt; lra).
  assert (u * u * u * H <= / 1000 * (u * u * H)) as cube.
  { replace (u * u * u * H) with (u * (u * u * H)) by ring. apply Rmult_le_compat_r; [repeat apply Rmult_le_pos; lra | unfold u; lra]. }
  assert (u * u * u * r <= / 1000 * (u * r)) as cube_r.
  { replace (u * u * u * r) with (u * u * (u * r)) by ring. apply Rmult_le_compat_r; [repeat apply Rmult_le_pos; lra | unfold u; lra]. }
  assert (0 < u * H) by (apply Rmult_lt_0_compat; lra). assert (0 < u * u * H) by (repeat apply Rmult_lt_0_compat; lra).
  set (Z := u * u * H) in *. set (W := u * H) in *. assert (Z = u * W) as ZW by (unfold Z, W; ring).
  assert (Z <= / 1000000 * W) as second by (rewrite ZW; apply Rmult_le_compat_r; [lra | unfold u; lra]).
  assert (W <= / 1000000 * H) as first_ by (unfold W; apply Rmult_le_compat_r; [lra | unfold u; lra]).
  (* first is near the root *)
  pose proof (fl_error r) as f_near. fold first in f_near. rewrite (Rabs_pos_eq r) in f_near by lra.
  assert (Rabs (first - r) <= (1 + / 1000) * u * r) as f_off by lra. apply within in f_off. clear f_near.
  assert (0 < u * r <= / 1000000 * r) by (split; [apply Rmult_lt_0_compat; lra | apply Rmult_le_compat_r; [lra | unfold u; lra]]).
  assert ((1 - / 1000) * r <= first <= (1 + / 1000) * r) as f_range by lra.
  assert (Rabs (first * first - H) <= (2 + / 100) * W) as ff_near.
  { replace (first * first - H) with ((first - r) * (first + r)) by (rewrite <- r_square; ring). rewrite Rabs_mult.
    apply Rle_trans with ((1 + / 1000) * u * r * ((2 + / 1000) * r)).
    - apply Rmult_le_compat; try apply Rabs_pos; [apply Rabs_le; lra | rewrite Rabs_pos_eq by lra; lra].
    - replace ((1 + / 1000) * u * r * ((2 + / 1000) * r)) with ((1 + / 1000) * (2 + / 1000) * (u * (r * r))) by ring.
      rewrite r_square. fold W. lra. }
  assert (Rabs (first * first) <= (1 + / 1000) * H) as ff_size.
  { replace (first * first) with (H + (first * first - H)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_pos_eq H) by lra. lra. }
  pose proof (fl_error (first * first)) as p_near. fold p in p_near. pose proof (scaled _ _ u ltac:(lra) ff_size).
  assert (Rabs (H - p) <= (3 + / 10) * W) as d_size.
  { replace (H - p) with (- (first * first - H) - (p - first * first)) by ring.
    apply Rle_trans with (1 := difference_size _ _). rewrite Rabs_Ropp. unfold W in *; lra. }
  destruct (near_difference_is_exact H p Dah (fl_is_double _)) as (s_is & rest_is); [rewrite (Rabs_pos_eq H) by lra; lra |].
  change (fl (H + - p)) with s in s_is.
  assert (is_double (- lost)) by now apply generic_format_opp.
  pose proof (sum_error al (- lost) Dal ltac:(assumption)) as t_near. change (al + - lost) with (al - lost) in t_near.
  assert (t = fl (al - lost)) as t_is.
  { unfold t. change (rest ah (- p)) with (rest H (- p)). rewrite rest_is, Rplus_0_l. change (al + - lost) with (al - lost).
    apply fl_of_double, fl_is_double. }
  rewrite <- t_is in t_near.
  assert (Rabs lost <= (1 + / 100) * W) as lost_size.
  { replace lost with ((lost - (first * first - p)) - (p - first * first)) by ring. apply Rle_trans with (1 := difference_size _ _). unfold W, Z in *; lra. }
  assert (Rabs (al - lost) <= (2 + / 50) * W) as ts by (apply Rle_trans with (1 := difference_size _ _); unfold W in *; lra).
  pose proof (scaled _ _ u ltac:(lra) ts).
  set (g := H + al - first * first).
  assert (Rabs (s + t - g) <= (2 + / 10) * Z) as st_off.
  { rewrite s_is. replace (H - p + t - g) with ((t - (al - lost)) - (lost - (first * first - p))) by (unfold g; ring).
    apply Rle_trans with (1 := difference_size _ _). unfold W, Z in *; lra. }
  assert (Rabs g <= (3 + / 20) * W) as g_size.
  { replace g with (al - (first * first - H)) by (unfold g; ring). apply Rle_trans with (1 := difference_size _ _). unfold W in *; lra. }
  assert (is_double t) as Dt by apply fl_is_double.
  pose proof (sum_error s t (fl_is_double _) Dt) as h_near. fold high in h_near.
  assert (Rabs (s + t) <= (3 + / 10) * W) as sts.
  { replace (s + t) with ((s + t - g) + g) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  pose proof (scaled _ _ u ltac:(lra) sts).
  assert (Rabs (high - g) <= (5 + / 2) * Z) as rest_off.
  { replace (high - g) with ((high - (s + t)) + (s + t - g)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). unfold W, Z in *; lra. }
  assert (Rabs high <= (3 + / 5) * W) as rest_size.
  { replace high with ((high - g) + g) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  (* c first is near g / 2 *)
  pose proof (fl_error (high / (2 * first))) as c_near. fold c in c_near.
  assert (tiny * first <= / 10 * Z).
  { apply Rle_trans with (u * u * u * r * ((1 + / 1000) * r)); [apply Rmult_le_compat; lra |].
    replace (u * u * u * r * ((1 + / 1000) * r)) with ((1 + / 1000) * (u * (u * u * (r * r)))) by ring. rewrite r_square. fold Z.
    assert (u * Z <= / 1000 * Z) by (apply Rmult_le_compat_r; [lra | unfold u; lra]). lra. }
  assert (Rabs ((c - high / (2 * first)) * first) <= 2 * Z) as cr.
  { rewrite Rabs_mult, (Rabs_pos_eq first) by lra. apply Rle_trans with ((u * Rabs (high / (2 * first)) + tiny) * first); [apply Rmult_le_compat_r; lra |].
    assert (Rabs (high / (2 * first)) * first = / 2 * Rabs high) as half.
    { rewrite <- (Rabs_pos_eq first) at 2 by lra. rewrite <- Rabs_mult. replace (high / (2 * first) * first) with (/ 2 * high) by (field; lra).
      now rewrite Rabs_mult, (Rabs_pos_eq (/ 2)) by lra. }
    replace ((u * Rabs (high / (2 * first)) + tiny) * first) with (u * (Rabs (high / (2 * first)) * first) + tiny * first) by ring. rewrite half.
    pose proof (scaled _ _ u ltac:(lra) rest_size). rewrite ZW in *; lra. }
  assert (Rabs (c * first - / 2 * g) <= 5 * Z) as c_off.
  { replace (c * first - / 2 * g) with ((c - high / (2 * first)) * first + / 2 * (high - g)) by (field; lra).
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_mult (/ 2)), (Rabs_pos_eq (/ 2)) by lra. lra. }
  (* the root of the whole *)
  apply within in a_tidy. fold W in a_tidy.
  assert (0 < H + al) by lra. set (q := sqrt (H + al)). assert (0 < q) by now apply sqrt_lt_R0.
  assert (q * q = H + al) as q_square by (apply sqrt_sqrt; lra).
  assert ((1 - / 1000) * r <= q) as q_low by (apply Rnot_lt_le; intros less; nra).
  assert (g = (q - first) * (q + first)) as g_is by (unfold g; rewrite <- q_square; ring).
  assert (Rabs (q - first) <= (1 + 6 / 10) * u * r) as near.
  { apply Rmult_le_reg_r with (q + first); [lra |]. rewrite <- (Rabs_pos_eq (q + first)) at 1 by lra. rewrite <- Rabs_mult, <- g_is.
    apply Rle_trans with (1 := g_size). apply Rle_trans with ((1 + 6 / 10) * u * r * ((2 - / 500) * r)).
    - replace ((1 + 6 / 10) * u * r * ((2 - / 500) * r)) with ((1 + 6 / 10) * (2 - / 500) * (u * (r * r))) by ring. rewrite r_square. fold W. lra.
    - apply Rmult_le_compat_l; [|lra]. repeat apply Rmult_le_pos; lra. }
  (* g / 2 = (q - first) first + (q - first)^2 / 2 *)
  assert (Rabs ((q - first) * (q - first)) <= 3 * Z) as squared.
  { rewrite Rabs_mult. apply Rle_trans with ((1 + 6 / 10) * u * r * ((1 + 6 / 10) * u * r)); [apply Rmult_le_compat; trivial; apply Rabs_pos |].
    replace ((1 + 6 / 10) * u * r * ((1 + 6 / 10) * u * r)) with ((1 + 6 / 10) * (1 + 6 / 10) * (u * u * (r * r))) by ring. rewrite r_square. fold Z. lra. }
  assert (Rabs ((first + c - q) * first) <= 7 * Z) as total.
  { replace ((first + c - q) * first) with ((c * first - / 2 * g) + / 2 * ((q - first) * (q - first))) by (rewrite g_is; field).
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_mult (/ 2)), (Rabs_pos_eq (/ 2)) by lra. lra. }
  assert (pair_unit = 16 * u * u) as -> by (unfold pair_unit, u; simpl; lra).
  rewrite Rabs_mult, (Rabs_pos_eq first) in total by lra.
  apply Rmult_le_reg_r with first; [lra |]. apply Rle_trans with (1 := total).
  apply Rle_trans with (16 * u * u * (((1 - / 1000) * r) * ((1 - / 1000) * r))).
  - replace (16 * u * u * ((1 - / 1000) * r * ((1 - / 1000) * r))) with (16 * (1 - / 1000) * (1 - / 1000) * (u * u * (r * r))) by ring.
    rewrite r_square. fold Z. lra.
  - rewrite (Rmult_assoc (16 * u * u)). apply Rmult_le_compat_l; [repeat apply Rmult_le_pos; lra |]. apply Rmult_le_compat; lra.
Qed.
End Root.

Print Assumptions pair_root_error.
