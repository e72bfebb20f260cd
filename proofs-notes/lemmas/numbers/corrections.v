(* Lemmas pair-operations and quick-quotient (proofs-notes/rounding-of-forces.md, sections 2 and 9), what every quotient and
   root of pairs has in common: a first one, of the high parts, is rounded; what it leaves of the dividend is divided and
   added. How far off the first one is, and what the correction's own error does to the sum. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles quotient.
Open Scope R_scope.

Lemma scaled : forall x y c, 0 <= c -> Rabs x <= y -> c * Rabs x <= c * y.
Proof. intros. now apply Rmult_le_compat_l. Qed.

(* Each order of the unit is small beside the one before. *)
Lemma orders : forall H, 0 < H -> 0 < u * H /\ 0 < u * u * H /\ u * u * H = u * (u * H) /\ u * H <= / 1000000 * H
  /\ u * u * H <= / 1000000 * (u * H) /\ u * u * u * H <= / 1000 * (u * u * H).
Proof.
  intros H some. assert (0 < u * H) by (apply Rmult_lt_0_compat; [unfold u; lra | assumption]).
  assert (0 < u * u * H) by (rewrite Rmult_assoc; apply Rmult_lt_0_compat; [unfold u; lra | assumption]).
  replace (u * u * u * H) with (u * (u * u * H)) by ring. repeat split; trivial; try ring.
  - apply Rmult_le_compat_r; [lra | unfold u; lra].
  - rewrite Rmult_assoc. apply Rmult_le_compat_r; [lra | unfold u; lra].
  - apply Rmult_le_compat_r; [lra | unfold u; lra].
Qed.

Section Quotient.

(* The dividend's parts may be less than S, as in a sum of which they are left; b is tidy. *)
Variables ah al bh bl first S : R.
Hypotheses (S_some : 0 < S) (a_size : Rabs ah <= S) (b_some : bh <> 0) (b_tidy : Rabs bl <= u * Rabs bh).
Hypothesis no_underflow : tiny <= u * u * u * S.
Local Notation W := (u * S).
Local Notation Z := (u * u * S).
Hypothesis first_near : Rabs (first * bh - ah) <= 10 * W.
Let p := fl (first * bh).
Let y := fl (first * bl).

Lemma first_products : Rabs (first * bh) <= (1 + / 1000) * S /\ Rabs (p - first * bh) <= (1 + / 500) * W
  /\ Rabs (first * bl) <= (1 + / 1000) * W /\ Rabs (y - first * bl) <= (1 + / 100) * Z.
Proof.
  destruct (orders S S_some) as (W_pos & Z_pos & ZW & W_H & Z_W & cube). pose proof tiny_positive.
  assert (0 < u) by (unfold u; lra).
  assert (Rabs (first * bh) <= (1 + / 1000) * S) as size.
  { replace (first * bh) with (ah + (first * bh - ah)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  pose proof (fl_error (first * bh)) as p_near. fold p in p_near. pose proof (scaled _ _ u ltac:(lra) size) as p_size.
  assert (Rabs (first * bl) <= (1 + / 1000) * W) as low.
  { rewrite Rabs_mult. apply Rle_trans with (Rabs first * (u * Rabs bh)); [apply Rmult_le_compat_l; [apply Rabs_pos | assumption] |].
    replace (Rabs first * (u * Rabs bh)) with (u * Rabs (first * bh)) by (rewrite Rabs_mult; ring). lra. }
  pose proof (fl_error (first * bl)) as y_near. fold y in y_near. pose proof (scaled _ _ u ltac:(lra) low) as y_size.
  repeat split; trivial; lra.
Qed.

Lemma divisor_some : bh + bl <> 0.
Proof.
  intros zero. pose proof (Rabs_pos_lt _ b_some). assert (Rabs bl = Rabs bh) as e by (replace bl with (- bh) by lra; apply Rabs_Ropp).
  rewrite e in b_tidy. unfold u in *; lra.
Qed.

(* What the first quotient leaves of the dividend. *)
Let g := ah + al - first * (bh + bl).

Lemma corrected_quotient : forall c G K, 0 <= K <= 1000 -> 0 <= G <= 100 -> Rabs g <= G * W -> Rabs (c * bh - g) <= K * Z ->
  Rabs (first + c - (ah + al) / (bh + bl)) * Rabs (bh + bl) <= (K + G + / 10) * Z.
Proof.
  intros c G K HK HG g_size c_near. destruct (orders S S_some) as (W_pos & Z_pos & ZW & W_H & Z_W & cube).
  assert (0 < u) by (unfold u; lra). pose proof divisor_some as some.
  assert (Rabs (c * bl) <= (G + / 10) * Z) as low.
  { rewrite Rabs_mult. apply Rle_trans with (Rabs c * (u * Rabs bh)); [apply Rmult_le_compat_l; [apply Rabs_pos | assumption] |].
    replace (Rabs c * (u * Rabs bh)) with (u * Rabs (c * bh)) by (rewrite Rabs_mult; ring). rewrite ZW.
    replace ((G + / 10) * (u * W)) with (u * ((G + / 10) * W)) by ring. apply Rmult_le_compat_l; [lra |].
    replace (c * bh) with ((c * bh - g) + g) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
    assert (K * Z <= 1000 * (/ 1000000 * W)) by (apply Rmult_le_compat; lra). lra. }
  rewrite <- Rabs_mult. replace ((first + c - (ah + al) / (bh + bl)) * (bh + bl)) with ((c * bh - g) + c * bl) by (unfold g; field; assumption).
  apply Rle_trans with (1 := Rabs_triang _ _). lra.
Qed.
End Quotient.

(* Of a tidy dividend, S = |a_h|, that is a part of the quotient. *)
Lemma part_of_quotient : forall ah al b error K, ah <> 0 -> Rabs al <= u * Rabs ah -> b <> 0 -> 0 <= K ->
  Rabs error * Rabs b <= K * (u * u * Rabs ah) -> Rabs error <= K * (1 + / 500) * (u * u) * Rabs ((ah + al) / b).
Proof.
  intros ah al b error K some tidy b_some HK near. assert (0 < Rabs b) by now apply Rabs_pos_lt. assert (0 < Rabs ah) by now apply Rabs_pos_lt.
  apply Rmult_le_reg_r with (Rabs b); [assumption |]. apply Rle_trans with (1 := near).
  rewrite (Rmult_assoc _ (Rabs ((ah + al) / _))), <- Rabs_mult. replace ((ah + al) / b * b) with (ah + al) by (field; assumption).
  assert (Rabs ah <= Rabs (ah + al) + Rabs al) by (replace ah with (ah + al - al) at 1 by ring; apply difference_size).
  rewrite !Rmult_assoc. apply Rmult_le_compat_l; [assumption |].
  replace ((1 + / 500) * (u * (u * Rabs (ah + al)))) with (u * (u * ((1 + / 500) * Rabs (ah + al)))) by ring.
  apply Rmult_le_compat_l; [unfold u; lra |]. apply Rmult_le_compat_l; [unfold u; lra |]. unfold u in *; lra.
Qed.

Section Root.

Variables ah al : R.
Hypotheses (a_pos : 0 < ah) (a_tidy : Rabs al <= u * ah).
Let first := fl (sqrt ah).
Let p := fl (first * first).
Hypotheses (no_underflow : tiny <= u * u * u * ah) (none_of_roots : tiny <= u * u * u * sqrt ah).
Local Notation r := (sqrt ah).
Local Notation W := (u * ah).
Local Notation Z := (u * u * ah).

Lemma root_squared : 0 < r /\ r * r = ah.
Proof. split; [now apply sqrt_lt_R0 | apply sqrt_sqrt; lra]. Qed.

Lemma first_square : (1 - / 1000) * r <= first <= (1 + / 1000) * r /\ Rabs (first - r) <= (1 + / 1000) * u * r
  /\ Rabs (first * first - ah) <= (2 + / 100) * W /\ Rabs (p - first * first) <= (1 + / 500) * W /\ tiny * first <= / 10 * Z.
Proof.
  destruct root_squared as (r_pos & r_square). destruct (orders ah a_pos) as (W_pos & Z_pos & ZW & W_H & Z_W & cube).
  destruct (orders r r_pos) as (ur_pos & _ & _ & ur_small & uur_small & cube_r). pose proof tiny_positive. assert (0 < u) by (unfold u; lra).
  pose proof (fl_error r) as f_near. fold first in f_near. rewrite (Rabs_pos_eq r) in f_near by lra.
  assert (Rabs (first - r) <= (1 + / 1000) * u * r) as off by lra.
  pose proof (within _ _ off) as range.
  assert ((1 - / 1000) * r <= first <= (1 + / 1000) * r) as f_range by lra.
  assert (Rabs (first * first - ah) <= (2 + / 100) * W) as near.
  { replace (first * first - ah) with ((first - r) * (first + r)) by (ring_simplify; lra). rewrite Rabs_mult.
    apply Rle_trans with ((1 + / 1000) * u * r * ((2 + / 1000) * r)).
    - apply Rmult_le_compat; try apply Rabs_pos; [assumption | rewrite Rabs_pos_eq by lra; lra].
    - replace ((1 + / 1000) * u * r * ((2 + / 1000) * r)) with ((1 + / 1000) * (2 + / 1000) * (u * (r * r))) by ring.
      rewrite r_square. lra. }
  assert (Rabs (first * first) <= (1 + / 1000) * ah) as size.
  { replace (first * first) with (ah + (first * first - ah)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_pos_eq ah) by lra. lra. }
  pose proof (fl_error (first * first)) as p_near. fold p in p_near. pose proof (scaled _ _ u ltac:(lra) size) as p_size.
  repeat split; trivial; try lra.
  apply Rle_trans with (u * u * u * r * ((1 + / 1000) * r)); [apply Rmult_le_compat; lra |].
  replace (u * u * u * r * ((1 + / 1000) * r)) with ((1 + / 1000) * (u * u * u * (r * r))) by ring. rewrite r_square. lra.
Qed.

(* What the first root's square leaves. *)
Let g := ah + al - first * first.

Lemma corrected_root : forall c K, 0 <= K -> Rabs (c * first - / 2 * g) <= K * Z ->
  Rabs (first + c - sqrt (ah + al)) <= (K + 2) * (1 + / 200) * (u * u) * sqrt (ah + al).
Proof.
  intros c K HK c_near. destruct root_squared as (r_pos & r_square). destruct first_square as (f_range & off & f_near & _ & _).
  destruct (orders ah a_pos) as (W_pos & Z_pos & ZW & W_H & Z_W & _). assert (0 < u) by (unfold u; lra).
  assert (Rabs g <= (3 + / 20) * W) as g_size.
  { replace g with (al - (first * first - ah)) by (unfold g; ring). apply Rle_trans with (1 := difference_size _ _). lra. }
  pose proof (within _ _ a_tidy) as tidy.
  set (q := sqrt (ah + al)). assert (0 < q) by (apply sqrt_lt_R0; lra).
  assert (q * q = ah + al) as q_square by (apply sqrt_sqrt; lra).
  assert ((1 - / 1000) * r <= q) as q_low by (apply Rnot_lt_le; intros less; nra).
  assert (g = (q - first) * (q + first)) as g_is by (unfold g; rewrite <- q_square; ring).
  assert (Rabs (q - first) <= (1 + 6 / 10) * u * r) as near.
  { apply Rmult_le_reg_r with (q + first); [lra |]. rewrite <- (Rabs_pos_eq (q + first)) at 1 by lra. rewrite <- Rabs_mult, <- g_is.
    apply Rle_trans with (1 := g_size). apply Rle_trans with ((1 + 6 / 10) * u * r * ((2 - / 500) * r)).
    - replace ((1 + 6 / 10) * u * r * ((2 - / 500) * r)) with ((1 + 6 / 10) * (2 - / 500) * (u * (r * r))) by ring. rewrite r_square. lra.
    - apply Rmult_le_compat_l; [|lra]. repeat apply Rmult_le_pos; lra. }
  (* g / 2 = (q - first) first + (q - first)^2 / 2 *)
  assert (Rabs ((q - first) * (q - first)) <= 3 * Z) as squared.
  { rewrite Rabs_mult. apply Rle_trans with ((1 + 6 / 10) * u * r * ((1 + 6 / 10) * u * r)); [apply Rmult_le_compat; trivial; apply Rabs_pos |].
    replace ((1 + 6 / 10) * u * r * ((1 + 6 / 10) * u * r)) with ((1 + 6 / 10) * (1 + 6 / 10) * (u * u * (r * r))) by ring. rewrite r_square. lra. }
  assert (Rabs ((first + c - q) * first) <= (K + 2) * Z) as total.
  { replace ((first + c - q) * first) with ((c * first - / 2 * g) + / 2 * ((q - first) * (q - first))) by (rewrite g_is; field).
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_mult (/ 2)), (Rabs_pos_eq (/ 2)) by lra. lra. }
  rewrite Rabs_mult, (Rabs_pos_eq first) in total by lra.
  apply Rmult_le_reg_r with first; [lra |]. apply Rle_trans with (1 := total).
  apply Rle_trans with ((K + 2) * (1 + / 200) * (u * u) * (((1 - / 1000) * r) * ((1 - / 1000) * r))).
  - replace ((K + 2) * (1 + / 200) * (u * u) * ((1 - / 1000) * r * ((1 - / 1000) * r)))
      with ((K + 2) * ((1 + / 200) * (1 - / 1000) * (1 - / 1000)) * (u * u * (r * r))) by ring.
    rewrite r_square. apply Rmult_le_compat_r; [lra |]. rewrite <- (Rmult_1_r (K + 2)) at 1. apply Rmult_le_compat_l; lra.
  - rewrite (Rmult_assoc _ q). apply Rmult_le_compat_l; [repeat apply Rmult_le_pos; lra |]. apply Rmult_le_compat; lra.
Qed.
End Root.

Print Assumptions corrected_quotient.
Print Assumptions corrected_root.
