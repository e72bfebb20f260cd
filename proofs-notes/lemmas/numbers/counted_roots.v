(* Lemmas counted-square, counted-quotient and counted-root (proofs-notes/rounding-of-forces.md, section 1): the other
   operators of fast/number_counted.hpp. Sizes come in as what their few roundings in doubles leave of them at least. *)

From Coq Require Import Reals Psatz.
From Groundtruth Require Import counted.
Open Scope R_scope.

Definition size_factor := 1 + 1 / 100. (* 1.01 *)
Definition rounded_factor := 1 + 9 / 1000. (* of which roundings leave this *)
Definition known_to := / 1024. (* 0x1p-10 *)
Definition nearly := 1 + 1 / 1000. (* the code's comparison with it is rounded *)

Section Roots.

Variable unit : R.
Hypothesis unit_is_small : 0 <= unit <= u.

Lemma value_of_size : forall n v s x, 0 <= n <= most_roundings -> counted unit n v s x ->
  Rabs v <= s * factor n * (1 + n * unit).
Proof.
  intros n v s x Hn (Hs & x_size & near).
  assert (Rabs v <= Rabs x + Rabs (v - x)) by (replace v with (x + (v - x)) at 1 by ring; apply Rabs_triang).
  replace (s * factor n * (1 + n * unit)) with (s * factor n + n * unit * s * factor n) by ring; lra.
Qed.

(* near = |v| (1 + 2^-50) + 2 error() is at least |v| and the error: `t`. *)
Theorem square_is_counted : forall n a sa xa t v s, 0 <= n -> 2 * n + 1 <= most_roundings ->
  counted unit n a sa xa -> Rabs a + n * unit * sa * factor n <= t ->
  Rabs (v - a * a) <= unit * (Rabs a * Rabs a) -> sa * t * (1 - u) <= s ->
  counted unit (2 * n + 1) v s (xa * xa).
Proof.
  intros n a sa xa t v s Hn most known t_near rounded s_near.
  assert (0 <= n <= most_roundings) as n_few by lra.
  pose proof (value_of_size n a sa xa n_few known) as a_size; destruct known as (Hsa & xa_size & a_near).
  destruct (size_of_count n n_few) as [f1 f2]; destruct (unit_of_count unit unit_is_small n n_few) as [n1 n2].
  destruct unit_is_small as [unit_0 unit_u].
  set (E := n * unit * sa * factor n) in *.
  assert (0 <= E) by (unfold E; rewrite Rmult_assoc; apply Rmult_le_pos; [| apply Rmult_le_pos]; lra).
  pose proof (Rabs_pos a); pose proof (Rabs_pos xa); pose proof (Rabs_pos (a - xa)).
  assert (Rabs xa <= Rabs a + Rabs (a - xa)).
  { replace xa with (a + - (a - xa)) at 1 by ring; rewrite <- (Rabs_Ropp (a - xa)); apply Rabs_triang. }
  assert (Rabs xa <= t) by lra. assert (0 <= t) by lra.
  set (P := sa * t) in *; assert (0 <= P) by (apply Rmult_le_pos; assumption).
  assert (P * factor n * (1 + second / 2) <= s * factor (2 * n + 1)) as grown.
  { apply Rle_trans with (P * (1 - u) * factor (2 * n + 1)).
    - rewrite !Rmult_assoc; apply Rmult_le_compat_l; [assumption |].
      unfold factor, second, u, most_roundings in *; nra.
    - apply Rmult_le_compat_r; [unfold factor, second; lra | assumption]. }
  assert (0 <= P * factor n) by (apply Rmult_le_pos; lra).
  split; [apply Rle_trans with (P * (1 - u)); [apply Rmult_le_pos; unfold u; lra | assumption] |]. split.
  - rewrite Rabs_mult; apply Rle_trans with (P * factor n).
    + replace (P * factor n) with (sa * factor n * t) by (unfold P; ring); apply Rmult_le_compat; assumption.
    + apply Rle_trans with (2 := grown); unfold second; nra.
  - assert (Rabs (a * a - xa * xa) <= 2 * n * unit * (P * factor n)).
    { replace (a * a - xa * xa) with ((a - xa) * (a + xa)) by ring; rewrite Rabs_mult.
      apply Rle_trans with (E * (2 * t)); [apply Rmult_le_compat; try assumption; [apply Rabs_pos |] |].
      - apply Rle_trans with (1 := Rabs_triang _ _); lra.
      - right; unfold E, P; ring. }
    assert (Rabs a * Rabs a <= P * factor n * (1 + n * unit)).
    { replace (P * factor n * (1 + n * unit)) with (sa * factor n * (1 + n * unit) * t) by (unfold P; ring).
      apply Rmult_le_compat; try assumption; lra. }
    assert (unit * (Rabs a * Rabs a) <= unit * (P * factor n * (1 + n * unit))) by (apply Rmult_le_compat_l; assumption).
    assert (Rabs (v - xa * xa) <= Rabs (v - a * a) + Rabs (a * a - xa * xa))
      by (replace (v - xa * xa) with (v - a * a + (a * a - xa * xa)) by ring; apply Rabs_triang).
    apply Rle_trans with ((2 * n + 1) * unit * (P * factor n * (1 + second / 2))).
    + set (G := P * factor n) in *.
      assert (unit * G * (n * unit) <= unit * G * (second / 2)) by (apply Rmult_le_compat_l; [apply Rmult_le_pos; assumption | unfold second; lra]).
      assert (0 <= 2 * n * unit * (G * (second / 2))) by (apply Rmult_le_pos; [nra | apply Rmult_le_pos; [assumption | unfold second; lra]]).
      nra.
    + replace ((2 * n + 1) * unit * s * factor (2 * n + 1)) with ((2 * n + 1) * unit * (s * factor (2 * n + 1))) by ring.
      apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | assumption].
Qed.

Theorem quotient_is_counted : forall m n a sa xa b sb xb v s, 0 <= m -> 0 <= n -> m + n + 2 <= most_roundings ->
  counted unit m a sa xa -> counted unit n b sb xb -> 0 < Rabs b ->
  n * unit * sb * factor n <= known_to * nearly * Rabs b ->
  Rabs (v - a / b) <= unit * Rabs (a / b) ->
  rounded_factor * (sa * / Rabs b) <= s -> rounded_factor * (sa * / Rabs b) * (rounded_factor * (sb * / Rabs b)) <= s ->
  counted unit (m + n + 2) v s (xa / xb).
Proof.
  intros m n a sa xa b sb xb v s Hm Hn most known_a known_b b_some b_known rounded s_one s_two.
  assert (0 <= m <= most_roundings) as m_few by lra; assert (0 <= n <= most_roundings) as n_few by lra.
  pose proof (value_of_size m a sa xa m_few known_a) as a_size.
  destruct known_a as (Hsa & xa_size & a_near); destruct known_b as (Hsb & xb_size & b_near).
  destruct (size_of_count m m_few) as [f1 f2]; destruct (unit_of_count unit unit_is_small m m_few) as [m1 m2].
  destruct (size_of_count n n_few) as [g1 g2]; destruct (unit_of_count unit unit_is_small n n_few) as [n1 n2].
  destruct unit_is_small as [unit_0 unit_u].
  set (r := / Rabs b) in *. assert (0 < r) by (apply Rinv_0_lt_compat; assumption).
  assert (Rabs b * r = 1) as r_inverse by (unfold r; field; lra).
  set (A := sa * r) in *; set (B := sb * r) in *.
  assert (0 <= A) by (apply Rmult_le_pos; lra). assert (0 <= B) by (apply Rmult_le_pos; lra).
  (* |xb| is near |b| *)
  assert (Rabs b <= Rabs xb + Rabs (b - xb)) by (replace b with (xb + (b - xb)) at 1 by ring; apply Rabs_triang).
  assert (known_to * nearly <= / 1000) by (unfold known_to, nearly; lra).
  assert (Rabs b * (1 - / 1000) <= Rabs xb) by nra.
  assert (0 < Rabs xb) by lra.
  assert (b <> 0) by (intros e; rewrite e, Rabs_R0 in b_some; lra).
  assert (xb <> 0) by (intros e; rewrite e, Rabs_R0 in *; lra).
  set (q := / Rabs xb). assert (0 < q) by (apply Rinv_0_lt_compat; assumption).
  assert (q <= r * (1 + / 900)) as q_near.
  { unfold q, r. apply Rmult_le_reg_r with (Rabs xb); [assumption |]. rewrite Rinv_l by lra.
    fold r. apply Rle_trans with (r * (1 + / 900) * (Rabs b * (1 - / 1000))).
    - replace (r * (1 + / 900) * (Rabs b * (1 - / 1000))) with (Rabs b * r * ((1 + / 900) * (1 - / 1000))) by ring.
      rewrite r_inverse; lra.
    - apply Rmult_le_compat_l; [apply Rmult_le_pos; lra | assumption]. }
  set (fm := factor m) in *; set (fn := factor n) in *.
  assert (A * rounded_factor <= s) by lra.
  assert (0 <= s) by (unfold rounded_factor in *; lra).
  assert (Rabs (xa / xb) <= s) as ratio_size.
  { unfold Rdiv; rewrite Rabs_mult, Rabs_Rinv by assumption; fold q.
    apply Rle_trans with (sa * fm * (r * (1 + / 900))); [apply Rmult_le_compat; try assumption; [apply Rabs_pos | lra] |].
    replace (sa * fm * (r * (1 + / 900))) with (A * (fm * (1 + / 900))) by (unfold A; ring).
    apply Rle_trans with (A * rounded_factor); [apply Rmult_le_compat_l; [assumption | unfold rounded_factor; lra] | assumption]. }
  assert (1 <= factor (m + n + 2)) by (unfold factor, second; lra).
  split; [assumption |].
  split; [apply Rle_trans with (s * 1); [lra | apply Rmult_le_compat_l; lra] |].
  assert (Rabs (a / b) <= s).
  { unfold Rdiv; rewrite Rabs_mult, Rabs_Rinv by assumption; fold r.
    apply Rle_trans with (sa * fm * (1 + m * unit) * r); [apply Rmult_le_compat_r; [lra | assumption] |].
    replace (sa * fm * (1 + m * unit) * r) with (A * (fm * (1 + m * unit))) by (unfold A; ring).
    apply Rle_trans with (A * rounded_factor); [apply Rmult_le_compat_l; [assumption |] | assumption].
    apply Rle_trans with ((1 + / 1024) * (1 + / 10000000000000)); [apply Rmult_le_compat; lra | unfold rounded_factor; lra]. }
  assert (Rabs (a / b - xa / b) <= m * unit * s).
  { replace (a / b - xa / b) with ((a - xa) * / b) by (field; assumption).
    rewrite Rabs_mult, Rabs_Rinv by assumption; fold r.
    apply Rle_trans with (m * unit * sa * fm * r); [apply Rmult_le_compat_r; [lra | assumption] |].
    replace (m * unit * sa * fm * r) with (m * unit * (A * fm)) by (unfold A; ring).
    apply Rmult_le_compat_l; [assumption |]. apply Rle_trans with (A * rounded_factor); [| assumption].
    apply Rmult_le_compat_l; [assumption | unfold rounded_factor; lra]. }
  assert (Rabs (xa / b - xa / xb) <= n * unit * s).
  { replace (xa / b - xa / xb) with (xa * (xb - b) * (/ b * / xb)) by (field; split; assumption).
    rewrite !Rabs_mult, !Rabs_Rinv by assumption; fold r q. rewrite (Rabs_minus_sym xb b).
    apply Rle_trans with (sa * fm * (n * unit * sb * fn) * (r * (r * (1 + / 900)))).
    { apply Rmult_le_compat.
      - apply Rmult_le_pos; apply Rabs_pos.
      - apply Rmult_le_pos; lra.
      - apply Rmult_le_compat; try assumption; apply Rabs_pos.
      - apply Rmult_le_compat_l; [lra | assumption]. }
    replace (sa * fm * (n * unit * sb * fn) * (r * (r * (1 + / 900)))) with (n * unit * (A * B * (fm * fn * (1 + / 900))))
      by (unfold A, B; ring).
    apply Rmult_le_compat_l; [assumption |].
    assert (0 <= A * B) by (apply Rmult_le_pos; assumption).
    assert (fm * fn <= (1 + / 1024) * (1 + / 1024)) by (apply Rmult_le_compat; lra).
    apply Rle_trans with (A * B * (rounded_factor * rounded_factor)).
    - apply Rmult_le_compat_l; [assumption | unfold rounded_factor; lra].
    - apply Rle_trans with (2 := s_two); right; ring. }
  assert (unit * Rabs (a / b) <= unit * s) by (apply Rmult_le_compat_l; assumption).
  apply Rle_trans with ((m + n + 2) * unit * s).
  - replace (v - xa / xb) with (v - a / b + (a / b - xa / b) + (xa / b - xa / xb)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _).
    apply Rle_trans with (Rabs (v - a / b) + Rabs (a / b - xa / b) + Rabs (xa / b - xa / xb));
      [apply Rplus_le_compat_r, Rabs_triang |].
    assert (0 <= unit * s) by (apply Rmult_le_pos; assumption). lra.
  - rewrite <- (Rmult_1_r ((m + n + 2) * unit * s)) at 1. apply Rmult_le_compat_l; [| assumption].
    apply Rmult_le_pos; [apply Rmult_le_pos; lra | assumption].
Qed.

(* k is n / 2, rounded up, and 1. *)
Theorem root_is_counted : forall n k a sa xa v s, 0 <= n <= most_roundings -> n / 2 + 1 <= k ->
  counted unit n a sa xa -> 0 <= xa -> 0 < a -> n * unit * sa * factor n <= known_to * nearly * a ->
  Rabs (v - sqrt a) <= unit * sqrt a ->
  rounded_factor * (sa / sqrt a) <= s -> rounded_factor * (a / sqrt a) <= s ->
  counted unit k v s (sqrt xa).
Proof.
  intros n k a sa xa v s n_few Hk (Hsa & xa_size & a_near) xa_pos a_pos a_known rounded s_one s_two.
  destruct (size_of_count n n_few) as [f1 f2]; destruct (unit_of_count unit unit_is_small n n_few) as [n1 n2].
  destruct unit_is_small as [unit_0 unit_u]. set (f := factor n) in *.
  assert (0 < sqrt a) as root_pos by now apply sqrt_lt_R0.
  assert (sqrt a * sqrt a = a) as root_a by (apply sqrt_sqrt; lra).
  assert (sqrt xa * sqrt xa = xa) as root_x by now apply sqrt_sqrt.
  pose proof (sqrt_pos xa) as root_x_pos.
  set (p := sqrt a) in *; set (q := sqrt xa) in *.
  assert (a / p = p) as whole by (unfold Rdiv; rewrite <- root_a at 1; field; lra). rewrite whole in s_two.
  assert (known_to * nearly <= / 1000) by (unfold known_to, nearly; lra).
  assert (n * unit * sa * f <= / 1000 * a) by nra.
  apply within in a_near.
  assert (p * (1 - / 1000) <= q) as q_low by (apply Rnot_lt_le; intros less; nra).
  assert (q <= p * (1 + / 1000)) as q_high by (apply Rnot_lt_le; intros more; nra).
  set (A := sa / p) in *. assert (sa = A * p) as sa_is by (unfold A; field; lra).
  assert (0 <= A) by (unfold A, Rdiv; apply Rmult_le_pos; [| left; apply Rinv_0_lt_compat]; assumption).
  assert (0 <= s) by (unfold rounded_factor in *; lra).
  assert (1 <= factor k) by (unfold factor, second; lra).
  assert (Rabs (p - q) <= n / 2 * unit * s) as roots_near.
  { assert (Rabs (p - q) * (p + q) <= n * unit * sa * f) as product.
    { rewrite <- (Rabs_pos_eq (p + q)) by lra; rewrite <- Rabs_mult.
      replace ((p - q) * (p + q)) with (a - xa) by (rewrite <- root_a, <- root_x; ring). apply Rabs_le; lra. }
    apply Rmult_le_reg_r with (p + q); [lra |]. apply Rle_trans with (1 := product).
    apply Rle_trans with (n * unit * (A * f * p)); [right; rewrite sa_is; ring |].
    apply Rle_trans with (n * unit * (s / 2 * (p + q))); [| right; field].
    apply Rmult_le_compat_l; [assumption |].
    apply Rle_trans with (s / 2 * (p * (2 - / 1000))); [| apply Rmult_le_compat_l; lra].
    replace (s / 2 * (p * (2 - / 1000))) with (s * (1 - / 2000) * p) by field.
    apply Rmult_le_compat_r; [lra |]. unfold rounded_factor in *; nra. }
  split; [assumption |]. split.
  - rewrite Rabs_pos_eq by assumption. apply Rle_trans with (s * 1); [unfold rounded_factor in *; lra | apply Rmult_le_compat_l; assumption].
  - apply Rle_trans with (k * unit * s).
    + assert (Rabs (v - q) <= Rabs (v - p) + Rabs (p - q)) by (replace (v - q) with (v - p + (p - q)) by ring; apply Rabs_triang).
      assert (unit * p <= unit * s) by (apply Rmult_le_compat_l; [assumption | unfold rounded_factor in *; lra]).
      assert ((n / 2 + 1) * (unit * s) <= k * (unit * s)) by (apply Rmult_le_compat_r; [apply Rmult_le_pos |]; assumption).
      lra.
    + rewrite <- (Rmult_1_r (k * unit * s)) at 1. apply Rmult_le_compat_l; [| assumption].
      apply Rmult_le_pos; [apply Rmult_le_pos; lra | assumption].
Qed.

End Roots.

Print Assumptions square_is_counted.
Print Assumptions quotient_is_counted.
Print Assumptions root_is_counted.
