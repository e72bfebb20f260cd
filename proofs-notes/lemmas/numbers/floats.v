(* Floats and their rounding to nearest, as doubles.v says it of doubles. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles.
Open Scope R_scope.

Definition is_float := generic_format radix2 (FLT_exp (-149) 24).
Definition to_float := round radix2 (FLT_exp (-149) 24) ZnearestE.
Definition v := / 16777216. (* 2^-24 *)
Definition small := bpow radix2 (-150).

#[export] Instance positive_float_precision : Prec_gt_0 24 := eq_refl.

Lemma small_is_small : 0 < small <= / 1000000000000000000000000000000000000000000.
Proof. split; [apply bpow_gt_0 | unfold small; simpl; lra]. Qed.

Lemma to_float_is_float : forall x, is_float (to_float x).
Proof. intros; apply generic_format_round; [now apply FLT_exp_valid | apply valid_rnd_N]. Qed.

Lemma float_error : forall x, Rabs (to_float x - x) <= v * Rabs x + small.
Proof. exact (nearest_error (-149) 24 eq_refl). Qed.

Lemma float_sum_error : forall x y, is_float x -> is_float y -> Rabs (to_float (x + y) - (x + y)) <= v * Rabs (x + y).
Proof. exact (nearest_sum_error (-149) 24 eq_refl). Qed.

Lemma to_float_sign : forall x, (0 <= x -> 0 <= to_float x) /\ (x <= 0 -> to_float x <= 0).
Proof.
  assert (to_float 0 = 0) as zero by (apply round_generic; [apply valid_rnd_N | apply generic_format_0]).
  split; intros; rewrite <- zero; apply round_le; trivial; try apply valid_rnd_N; now apply FLT_exp_valid.
Qed.

(* rounded_down and rounded_up (fast/hierarchy.cpp): sides of boxes are rounded outwards. *)
Definition rounded_down x := if Rle_dec (to_float x) x then to_float x else pred radix2 (FLT_exp (-149) 24) (to_float x).
Definition rounded_up x := - rounded_down (- x).

Lemma rounded_outwards : forall x, rounded_down x <= x <= rounded_up x.
Proof.
  assert (forall x, rounded_down x <= x) as down.
  { intros x. unfold rounded_down. destruct (Rle_dec (to_float x) x); [assumption |].
    apply pred_round_le_id; [now apply FLT_exp_valid | apply valid_rnd_N]. }
  intros x. split; [apply down |]. pose proof (down (- x)). unfold rounded_up. lra.
Qed.

Print Assumptions float_error.
Print Assumptions float_sum_error.
Print Assumptions rounded_outwards.
