(* Lemma pair-operations (proofs-notes/rounding-of-forces.md, section 2): quotient and root of pairs are within 2^-102 of
   their results. fast/number_pair.hpp, operator/ and sqrt: `rest` is a - first * b, or a - first * first, in pairs; its
   high part alone is divided. Where underflow is kept away, as the windows of that note do. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core Sterbenz.
From Groundtruth Require Import doubles pair_sum pair_product quotient corrections.
Open Scope R_scope.

(* Nearly equal doubles: their difference is one, and two_sum leaves nothing. *)
Lemma near_difference_is_exact : forall a b, is_double a -> is_double b -> Rabs (a - b) <= / 4 * Rabs a ->
  fl (a + - b) = a - b /\ rest a (- b) = 0.
Proof.
  intros a b Da Db near. assert (is_double (- b)) as Dm by now apply generic_format_opp.
  assert (is_double (a - b)) as Dd.
  { apply within in near. destruct (Rle_or_lt 0 a) as [pos | neg].
    - rewrite (Rabs_pos_eq a) in near by assumption.
      apply sterbenz; trivial; [now apply FLT_exp_valid | apply FLT_exp_monotone |]. split; lra.
    - rewrite (Rabs_left a) in near by assumption. replace (a - b) with (- (- a - - b)) by ring. apply generic_format_opp.
      apply sterbenz; [now apply FLT_exp_valid | apply FLT_exp_monotone | now apply generic_format_opp | assumption |]. split; lra. }
  assert (fl (a + - b) = a - b) as same by now apply fl_of_double.
  split; [assumption |]. pose proof (two_sum_is_exact a (- b) Da Dm) as exact. rewrite same in exact. lra.
Qed.

Section Quotient.

Variables ah al bh bl lost : R.
Hypotheses (Dah : is_double ah) (Dal : is_double al) (Dbh : is_double bh) (Dlost : is_double lost).
Hypotheses (a_some : ah <> 0) (b_some : bh <> 0) (a_tidy : Rabs al <= u * Rabs ah) (b_tidy : Rabs bl <= u * Rabs bh).
Let first := fl (ah / bh).
Let p := fl (first * bh).
Hypothesis lost_near : Rabs (lost - (first * bh - p)) <= 7 * tiny.
Hypotheses (no_underflow : tiny <= u * u * u * Rabs ah) (none_of_quotients : tiny * Rabs bh <= u * u * u * Rabs ah).

(* first * b: loose_product and tidy. *)
Let l := fl (lost + fl (first * bl)).
Let ph := fl (p + l).
Let pl := fl (l - fl (ph - p)).
(* a - that: loose_sum, of which tidy takes the sum for its high part. *)
Let s := fl (ah + - ph).
Let t := fl (rest ah (- ph) + fl (al + - pl)).
Let high := fl (s + t).
Let c := fl (high / bh).

Theorem pair_quotient_error : Rabs (first + c - (ah + al) / (bh + bl)) <= pair_unit * Rabs ((ah + al) / (bh + bl)).
Proof.
  set (H := Rabs ah) in *. assert (0 < H) by now apply Rabs_pos_lt. assert (0 < Rabs bh) by now apply Rabs_pos_lt.
  pose proof tiny_positive. assert (0 < u) by (unfold u; lra).
  destruct (orders H ltac:(assumption)) as (W_pos & Z_pos & ZW & first_ & second & cube).
  set (W := u * H) in *. set (Z := u * u * H) in *.
  pose proof (fl_error (ah / bh)) as f_near. fold first in f_near.
  assert (Rabs (first * bh - ah) <= (1 + / 1000) * W) as fb_near.
  { replace (first * bh - ah) with ((first - ah / bh) * bh) by (field; assumption). rewrite Rabs_mult.
    apply Rle_trans with ((u * Rabs (ah / bh) + tiny) * Rabs bh); [apply Rmult_le_compat_r; lra |].
    assert (Rabs (ah / bh) * Rabs bh = H) as whole by (rewrite <- Rabs_mult; unfold H; f_equal; field; assumption).
    replace ((u * Rabs (ah / bh) + tiny) * Rabs bh) with (u * (Rabs (ah / bh) * Rabs bh) + tiny * Rabs bh) by ring. rewrite whole. fold W. lra. }
  destruct (first_products ah bh bl first H) as (fb_size & p_near & y_size & y_off); trivial; [unfold H; lra | fold W; lra |].
  fold H p W Z in fb_size, p_near, y_size, y_off. set (y := fl (first * bl)) in *.
  assert (Rabs (first * bh - p) <= (1 + / 500) * W) as e_size by now rewrite Rabs_minus_sym.
  assert (Rabs lost <= (1 + / 400) * W) as lost_size.
  { replace lost with ((lost - (first * bh - p)) + (first * bh - p)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). unfold W, Z in *; lra. }
  assert (Rabs y <= (1 + / 500) * W) as yy by (replace y with (first * bl + (y - first * bl)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra).
  pose proof (sum_error lost y Dlost (fl_is_double _)) as l_near. fold l in l_near.
  assert (Rabs (lost + y) <= (2 + / 200) * W) as ls by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  pose proof (scaled _ _ u ltac:(lra) ls).
  assert (Rabs l <= (2 + / 100) * W) as l_size.
  { replace l with ((l - (lost + y)) + (lost + y)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite ZW in *; lra. }
  (* the product, tidy without loss *)
  assert ((1 - / 500) * H <= Rabs p) as p_size.
  { assert (H <= Rabs p + Rabs (ah - p)) by (unfold H; replace ah with (p + (ah - p)) at 1 by ring; apply Rabs_triang).
    assert (Rabs (ah - p) <= Rabs (first * bh - ah) + Rabs (first * bh - p)).
    { replace (ah - p) with ((first * bh - p) - (first * bh - ah)) by ring. apply Rle_trans with (1 := difference_size _ _). lra. } lra. }
  pose proof (tidy_is_exact p l (fl_is_double _) (fl_is_double _) ltac:(lra)) as product. fold ph pl in product.
  assert (Rabs (ph + pl - first * (bh + bl)) <= (3 + / 10) * Z) as product_near.
  { rewrite product. replace (p + l - first * (bh + bl)) with ((l - (lost + y)) + (lost - (first * bh - p)) + (y - first * bl)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _).
    assert (Rabs (l - (lost + y) + (lost - (first * bh - p))) <= Rabs (l - (lost + y)) + Rabs (lost - (first * bh - p))) by apply Rabs_triang.
    rewrite ZW in *; lra. }
  pose proof (sum_error_of_rounded p l (fl_is_double _) (fl_is_double _)) as ph_near. fold ph in ph_near.
  assert (Rabs p <= (1 + / 500) * H) as p_most.
  { replace p with (first * bh - (first * bh - p)) by ring. apply Rle_trans with (1 := difference_size _ _). lra. }
  assert (Rabs ph <= (1 + / 100) * H) as ph_size.
  { assert (Rabs ph <= Rabs (p + l) + Rabs (ph - (p + l))).
    { replace ph with ((p + l) + (ph - (p + l))) at 1 by ring. apply Rabs_triang. }
    assert (Rabs (p + l) <= Rabs p + Rabs l) by apply Rabs_triang. pose proof (Rabs_pos ph).
    assert (u * Rabs ph <= / 1000000 * Rabs ph) by (apply Rmult_le_compat_r; [lra | unfold u; lra]). lra. }
  pose proof (scaled _ _ u ltac:(lra) ph_size).
  assert (Rabs pl <= (1 + / 50) * W) as pl_size.
  { replace pl with (- (ph - (p + l))) by lra. rewrite Rabs_Ropp. unfold W in *; lra. }
  (* a - product *)
  assert (Rabs (ah - ph) <= (5 + / 10) * W) as d_size.
  { replace (ah - ph) with ((first * bh - p) - (first * bh - ah) - (l - pl)) by lra.
    apply Rle_trans with (1 := difference_size _ _).
    assert (Rabs (first * bh - p - (first * bh - ah)) <= Rabs (first * bh - p) + Rabs (first * bh - ah)) by apply difference_size.
    assert (Rabs (l - pl) <= Rabs l + Rabs pl) by apply difference_size. lra. }
  destruct (near_difference_is_exact ah ph Dah (fl_is_double _) ltac:(fold H; lra)) as (s_is & rest_is). fold s in s_is.
  assert (is_double (- pl)) by (apply generic_format_opp, fl_is_double).
  pose proof (sum_error al (- pl) Dal ltac:(assumption)) as t_near. change (al + - pl) with (al - pl) in t_near.
  assert (t = fl (al - pl)) as t_is.
  { unfold t. rewrite rest_is, Rplus_0_l. change (al + - pl) with (al - pl). apply fl_of_double, fl_is_double. }
  rewrite <- t_is in t_near.
  assert (Rabs (al - pl) <= (2 + / 40) * W) as ts by (apply Rle_trans with (1 := difference_size _ _); unfold W in *; lra).
  pose proof (scaled _ _ u ltac:(lra) ts).
  set (g := ah + al - first * (bh + bl)).
  assert (Rabs (s + t - g) <= (5 + / 5) * Z) as st_off.
  { rewrite s_is. replace (ah - ph + t - g) with ((t - (al - pl)) - (ph + pl - first * (bh + bl))) by (unfold g; ring).
    apply Rle_trans with (1 := difference_size _ _). rewrite ZW in *; lra. }
  assert (Rabs g <= (3 + / 40) * W) as g_size.
  { unfold g. replace (ah + al - first * (bh + bl)) with (al - (first * bh - ah) - first * bl) by ring.
    apply Rle_trans with (1 := difference_size _ _).
    assert (Rabs (al - (first * bh - ah)) <= Rabs al + Rabs (first * bh - ah)) by apply difference_size. unfold W in *; lra. }
  assert (is_double t) as Dt by apply fl_is_double.
  pose proof (sum_error s t (fl_is_double _) Dt) as h_near. fold high in h_near.
  assert (Rabs (s + t) <= (3 + / 20) * W) as sts.
  { replace (s + t) with ((s + t - g) + g) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  pose proof (scaled _ _ u ltac:(lra) sts).
  assert (Rabs (high - g) <= (8 + / 2) * Z) as h_off.
  { replace (high - g) with ((high - (s + t)) + (s + t - g)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite ZW in *; lra. }
  assert (Rabs high <= (3 + / 10) * W) as h_size.
  { replace high with ((high - g) + g) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  pose proof (fl_error (high / bh)) as c_near. fold c in c_near.
  assert (Rabs (c * bh - high) <= (3 + / 2) * Z) as c_off.
  { replace (c * bh - high) with ((c - high / bh) * bh) by (field; assumption). rewrite Rabs_mult.
    apply Rle_trans with ((u * Rabs (high / bh) + tiny) * Rabs bh); [apply Rmult_le_compat_r; lra |].
    assert (Rabs (high / bh) * Rabs bh = Rabs high) as whole by (rewrite <- Rabs_mult; f_equal; field; assumption).
    replace ((u * Rabs (high / bh) + tiny) * Rabs bh) with (u * (Rabs (high / bh) * Rabs bh) + tiny * Rabs bh) by ring. rewrite whole.
    pose proof (scaled _ _ u ltac:(lra) h_size). rewrite ZW in *; lra. }
  assert (Rabs (c * bh - g) <= 12 * Z) as total.
  { replace (c * bh - g) with ((c * bh - high) + (high - g)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  pose proof (corrected_quotient ah al bh bl first H ltac:(assumption) b_some b_tidy c (3 + / 40) 12
    ltac:(lra) ltac:(lra) g_size total) as near.
  apply Rle_trans with (1 := part_of_quotient ah al _ _ (12 + (3 + / 40) + / 10) a_some a_tidy (divisor_some bh bl b_some b_tidy) ltac:(lra) near).
  apply Rmult_le_compat_r; [apply Rabs_pos |]. unfold pair_unit, u; simpl; lra.
Qed.
End Quotient.

Print Assumptions near_difference_is_exact.
Print Assumptions pair_quotient_error.
