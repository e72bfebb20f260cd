(* Between decisions.v and clip_in_pairs.v (proofs-notes/rounding-of-forces.md, sections 8 and 9): a slip that was decided for
   certain is no tiny part of its sizes, and the corner's condition in doubles is more than half of what it stands for.
   fast/surface_in_doubles.hpp, corner_condition; fast/surface_in_pairs.hpp, clip_error. *)

From Coq Require Import Reals Psatz.
From Groundtruth Require Import surface sizes decisions.
Open Scope R_scope.

Lemma certainly_less : forall d size, 0 <= size -> rd d < - rd (margin_part * size) -> d < - (511 * u * size).
Proof.
  intros d size pos certain. pose proof (rd_near d _ (Rle_refl _)) as near. apply within in near.
  pose proof (rd_positive (margin_part * size) ltac:(unfold margin_part; lra)) as m.
  unfold Rabs in near. destruct (Rcase_abs d); unfold margin_part, u in *; lra.
Qed.

Section Slips.

(* As in decisions.v. *)
Variables D D' tt tt' gg' nn' k l f mu B : R.
Hypotheses (l_pos : 0 <= l) (f_pos : 0 <= f).
Hypotheses (D_near : Rabs (D' - D) <= 6 * u * (l * f)).
Hypotheses (tt_near : Rabs (tt' - tt) <= 21 * u * tt' + 3 * u * (l * f * (l * f))) (tt_pos : 0 <= tt').
Hypotheses (gg_near : Rabs (gg' - k * k) <= 132 * u * (k * k)) (nn_near : Rabs (nn' - l * l) <= 4 * u * (l * l)).
Let limit := limit_of mu D'.
Let band := band_of B nn'.
Let disc_floor := disc_floor_of mu nn' f.
Let N := l * f * (l * f).
Let L := mu * mu * (D * D).
Let K := B * B * (l * l).

Lemma sizes_ : 0 <= N /\ 0 <= mu * mu * N /\ (1 - 20 * u) * (N + mu * mu * N) <= disc_floor /\ 0 <= limit /\ 0 <= band /\
  Rabs (limit - L) <= 22 * u * limit + 23 / 10 * u * (mu * mu * N) /\ Rabs (band - K) <= 8 * u * band.
Proof.
  destruct (floors mu gg' nn' k l f gg_near nn_near) as (_ & HN & _ & _ & nF). fold N disc_floor in HN, nF.
  destruct (limit_near mu D D' (l * f) ltac:(now apply Rmult_le_pos) D_near) as (L_pos & nL). fold limit L N in L_pos, nL.
  destruct (band_near B nn' l 4 ltac:(lra) nn_near) as (b_pos & nb). fold band K in b_pos, nb.
  assert (0 <= mu * mu * N) by (apply Rmult_le_pos; [apply Rle_0_sqr | assumption]). repeat split; trivial; lra.
Qed.

(* Outside of the disc: |T| >= 2^-23 |n| f. *)
Theorem turns_enough : let size := rd (rd (tt' + limit) + disc_floor) in
  rd (limit - tt') < - rd (margin_part * size) -> 128 * u * N <= tt.
Proof.
  intros size certain. destruct sizes_ as (HN & HM & nF & L_pos & _). apply within in tt_near. fold N in tt_near.
  pose proof (rd_positive (tt' + limit) ltac:(lra)) as s1. pose proof (rd_positive (rd (tt' + limit) + disc_floor) ltac:(unfold u in *; lra)) as s2. fold size in s2.
  pose proof (certainly_less _ size ltac:(unfold u in *; lra) certain). unfold u in *; lra.
Qed.

(* A corner: sigma >= 2^-46 mu^2 |n|^2 f^2, and condition^2 = L / (L - K) is at most four times the computed one's. *)
Theorem corner_is_open : let size := rd (rd (limit + band) + disc_floor) in
  rd (band - limit) < - rd (margin_part * size) -> 128 * u * (mu * mu * N) <= L - K /\ 0 < limit - band /\ L * (limit - band) <= 2 * limit * (L - K).
Proof.
  intros size certain. destruct sizes_ as (HN & HM & nF & L_pos & b_pos & nL & nK). apply within in nL. apply within in nK.
  pose proof (rd_positive (limit + band) ltac:(lra)) as s1. pose proof (rd_positive (rd (limit + band) + disc_floor) ltac:(unfold u in *; lra)) as s2. fold size in s2.
  pose proof (certainly_less _ size ltac:(unfold u in *; lra) certain) as less.
  assert (0 <= limit - band) as open_ by (unfold u in *; lra).
  assert (0 < limit - band) as some.
  { destruct (Req_dec (limit - band) 0) as [zero |]; [| lra]. exfalso. replace (band - limit) with 0 in less by lra. unfold u in *; lra. }
  split; [unfold u in *; lra |]. split; [assumption |].
  assert (9 / 10 * (limit - band) <= L - K) as near by (unfold u in *; lra). assert (L <= 11 / 10 * limit) as most by (unfold u in *; lra).
  apply Rle_trans with (11 / 10 * limit * (limit - band)); [apply Rmult_le_compat_r; lra |].
  apply Rle_trans with (2 * limit * (9 / 10 * (limit - band))); [| apply Rmult_le_compat_l; lra].
  assert (0 <= limit * (limit - band)) by (apply Rmult_le_pos; lra). lra.
Qed.

End Slips.

Print Assumptions turns_enough.
Print Assumptions corner_is_open.
