(* Lemma packed-places (proofs-notes/rounding.md): Stretches::reach() of fast/grid.hpp makes its six comparisons at once. Places
   below 512 lie ten bits apart; the bit that is free above each tells whether the difference there is negative. *)

From Coq Require Import ZArith Lia Bool.
Open Scope Z_scope.

Definition packed a b c d e f := a + 2 ^ 10 * b + 2 ^ 20 * c + 2 ^ 30 * d + 2 ^ 40 * e + 2 ^ 50 * f.
Definition free_bits := 0x0802008020080200.

Lemma free_bit_tells : forall n x K below lane above, 0 <= n -> 2 ^ n = K * 512 -> x = below + K * lane + K * 1024 * above ->
  0 <= below < K -> 0 <= lane < 1024 -> Z.testbit x n = (512 <=? lane).
Proof.
  intros n x K below lane above pos power -> small_below small_lane. rewrite Z.testbit_odd, Z.shiftr_div_pow2, power by assumption.
  pose proof (Z.div_mod lane 512 ltac:(lia)). pose proof (Z.mod_pos_bound lane 512 ltac:(lia)).
  rewrite <- (Z.div_unique _ (K * 512) (lane / 512 + 2 * above) (below + K * (lane mod 512))); [| left; nia | nia].
  rewrite Z.odd_add_mul_2. assert (lane / 512 = 0 \/ lane / 512 = 1) as [zero | one] by lia; rewrite ?zero, ?one; simpl; symmetry;
    [apply Z.leb_gt | apply Z.leb_le]; lia.
Qed.

Lemma free_bits_one_by_one : forall x, Z.land x free_bits = free_bits <->
  Z.testbit x 9 = true /\ Z.testbit x 19 = true /\ Z.testbit x 29 = true /\
  Z.testbit x 39 = true /\ Z.testbit x 49 = true /\ Z.testbit x 59 = true.
Proof.
  intros x. split.
  - intros all. assert (forall n, Z.testbit free_bits n = true -> Z.testbit x n = true) as bits.
    { intros n bit. rewrite <- all, Z.land_spec in bit. now apply andb_prop in bit. }
    repeat split; now apply bits.
  - intros bits. apply Z.bits_inj'. intros n pos. rewrite Z.land_spec. destruct (Z.testbit free_bits n) eqn:free; [| apply andb_false_r].
    rewrite andb_true_r. destruct (Z_lt_le_dec n 60) as [low | high].
    + rewrite <- (Z2Nat.id n pos) in *. assert (Z.to_nat n < 60)%nat as few by lia. revert few free. generalize (Z.to_nat n).
      intros k few free. do 60 (destruct k as [| k]; [first [discriminate free | simpl Z.of_nat; tauto] |]). lia.
    + rewrite Z.bits_above_log2 in free; [discriminate | unfold free_bits; lia |].
      apply Z.lt_le_trans with 60; [reflexivity | assumption].
Qed.

Definition is_place a := 0 <= a < 512.

Theorem reach_compares : forall a b c d e f a' b' c' d' e' f',
  is_place a -> is_place b -> is_place c -> is_place d -> is_place e -> is_place f ->
  is_place a' -> is_place b' -> is_place c' -> is_place d' -> is_place e' -> is_place f' ->
  Z.land (packed a b c d e f + free_bits - packed a' b' c' d' e' f') free_bits = free_bits <->
  a' <= a /\ b' <= b /\ c' <= c /\ d' <= d /\ e' <= e /\ f' <= f.
Proof.
  unfold is_place. intros. rewrite free_bits_one_by_one. set (x := packed a b c d e f + free_bits - packed a' b' c' d' e' f').
  pose (A := a + 512 - a'). pose (B := b + 512 - b'). pose (C := c + 512 - c').
  pose (D := d + 512 - d'). pose (E := e + 512 - e'). pose (F := f + 512 - f').
  assert (x = packed A B C D E F) as lanes by (unfold x, A, B, C, D, E, F, packed, free_bits; lia). unfold packed in lanes.
  assert (0 <= A < 1024 /\ 0 <= B < 1024 /\ 0 <= C < 1024 /\ 0 <= D < 1024 /\ 0 <= E < 1024 /\ 0 <= F < 1024) as small
    by (unfold A, B, C, D, E, F; lia).
  rewrite (free_bit_tells 9 x (2 ^ 0) 0 A (B + 2 ^ 10 * C + 2 ^ 20 * D + 2 ^ 30 * E + 2 ^ 40 * F)) by lia.
  rewrite (free_bit_tells 19 x (2 ^ 10) A B (C + 2 ^ 10 * D + 2 ^ 20 * E + 2 ^ 30 * F)) by lia.
  rewrite (free_bit_tells 29 x (2 ^ 20) (A + 2 ^ 10 * B) C (D + 2 ^ 10 * E + 2 ^ 20 * F)) by lia.
  rewrite (free_bit_tells 39 x (2 ^ 30) (A + 2 ^ 10 * B + 2 ^ 20 * C) D (E + 2 ^ 10 * F)) by lia.
  rewrite (free_bit_tells 49 x (2 ^ 40) (A + 2 ^ 10 * B + 2 ^ 20 * C + 2 ^ 30 * D) E F) by lia.
  rewrite (free_bit_tells 59 x (2 ^ 50) (A + 2 ^ 10 * B + 2 ^ 20 * C + 2 ^ 30 * D + 2 ^ 40 * E) F 0) by lia.
  rewrite !Z.leb_le. unfold A, B, C, D, E, F. lia.
Qed.

Print Assumptions reach_compares.
