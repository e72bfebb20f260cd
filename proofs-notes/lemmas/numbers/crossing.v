(* Lemma crossing-in-double-double (proofs-notes/rounding.md): the quotient of fast/crossing_body.hpp, and that its
   rounding is right where its two limits round alike. Delta at both ends is delta_in_pairs.v's; W and the quotient are
   taken as double-doubles here. Underflow comes in as `lost`, a bound of what each operation loses by it. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles pair_sum.
Open Scope R_scope.

Definition crossing_unit := 128 * u * u.

(* If high + (low - e) and high + (low + e) round alike, the exact number rounds so too: to high. *)
Theorem rounding_is_certain : forall high low e error lambda,
  is_double high -> is_double low -> is_double e -> fl (high + low) = high ->
  Rabs (lambda - (high + low)) <= error -> 0 <= error -> error + 2 * u * (Rabs low + e) <= e ->
  fl (high + fl (low + e)) = fl (high + fl (low + - e)) -> fl lambda = high.
Proof.
  intros high low e error lambda Dh Dl De tidy near positive enough same.
  assert (0 <= u) by (unfold u; lra). pose proof (Rabs_pos low).
  assert (0 <= e) by (unfold u in *; nra).
  pose proof (sum_error low e Dl De) as up.
  assert (is_double (- e)) as Dm by now apply generic_format_opp.
  pose proof (sum_error low (- e) Dl Dm) as down.
  assert (Rabs (low + e) <= Rabs low + e) by (apply Rle_trans with (1 := Rabs_triang _ _); rewrite (Rabs_pos_eq e) by assumption; lra).
  assert (Rabs (low + - e) <= Rabs low + e)
    by (apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_Ropp, (Rabs_pos_eq e) by assumption; lra).
  assert (u * Rabs (low + e) <= u * (Rabs low + e)) by now apply Rmult_le_compat_l.
  assert (u * Rabs (low + - e) <= u * (Rabs low + e)) by now apply Rmult_le_compat_l.
  apply within in up; apply within in down; apply within in near.
  assert (0 <= u * (Rabs low + e)) by (apply Rmult_le_pos; lra).
  assert (low + error <= fl (low + e)) as above by lra.
  assert (fl (low + - e) <= low - error) as below by lra.
  assert (fl lambda <= fl (high + fl (low + e))) as at_most by (apply fl_monotone; lra).
  assert (fl (high + fl (low + - e)) <= fl lambda) as at_least by (apply fl_monotone; lra).
  assert (fl (high + low) <= fl (high + fl (low + e))) by (apply fl_monotone; lra).
  assert (fl (high + fl (low + - e)) <= fl (high + low)) by (apply fl_monotone; lra).
  lra.
Qed.

Section Difference.

(* Delta at both ends, as delta_in_pairs.v leaves it; M the sum of both sizes. *)
Variables va ra vb rb Ma Mb lost A B : R.
Hypotheses (Dva : is_double va) (Dra : is_double ra) (Dvb : is_double vb) (Drb : is_double rb).
Hypotheses (Ma_pos : 0 <= Ma) (Mb_pos : 0 <= Mb) (lost_pos : 0 <= lost).
Hypotheses (a_near : Rabs (va + ra - A) <= 32 * u * u * Ma + lost) (b_near : Rabs (vb + rb - B) <= 32 * u * u * Mb + lost).
Hypotheses (va_size : Rabs va <= (1 + 4 * u) * Ma) (vb_size : Rabs vb <= (1 + 4 * u) * Mb).
Hypotheses (ra_size : Rabs ra <= 4 * u * Ma) (rb_size : Rabs rb <= 4 * u * Mb).

Let difference := fl (va + - vb).
Let t := fl (rest va (- vb) + fl (ra + - rb)).
Let w_high := fl (difference + t).
Let w_low := rest difference t.

Theorem w_error : Rabs (w_high + w_low - (A - B)) <= 42 * u * u * (Ma + Mb) + 2 * lost.
Proof.
  assert (is_double (- vb)) as Dnb by now apply generic_format_opp.
  assert (is_double (- rb)) as Dnr by now apply generic_format_opp.
  assert (is_double difference) as Dd by apply fl_is_double. assert (is_double t) as Dt by apply fl_is_double.
  unfold w_high, w_low. rewrite (two_sum_is_exact difference t Dd Dt).
  pose proof (two_sum_is_exact va (- vb) Dva Dnb) as exact; fold difference in exact.
  pose proof (sum_error va (- vb) Dva Dnb) as d_near; fold difference in d_near.
  set (d := rest va (- vb)) in *. assert (is_double d) as Ddl by apply fl_is_double.
  pose proof (sum_error ra (- rb) Dra Dnr) as r_near; set (r := fl (ra + - rb)) in *.
  pose proof (sum_error d r Ddl (fl_is_double _)) as t_near; fold t in t_near.
  set (M := Ma + Mb). assert (0 <= M) by (unfold M; lra).
  assert (0 <= u) by (unfold u; lra). assert (0 <= u * M) by now apply Rmult_le_pos.
  assert (0 <= u * (u * M)) by now apply Rmult_le_pos.
  assert (u * (u * M) <= / 1000000000 * (u * M)) by (apply Rmult_le_compat_r; [assumption | unfold u; lra]).
  assert (u * (u * (u * M)) <= / 1000000000 * (u * (u * M))) by (apply Rmult_le_compat_r; [assumption | unfold u; lra]).
  apply within in va_size; apply within in vb_size; apply within in ra_size; apply within in rb_size.
  assert (Rabs (va + - vb) <= M + 4 * (u * M)) by (unfold M; apply Rabs_le; lra).
  assert (u * Rabs (va + - vb) <= u * (M + 4 * (u * M))) by now apply Rmult_le_compat_l.
  assert (Rabs (ra + - rb) <= 4 * (u * M)) by (unfold M; apply Rabs_le; lra).
  assert (u * Rabs (ra + - rb) <= u * (4 * (u * M))) by now apply Rmult_le_compat_l.
  apply within in d_near; apply within in r_near; apply within in a_near; apply within in b_near.
  assert (Rabs (ra + - rb) <= 4 * (u * M)) as rr by assumption; apply within in rr.
  assert (Rabs (d + r) <= 5 * (u * M) + 9 * (u * (u * M))) by (apply Rabs_le; lra).
  assert (u * Rabs (d + r) <= u * (5 * (u * M) + 9 * (u * (u * M)))) by now apply Rmult_le_compat_l.
  apply within in t_near.
  replace (42 * u * u * (Ma + Mb)) with (42 * (u * (u * M))) by (unfold M; ring).
  replace (32 * u * u * Ma) with (32 * (u * (u * Ma))) in a_near by ring.
  replace (32 * u * u * Mb) with (32 * (u * (u * Mb))) in b_near by ring.
  assert (u * (u * M) = u * (u * Ma) + u * (u * Mb)) by (unfold M; ring).
  apply Rabs_le; lra.
Qed.

(* What the quotient takes of it. *)
Theorem lambda_is_near : forall lambda, A = lambda * (A - B) ->
  Rabs (va + ra - lambda * (w_high + w_low)) <= (1 + 2 * Rabs lambda) * (52 * u * u * (Ma + Mb) + lost).
Proof.
  intros lambda crossing. pose proof w_error as near. set (w := w_high + w_low) in *.
  replace (va + ra - lambda * w) with ((va + ra - A) + - (lambda * (w - (A - B))))
    by (replace (lambda * (w - (A - B))) with (lambda * w - lambda * (A - B)) by ring; rewrite <- crossing; ring).
  apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, Rabs_mult.
  assert (Rabs lambda * Rabs (w - (A - B)) <= Rabs lambda * (42 * u * u * (Ma + Mb) + 2 * lost))
    by (apply Rmult_le_compat_l; [apply Rabs_pos | assumption]).
  set (X := u * u * (Ma + Mb)). assert (0 <= X) by (apply Rmult_le_pos; [unfold u |]; lra).
  assert (u * u * Ma <= X) by (apply Rmult_le_compat_l; [unfold u |]; lra).
  pose proof (Rabs_pos lambda). assert (0 <= Rabs lambda * X) by now apply Rmult_le_pos.
  replace (42 * u * u * (Ma + Mb)) with (42 * X) in * by (unfold X; ring).
  replace (52 * u * u * (Ma + Mb)) with (52 * X) by (unfold X; ring).
  replace (32 * u * u * Ma) with (32 * (u * u * Ma)) in a_near by ring.
  lra.
Qed.
End Difference.

Section Quotient.

(* value + rest at the first end and w_high + w_low stand for A and W. *)
Variables value rest w_high w_low size lost A W q remainder : R.
Hypothesis size_pos : 0 <= size.
Hypothesis lost_bounds : 0 <= lost.
Hypothesis value_size : Rabs value <= (1 + 4 * u) * size.
Hypothesis rest_size : Rabs rest <= 4 * u * size.
Hypothesis w_some : w_high <> 0.
Hypothesis w_tidy : Rabs w_low <= u * Rabs w_high.
Hypothesis lambda_near : forall lambda, A = lambda * W ->
  Rabs (value + rest - lambda * (w_high + w_low)) <= (1 + 2 * Rabs lambda) * (52 * u * u * size + lost).

(* q = fl(value / w_high); its remainder is exact, or loses by underflow. *)
Hypothesis quotient_near : Rabs (value - q * w_high) <= (u + 2 * u * u) * Rabs value + lost.
Hypothesis remainder_near : Rabs (remainder - (value - q * w_high)) <= lost.

Let y := fl (q * w_low).
Let z := fl (rest + - y).
Let s := fl (remainder + z).
Variable inverse : R.
Hypothesis inverse_near : Rabs (inverse * w_high - 1) <= 2 * u.
Let c := fl (s * inverse).
Hypothesis remainder_is_double : is_double remainder.
Hypothesis rest_is_double : is_double rest.
Hypothesis tiny_lost : tiny <= lost.
Hypothesis tiny_times_w : tiny * Rabs w_high <= lost.

Lemma product_bound : forall a b p q_, Rabs a <= p -> Rabs b <= q_ -> Rabs (a * b) <= p * q_.
Proof. intros; rewrite Rabs_mult; apply Rmult_le_compat; try assumption; apply Rabs_pos. Qed.

(* How far q + c is from lambda, times |w|. *)
Theorem quotient_error : forall lambda, A = lambda * W -> lost <= size ->
  Rabs ((q + c - lambda) * (w_high + w_low)) <= (1 + 2 * Rabs lambda) * (106 * u * u * size + 12 * lost).
Proof.
  intros lambda crossing small_lost. specialize (lambda_near lambda crossing).
  pose proof tiny_positive. pose proof (Rabs_pos lambda). assert (0 < u) by (unfold u; lra).
  set (rho := value - q * w_high) in *.
  set (M := size) in *.
  assert (u * M >= 0) by (apply Rle_ge, Rmult_le_pos; lra).
  assert (u * (u * M) <= / 1000000000 * (u * M)) by (apply Rmult_le_compat_r; [lra | unfold u; lra]).
  assert (u * M <= / 1000000000 * M) by (apply Rmult_le_compat_r; [lra | unfold u; lra]).
  assert (u * lost <= / 1000000000 * lost) by (apply Rmult_le_compat_r; [lra | unfold u; lra]).
  assert (0 <= u * lost) by (apply Rmult_le_pos; lra).
  assert (u * (u * lost) <= u * lost) by (unfold u in *; lra).
  (* |rho| <= 1.001 u M + lost, |q w_high| <= 1.001 M + lost *)
  assert (Rabs rho <= (1 + / 1000) * (u * M) + lost) as rho_size.
  { apply Rle_trans with (1 := quotient_near). apply Rplus_le_compat_r.
    apply Rle_trans with ((u + 2 * u * u) * ((1 + 4 * u) * M)); [apply Rmult_le_compat_l; [unfold u; lra | assumption] |].
    replace ((u + 2 * u * u) * ((1 + 4 * u) * M)) with (u * M * ((1 + 2 * u) * (1 + 4 * u))) by ring.
    rewrite (Rmult_comm (1 + / 1000)); apply Rmult_le_compat_l; [lra | unfold u; lra]. }
  assert (Rabs (q * w_high) <= (1 + / 1000) * M + lost) as q_size.
  { replace (q * w_high) with (value - rho) by (unfold rho; ring).
    apply Rle_trans with (Rabs value + Rabs rho); [unfold Rminus; rewrite <- (Rabs_Ropp rho); apply Rabs_triang |].
    unfold u in *; lra. }
  assert (Rabs (q * w_low) <= u * ((1 + / 1000) * M + lost)) as qw_size.
  { rewrite Rabs_mult. apply Rle_trans with (Rabs q * (u * Rabs w_high)); [apply Rmult_le_compat_l; [apply Rabs_pos | assumption] |].
    replace (Rabs q * (u * Rabs w_high)) with (u * Rabs (q * w_high)) by (rewrite Rabs_mult; ring).
    apply Rmult_le_compat_l; lra. }
  assert (u * Rabs (q * w_low) <= u * (u * ((1 + / 1000) * M + lost))) by (apply Rmult_le_compat_l; lra).
  pose proof (fl_error (q * w_low)) as y_near; fold y in y_near.
  assert (Rabs (y - q * w_low) <= (1 + / 1000) * (u * (u * M)) + 2 * lost) as y_error by lra.
  assert (is_double (- y)) as Dy by (apply generic_format_opp, fl_is_double).
  pose proof (sum_error rest (- y) rest_is_double Dy) as z_near; fold z in z_near.
  apply within in y_error; apply within in qw_size. pose proof (within _ _ rest_size) as rest_range.
  assert (Rabs (rest + - y) <= (6 + / 1000) * (u * M) + 3 * lost) as z_size by (apply Rabs_le; lra).
  assert (u * Rabs (rest + - y) <= u * ((6 + / 1000) * (u * M) + 3 * lost)) by (apply Rmult_le_compat_l; lra).
  assert (Rabs (z - (rest - q * w_low)) <= (8 + / 100) * (u * (u * M)) + 3 * lost) as z_error.
  { apply within in z_near. apply Rabs_le; lra. }
  pose proof (sum_error remainder z remainder_is_double (fl_is_double _)) as s_near; fold s in s_near.
  apply within in z_error; apply within in rho_size. pose proof (within _ _ remainder_near) as remainder_range.
  set (g := rho + (rest - q * w_low)).
  assert (Rabs g <= (7 + / 10) * (u * M) + 2 * lost) as g_size by (unfold g; apply Rabs_le; lra).
  apply within in g_size.
  assert (Rabs (remainder + z) <= (8 + / 10) * (u * M) + 7 * lost) as s_size by (unfold g in *; apply Rabs_le; lra).
  assert (u * Rabs (remainder + z) <= u * ((8 + / 10) * (u * M) + 7 * lost)) by (apply Rmult_le_compat_l; lra).
  assert (Rabs (s - g) <= (17 + / 2) * (u * (u * M)) + 5 * lost) as s_error.
  { apply within in s_near. unfold g in *. apply Rabs_le; lra. }
  apply within in s_error.
  assert (Rabs s <= (8 + / 4) * (u * M) + 8 * lost) as s_bound by (apply Rabs_le; lra).
  (* c w_high is near s *)
  pose proof (fl_error (s * inverse)) as c_near; fold c in c_near.
  set (i := inverse * w_high - 1) in *.
  assert (Rabs (s * i) <= ((8 + / 4) * (u * M) + 8 * lost) * (2 * u)) as si by now apply product_bound.
  assert (Rabs ((c - s * inverse) * w_high) <= u * (Rabs s * (1 + 2 * u)) + lost) as cs.
  { rewrite Rabs_mult. apply Rle_trans with ((u * Rabs (s * inverse) + tiny) * Rabs w_high);
      [apply Rmult_le_compat_r; [apply Rabs_pos | assumption] |].
    replace ((u * Rabs (s * inverse) + tiny) * Rabs w_high) with (u * (Rabs s * Rabs (inverse * w_high)) + tiny * Rabs w_high)
      by (rewrite !Rabs_mult; ring).
    apply Rplus_le_compat; [| assumption]. apply Rmult_le_compat_l; [lra |]. apply Rmult_le_compat_l; [apply Rabs_pos |].
    replace (inverse * w_high) with (1 + i) by (unfold i; ring). apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_R1; lra. }
  assert (u * (Rabs s * (1 + 2 * u)) <= u * (((8 + / 4) * (u * M) + 8 * lost) * (1 + 2 * u))).
  { apply Rmult_le_compat_l; [lra |]. apply Rmult_le_compat_r; [unfold u; lra | assumption]. }
  assert (Rabs (c * w_high - s) <= 26 * (u * (u * M)) + 3 * lost) as c_error.
  { replace (c * w_high - s) with ((c - s * inverse) * w_high + s * i) by (unfold i; ring).
    apply Rle_trans with (1 := Rabs_triang _ _). unfold u in *; lra. }
  assert (Rabs (c * w_high) <= (8 + / 2) * (u * M) + 12 * lost) as c_size.
  { apply within in c_error; apply within in s_bound. apply Rabs_le; lra. }
  assert (Rabs (c * w_low) <= u * ((8 + / 2) * (u * M) + 12 * lost)) as cw.
  { rewrite Rabs_mult. apply Rle_trans with (Rabs c * (u * Rabs w_high)); [apply Rmult_le_compat_l; [apply Rabs_pos | assumption] |].
    replace (Rabs c * (u * Rabs w_high)) with (u * Rabs (c * w_high)) by (rewrite Rabs_mult; ring).
    apply Rmult_le_compat_l; lra. }
  replace ((q + c - lambda) * (w_high + w_low))
    with ((c * w_high - s) + (s - g) + c * w_low + (value + rest - lambda * (w_high + w_low))) by (unfold g, rho; ring).
  assert (Rabs ((c * w_high - s) + (s - g) + c * w_low) <= 53 * (u * (u * M)) + 10 * lost) as own.
  { apply within in c_error; apply within in cw. apply Rabs_le; lra. }
  apply Rle_trans with (1 := Rabs_triang _ _).
  apply Rle_trans with (53 * (u * (u * M)) + 10 * lost + (1 + 2 * Rabs lambda) * (52 * u * u * M + lost)); [lra |].
  assert (0 <= Rabs lambda * (u * (u * M))) by (apply Rmult_le_pos; [assumption | apply Rmult_le_pos; lra]).
  assert (0 <= Rabs lambda * lost) by (apply Rmult_le_pos; assumption).
  assert (0 <= u * (u * M)) by (apply Rmult_le_pos; lra).
  replace ((1 + 2 * Rabs lambda) * (106 * u * u * M + 12 * lost)) with
    (106 * (u * (u * M)) + 12 * lost + 212 * (Rabs lambda * (u * (u * M))) + 24 * (Rabs lambda * lost)) by ring.
  replace ((1 + 2 * Rabs lambda) * (52 * u * u * M + lost)) with
    (52 * (u * (u * M)) + lost + 104 * (Rabs lambda * (u * (u * M))) + 2 * (Rabs lambda * lost)) by ring.
  lra.
Qed.
End Quotient.

(* The same in terms of the lambda that was computed: 128 u^2 size / |w| (1 + 2 |lambda|) leaves an eighth for the
   rounding of the bound itself. `part` is (106 u^2 size + 12 lost) / |w|. *)
Theorem error_by_computed : forall computed lambda part, 0 <= part -> 128 * part <= 1 ->
  Rabs (computed - lambda) <= (1 + 2 * Rabs lambda) * part ->
  Rabs (computed - lambda) <= (1 + 2 * Rabs computed) * (64 / 63 * part).
Proof.
  intros computed lambda part positive small near.
  assert (Rabs lambda <= Rabs computed + Rabs (computed - lambda)).
  { replace lambda with (computed + - (computed - lambda)) at 1 by ring; rewrite <- (Rabs_Ropp (computed - lambda)); apply Rabs_triang. }
  pose proof (Rabs_pos lambda); pose proof (Rabs_pos computed).
  assert (1 + 2 * Rabs lambda <= 64 / 63 * (1 + 2 * Rabs computed)) as sizes.
  { assert (Rabs lambda * (128 * part) <= Rabs lambda * 1) by (apply Rmult_le_compat_l; lra). lra. }
  apply Rle_trans with (1 := near).
  replace ((1 + 2 * Rabs computed) * (64 / 63 * part)) with (64 / 63 * (1 + 2 * Rabs computed) * part) by ring.
  now apply Rmult_le_compat_r.
Qed.

Print Assumptions rounding_is_certain.
Print Assumptions w_error.
Print Assumptions lambda_is_near.
Print Assumptions quotient_error.
Print Assumptions error_by_computed.
