(* Lemma pair-operations (proofs-notes/rounding-of-forces.md, section 2), products: with a fused or Dekker's product for
   what is lost, the product of two pairs before it is made tidy is off by at most 9 u^2 of its size, and by 2^-1070
   where something underflows. fast/number_pair.hpp, loose_product. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core Mult_error.
From Groundtruth Require Import doubles pair_sum.
Open Scope R_scope.

(* What FusedProducts::lost gives: exact, or off by three underflows. *)
Lemma fused_rest : forall a b, is_double a -> is_double b ->
  Rabs (fl (a * b - fl (a * b)) - (a * b - fl (a * b))) <= 3 * tiny.
Proof.
  intros a b Da Db; pose proof tiny_positive.
  destruct (Rle_or_lt (bpow radix2 (-1074 + 2 * 53 - 1)) (Rabs (a * b))) as [large | small].
  - assert (is_double (a * b - fl (a * b))) as exact.
    { replace (a * b - fl (a * b)) with (- (fl (a * b) - a * b)) by ring; apply generic_format_opp.
      apply (mult_error_FLT radix2 (-1074) 53 ZnearestE a b Da Db); intros _; assumption. }
    rewrite (fl_of_double _ exact), Rminus_diag_eq, Rabs_R0 by reflexivity; lra.
  - pose proof (fl_error (a * b)) as near; pose proof (fl_error (a * b - fl (a * b))) as rest_near.
    rewrite (Rabs_minus_sym (fl (a * b)) (a * b)) in near.
    set (r := a * b - fl (a * b)) in *.
    assert (u * (u * bpow radix2 (-1074 + 2 * 53 - 1)) = tiny) as scale.
    { assert (u = bpow radix2 (-53)) as -> by reflexivity; unfold tiny; rewrite <- !bpow_plus; reflexivity. }
    assert (u * Rabs (a * b) <= u * bpow radix2 (-1074 + 2 * 53 - 1)) by (apply Rmult_le_compat_l; [unfold u |]; lra).
    assert (u * Rabs r <= u * (u * bpow radix2 (-1074 + 2 * 53 - 1) + tiny)) by (apply Rmult_le_compat_l; [unfold u |]; lra).
    assert (u * tiny <= tiny) by (unfold u; lra).
    lra.
Qed.

Section Product.

Variables ah al bh bl r : R.
Hypotheses (a_tidy : Rabs al <= u * Rabs ah) (b_tidy : Rabs bl <= u * Rabs bh).
Hypotheses (r_is_double : is_double r) (r_near : Rabs (r - (ah * bh - fl (ah * bh))) <= 7 * tiny).

Let l := fl (r + fl (fl (ah * bl) + fl (al * bh))).

Theorem loose_product_error :
  Rabs (fl (ah * bh) + l - (ah + al) * (bh + bl)) <= 9 * u * u * (Rabs ah * Rabs bh) + 32 * tiny.
Proof.
  pose proof tiny_positive.
  pose proof (fl_error (ah * bh)) as h_near; set (h := fl (ah * bh)) in *.
  pose proof (fl_error (ah * bl)) as p_near; set (p := fl (ah * bl)) in *.
  pose proof (fl_error (al * bh)) as q_near; set (q := fl (al * bh)) in *.
  pose proof (sum_error p q (fl_is_double _) (fl_is_double _)) as c_near; set (c := fl (p + q)) in *.
  pose proof (sum_error r c r_is_double (fl_is_double _)) as l_near; fold l in l_near.
  set (P := Rabs ah * Rabs bh).
  pose proof (Rabs_pos ah); pose proof (Rabs_pos bh); pose proof (Rabs_pos al); pose proof (Rabs_pos bl).
  assert (0 <= P) by (apply Rmult_le_pos; assumption).
  assert (Rabs (ah * bh) = P) as size_h by apply Rabs_mult; rewrite size_h in h_near.
  assert (Rabs (ah * bl) <= u * P) as size_p.
  { rewrite Rabs_mult; replace (u * P) with (Rabs ah * (u * Rabs bh)) by (unfold P; ring); now apply Rmult_le_compat_l. }
  assert (Rabs (al * bh) <= u * P) as size_q.
  { rewrite Rabs_mult; replace (u * P) with (u * Rabs ah * Rabs bh) by (unfold P; ring); now apply Rmult_le_compat_r. }
  assert (Rabs (al * bl) <= u * u * P) as neglected.
  { rewrite Rabs_mult; replace (u * u * P) with (u * Rabs ah * (u * Rabs bh)) by (unfold P; ring);
      apply Rmult_le_compat; assumption. }
  assert (u * Rabs (ah * bl) <= u * (u * P)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (u * Rabs (al * bh) <= u * (u * P)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in p_near; apply within in q_near; apply within in size_p; apply within in size_q; apply within in h_near.
  assert (Rabs (p + q) <= 2 * u * P + 2 * u * u * P + 2 * tiny) by (apply Rabs_le; unfold u in *; lra).
  assert (u * Rabs (p + q) <= u * (2 * u * P + 2 * u * u * P + 2 * tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in c_near; apply within in r_near.
  assert (Rabs (r + c) <= 3 * u * P + 5 * u * u * P + 11 * tiny) by (apply Rabs_le; unfold u in *; lra).
  assert (u * Rabs (r + c) <= u * (3 * u * P + 5 * u * u * P + 11 * tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in l_near; apply within in neglected.
  replace (h + l - (ah + al) * (bh + bl)) with (h + l - ah * bh - ah * bl - al * bh - al * bl) by ring.
  apply Rabs_le; unfold u in *; lra.
Qed.

(* Made tidy: operator*. *)
Let h := fl (ah * bh).
Let high := fl (h + l).
Let low := fl (l - fl (high - h)).

Theorem pair_product_error :
  Rabs (high + low - (ah + al) * (bh + bl)) <= pair_unit * (Rabs (ah + al) * Rabs (bh + bl)) + 40 * tiny.
Proof.
  pose proof tiny_positive. pose proof loose_product_error as loose. fold h in loose.
  pose proof (tidy_error h l (fl_is_double _) (fl_is_double _)) as near; fold high low in near.
  set (P := Rabs ah * Rabs bh) in *. assert (0 <= P) by (apply Rmult_le_pos; apply Rabs_pos).
  assert (pair_unit = 16 * u * u) as -> by (unfold pair_unit, u; simpl; lra).
  assert (P * (1 - 3 * u) <= Rabs (ah + al) * Rabs (bh + bl)) as size.
  { assert (Rabs ah * (1 - u) <= Rabs (ah + al)).
    { assert (Rabs ah <= Rabs (ah + al) + Rabs al)
        by (replace ah with (ah + al + - al) at 1 by ring; rewrite <- (Rabs_Ropp al); apply Rabs_triang). lra. }
    assert (Rabs bh * (1 - u) <= Rabs (bh + bl)).
    { assert (Rabs bh <= Rabs (bh + bl) + Rabs bl)
        by (replace bh with (bh + bl + - bl) at 1 by ring; rewrite <- (Rabs_Ropp bl); apply Rabs_triang). lra. }
    apply Rle_trans with (Rabs ah * (1 - u) * (Rabs bh * (1 - u))).
    - replace (Rabs ah * (1 - u) * (Rabs bh * (1 - u))) with (P * (1 - 2 * u + u * u)) by (unfold P; ring).
      apply Rmult_le_compat_l; [assumption | unfold u; lra].
    - pose proof (Rabs_pos ah). pose proof (Rabs_pos bh).
      apply Rmult_le_compat; trivial; apply Rmult_le_pos; trivial; unfold u; lra. }
  assert (u * u * (P * (1 - 3 * u)) <= u * u * (Rabs (ah + al) * Rabs (bh + bl))) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  pose proof (fl_error (ah * bh)) as h_near; fold h in h_near. rewrite Rabs_mult in h_near; fold P in h_near.
  assert (Rabs (h + l) <= Rabs (ah + al) * Rabs (bh + bl) + (9 * u * u * P + 32 * tiny)).
  { replace (h + l) with ((ah + al) * (bh + bl) + (h + l - (ah + al) * (bh + bl))) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_mult. lra. }
  assert (Rabs (ah + al) * Rabs (bh + bl) <= P * (1 + 3 * u)) as size'.
  { assert (Rabs (ah + al) <= Rabs ah * (1 + u)) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
    assert (Rabs (bh + bl) <= Rabs bh * (1 + u)) by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
    apply Rle_trans with (Rabs ah * (1 + u) * (Rabs bh * (1 + u))); [apply Rmult_le_compat; trivial; apply Rabs_pos |].
    replace (Rabs ah * (1 + u) * (Rabs bh * (1 + u))) with (P * (1 + 2 * u + u * u)) by (unfold P; ring).
    apply Rmult_le_compat_l; [assumption | unfold u; lra]. }
  destruct (Rle_or_lt (Rabs l) (Rabs h)) as [ordered | tiny_one].
  - pose proof (tidy_is_exact h l (fl_is_double _) (fl_is_double _) ordered) as exact. fold high low in exact. rewrite exact.
    apply Rle_trans with (1 := loose). unfold u in *; lra.
  - (* only where nearly everything underflows *)
    apply within in h_near.
    assert (Rabs h >= P - u * P - tiny).
    { assert (P <= Rabs h + Rabs (h - ah * bh)).
      { unfold P. rewrite <- Rabs_mult, (Rabs_minus_sym h). replace (ah * bh) with (h + (ah * bh - h)) at 1 by ring. apply Rabs_triang. }
      assert (Rabs (h - ah * bh) <= u * P + tiny) by (apply Rabs_le; lra). lra. }
    assert (Rabs l <= Rabs (h + l - (ah + al) * (bh + bl)) + Rabs ((ah + al) * (bh + bl) - h)).
    { replace l with ((h + l - (ah + al) * (bh + bl)) + ((ah + al) * (bh + bl) - h)) at 1 by ring. apply Rabs_triang. }
    assert (Rabs ((ah + al) * (bh + bl) - h) <= 4 * u * P + 2 * tiny) as off.
    { replace ((ah + al) * (bh + bl) - h) with (ah * bl + al * bh + al * bl - (h - ah * bh)) by ring.
      assert (Rabs (ah * bl) <= u * P) as z1 by (rewrite Rabs_mult; replace (u * P) with (Rabs ah * (u * Rabs bh)) by (unfold P; ring); apply Rmult_le_compat_l; [apply Rabs_pos | assumption]).
      assert (Rabs (al * bh) <= u * P) as z2 by (rewrite Rabs_mult; replace (u * P) with (u * Rabs ah * Rabs bh) by (unfold P; ring); apply Rmult_le_compat_r; [apply Rabs_pos | assumption]).
      assert (Rabs (al * bl) <= u * u * P) as z3 by (rewrite Rabs_mult; replace (u * u * P) with (u * Rabs ah * (u * Rabs bh)) by (unfold P; ring); apply Rmult_le_compat; trivial; apply Rabs_pos).
      apply within in z1; apply within in z2; apply within in z3. apply Rabs_le. unfold u in *; lra. }
    assert (Rabs (high + low - (ah + al) * (bh + bl)) <= Rabs (high + low - (h + l)) + Rabs (h + l - (ah + al) * (bh + bl))).
    { replace (high + low - (ah + al) * (bh + bl)) with ((high + low - (h + l)) + (h + l - (ah + al) * (bh + bl))) by ring. apply Rabs_triang. }
    unfold u in *; lra.
Qed.

End Product.

Print Assumptions fused_rest.
Print Assumptions loose_product_error.
Print Assumptions pair_product_error.
