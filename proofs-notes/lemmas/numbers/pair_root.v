(* Lemma pair-operations (proofs-notes/rounding-of-forces.md, section 2): the root of a pair is within 2^-102 of its
   result. fast/number_pair.hpp, sqrt. Where underflow is kept away, as the windows of that note do. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles pair_sum quotient corrections pair_quotient.
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
  pose proof tiny_positive as tiny_pos. assert (0 < u) as u_pos by (unfold u; lra).
  destruct (orders ah a_pos) as (W_pos & Z_pos & ZW & first_ & second & cube).
  destruct (first_square ah a_pos no_underflow none_of_roots) as (f_range & _ & ff_near & p_near & tf_small).
  fold first p in f_range, ff_near, p_near, tf_small. destruct (root_squared ah a_pos) as (r_pos & r_square).
  set (H := ah) in *. set (W := u * H) in *. set (Z := u * u * H) in *.
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
  apply Rle_trans with (1 := corrected_root ah al a_pos a_tidy no_underflow none_of_roots c 5 ltac:(lra) c_off).
  apply Rmult_le_compat_r; [apply sqrt_pos |]. unfold pair_unit, u; simpl; lra.
Qed.
End Root.

Print Assumptions pair_root_error.
