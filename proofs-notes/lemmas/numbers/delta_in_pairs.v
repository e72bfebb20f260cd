(* Lemma crossing-in-double-double (proofs-notes/rounding.md), its first part: Delta as a pair is off by at most
   32 u^2 of the size that is computed with it, and 2^-1060. fast/crossing_body.hpp, delta. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles pair_sum.
Open Scope R_scope.

Definition delta_error_unit := 32 * u * u.

Lemma product_by_rounded : forall a b, Rabs (a * b) <= (1 + 2 * u) * Rabs (fl (a * b)) + 2 * tiny.
Proof.
  intros a b; pose proof (fl_error (a * b)) as near; pose proof tiny_positive.
  assert (Rabs (a * b) <= Rabs (fl (a * b)) + Rabs (fl (a * b) - a * b)).
  { rewrite (Rabs_minus_sym (fl (a * b))); replace (a * b) with (fl (a * b) + (a * b - fl (a * b))) at 1 by ring; apply Rabs_triang. }
  pose proof (Rabs_pos (fl (a * b))); unfold u in *; lra.
Qed.

Lemma rounded_sum : forall a b s, is_double a -> is_double b -> Rabs (a + b) <= s -> Rabs (fl (a + b) - (a + b)) <= u * s.
Proof.
  intros a b s Da Db Hs; apply Rle_trans with (1 := sum_error a b Da Db).
  apply Rmult_le_compat_l; [unfold u; lra | assumption].
Qed.

Section Delta.

Variables n1 n2 n3 d x1 x2 x3 r1 r2 r3 : R.
Hypotheses (Dd : is_double d) (Dr1 : is_double r1) (Dr2 : is_double r2) (Dr3 : is_double r3).

Let p1 := fl (n1 * x1).
Let p2 := fl (n2 * x2).
Let p3 := fl (n3 * x3).
(* What the products lose, fused or Dekker's (pair_product.v). *)
Hypotheses (lost_1 : Rabs (r1 - (n1 * x1 - p1)) <= 7 * tiny) (lost_2 : Rabs (r2 - (n2 * x2 - p2)) <= 7 * tiny)
  (lost_3 : Rabs (r3 - (n3 * x3 - p3)) <= 7 * tiny).

Let s0 := fl (p1 + p2).
Let s1 := fl (p3 + - d).
Let s2 := fl (s0 + s1).
Let low := fl (fl (fl (r1 + r2) + r3) + fl (fl (rest p1 p2 + rest p3 (- d)) + rest s0 s1)).

Definition delta_pair := fl (s2 + low) + rest s2 low.
Definition delta_size := fl (fl (fl (Rabs p1 + Rabs p2) + Rabs p3) + Rabs d).

(* How far off the pair is, and how large its parts are. *)
Lemma delta_parts : Rabs (s2 + low - (n1 * x1 + n2 * x2 + n3 * x3 - d)) <= delta_error_unit * delta_size + 64 * tiny
  /\ Rabs s2 <= (1 + 7 * u) * delta_size /\ Rabs low <= 7 / 2 * u * delta_size + 32 * tiny.
Proof.
  pose proof tiny_positive.
  assert (is_double p1) as Dp1 by apply fl_is_double; assert (is_double p2) as Dp2 by apply fl_is_double.
  assert (is_double p3) as Dp3 by apply fl_is_double; assert (is_double (- d)) as Dd' by now apply generic_format_opp.
  assert (is_double s0) as Ds0 by apply fl_is_double; assert (is_double s1) as Ds1 by apply fl_is_double.
  assert (is_double s2) as Ds2 by apply fl_is_double; assert (is_double low) as Dlow by apply fl_is_double.
  pose proof (two_sum_is_exact p1 p2 Dp1 Dp2) as exact0; fold s0 in exact0.
  pose proof (two_sum_is_exact p3 (- d) Dp3 Dd') as exact1; fold s1 in exact1.
  pose proof (two_sum_is_exact s0 s1 Ds0 Ds1) as exact2; fold s2 in exact2.
  assert (is_double (rest p1 p2)) as Dt0 by apply fl_is_double.
  assert (is_double (rest p3 (- d))) as Dt1 by apply fl_is_double.
  assert (is_double (rest s0 s1)) as Dt2 by apply fl_is_double.
  set (t0 := rest p1 p2) in *; set (t1 := rest p3 (- d)) in *; set (t2 := rest s0 s1) in *.
  pose proof (magnitude p1); pose proof (magnitude p2); pose proof (magnitude p3); pose proof (magnitude d).
  set (M := Rabs p1 + Rabs p2 + Rabs p3 + Rabs d).
  pose proof (Rabs_pos p1); pose proof (Rabs_pos p2); pose proof (Rabs_pos p3); pose proof (Rabs_pos d).
  (* What is added up. *)
  assert (Rabs r1 <= (u + 2 * u * u) * Rabs p1 + 9 * tiny /\ Rabs r2 <= (u + 2 * u * u) * Rabs p2 + 9 * tiny
          /\ Rabs r3 <= (u + 2 * u * u) * Rabs p3 + 9 * tiny) as (size_r1 & size_r2 & size_r3).
  { pose proof (product_by_rounded n1 x1) as m1; pose proof (product_by_rounded n2 x2) as m2; pose proof (product_by_rounded n3 x3) as m3.
    pose proof (fl_error (n1 * x1)) as e1; pose proof (fl_error (n2 * x2)) as e2; pose proof (fl_error (n3 * x3)) as e3.
    fold p1 in m1, e1; fold p2 in m2, e2; fold p3 in m3, e3.
    assert (u * Rabs (n1 * x1) <= u * ((1 + 2 * u) * Rabs p1 + 2 * tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    assert (u * Rabs (n2 * x2) <= u * ((1 + 2 * u) * Rabs p2 + 2 * tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    assert (u * Rabs (n3 * x3) <= u * ((1 + 2 * u) * Rabs p3 + 2 * tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    apply within in e1; apply within in e2; apply within in e3.
    apply within in lost_1; apply within in lost_2; apply within in lost_3.
    repeat split; apply Rabs_le; unfold u in *; lra. }
  pose proof (rounded_sum p1 p2 (Rabs p1 + Rabs p2) Dp1 Dp2 ltac:(apply Rabs_le; lra)) as e0; fold s0 in e0.
  pose proof (rounded_sum p3 (- d) (Rabs p3 + Rabs d) Dp3 Dd' ltac:(apply Rabs_le; lra)) as e1; fold s1 in e1.
  apply within in e0; apply within in e1.
  pose proof (rounded_sum s0 s1 ((1 + u) * M) Ds0 Ds1 ltac:(apply Rabs_le; unfold M, u in *; lra)) as e2; fold s2 in e2.
  apply within in e2; apply within in size_r1; apply within in size_r2; apply within in size_r3.
  (* Five roundings of the rests. *)
  pose proof (rounded_sum r1 r2 ((u + 2 * u * u) * M + 18 * tiny) Dr1 Dr2 ltac:(apply Rabs_le; unfold M, u in *; lra)) as f1.
  set (a1 := fl (r1 + r2)) in *; assert (is_double a1) as Da1 by apply fl_is_double; apply within in f1.
  pose proof (rounded_sum a1 r3 ((u + 4 * u * u) * M + 28 * tiny) Da1 Dr3 ltac:(apply Rabs_le; unfold M, u in *; lra)) as f2.
  set (a2 := fl (a1 + r3)) in *; assert (is_double a2) as Da2 by apply fl_is_double; apply within in f2.
  pose proof (rounded_sum t0 t1 (u * M) Dt0 Dt1 ltac:(apply Rabs_le; unfold M, u in *; lra)) as g1.
  set (b1 := fl (t0 + t1)) in *; assert (is_double b1) as Db1 by apply fl_is_double; apply within in g1.
  pose proof (rounded_sum b1 t2 ((2 * u + 4 * u * u) * M) Db1 Dt2 ltac:(apply Rabs_le; unfold M, u in *; lra)) as g2.
  set (b2 := fl (b1 + t2)) in *; assert (is_double b2) as Db2 by apply fl_is_double; apply within in g2.
  pose proof (rounded_sum a2 b2 ((3 * u + 20 * u * u) * M + 30 * tiny) Da2 Db2 ltac:(apply Rabs_le; unfold M, u in *; lra)) as last.
  fold low in last; apply within in last.
  (* The size, as computed. *)
  assert (M * (1 - 4 * u) <= delta_size) as size.
  { unfold delta_size.
    assert (is_double (Rabs p1)) by now apply generic_format_abs. assert (is_double (Rabs p2)) by now apply generic_format_abs.
    assert (is_double (Rabs p3)) by now apply generic_format_abs. assert (is_double (Rabs d)) by now apply generic_format_abs.
    pose proof (sum_at_least (Rabs p1) (Rabs p2) (Rabs p1 + Rabs p2) ltac:(assumption) ltac:(assumption) ltac:(lra)).
    pose proof (sum_at_least _ (Rabs p3) ((Rabs p1 + Rabs p2) * (1 - u) + Rabs p3) (fl_is_double (Rabs p1 + Rabs p2)) ltac:(assumption)
      ltac:(unfold u in *; lra)).
    pose proof (sum_at_least _ (Rabs d) (((Rabs p1 + Rabs p2) * (1 - u) + Rabs p3) * (1 - u) + Rabs d)
      (fl_is_double (fl (Rabs p1 + Rabs p2) + Rabs p3)) ltac:(assumption) ltac:(unfold u in *; lra)).
    unfold M, u in *; lra. }
  apply within in lost_1; apply within in lost_2; apply within in lost_3.
  assert (0 <= M) by (unfold M; lra).
  split; [| split]; apply Rabs_le; unfold delta_error_unit, M, u in *; lra.
Qed.

Theorem delta_pair_error : Rabs (delta_pair - (n1 * x1 + n2 * x2 + n3 * x3 - d)) <= delta_error_unit * delta_size + 64 * tiny.
Proof.
  unfold delta_pair. rewrite (two_sum_is_exact s2 low (fl_is_double _) (fl_is_double _)). apply delta_parts.
Qed.

End Delta.

Print Assumptions delta_parts.
Print Assumptions delta_pair_error.
