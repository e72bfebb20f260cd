(* Lemma quick-quotient (proofs-notes/rounding-of-forces.md, 9): quotient and square_root of fast/pairs.hpp, within
   2^-98 and 2^-101 of their results where the windows of that note keep underflow away. That the sorted sum, which then
   makes them tidy, loses nothing is Fast2Sum's (pair_sum.v: tidy_error). *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles quotient corrections.
Open Scope R_scope.

Section Quotient.

Variables ah al bh bl i lost S k : R.
Hypotheses (Dah : is_double ah) (Dal : is_double al) (Dlost : is_double lost).
(* The dividend may be loose, or what is left of a sum: S bounds its parts' sizes; k units its low part. *)
Hypotheses (S_some : 0 < S) (a_size : Rabs ah <= S) (k_range : 1 <= k <= 16) (a_low : Rabs al <= k * (u * S)).
Hypotheses (b_some : bh <> 0) (b_tidy : Rabs bl <= u * Rabs bh).
(* An approximate inverse, within 2^-50. *)
Hypothesis i_near : Rabs (i * bh - 1) <= 8 * u.
Let first := fl (ah * i).
Let p := fl (first * bh).
Hypothesis lost_near : Rabs (lost - (first * bh - p)) <= 7 * tiny.
Hypotheses (no_underflow : tiny <= u * u * u * S) (none_of_quotients : tiny * Rabs bh <= u * u * u * S).

Let rest := fl (fl (fl (ah - p) - lost) + fl (al - fl (first * bl))).
Let c := fl (rest * i).

Theorem loose_quotient_error :
  Rabs (first + c - (ah + al) / (bh + bl)) * Rabs (bh + bl) <= (138 + 12 * k) * (u * u * S) /\ Rabs (c * bh) <= (12 + k) * (u * S).
Proof.
  set (H := S) in *. assert (0 < Rabs bh) by now apply Rabs_pos_lt.
  pose proof tiny_positive as tiny_pos. assert (0 < u) as u_pos by (unfold u; lra).
  destruct (orders H S_some) as (W_pos & Z_pos & ZW & first_ & second & cube).
  set (W := u * H) in *. set (Z := u * u * H) in *.
  assert (0 <= k * Z <= 16 * Z) as kZ by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (0 <= k * W <= 16 * W) as kW by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  assert (k * Z = u * k * W) as kZW by (rewrite ZW; ring).
  (* first bh is near ah *)
  pose proof (fl_error (ah * i)) as f_near. fold first in f_near.
  assert (Rabs (ah * (i * bh - 1)) <= 8 * W) as off.
  { rewrite Rabs_mult. apply Rle_trans with (H * (8 * u)); [apply Rmult_le_compat; trivial; apply Rabs_pos | unfold W; lra]. }
  assert (Rabs (ah * i) * Rabs bh <= (1 + / 1000) * H) as whole.
  { rewrite <- Rabs_mult. replace (ah * i * bh) with (ah + ah * (i * bh - 1)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  assert (Rabs ((first - ah * i) * bh) <= (1 + / 500) * W) as rounded.
  { rewrite Rabs_mult. apply Rle_trans with ((u * Rabs (ah * i) + tiny) * Rabs bh); [apply Rmult_le_compat_r; lra |].
    replace ((u * Rabs (ah * i) + tiny) * Rabs bh) with (u * (Rabs (ah * i) * Rabs bh) + tiny * Rabs bh) by ring.
    assert (u * (Rabs (ah * i) * Rabs bh) <= u * ((1 + / 1000) * H)) by (apply Rmult_le_compat_l; lra). unfold W in *; lra. }
  assert (Rabs (first * bh - ah) <= (9 + / 100) * W) as fb_near.
  { replace (first * bh - ah) with ((first - ah * i) * bh + ah * (i * bh - 1)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  destruct (first_products ah bh bl first H) as (fb_size & p_near & y_size & y_off); trivial; [fold W; lra |].
  fold p W Z in fb_size, p_near, y_size, y_off.
  assert (is_double (- p)) by (apply generic_format_opp, fl_is_double). assert (is_double (- lost)) by now apply generic_format_opp.
  pose proof (sum_error ah (- p) Dah ltac:(assumption)) as d1_near. change (ah + - p) with (ah - p) in d1_near.
  set (d1 := fl (ah - p)) in *.
  assert (Rabs (ah - p) <= (10 + / 10) * W) as d1_size.
  { replace (ah - p) with (- (first * bh - ah) - (p - first * bh)) by ring.
    apply Rle_trans with (1 := difference_size _ _). rewrite Rabs_Ropp. unfold W in *; lra. }
  pose proof (scaled _ _ u ltac:(lra) d1_size). 
  pose proof (sum_error d1 (- lost) (fl_is_double _) ltac:(assumption)) as d2_near. change (d1 + - lost) with (d1 - lost) in d2_near.
  set (d2 := fl (d1 - lost)) in *.
  assert (Rabs (d1 - lost - (ah - first * bh)) <= (10 + / 5) * Z) as d2_off.
  { replace (d1 - lost - (ah - first * bh)) with ((d1 - (ah - p)) - (lost - (first * bh - p))) by ring.
    apply Rle_trans with (1 := difference_size _ _). unfold W, Z in *; lra. }
  assert (Rabs (d1 - lost) <= (9 + / 10) * W) as d2_size.
  { replace (d1 - lost) with ((d1 - lost - (ah - first * bh)) - (first * bh - ah)) by ring.
    apply Rle_trans with (1 := difference_size _ _). lra. }
  pose proof (scaled _ _ u ltac:(lra) d2_size).
  (* lower parts *)
  set (y := fl (first * bl)) in *.
  assert (is_double (- y)) by (apply generic_format_opp, fl_is_double).
  pose proof (sum_error al (- y) Dal ltac:(assumption)) as z_near. change (al + - y) with (al - y) in z_near. set (z := fl (al - y)) in *.
  assert (Rabs y <= (1 + / 100) * W) by (replace y with (first * bl + (y - first * bl)) by ring; apply Rle_trans with (1 := Rabs_triang _ _); lra).
  assert (Rabs (al - y) <= (k + 1 + / 20) * W) as z_size by (apply Rle_trans with (1 := difference_size _ _); unfold W in *; lra).
  pose proof (scaled _ _ u ltac:(lra) z_size).
  pose proof (sum_error d2 z (fl_is_double _) (fl_is_double _)) as r_near. fold rest in r_near.
  set (g := ah + al - first * (bh + bl)).
  assert (Rabs (d2 + z - g) <= (23 + k) * Z) as r_off.
  { replace (d2 + z - g) with ((d2 - (d1 - lost)) + (d1 - lost - (ah - first * bh)) + (z - (al - y)) - (y - first * bl)) by (unfold g; ring).
    apply Rle_trans with (1 := difference_size _ _).
    assert (Rabs (d2 - (d1 - lost) + (d1 - lost - (ah - first * bh)) + (z - (al - y)))
            <= Rabs (d2 - (d1 - lost)) + Rabs (d1 - lost - (ah - first * bh)) + Rabs (z - (al - y)))
      by (apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat_r, Rabs_triang).
    unfold W, Z in *; lra. }
  assert (Rabs g <= (10 + / 9 + k) * W) as g_size.
  { unfold g. replace (ah + al - first * (bh + bl)) with (al - first * bl - (first * bh - ah)) by ring.
    apply Rle_trans with (1 := difference_size _ _).
    assert (Rabs (al - first * bl) <= Rabs al + Rabs (first * bl)) by apply difference_size. unfold W in *; lra. }
  assert (Rabs (d2 + z) <= (10 + / 5 + k) * W) as rs.
  { replace (d2 + z) with ((d2 + z - g) + g) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  pose proof (scaled _ _ u ltac:(lra) rs).
  assert (Rabs (rest - g) <= (34 + 2 * k) * Z) as rest_off.
  { replace (rest - g) with ((rest - (d2 + z)) + (d2 + z - g)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). unfold W, Z in *; lra. }
  assert (Rabs rest <= (10 + / 4 + k) * W) as rest_size.
  { replace rest with ((rest - g) + g) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  (* c bh is near rest *)
  pose proof (fl_error (rest * i)) as c_near. fold c in c_near.
  assert (Rabs (rest * (i * bh - 1)) <= (82 + 8 * k) * Z) as ri.
  { rewrite Rabs_mult. apply Rle_trans with ((10 + / 4 + k) * W * (8 * u)); [apply Rmult_le_compat; trivial; apply Rabs_pos | rewrite ZW; lra]. }
  assert (Rabs (rest * i) * Rabs bh <= (10 + / 3 + k) * W) as ris.
  { rewrite <- Rabs_mult. replace (rest * i * bh) with (rest + rest * (i * bh - 1)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  assert (Rabs ((c - rest * i) * bh) <= (10 + / 2 + k) * Z) as cr.
  { rewrite Rabs_mult. apply Rle_trans with ((u * Rabs (rest * i) + tiny) * Rabs bh); [apply Rmult_le_compat_r; lra |].
    replace ((u * Rabs (rest * i) + tiny) * Rabs bh) with (u * (Rabs (rest * i) * Rabs bh) + tiny * Rabs bh) by ring.
    assert (u * (Rabs (rest * i) * Rabs bh) <= u * ((10 + / 3 + k) * W)) by (apply Rmult_le_compat_l; lra). rewrite ZW in *; lra. }
  assert (Rabs (c * bh - rest) <= (93 + 9 * k) * Z) as c_off.
  { replace (c * bh - rest) with ((c - rest * i) * bh + rest * (i * bh - 1)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  assert (Rabs (c * bh - g) <= (127 + 11 * k) * Z) as total.
  { replace (c * bh - g) with ((c * bh - rest) + (rest - g)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  split.
  - pose proof (corrected_quotient ah al bh bl first H S_some b_some b_tidy c (10 + / 9 + k) (127 + 11 * k)
      ltac:(lra) ltac:(lra) g_size total) as near. fold Z in near. lra.
  - replace (c * bh) with ((c * bh - rest) + rest) by ring. apply Rle_trans with (1 := Rabs_triang _ _). fold W. lra.
Qed.
End Quotient.

(* Of a tidy dividend: a part of the quotient. *)
Corollary quick_quotient_error : forall ah al bh bl i lost, is_double ah -> is_double al -> is_double lost -> ah <> 0 -> bh <> 0 ->
  Rabs al <= u * Rabs ah -> Rabs bl <= u * Rabs bh -> Rabs (i * bh - 1) <= 8 * u ->
  let first := fl (ah * i) in let p := fl (first * bh) in Rabs (lost - (first * bh - p)) <= 7 * tiny ->
  tiny <= u * u * u * Rabs ah -> tiny * Rabs bh <= u * u * u * Rabs ah ->
  let rest := fl (fl (fl (ah - p) - lost) + fl (al - fl (first * bl))) in
  Rabs (first + fl (rest * i) - (ah + al) / (bh + bl)) <= bpow radix2 (-98) * Rabs ((ah + al) / (bh + bl)).
Proof.
  intros ah al bh bl i lost Dah Dal Dlost a_some b_some a_tidy b_tidy i_near first p lost_near none none' rest.
  destruct (loose_quotient_error ah al bh bl i lost (Rabs ah) 1 Dah Dal Dlost (Rabs_pos_lt _ a_some) ltac:(lra) ltac:(lra) ltac:(lra)
    b_some b_tidy i_near lost_near none none') as (near & _).
  apply Rle_trans with (1 := part_of_quotient ah al _ _ (138 + 12 * 1) a_some a_tidy (divisor_some bh bl b_some b_tidy) ltac:(lra) near).
  apply Rmult_le_compat_r; [apply Rabs_pos |]. unfold u; simpl; lra.
Qed.

Section Root.

Variables ah al lost : R.
Hypotheses (Dah : is_double ah) (Dal : is_double al) (Dlost : is_double lost) (a_pos : 0 < ah) (a_tidy : Rabs al <= u * ah).
Let first := fl (sqrt ah).
Let inverse := fl (1 / first).
Let p := fl (first * first).
Hypothesis lost_near : Rabs (lost - (first * first - p)) <= 7 * tiny.
Hypotheses (no_underflow : tiny <= u * u * u * ah) (none_of_inverse : tiny * sqrt ah <= u * u) (none_of_roots : tiny <= u * u * u * sqrt ah).

Let rest := fl (fl (fl (ah - p) - lost) + al).
Let c := fl (rest * fl (/ 2 * inverse)).

Theorem quick_root_error : Rabs (first + c - sqrt (ah + al)) <= bpow radix2 (-101) * sqrt (ah + al).
Proof.
  pose proof tiny_positive as tiny_pos. assert (0 < u) as u_pos by (unfold u; lra).
  destruct (orders ah a_pos) as (W_pos & Z_pos & ZW & first_ & second & cube).
  destruct (first_square ah a_pos no_underflow none_of_roots) as (f_range & _ & ff_near & p_near & tf_small).
  fold first p in f_range, ff_near, p_near, tf_small. destruct (root_squared ah a_pos) as (r_pos & r_square).
  set (H := ah) in *. set (r := sqrt H) in *. set (W := u * H) in *. set (Z := u * u * H) in *.
  assert (is_double (- p)) by (apply generic_format_opp, fl_is_double). assert (is_double (- lost)) by now apply generic_format_opp.
  pose proof (sum_error H (- p) Dah ltac:(assumption)) as d1_near. change (H + - p) with (H - p) in d1_near. set (d1 := fl (H - p)) in *.
  assert (Rabs (H - p) <= (3 + / 10) * W) as d1_size.
  { replace (H - p) with (- (first * first - H) - (p - first * first)) by ring.
    apply Rle_trans with (1 := difference_size _ _). rewrite Rabs_Ropp. unfold W in *; lra. }
  pose proof (scaled _ _ u ltac:(lra) d1_size).
  pose proof (sum_error d1 (- lost) (fl_is_double _) ltac:(assumption)) as d2_near. change (d1 + - lost) with (d1 - lost) in d2_near.
  set (d2 := fl (d1 - lost)) in *.
  assert (Rabs (d1 - lost - (H - first * first)) <= (3 + / 5) * Z) as d2_off.
  { replace (d1 - lost - (H - first * first)) with ((d1 - (H - p)) - (lost - (first * first - p))) by ring.
    apply Rle_trans with (1 := difference_size _ _). unfold W, Z in *; lra. }
  assert (Rabs (d1 - lost) <= (2 + / 10) * W) as d2_size.
  { replace (d1 - lost) with ((d1 - lost - (H - first * first)) - (first * first - H)) by ring. apply Rle_trans with (1 := difference_size _ _). lra. }
  pose proof (scaled _ _ u ltac:(lra) d2_size).
  pose proof (sum_error d2 al (fl_is_double _) Dal) as r_near. fold rest in r_near.
  set (g := H + al - first * first).
  assert (Rabs (d2 + al - g) <= 6 * Z) as r_off.
  { replace (d2 + al - g) with ((d2 - (d1 - lost)) + (d1 - lost - (H - first * first))) by (unfold g; ring).
    apply Rle_trans with (1 := Rabs_triang _ _). unfold W, Z in *; lra. }
  assert (Rabs g <= (3 + / 20) * W) as g_size.
  { replace g with (al - (first * first - H)) by (unfold g; ring). apply Rle_trans with (1 := difference_size _ _). unfold W in *; lra. }
  assert (Rabs (d2 + al) <= (3 + / 10) * W) as rs.
  { replace (d2 + al) with ((d2 + al - g) + g) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  pose proof (scaled _ _ u ltac:(lra) rs).
  assert (Rabs (rest - g) <= (9 + / 2) * Z) as rest_off.
  { replace (rest - g) with ((rest - (d2 + al)) + (d2 + al - g)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). unfold W, Z in *; lra. }
  assert (Rabs rest <= (3 + / 5) * W) as rest_size.
  { replace rest with ((rest - g) + g) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  (* half the inverse: a power of two, but for underflow *)
  pose proof (fl_error (1 / first)) as i_near. fold inverse in i_near.
  pose proof (fl_error (/ 2 * inverse)) as h_near. set (h := fl (/ 2 * inverse)) in *.
  assert (1 / first * first = 1) as whole by (field; lra). assert (0 < 1 / first) by (apply Rdiv_lt_0_compat; lra).
  rewrite (Rabs_pos_eq (1 / first)) in i_near by lra.
  assert (tiny * first <= (1 + / 1000) * (u * u)) as tf by (apply Rle_trans with (tiny * ((1 + / 1000) * r)); [apply Rmult_le_compat_l |]; lra).
  assert (u * u <= / 1000 * u) by (apply Rmult_le_compat_r; [lra | unfold u; lra]).
  assert (Rabs (inverse * first - 1) <= (1 + / 100) * u) as if_near.
  { replace (inverse * first - 1) with ((inverse - 1 / first) * first) by (rewrite Rmult_minus_distr_r, whole; ring).
    rewrite Rabs_mult, (Rabs_pos_eq first) by lra.
    apply Rle_trans with ((u * (1 / first) + tiny) * first); [apply Rmult_le_compat_r; lra |].
    rewrite Rmult_plus_distr_r, (Rmult_assoc u), whole. lra. }
  apply within in if_near.
  assert (Rabs (h * first - / 2) <= (1 + / 10) * u) as hf_near.
  { replace (h * first - / 2) with ((h - / 2 * inverse) * first + / 2 * (inverse * first - 1)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_mult _ first), (Rabs_pos_eq first) by lra.
    assert (Rabs (h - / 2 * inverse) * first <= (u * Rabs (/ 2 * inverse) + tiny) * first) by (apply Rmult_le_compat_r; lra).
    assert (Rabs (/ 2 * inverse) * first = Rabs (/ 2 * (inverse * first))) as same.
    { rewrite <- (Rabs_pos_eq first) at 1 by lra. rewrite <- Rabs_mult. f_equal. ring. }
    replace ((u * Rabs (/ 2 * inverse) + tiny) * first) with (u * (Rabs (/ 2 * inverse) * first) + tiny * first) in * by ring.
    rewrite same in *. rewrite (Rabs_pos_eq (/ 2 * (inverse * first))) in * by (unfold u in *; lra).
    assert (u * (/ 2 * (inverse * first)) <= u * (/ 2 * (1 + / 100))) by (apply Rmult_le_compat_l; [lra | unfold u in *; lra]).
    assert (Rabs (/ 2 * (inverse * first - 1)) <= / 2 * ((1 + / 100) * u)) by (apply Rabs_le; lra). lra. }
  (* c first is near g / 2 *)
  pose proof (fl_error (rest * h)) as c_near. fold c in c_near.
  assert (Rabs (rest * (h * first - / 2)) <= 4 * Z) as rh.
  { rewrite Rabs_mult. apply Rle_trans with ((3 + / 5) * W * ((1 + / 10) * u)); [apply Rmult_le_compat; trivial; apply Rabs_pos | rewrite ZW; lra]. }
  assert (Rabs (rest * h) * first <= 2 * W) as rhs.
  { rewrite <- (Rabs_pos_eq first) at 1 by lra. rewrite <- Rabs_mult. replace (rest * h * first) with (/ 2 * rest + rest * (h * first - / 2)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_mult (/ 2)), (Rabs_pos_eq (/ 2)) by lra. lra. }
  assert (Rabs ((c - rest * h) * first) <= (2 + / 5) * Z) as cr.
  { rewrite Rabs_mult, (Rabs_pos_eq first) by lra. apply Rle_trans with ((u * Rabs (rest * h) + tiny) * first); [apply Rmult_le_compat_r; lra |].
    replace ((u * Rabs (rest * h) + tiny) * first) with (u * (Rabs (rest * h) * first) + tiny * first) by ring.
    assert (u * (Rabs (rest * h) * first) <= u * (2 * W)) by (apply Rmult_le_compat_l; lra). rewrite ZW in *; lra. }
  assert (Rabs (c * first - / 2 * g) <= (11 + / 4) * Z) as c_off.
  { replace (c * first - / 2 * g) with ((c - rest * h) * first + rest * (h * first - / 2) + / 2 * (rest - g)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_mult (/ 2)), (Rabs_pos_eq (/ 2)) by lra.
    assert (Rabs ((c - rest * h) * first + rest * (h * first - / 2)) <= Rabs ((c - rest * h) * first) + Rabs (rest * (h * first - / 2))) by apply Rabs_triang.
    lra. }
  apply Rle_trans with (1 := corrected_root ah al a_pos a_tidy no_underflow none_of_roots c (11 + / 4) ltac:(lra) c_off).
  apply Rmult_le_compat_r; [apply sqrt_pos |]. unfold u; simpl; lra.
Qed.
End Root.

Print Assumptions loose_quotient_error.
Print Assumptions quick_quotient_error.
Print Assumptions quick_root_error.
