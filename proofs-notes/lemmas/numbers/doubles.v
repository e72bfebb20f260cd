(* Doubles and their rounding to nearest, underflow included, without a largest number: that nothing overflows is
   a condition of the lemmas that use this. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core Relative Plus_error.
Open Scope R_scope.

(* In any format with gradual underflow: doubles here, floats in floats.v. *)
Section Format.

Variables lowest precision : Z.
Hypothesis some_precision : Prec_gt_0 precision.
Let nearest := round radix2 (FLT_exp lowest precision) ZnearestE.
Let belongs := generic_format radix2 (FLT_exp lowest precision).

Lemma nearest_error : forall x, Rabs (nearest x - x) <= bpow radix2 (- precision) * Rabs x + bpow radix2 (lowest - 1).
Proof.
  intros x; destruct (error_N_FLT radix2 lowest precision some_precision (fun z => negb (Z.even z)) x)
    as (e & t & He & Ht & _ & rounded).
  unfold nearest; rewrite rounded.
  replace (x * (1 + e) + t - x) with (e * x + t) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat.
  - rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos |].
    apply Rle_trans with (1 := He); rewrite bpow_plus; change (bpow radix2 1) with 2; lra.
  - apply Rle_trans with (1 := Ht); replace (lowest - 1)%Z with (-1 + lowest)%Z by ring; rewrite bpow_plus;
    change (bpow radix2 (-1)) with (/ 2); lra.
Qed.

Lemma nearest_sum_error : forall x y, belongs x -> belongs y ->
  Rabs (nearest (x + y) - (x + y)) <= bpow radix2 (- precision) * Rabs (x + y).
Proof.
  intros x y Hx Hy.
  destruct (FLT_plus_error_N_ex radix2 lowest precision (fun z => negb (Z.even z)) x y Hx Hy) as (e & He & rounded).
  unfold nearest; rewrite rounded.
  replace ((x + y) * (1 + e) - (x + y)) with (e * (x + y)) by ring.
  rewrite Rabs_mult; apply Rmult_le_compat_r; [apply Rabs_pos |].
  apply Rle_trans with (1 := He).
  assert (0 < u_ro radix2 precision) by (unfold u_ro; pose proof (bpow_gt_0 radix2 (- precision + 1)); lra).
  apply Rmult_le_reg_r with (1 + u_ro radix2 precision); [lra |].
  replace (u_ro radix2 precision / (1 + u_ro radix2 precision) * (1 + u_ro radix2 precision)) with (u_ro radix2 precision) by (field; lra).
  replace (bpow radix2 (- precision)) with (u_ro radix2 precision)
    by (unfold u_ro; rewrite bpow_plus; change (bpow radix2 1) with 2; field).
  nra.
Qed.

End Format.

Definition is_double := generic_format radix2 (FLT_exp (-1074) 53).
Definition fl := round radix2 (FLT_exp (-1074) 53) ZnearestE.
Definition u := / 9007199254740992. (* 2^-53 *)
Definition tiny := bpow radix2 (-1075).

#[export] Instance positive_precision : Prec_gt_0 53 := eq_refl.

Lemma fl_is_double : forall x, is_double (fl x).
Proof. intros; apply generic_format_round; [apply FLT_exp_valid; easy | apply valid_rnd_N]. Qed.

Lemma fl_monotone : forall x y, x <= y -> fl x <= fl y.
Proof. intros; apply round_le; [apply FLT_exp_valid; easy | apply valid_rnd_N | assumption]. Qed.

Lemma fl_of_double : forall x, is_double x -> fl x = x.
Proof. intros; apply round_generic; [apply valid_rnd_N | assumption]. Qed.

Lemma tiny_positive : 0 < tiny.
Proof. apply bpow_gt_0. Qed.

Lemma fl_error : forall x, Rabs (fl x - x) <= u * Rabs x + tiny.
Proof. exact (nearest_error (-1074) 53 eq_refl). Qed.

Lemma sum_error : forall x y, is_double x -> is_double y -> Rabs (fl (x + y) - (x + y)) <= u * Rabs (x + y).
Proof. exact (nearest_sum_error (-1074) 53 eq_refl). Qed.

Lemma sum_error_of_rounded : forall x y, is_double x -> is_double y -> Rabs (fl (x + y) - (x + y)) <= u * Rabs (fl (x + y)).
Proof.
  intros x y Dx Dy. destruct (FLT_plus_error_N_round_ex radix2 (-1074) 53 (fun z => negb (Z.even z)) x y Dx Dy) as (e & small & exact).
  fold (fl (x + y)) in exact. rewrite exact at 2.
  replace (fl (x + y) - fl (x + y) * (1 + e)) with (- e * fl (x + y)) by ring. rewrite Rabs_mult, Rabs_Ropp.
  apply Rmult_le_compat_r; [apply Rabs_pos |]. apply Rle_trans with (1 := small). unfold u_ro, u; simpl; lra.
Qed.

Lemma within : forall x a, Rabs x <= a -> - a <= x <= a.
Proof. intros x a; unfold Rabs; destruct (Rcase_abs x); lra. Qed.
Lemma magnitude : forall x, - Rabs x <= x <= Rabs x.
Proof. intros; apply within; lra. Qed.

Lemma product_near : forall x y, Rabs (fl (x * y) - x * y) <= u * (Rabs x * Rabs y) + tiny.
Proof. intros; rewrite <- Rabs_mult; apply fl_error. Qed.

(* Sums of numbers that are known within a and b. *)
Lemma sum_near : forall x y X Y a b s, is_double x -> is_double y -> Rabs (x - X) <= a -> Rabs (y - Y) <= b ->
  Rabs (X + Y) <= s -> Rabs (fl (x + y) - (X + Y)) <= a + b + u * (s + a + b).
Proof.
  intros x y X Y a b s Dx Dy Hx Hy Hs; pose proof (sum_error x y Dx Dy) as rounded.
  assert (Rabs (x + y) <= s + a + b)
    by (apply within in Hx; apply within in Hy; apply within in Hs; apply Rabs_le; lra).
  assert (0 < u) by (unfold u; lra).
  apply within in rounded; apply within in Hx; apply within in Hy; apply Rabs_le; nra.
Qed.

Lemma power_is_double : forall k, (-1074 <= k)%Z -> is_double (bpow radix2 k).
Proof. intros; apply generic_format_bpow; unfold FLT_exp; lia. Qed.

Lemma product_at_least : forall x y, 0 <= x -> 0 <= y -> x * y * (1 - u) - tiny <= fl (x * y).
Proof.
  intros x y Hx Hy; pose proof (fl_error (x * y)) as near; rewrite (Rabs_pos_eq (x * y)) in near by nra.
  apply within in near; unfold u in *; lra.
Qed.

Lemma sum_at_least : forall x y s, is_double x -> is_double y -> 0 <= s <= x + y -> s * (1 - u) <= fl (x + y).
Proof.
  intros x y s Dx Dy Hs; pose proof (sum_error x y Dx Dy) as near; rewrite (Rabs_pos_eq (x + y)) in near by lra.
  apply within in near; unfold u in *; lra.
Qed.

Print Assumptions fl_error.
Print Assumptions sum_error.
Print Assumptions sum_error_of_rounded.
Print Assumptions sum_near.
Print Assumptions product_at_least.
Print Assumptions sum_at_least.
