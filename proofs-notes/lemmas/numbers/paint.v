(* Lemma clip-interval (proofs-notes/rounding.md), *Paint*: what fast/paint.cpp computes of Delta at the limits of a hit
   decides on which side of a half-space the hit lies. Sizes and bounds as in clip_interval.v. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles delta_error.
Open Scope R_scope.

Section Paint.

(* Delta at s in [0, 1] is A (1 - s) + B s. *)
Variables A B a b E E0 Q : R.
Hypotheses (a_is_double : is_double a) (b_is_double : is_double b).
Hypotheses (a_near : Rabs (a - A) <= E0) (b_near : Rabs (b - B) <= E0).
Hypotheses (a_size : Rabs a <= (1 + 5 * u) * Q + 4 * tiny) (b_size : Rabs b <= (1 + 5 * u) * Q + 4 * tiny).
Hypotheses (E0_positive : 0 <= E0) (Q_positive : 0 <= Q).
Hypothesis E_enough : E0 * (1 + / 512) + 12.9 * u * Q + error_floor / 4 <= E.

Definition delta_at s := A * (1 - s) + B * s.
Definition computed_at l := fl (a + fl (l * fl (b - a))).

Lemma computed_is_near : forall l, 0 <= l <= 1 -> Rabs (computed_at l - delta_at l) <= E.
Proof.
  intros l range. pose proof tiny_positive.
  assert (100 * tiny <= error_floor / 4) as floor.
  { assert (error_floor = 41538374868278621028243970633760768 * tiny) as -> by (destruct floors_and_tiny as [-> _]; reflexivity). lra. }
  set (S := (1 + 5 * u) * Q + 4 * tiny) in *. assert (0 <= S) by (unfold S, u; lra).
  assert (is_double (- a)) as Dm by now apply generic_format_opp.
  pose proof (sum_error b (- a) b_is_double Dm) as d_near. change (b + - a) with (b - a) in d_near. set (d := fl (b - a)) in *.
  assert (Rabs (b - a) <= 2 * S) as d_size.
  { unfold Rminus. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp. lra. }
  assert (u * Rabs (b - a) <= u * (2 * S)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (Rabs (d - (b - a)) <= 2 * u * S) as d_off by lra.
  assert (Rabs d <= (2 + / 1000) * S) as d_most.
  { replace d with ((b - a) + (d - (b - a))) by ring. apply Rle_trans with (1 := Rabs_triang _ _). unfold u in *; lra. }
  pose proof (fl_error (l * d)) as p_near. set (p := fl (l * d)) in *.
  assert (Rabs (l * d) <= (2 + / 1000) * S) as p_size.
  { rewrite Rabs_mult, (Rabs_pos_eq l) by lra. rewrite <- (Rmult_1_l ((2 + / 1000) * S)). apply Rmult_le_compat; try lra. apply Rabs_pos. }
  assert (u * Rabs (l * d) <= u * ((2 + / 1000) * S)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (Rabs (l * (d - (b - a))) <= 2 * u * S) as l_off.
  { rewrite Rabs_mult, (Rabs_pos_eq l) by lra. rewrite <- (Rmult_1_l (2 * u * S)). apply Rmult_le_compat; try lra. apply Rabs_pos. }
  pose proof (sum_error a p a_is_double (fl_is_double _)) as s_near. fold (computed_at l) in s_near.
  assert (Rabs (a + p) <= 4 * S + tiny) as s_size.
  { apply Rle_trans with (1 := Rabs_triang _ _).
    assert (Rabs p <= Rabs (l * d) + Rabs (p - l * d)) by (replace p with (l * d + (p - l * d)) at 1 by ring; apply Rabs_triang).
    unfold u in *; lra. }
  assert (u * Rabs (a + p) <= u * (4 * S + tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  change (fl (a + p)) with (computed_at l) in s_near.
  assert (Rabs (a + l * (b - a) - delta_at l) <= E0) as convex.
  { unfold delta_at. replace (a + l * (b - a) - (A * (1 - l) + B * l)) with ((1 - l) * (a - A) + l * (b - B)) by ring.
    apply within in a_near. apply within in b_near.
    assert ((1 - l) * (- E0) <= (1 - l) * (a - A) <= (1 - l) * E0) by (split; apply Rmult_le_compat_l; lra).
    assert (l * (- E0) <= l * (b - B) <= l * E0) by (split; apply Rmult_le_compat_l; lra). apply Rabs_le; lra. }
  apply within in s_near; apply within in p_near; apply within in l_off; apply within in convex.
  replace (l * (d - (b - a))) with (l * d - l * (b - a)) in l_off by ring.
  apply Rabs_le. unfold S, u in *; lra.
Qed.

(* Between two limits Delta lies between its values there. *)
Theorem hit_is_on_one_side : forall l h s, 0 <= l -> h <= 1 -> l <= s <= h ->
  (computed_at l < - E -> computed_at h < - E -> delta_at s < 0) /\ (E < computed_at l -> E < computed_at h -> 0 < delta_at s).
Proof.
  intros l h s low high between. pose proof (computed_is_near l ltac:(lra)) as at_l. pose proof (computed_is_near h ltac:(lra)) as at_h.
  apply within in at_l. apply within in at_h.
  destruct (Req_dec l h) as [same | differ].
  - assert (s = l) as -> by lra. split; intros; lra.
  - assert (delta_at s * (h - l) = delta_at l * (h - s) + delta_at h * (s - l)) as mixed by (unfold delta_at; ring).
    assert (0 < h - l) by lra. split; intros one two.
    + assert (delta_at l < 0) by lra. assert (delta_at h < 0) by lra. apply Rnot_le_lt. intros wrong.
      assert (0 <= delta_at s * (h - l)) by (apply Rmult_le_pos; lra).
      destruct (Req_dec s l) as [-> |]; [lra |]. assert (delta_at h * (s - l) < 0) by nra. assert (delta_at l * (h - s) <= 0) by nra. lra.
    + assert (0 < delta_at l) by lra. assert (0 < delta_at h) by lra. apply Rnot_le_lt. intros wrong.
      assert (delta_at s * (h - l) <= 0) by nra.
      destruct (Req_dec s l) as [-> |]; [lra |]. assert (0 < delta_at h * (s - l)) by nra. assert (0 <= delta_at l * (h - s)) by nra. lra.
Qed.
End Paint.

Print Assumptions computed_is_near.
Print Assumptions hit_is_on_one_side.
