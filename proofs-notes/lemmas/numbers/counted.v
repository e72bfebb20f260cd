(* Lemma counted-roundings (proofs-notes/rounding-of-forces.md, section 1): sums and products of
   numbers that carry a value, a size and a count of roundings.

   One rounding of the type is off by at most `unit` of the sum of its terms' magnitudes (or of its result), once
   underflow is counted in. Sizes are computed in doubles, each operation off by at most 2^-53 of itself. What
   second orders and sizes cost is `second` for each rounding counted: n of them cost n times as much, which stays within
   2^-10 while n <= 400 (size_of_count). *)

From Coq Require Import Reals Psatz.
Open Scope R_scope.

Definition second := / 1048576. (* 2^-20 *)
Definition most_roundings := 400.
Definition second_orders := / 1024. (* 0x1p-10 *)
Definition u := / 9007199254740992. (* 2^-53 *)

Section Counted.

Variable unit : R.
Hypothesis unit_is_small : 0 <= unit <= u.

Definition factor n := 1 + second * n.

(* `value`, `size` stand for x after n roundings. *)
Definition counted n value size x :=
  0 <= size /\ Rabs x <= size * factor n /\ Rabs (value - x) <= n * unit * size * factor n.

Lemma within : forall x a, Rabs x <= a -> - a <= x <= a.
Proof. intros x a; unfold Rabs; destruct (Rcase_abs x); lra. Qed.

Lemma size_of_count : forall n, 0 <= n <= most_roundings -> 1 <= factor n <= 1 + / 1024.
Proof. intros; unfold factor, second, most_roundings in *; lra. Qed.

(* The code's error(): n units of size, and 2^-10 of that. *)
Theorem error_is_bound : forall n value size x, 0 <= n <= most_roundings -> counted n value size x ->
  Rabs (value - x) <= n * unit * (1 + second_orders) * size.
Proof.
  intros n value size x Hn (Hs & _ & near); destruct (size_of_count n Hn) as [_ most].
  apply Rle_trans with (1 := near).
  unfold second_orders; replace (n * unit * (1 + / 1024) * size) with (n * unit * size * (1 + / 1024)) by ring.
  apply Rmult_le_compat_l; [| assumption].
  apply Rmult_le_pos; [apply Rmult_le_pos |]; tauto.
Qed.

Lemma unit_of_count : forall n, 0 <= n <= most_roundings -> 0 <= n * unit <= / 10000000000000.
Proof.
  intros n Hn; destruct unit_is_small; unfold most_roundings, u in *; split; [apply Rmult_le_pos; lra |].
  apply Rle_trans with (400 * / 9007199254740992); [apply Rmult_le_compat; lra | lra].
Qed.

Theorem sum_is_counted : forall n a sa xa b sb xb v s, 0 <= n -> n + 1 <= most_roundings ->
  counted n a sa xa -> counted n b sb xb ->
  Rabs (v - (a + b)) <= unit * (Rabs a + Rabs b) -> (sa + sb) * (1 - u) <= s ->
  counted (n + 1) v s (xa + xb).
Proof.
  intros n a sa xa b sb xb v s Hn most (Hsa & xa_size & a_near) (Hsb & xb_size & b_near) rounded s_near.
  destruct (size_of_count n) as [f1 f2]; [lra |].
  destruct (unit_of_count n) as [n1 n2]; [lra |].
  set (S := sa + sb) in *; assert (0 <= S) by (unfold S; lra).
  assert (factor (n + 1) = factor n + second) as more by (unfold factor; ring).
  assert (S * factor n <= s * factor (n + 1)) as grown.
  { apply Rle_trans with (S * (1 - u) * factor (n + 1)).
    - replace (S * (1 - u) * factor (n + 1)) with (S * ((1 - u) * factor (n + 1))) by ring.
      apply Rmult_le_compat_l; [assumption |]; rewrite more; unfold u, second in *; lra.
    - apply Rmult_le_compat_r; [rewrite more; unfold second; lra | assumption]. }
  set (F := S * factor n) in *.
  assert (0 <= F) by (apply Rmult_le_pos; lra).
  assert (Rabs xa + Rabs xb <= F) by (unfold F, S; lra).
  assert (Rabs (a - xa) + Rabs (b - xb) <= n * unit * F)
    by (replace (n * unit * F) with (n * unit * sa * factor n + n * unit * sb * factor n) by (unfold F, S; ring); lra).
  assert (Rabs a <= Rabs xa + Rabs (a - xa)) by (replace a with (xa + (a - xa)) at 1 by ring; apply Rabs_triang).
  assert (Rabs b <= Rabs xb + Rabs (b - xb)) by (replace b with (xb + (b - xb)) at 1 by ring; apply Rabs_triang).
  destruct unit_is_small as [unit_0 unit_u].
  assert (Rabs (v - (a + b)) <= unit * (F + n * unit * F))
    by (apply Rle_trans with (1 := rounded); apply Rmult_le_compat_l; lra).
  split; [apply Rle_trans with (S * (1 - u)); [apply Rmult_le_pos; unfold u; lra | assumption] |].
  split; [apply Rle_trans with (2 := grown); apply Rle_trans with (2 := H1); apply Rabs_triang |].
  assert (Rabs (v - (xa + xb)) <= Rabs (v - (a + b)) + Rabs (a - xa) + Rabs (b - xb)).
  { replace (v - (xa + xb)) with (v - (a + b) + (a - xa) + (b - xb)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat_r, Rabs_triang. }
  apply Rle_trans with ((n + 1) * unit * (S * (1 - u) * factor (n + 1))).
  - apply Rle_trans with ((n + 1) * unit * F + n * unit * (unit * F)); [lra |].
    assert (F * (1 + second / 2) <= S * (1 - u) * factor (n + 1)).
    { replace (S * (1 - u) * factor (n + 1)) with (S * ((1 - u) * factor (n + 1))) by ring.
      unfold F; rewrite Rmult_assoc; apply Rmult_le_compat_l; [assumption |]; rewrite more; unfold u, second in *; lra. }
    assert (unit * F <= second / 2 * F) by (apply Rmult_le_compat_r; [assumption | unfold u, second in *; lra]).
    apply Rle_trans with ((n + 1) * unit * (F * (1 + second / 2))).
    + replace ((n + 1) * unit * (F * (1 + second / 2))) with ((n + 1) * unit * F + n * unit * (second / 2 * F) + unit * (second / 2 * F)) by ring.
      assert (n * unit * (unit * F) <= n * unit * (second / 2 * F)) by (apply Rmult_le_compat_l; assumption).
      assert (0 <= unit * (second / 2 * F)) by (apply Rmult_le_pos; [assumption | unfold second; lra]).
      lra.
    + apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | assumption].
  - replace ((n + 1) * unit * s * factor (n + 1)) with ((n + 1) * unit * (s * factor (n + 1))) by ring.
    apply Rmult_le_compat_l; [apply Rmult_le_pos; lra |].
    apply Rmult_le_compat_r; [rewrite more; unfold second; lra | assumption].
Qed.

Theorem product_is_counted : forall m n a sa xa b sb xb v s, 0 <= m -> 0 <= n -> m + n + 1 <= most_roundings ->
  counted m a sa xa -> counted n b sb xb ->
  Rabs (v - a * b) <= unit * (Rabs a * Rabs b) -> sa * sb * (1 - u) <= s ->
  counted (m + n + 1) v s (xa * xb).
Proof.
  intros m n a sa xa b sb xb v s Hm Hn most (Hsa & xa_size & a_near) (Hsb & xb_size & b_near) rounded s_near.
  destruct (size_of_count m) as [f1 f2]; [lra |]; destruct (size_of_count n) as [g1 g2]; [lra |].
  destruct (unit_of_count m) as [m1 m2]; [lra |]; destruct (unit_of_count n) as [n1 n2]; [lra |].
  set (P := sa * sb) in *; assert (0 <= P) by (apply Rmult_le_pos; assumption).
  destruct unit_is_small as [unit_0 unit_u].
  set (k := m + n + 1) in *.
  assert (factor m * factor n * (1 + second / 8) <= (1 - u) * factor k) as factors.
  { assert (m * n <= 400 * 400) by (unfold k, most_roundings in most; apply Rmult_le_compat; lra).
    replace (factor m * factor n) with (1 + second * (m + n) + second * second * (m * n)) by (unfold factor; ring).
    unfold factor, k, most_roundings, second, u in *; lra. }
  set (F := P * (factor m * factor n)) in *.
  assert (0 <= F) by (apply Rmult_le_pos; [assumption | apply Rmult_le_pos; lra]).
  assert (F * (1 + second / 8) <= s * factor k) as grown.
  { apply Rle_trans with (P * (1 - u) * factor k).
    - unfold F; rewrite !Rmult_assoc; apply Rmult_le_compat_l; [assumption |]; rewrite <- Rmult_assoc; assumption.
    - apply Rmult_le_compat_r; [unfold factor, k, second; lra | assumption]. }
  assert (0 <= m * unit) as am by apply m1; assert (0 <= n * unit) as bn by apply n1.
  set (al := m * unit) in *; set (be := n * unit) in *.
  pose proof (Rabs_pos xa); pose proof (Rabs_pos xb); pose proof (Rabs_pos (a - xa)); pose proof (Rabs_pos (b - xb)).
  assert (Rabs (a - xa) * Rabs xb <= al * F).
  { replace (al * F) with (al * sa * factor m * (sb * factor n)) by (unfold F, P; ring); apply Rmult_le_compat; assumption. }
  assert (Rabs xa * Rabs (b - xb) <= be * F).
  { replace (be * F) with (sa * factor m * (be * sb * factor n)) by (unfold F, P; ring); apply Rmult_le_compat; assumption. }
  assert (Rabs (a - xa) * Rabs (b - xb) <= al * be * F).
  { replace (al * be * F) with (al * sa * factor m * (be * sb * factor n)) by (unfold F, P; ring);
      apply Rmult_le_compat; assumption. }
  assert (Rabs xa * Rabs xb <= F).
  { replace F with (sa * factor m * (sb * factor n)) by (unfold F, P; ring); apply Rmult_le_compat; assumption. }
  assert (Rabs a <= Rabs xa + Rabs (a - xa)) by (replace a with (xa + (a - xa)) at 1 by ring; apply Rabs_triang).
  assert (Rabs b <= Rabs xb + Rabs (b - xb)) by (replace b with (xb + (b - xb)) at 1 by ring; apply Rabs_triang).
  assert (Rabs a * Rabs b <= F + al * F + be * F + al * be * F).
  { apply Rle_trans with ((Rabs xa + Rabs (a - xa)) * (Rabs xb + Rabs (b - xb)));
      [apply Rmult_le_compat; try assumption; apply Rabs_pos | lra]. }
  assert (Rabs (a * b - xa * xb) <= al * F + be * F + al * be * F).
  { replace (a * b - xa * xb) with ((a - xa) * xb + xa * (b - xb) + (a - xa) * (b - xb)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_mult with (x := a - xa) (y := b - xb).
    apply Rplus_le_compat; [| assumption].
    apply Rle_trans with (1 := Rabs_triang _ _); rewrite !Rabs_mult; lra. }
  assert (Rabs (v - xa * xb) <= Rabs (v - a * b) + Rabs (a * b - xa * xb)).
  { replace (v - xa * xb) with (v - a * b + (a * b - xa * xb)) by ring; apply Rabs_triang. }
  assert (al * be <= unit * k * (second / 32)).
  { unfold al at 1; replace (unit * k * (second / 32)) with (unit * (k * (second / 32))) by ring.
    replace (m * unit * be) with (unit * (m * be)) by ring; apply Rmult_le_compat_l; [assumption |].
    apply Rmult_le_compat; [assumption | assumption | unfold k; lra | unfold second; lra]. }
  assert (unit * (al + be + al * be) <= unit * k * (second / 32)).
  { replace (unit * k * (second / 32)) with (unit * (k * (second / 32))) by ring; apply Rmult_le_compat_l; [assumption |].
    assert (al * be <= 1 * be) by (apply Rmult_le_compat_r; lra); unfold k, second; lra. }
  split; [apply Rle_trans with (P * (1 - u)); [apply Rmult_le_pos; unfold u; lra | assumption] |].
  split.
  - rewrite Rabs_mult; apply Rle_trans with F; [assumption |]; apply Rle_trans with (2 := grown); unfold second; lra.
  - apply Rle_trans with (k * unit * (F * (1 + second / 8))).
    + assert (unit * (Rabs a * Rabs b) <= unit * (F + al * F + be * F + al * be * F)) by (apply Rmult_le_compat_l; assumption).
      apply Rle_trans with ((unit + al + be + al * be + unit * (al + be + al * be)) * F); [lra |].
      replace (k * unit * (F * (1 + second / 8))) with (k * unit * (1 + second / 8) * F) by ring.
      apply Rmult_le_compat_r; [assumption |].
      assert (k * unit = al + be + unit) by (unfold k, al, be; ring).
      assert (0 <= k * unit) by lra.
      unfold second in *; lra.
    + replace (k * unit * s * factor k) with (k * unit * (s * factor k)) by ring.
      apply Rmult_le_compat_l; [apply Rmult_le_pos; [unfold k; lra | assumption] | assumption].
Qed.

End Counted.

Print Assumptions error_is_bound.
Print Assumptions sum_is_counted.
Print Assumptions product_is_counted.
