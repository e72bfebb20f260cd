(* Lemma clip-interval (proofs-notes/rounding.md): the error bound of fast/cell.hpp bounds both Deltas of a half-space at
   the ends of a range, and the limits that the kernels compute for its crossing are limits.

   With E < 2^900 no sum or product that counts overflows, as |n|_1 X + |d| is then below 2^950; a middle that
   does is on its side of [0, 1]. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles delta_error.
Open Scope R_scope.

(* The kernels' limits of a crossing (fast/cell_kernels_body.hpp), as computed. *)
Definition slope a b := fl (a - b).
Definition middle a b := fl (a * fl (1 / slope a b)).
Definition margin E a b := Rabs (fl (E * fl (1 / slope a b))).
Definition lower_limit E a b := fl (middle a b - margin E a b).
Definition upper_limit E a b := fl (middle a b + margin E a b).

Section Crossing.

(* Delta at s in [0, 1] is A (1 - s) + B s. *)
Variables A B a b E E0 Q : R.
Hypotheses (a_is_double : is_double a) (b_is_double : is_double b).
Hypotheses (a_near : Rabs (a - A) <= E0) (b_near : Rabs (b - B) <= E0).
Hypotheses (a_size : Rabs a <= (1 + 5 * u) * Q + 4 * tiny) (b_size : Rabs b <= (1 + 5 * u) * Q + 4 * tiny).
Hypotheses (E0_positive : 0 <= E0) (Q_positive : 0 <= Q).
Hypotheses (E_enough : E0 * (1 + / 512) + 12.9 * u * Q + error_floor / 4 <= E) (E_usable : E < greatest_usable_error).
Hypothesis enters : 2 * E < slope a b.

Let w := slope a b.
Let d := a - b.

Lemma powers : error_floor = 41538374868278621028243970633760768 * tiny /\ tiny * (u * u) * bpow radix2 900 * 1267650600228229401496703205376 <= u * u * u
  /\ tiny * 1000000000000000000000000000000 <= u.
Proof.
  assert (u = bpow radix2 (-53)) as -> by reflexivity.
  destruct floors_and_tiny as [-> _]; split; [reflexivity |].
  change 1267650600228229401496703205376 with (bpow radix2 100); unfold tiny; rewrite <- !bpow_plus; split.
  - apply bpow_le; easy.
  - apply Rle_trans with (bpow radix2 (-1075) * bpow radix2 100); [apply Rmult_le_compat_l; [apply bpow_ge_0 | simpl; lra] |].
    rewrite <- bpow_plus; apply bpow_le; easy.
Qed.

Lemma slope_facts : 0 < w /\ 0 < d /\ Rabs (d - w) <= (u + 2 * u * u) * w /\ w <= (1 + u) * (2 * (1 + 5 * u) * Q + 8 * tiny).
Proof.
  pose proof tiny_positive; destruct powers as [floor _].
  assert (0 <= 12.9 * u * Q) by (unfold u; lra).
  assert (0 < w) by (unfold w; lra).
  pose proof (sum_error a (- b) a_is_double (generic_format_opp _ _ _ b_is_double)) as near.
  change (a + - b) with d in near; change (fl d) with w in near.
  assert (0 < d).
  { apply Rnot_le_lt; intro wrong; rewrite (Rabs_left1 d wrong) in near; apply within in near; unfold u in *; lra. }
  rewrite (Rabs_pos_eq d) in near by lra; apply within in near.
  apply within in a_size; apply within in b_size.
  assert (d <= 2 * (1 + 5 * u) * Q + 8 * tiny) by (unfold d; lra).
  repeat split; try assumption; [apply Rabs_le |]; unfold u in *; lra.
Qed.

Lemma slope_in_range : w * tiny <= u / 1000000.
Proof.
  destruct slope_facts as (w_positive & _ & _ & w_size); destruct powers as (floor & far & small); pose proof tiny_positive.
  assert (12.9 * u * Q <= bpow radix2 900) by (pose proof E_usable as usable; unfold greatest_usable_error in usable; lra).
  assert (w <= bpow radix2 900 / (6 * u)).
  { apply Rle_trans with (1 := w_size).
    assert (tiny <= bpow radix2 900) by (apply Rle_trans with 1; [unfold u in *; lra | apply (bpow_le radix2 0 900); easy]).
    unfold u in *; lra. }
  apply Rle_trans with (bpow radix2 900 / (6 * u) * tiny); [apply Rmult_le_compat_r; lra |].
  unfold u in *; lra.
Qed.

(* All divided by the slope. *)
Lemma scaled : exists alpha delta rho eps eps0 : R,
  a = alpha * w /\ d = delta * w /\ E = eps * w /\ E0 = eps0 * w /\ fl (1 / w) = rho / w /\
  Rabs (delta - 1) <= u + 2 * u * u /\ Rabs (rho - 1) <= u * 1.00001 /\
  0 <= eps0 /\ eps < / 2 /\ eps0 * (1 + / 512) + 6.4 * u <= eps.
Proof.
  destruct slope_facts as (w_positive & _ & d_near & w_size); pose proof slope_in_range as in_range.
  destruct powers as (floor & _ & small); pose proof tiny_positive.
  exists (a / w), (d / w), (fl (1 / w) * w), (E / w), (E0 / w).
  pose proof (fl_error (1 / w)) as near; rewrite (Rabs_pos_eq (1 / w)) in near
    by (apply Rlt_le, Rdiv_lt_0_compat; lra).
  apply within in near; apply within in d_near.
  repeat split; try (field; lra).
  - apply Rabs_le; split; apply Rmult_le_reg_r with w; try assumption;
      replace ((d / w - 1) * w) with (d - w) by (field; lra); lra.
  - assert (u / w * w = u) as uw by (field; lra).
    assert (1 / w * w = 1) as ww by (field; lra).
    apply Rabs_le; split.
    + apply Rle_trans with (- (u * (1 / w) + tiny) * w).
      * replace (- (u * (1 / w) + tiny) * w) with (- (u / w * w) - w * tiny) by (field; lra); unfold u in *; lra.
      * replace (fl (1 / w) * w - 1) with ((fl (1 / w) - 1 / w) * w) by (field; lra); apply Rmult_le_compat_r; lra.
    + apply Rle_trans with ((u * (1 / w) + tiny) * w).
      * replace (fl (1 / w) * w - 1) with ((fl (1 / w) - 1 / w) * w) by (field; lra); apply Rmult_le_compat_r; lra.
      * replace ((u * (1 / w) + tiny) * w) with (u / w * w + w * tiny) by (field; lra); unfold u in *; lra.
  - apply Rle_mult_inv_pos; assumption.
  - apply Rmult_lt_reg_r with w; [assumption |]; replace (E / w * w) with E by (field; lra); unfold w; lra.
  - apply Rmult_le_reg_r with w; [assumption |].
    replace ((E0 / w * (1 + / 512) + 6.4 * u) * w) with (E0 * (1 + / 512) + 6.4 * u * w) by (field; lra).
    replace (E / w * w) with E by (field; lra).
    assert (u * w <= u * ((1 + u) * (2 * (1 + 5 * u) * Q + 8 * tiny))) by (apply Rmult_le_compat_l; [unfold u |]; lra).
    unfold u in *; lra.
Qed.

Lemma convex_error : forall s, 0 <= s <= 1 -> Rabs (a - s * d - (A * (1 - s) + B * s)) <= E0.
Proof.
  intros s Hs; replace (a - s * d - (A * (1 - s) + B * s)) with ((a - A) * (1 - s) + (b - B) * s) by (unfold d; ring).
  apply within in a_near; apply within in b_near; apply Rabs_le; nra.
Qed.

(* Before the last rounding the limits are two units wide of any place on the wrong side. *)
Lemma limits_before_rounding : forall s, 0 <= s <= 1 ->
  (A * (1 - s) + B * s <= 0 -> middle a b - margin E a b <= s - 2 * u) /\ (0 <= A * (1 - s) + B * s -> s + 2 * u <= middle a b + margin E a b).
Proof.
  intros s Hs; pose proof (convex_error s Hs) as near; apply within in near.
  destruct scaled as (alpha & delta & rho & eps & eps0 & Ha & Hd & HE & HE0 & Hr & delta_1 & rho_1 & eps0_0 & eps_half & enough).
  destruct slope_facts as (w_positive & _); destruct powers as (_ & _ & small); pose proof tiny_positive.
  unfold middle, margin; fold w; rewrite Hr.
  replace (a * (rho / w)) with (alpha * rho) by (rewrite Ha; field; lra).
  replace (E * (rho / w)) with (eps * rho) by (rewrite HE; field; lra).
  apply within in delta_1; apply within in rho_1.
  assert (0 <= rho) by (unfold u in *; lra).
  assert (0 <= eps) by (unfold u in *; lra).
  pose proof (product_at_least eps rho ltac:(assumption) ltac:(assumption)) as g_least.
  set (g := Rabs (fl (eps * rho))).
  assert (fl (eps * rho) <= g) by (unfold g; apply magnitude).
  set (m := fl (alpha * rho)).
  pose proof (fl_error (alpha * rho)) as m_near; fold m in m_near.
  assert (eps * (1 - u * 1.00001) <= eps * rho) by (apply Rmult_le_compat_l; lra).
  assert (s * (1 - (u + 2 * u * u)) <= s * delta <= s * (1 + (u + 2 * u * u))) by (split; apply Rmult_le_compat_l; lra).
  split; intros side.
  - assert (alpha - s * delta <= eps0).
    { apply Rmult_le_reg_r with w; [assumption |]; rewrite Rmult_minus_distr_r, Rmult_assoc, <- Ha, <- Hd, <- HE0; lra. }
    destruct (Rle_or_lt alpha 0) as [before | after].
    + assert (m <= 0); [| unfold u in *; lra].
      replace 0 with (fl 0) by (apply fl_of_double, generic_format_0); apply fl_monotone; nra.
    + rewrite (Rabs_pos_eq (alpha * rho)) in m_near by nra; apply within in m_near.
      assert (alpha * rho <= alpha * (1 + u * 1.00001)) by (apply Rmult_le_compat_l; lra).
      unfold u in *; lra.
  - assert (- eps0 <= alpha - s * delta).
    { apply Rmult_le_reg_r with w; [assumption |]; rewrite Rmult_minus_distr_r, Rmult_assoc, <- Ha, <- Hd.
      replace (- eps0 * w) with (- E0) by (rewrite HE0; ring); lra. }
    destruct (Rle_or_lt 0 alpha) as [positive | negative].
    + rewrite (Rabs_pos_eq (alpha * rho)) in m_near by nra; apply within in m_near.
      assert (alpha * (1 - u * 1.00001) <= alpha * rho) by (apply Rmult_le_compat_l; lra).
      unfold u in *; lra.
    + rewrite (Rabs_left1 (alpha * rho)) in m_near by nra; apply within in m_near.
      assert (alpha * (1 + u * 1.00001) <= alpha * rho) by nra.
      unfold u in *; lra.
Qed.

(* Strictly: a place at a limit is on the right side, at the ends of the range too. *)
Theorem entered_after_lower : forall s, 0 <= s <= 1 -> A * (1 - s) + B * s <= 0 -> lower_limit E a b < s.
Proof.
  intros s Hs side; destruct (limits_before_rounding s Hs) as [wide _]; specialize (wide side); destruct powers as (_ & _ & small).
  apply Rle_lt_trans with (fl (s - 2 * u)); [now apply fl_monotone |].
  pose proof (fl_error (s - 2 * u)) as near; assert (Rabs (s - 2 * u) <= 1) by (apply Rabs_le; unfold u; lra).
  apply within in near; unfold u in *; lra.
Qed.

Theorem left_before_upper : forall s, 0 <= s <= 1 -> 0 <= A * (1 - s) + B * s -> s < upper_limit E a b.
Proof.
  intros s Hs side; destruct (limits_before_rounding s Hs) as [_ wide]; specialize (wide side); destruct powers as (_ & _ & small).
  apply Rlt_le_trans with (fl (s + 2 * u)); [| now apply fl_monotone].
  pose proof (fl_error (s + 2 * u)) as near; assert (Rabs (s + 2 * u) <= 1 + 2 * u) by (apply Rabs_le; unfold u; lra).
  apply within in near; unfold u in *; lra.
Qed.

End Crossing.

(* The same for a half-space that is left: mirrored. *)
Lemma fl_opp : forall x, fl (- x) = - fl x.
Proof. intros; apply round_NE_opp. Qed.

Lemma mirrored : forall E a b, lower_limit E (- a) (- b) = lower_limit E a b /\ upper_limit E (- a) (- b) = upper_limit E a b
  /\ slope (- a) (- b) = - slope a b.
Proof.
  intros E a b.
  assert (slope (- a) (- b) = - slope a b) as turned.
  { unfold slope; rewrite <- fl_opp; f_equal; ring. }
  assert (fl (1 / - slope a b) = - fl (1 / slope a b)) as inverse.
  { rewrite <- fl_opp; f_equal; unfold Rdiv; rewrite Rinv_opp; ring. }
  assert (middle (- a) (- b) = middle a b) as same_middle.
  { unfold middle; rewrite turned, inverse; f_equal; ring. }
  assert (margin E (- a) (- b) = margin E a b) as same_margin.
  { unfold margin; rewrite turned, inverse.
    replace (E * - fl (1 / slope a b)) with (- (E * fl (1 / slope a b))) by ring.
    rewrite fl_opp; apply Rabs_Ropp. }
  unfold lower_limit, upper_limit; rewrite same_middle, same_margin, turned; auto.
Qed.

Section Together.

Variables n1 n2 n3 d N D X e : R.
Variables x1 x2 x3 p1 p2 p3 y1 y2 y3 q1 q2 q3 : R. (* first end: computed x, exact p; last end: y, q *)
Hypotheses (d_is_double : is_double d) (N_is : Rabs n1 + Rabs n2 + Rabs n3 <= N) (D_is : Rabs d <= D).
Hypotheses (X1 : Rabs x1 <= X) (X2 : Rabs x2 <= X) (X3 : Rabs x3 <= X).
Hypotheses (Y1 : Rabs y1 <= X) (Y2 : Rabs y2 <= X) (Y3 : Rabs y3 <= X).
Hypotheses (P1 : Rabs (x1 - p1) <= e) (P2 : Rabs (x2 - p2) <= e) (P3 : Rabs (x3 - p3) <= e).
Hypotheses (Q1 : Rabs (y1 - q1) <= e) (Q2 : Rabs (y2 - q2) <= e) (Q3 : Rabs (y3 - q3) <= e).

Let a := computed_delta n1 n2 n3 d x1 x2 x3.
Let b := computed_delta n1 n2 n3 d y1 y2 y3.
Let A := exact_delta n1 n2 n3 d p1 p2 p3.
Let B := exact_delta n1 n2 n3 d q1 q2 q3.
Let E := error_bound N D X e.
Let E0 := least_error N D X e.

Lemma sizes_are_not_negative : 0 <= N /\ 0 <= D /\ 0 <= X /\ 0 <= e.
Proof.
  pose proof (Rabs_pos n1); pose proof (Rabs_pos n2); pose proof (Rabs_pos n3); pose proof (Rabs_pos d).
  pose proof (Rabs_pos x1); pose proof (Rabs_pos (x1 - p1)); repeat split; lra.
Qed.

Lemma bound_is_enough : 0 <= E0 /\ E0 * (1 + / 512) + 12.9 * u * (N * X + D) + error_floor / 4 <= E.
Proof.
  destruct sizes_are_not_negative as (HN & HD & HX & He).
  pose proof (error_bound_at_least N D X e HN HD HX He) as least; fold E in least.
  destruct floors_and_tiny as [floor _]; pose proof tiny_positive.
  change (bpow radix2 115) with 41538374868278621028243970633760768 in floor.
  assert (0 <= N * X) by (apply Rmult_le_pos; assumption).
  assert (0 <= N * e) by (apply Rmult_le_pos; assumption).
  unfold E0, least_error, u in *; lra.
Qed.

Lemma bound_exceeds_errors : E0 <= E.
Proof.
  destruct bound_is_enough as [positive enough]; destruct sizes_are_not_negative as (HN & HD & HX & He).
  assert (0 <= N * X) by (apply Rmult_le_pos; assumption).
  assert (0 < error_floor) by apply bpow_gt_0; unfold u in *; lra.
Qed.

Theorem signs_are_certain : (a < - E -> A < 0) /\ (E < a -> 0 < A) /\ (b < - E -> B < 0) /\ (E < b -> 0 < B).
Proof.
  pose proof bound_exceeds_errors.
  pose proof (delta_error n1 n2 n3 d x1 x2 x3 p1 p2 p3 N D X e d_is_double N_is D_is X1 X2 X3 P1 P2 P3) as near_a.
  pose proof (delta_error n1 n2 n3 d y1 y2 y3 q1 q2 q3 N D X e d_is_double N_is D_is Y1 Y2 Y3 Q1 Q2 Q3) as near_b.
  fold a A E0 in near_a; fold b B E0 in near_b; apply within in near_a; apply within in near_b; repeat split; lra.
Qed.

(* A place s of the range lies in the half-space iff A (1 - s) + B s <= 0. *)
Theorem crossing_is_between_limits : E < greatest_usable_error -> forall s, 0 <= s <= 1 ->
  (2 * E < slope a b ->
    (A * (1 - s) + B * s <= 0 -> lower_limit E a b < s) /\ (0 <= A * (1 - s) + B * s -> s < upper_limit E a b)) /\
  (slope a b < - (2 * E) ->
    (0 <= A * (1 - s) + B * s -> lower_limit E a b < s) /\ (A * (1 - s) + B * s <= 0 -> s < upper_limit E a b)).
Proof.
  intros usable s Hs; destruct bound_is_enough as [positive enough].
  destruct sizes_are_not_negative as (HN & HD & HX & He).
  assert (0 <= N * X + D) as Q_positive by (pose proof (Rmult_le_pos N X HN HX); lra).
  pose proof (delta_error n1 n2 n3 d x1 x2 x3 p1 p2 p3 N D X e d_is_double N_is D_is X1 X2 X3 P1 P2 P3) as near_a.
  pose proof (delta_error n1 n2 n3 d y1 y2 y3 q1 q2 q3 N D X e d_is_double N_is D_is Y1 Y2 Y3 Q1 Q2 Q3) as near_b.
  pose proof (delta_size n1 n2 n3 d x1 x2 x3 N D X d_is_double N_is D_is X1 X2 X3) as size_a.
  pose proof (delta_size n1 n2 n3 d y1 y2 y3 N D X d_is_double N_is D_is Y1 Y2 Y3) as size_b.
  fold a A E0 in near_a; fold b B E0 in near_b; fold a in size_a; fold b in size_b.
  assert (is_double a) as double_a by apply fl_is_double; assert (is_double b) as double_b by apply fl_is_double.
  split; intros steep.
  - split; intros side.
    + now apply (entered_after_lower A B a b E E0 (N * X + D)).
    + now apply (left_before_upper A B a b E E0 (N * X + D)).
  - destruct (mirrored E a b) as (same_lower & same_upper & turned).
    assert (Rabs (- a - - A) <= E0) by (replace (- a - - A) with (- (a - A)) by ring; now rewrite Rabs_Ropp).
    assert (Rabs (- b - - B) <= E0) by (replace (- b - - B) with (- (b - B)) by ring; now rewrite Rabs_Ropp).
    assert (is_double (- a)) by now apply generic_format_opp.
    assert (is_double (- b)) by now apply generic_format_opp.
    rewrite <- (Rabs_Ropp a) in size_a; rewrite <- (Rabs_Ropp b) in size_b.
    rewrite <- same_lower, <- same_upper; split; intros side.
    + apply (entered_after_lower (- A) (- B) (- a) (- b) E E0 (N * X + D)); auto; lra.
    + apply (left_before_upper (- A) (- B) (- a) (- b) E E0 (N * X + D)); auto; lra.
Qed.

End Together.

Print Assumptions signs_are_certain.
Print Assumptions crossing_is_between_limits.
