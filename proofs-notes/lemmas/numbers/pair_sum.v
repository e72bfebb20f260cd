(* Lemma pair-operations (proofs-notes/rounding-of-forces.md, section 2), sums: the sum of two pairs is off by at most
   2^-102 of the sum of their magnitudes. fast/number_pair.hpp, loose_sum and tidy. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core Plus_error Pff2Flocq.
From Groundtruth Require Import doubles.
Open Scope R_scope.

Definition pair_unit := bpow radix2 (-102). (* 0x1p-102 *)

Lemma ties_are_symmetric : forall z, negb (Z.even z) = negb (negb (Z.even (- (z + 1)))).
Proof. intros z; rewrite Z.even_opp, Z.even_add; now destruct (Z.even z). Qed.

(* What two_sum leaves: exact. *)
Definition rest a b :=
  let sum := fl (a + b) in let b_part := fl (sum - a) in
  fl (fl (a - fl (sum - b_part)) + fl (b - b_part)).

Lemma two_sum_is_exact : forall a b, is_double a -> is_double b -> fl (a + b) + rest a b = a + b.
Proof.
  intros a b Da Db.
  exact (TwoSum_correct (-1074) 53 (fun z => negb (Z.even z)) ltac:(easy) ltac:(easy)
    ties_are_symmetric a b Da Db).
Qed.

(* Tidy: off by at most u of the low part and second order, whatever the order of |s| and |l|. *)
Section Tidy.

Variables s l : R.
Hypotheses (Ds : is_double s) (Dl : is_double l).
Let high := fl (s + l).
Let low := fl (l - fl (high - s)).

Lemma tidy_is_exact : Rabs l <= Rabs s -> high + low = s + l.
Proof.
  intros ordered. assert (high + fl (l + fl (s - high)) = s + l) as exact
    by exact (Fast2Sum_correct (-1074) 53 (fun z => negb (Z.even z)) ltac:(easy) ltac:(easy)
      ties_are_symmetric s l Ds Dl ordered).
  assert (low = fl (l + fl (s - high))) as same.
  { unfold low; f_equal; replace (s - high) with (- (high - s)) by ring.
    unfold fl at 2; rewrite round_NE_opp; fold (fl (high - s)); ring. }
  now rewrite same.
Qed.

Lemma tidy_error : Rabs (high + low - (s + l)) <= 3 * u * Rabs l.
Proof.
  assert (is_double high) as Dh by apply fl_is_double.
  destruct (Rle_or_lt (Rabs l) (Rabs s)) as [ordered | not_ordered].
  - rewrite (tidy_is_exact ordered), Rminus_diag_eq, Rabs_R0 by reflexivity.
    pose proof (Rabs_pos l); unfold u; lra.
  - pose proof (sum_error s l Ds Dl) as high_near; fold high in high_near.
    assert (is_double (- s)) as Ds' by now apply generic_format_opp.
    pose proof (sum_error high (- s) Dh Ds') as z_near; change (high + - s) with (high - s) in z_near.
    set (z := fl (high - s)) in *.
    assert (is_double (- z)) as Dz by (apply generic_format_opp, fl_is_double).
    pose proof (sum_error l (- z) Dl Dz) as low_near; change (l + - z) with (l - z) in low_near; fold low in low_near.
    pose proof (Rabs_pos l); pose proof (magnitude l); pose proof (magnitude s).
    assert (Rabs (s + l) <= 2 * Rabs l) as size by (apply Rabs_le; lra).
    assert (u * Rabs (s + l) <= u * (2 * Rabs l)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    apply within in high_near.
    assert (Rabs (high - s) <= (1 + 2 * u) * Rabs l) as step by (apply Rabs_le; lra).
    assert (u * Rabs (high - s) <= u * ((1 + 2 * u) * Rabs l)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    apply within in z_near.
    assert (Rabs (l - z) <= (3 * u + 2 * u * u) * Rabs l + 0) as last by (apply Rabs_le; lra).
    assert (u * Rabs (l - z) <= u * ((3 * u + 2 * u * u) * Rabs l + 0))
      by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    apply within in low_near; apply Rabs_le; unfold u in *; lra.
Qed.

End Tidy.

Section Sum.

Variables ah al bh bl : R.
Hypotheses (Dah : is_double ah) (Dal : is_double al) (Dbh : is_double bh) (Dbl : is_double bl).
Hypotheses (a_tidy : Rabs al <= u * Rabs ah) (b_tidy : Rabs bl <= u * Rabs bh).

Let s := fl (ah + bh).
Let l := fl (rest ah bh + fl (al + bl)).

(* Loose: before it is made tidy. *)
Lemma loose_sum_error : Rabs (s + l - (ah + al + (bh + bl))) <= 4 * u * u * (Rabs ah + Rabs bh).
Proof.
  pose proof (two_sum_is_exact ah bh Dah Dbh) as exact; fold s in exact.
  pose proof (sum_error ah bh Dah Dbh) as s_near; fold s in s_near.
  assert (is_double (rest ah bh)) as Dr by apply fl_is_double.
  pose proof (sum_error al bl Dal Dbl) as t_near.
  pose proof (sum_error (rest ah bh) (fl (al + bl)) Dr (fl_is_double _)) as l_near; fold l in l_near.
  set (r := rest ah bh) in *; set (t := fl (al + bl)) in *.
  pose proof (magnitude ah); pose proof (magnitude bh).
  assert (Rabs (ah + bh) <= Rabs ah + Rabs bh) as sum_size by apply Rabs_triang.
  set (S := Rabs ah + Rabs bh) in *.
  assert (Rabs (al + bl) <= u * S) as low_size
    by (apply Rle_trans with (1 := Rabs_triang _ _); unfold S; lra).
  assert (u * Rabs (al + bl) <= u * (u * S)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (u * Rabs (ah + bh) <= u * S) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (0 <= S) by (unfold S; pose proof (Rabs_pos ah); pose proof (Rabs_pos bh); lra).
  apply within in s_near; apply within in t_near; apply within in low_size.
  assert (Rabs (r + t) <= 2 * u * S + u * u * S) by (apply Rabs_le; unfold u in *; lra).
  assert (u * Rabs (r + t) <= u * (2 * u * S + u * u * S)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in l_near; apply Rabs_le; unfold u in *; lra.
Qed.

Lemma low_part_size : Rabs l <= (2 * u + 4 * u * u) * (Rabs ah + Rabs bh).
Proof.
  pose proof loose_sum_error as near; pose proof (sum_error ah bh Dah Dbh) as s_near; fold s in s_near.
  assert (Rabs (ah + bh) <= Rabs ah + Rabs bh) as sum_size by apply Rabs_triang.
  assert (u * Rabs (ah + bh) <= u * (Rabs ah + Rabs bh)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in near; apply within in s_near; apply within in a_tidy; apply within in b_tidy.
  apply Rabs_le; lra.
Qed.

Let high := fl (s + l).
Let low := fl (l - fl (high - s)).

Theorem pair_sum_error :
  Rabs (high + low - (ah + al + (bh + bl))) <= pair_unit * (Rabs (ah + al) + Rabs (bh + bl)).
Proof.
  pose proof loose_sum_error as loose;
  pose proof (tidy_error s l (fl_is_double _) (fl_is_double _)) as tidy; fold high low in tidy; pose proof low_part_size as size.
  assert (pair_unit = 16 * u * u) as -> by (unfold pair_unit, u; simpl; lra).
  assert (u * Rabs l <= u * ((2 * u + 4 * u * u) * (Rabs ah + Rabs bh)))
    by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (Rabs ah <= Rabs (ah + al) + Rabs al)
    by (replace ah with (ah + al + - al) at 1 by ring; rewrite <- (Rabs_Ropp al); apply Rabs_triang).
  assert (Rabs bh <= Rabs (bh + bl) + Rabs bl)
    by (replace bh with (bh + bl + - bl) at 1 by ring; rewrite <- (Rabs_Ropp bl); apply Rabs_triang).
  pose proof (Rabs_pos ah); pose proof (Rabs_pos bh).
  pose proof (Rabs_pos (ah + al)); pose proof (Rabs_pos (bh + bl)).
  apply within in loose; apply within in tidy; apply Rabs_le; unfold u in *; lra.
Qed.

End Sum.

Print Assumptions two_sum_is_exact.
Print Assumptions tidy_is_exact.
Print Assumptions tidy_error.
Print Assumptions loose_sum_error.
Print Assumptions pair_sum_error.
