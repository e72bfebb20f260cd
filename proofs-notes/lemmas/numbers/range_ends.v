(* Lemmas range-ends and hit-outside-box (proofs-notes/rounding.md): where fast/range_ends.hpp and fast/paint.cpp
   place a point between two others, and the errors that they allow for. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles.
Open Scope R_scope.

Definition placed from to lambda := fl (from + fl (lambda * fl (to - from))).

Lemma placing_error : forall from to lambda, is_double from -> is_double to ->
  Rabs (placed from to lambda - (from + lambda * (to - from)))
    <= (3 * u + 4 * u * u) * (Rabs lambda * (Rabs from + Rabs to)) + (u + 4 * u * u) * Rabs from + 2 * tiny.
Proof.
  intros from to lambda Dfrom Dto; pose proof tiny_positive.
  assert (is_double (- from)) as Dminus by now apply generic_format_opp.
  pose proof (sum_error to (- from) Dto Dminus) as step1; change (to + - from) with (to - from) in step1.
  set (s := fl (to - from)) in *.
  pose proof (fl_error (lambda * s)) as step2; set (p := fl (lambda * s)) in *.
  pose proof (sum_error from p Dfrom (fl_is_double _)) as step3.
  unfold placed; fold s; fold p.
  set (k := Rabs lambda); set (r := Rabs from + Rabs to).
  assert (0 <= k) by apply Rabs_pos.
  assert (Rabs (to - from) <= r) as reach
    by (unfold r; pose proof (magnitude to); pose proof (magnitude from); apply Rabs_le; lra).
  assert (Rabs (s - (to - from)) <= u * r) as off_s
    by (apply Rle_trans with (1 := step1); apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (Rabs s <= (1 + u) * r) as size_s
    by (apply within in off_s; apply within in reach; apply Rabs_le; unfold u in *; lra).
  assert (Rabs (lambda * s) <= (1 + u) * (k * r)) as size_ls.
  { rewrite Rabs_mult; fold k; replace ((1 + u) * (k * r)) with (k * ((1 + u) * r)) by ring.
    now apply Rmult_le_compat_l. }
  assert (Rabs (lambda * s - lambda * (to - from)) <= u * (k * r)) as off_ls.
  { replace (lambda * s - lambda * (to - from)) with (lambda * (s - (to - from))) by ring.
    rewrite Rabs_mult; fold k; replace (u * (k * r)) with (k * (u * r)) by ring; now apply Rmult_le_compat_l. }
  assert (0 <= k * r) by (apply Rmult_le_pos; [assumption | unfold r; pose proof (Rabs_pos from); pose proof (Rabs_pos to); lra]).
  set (z := k * r) in *.
  assert (Rabs (p - lambda * s) <= u * ((1 + u) * z) + tiny) as off_p
    by (apply Rle_trans with (1 := step2); apply Rplus_le_compat_r, Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (Rabs (from + p) <= Rabs from + (1 + u) * (1 + u) * z + tiny) as size_sum.
  { pose proof (magnitude from); apply within in off_p; apply within in size_ls; apply Rabs_le; unfold u in *; lra. }
  assert (Rabs (fl (from + p) - (from + p)) <= u * (Rabs from + (1 + u) * (1 + u) * z + tiny)) as off_sum
    by (apply Rle_trans with (1 := step3); apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  pose proof (Rabs_pos from).
  apply within in off_sum; apply within in off_p; apply within in off_ls; apply Rabs_le; unfold u in *; lra.
Qed.

Definition floor := bpow radix2 (-1000). (* 0x1p-1000 *)
Lemma floor_and_tiny : floor = 37778931862957161709568 * tiny.
Proof. change 37778931862957161709568 with (bpow radix2 75); unfold floor, tiny; now rewrite <- bpow_plus. Qed.

(* range-ends *)
Definition per_end := 4 * u. (* 0x4p-53 *)
Definition coordinate_error from to lambda :=
  fl (fl (per_end * fl (fl (Rabs lambda * fl (Rabs from + Rabs to)) + Rabs from)) + floor).

Lemma coordinate_error_at_least : forall from to lambda, is_double from -> is_double to ->
  (4 * u - 30 * u * u) * (Rabs lambda * (Rabs from + Rabs to) + Rabs from) + floor / 2 <= coordinate_error from to lambda.
Proof.
  intros from to lambda Dfrom Dto.
  pose proof tiny_positive; pose proof floor_and_tiny as hfloor.
  assert (is_double (Rabs from)) as Df by now apply generic_format_abs.
  assert (is_double (Rabs to)) as Dt by now apply generic_format_abs.
  pose proof (Rabs_pos from) as pf; pose proof (Rabs_pos to) as pt; pose proof (Rabs_pos lambda) as pk.
  unfold coordinate_error; set (f := Rabs from) in *; set (t := Rabs to) in *; set (k := Rabs lambda) in *.
  pose proof (sum_at_least f t (f + t) Df Dt ltac:(lra)) as reach; set (r := fl (f + t)) in *.
  assert (0 <= r) by (unfold u in *; lra).
  pose proof (product_at_least k r pk ltac:(assumption)) as product.
  assert (k * ((f + t) * (1 - u)) <= k * r) by now apply Rmult_le_compat_l.
  assert (0 <= k * (f + t)) by (apply Rmult_le_pos; lra).
  replace (k * ((f + t) * (1 - u))) with (k * (f + t) * (1 - u)) in * by ring; set (z := k * (f + t)) in *.
  assert (0 <= fl (k * r))
    by (replace 0 with (fl 0) by (apply fl_of_double, generic_format_0); apply fl_monotone, Rmult_le_pos; assumption).
  pose proof (sum_at_least (fl (k * r)) f (fl (k * r) + f) (fl_is_double _) Df ltac:(lra)) as both.
  set (q := fl (fl (k * r) + f)) in *.
  assert (0 <= q) by (unfold u in *; lra).
  pose proof (product_at_least per_end q ltac:(unfold per_end, u; lra) ltac:(assumption)) as times_4.
  assert (0 <= fl (per_end * q))
    by (replace 0 with (fl 0) by (apply fl_of_double, generic_format_0); apply fl_monotone, Rmult_le_pos;
        [unfold per_end, u; lra | assumption]).
  pose proof (sum_at_least _ floor (fl (per_end * q) + floor) (fl_is_double (per_end * q)) (power_is_double (-1000) ltac:(easy))
    ltac:(lra)) as total.
  unfold per_end, u in *; lra.
Qed.

Theorem ends_are_near : forall from to lambda, is_double from -> is_double to ->
  Rabs (placed from to lambda - (from + lambda * (to - from))) <= coordinate_error from to lambda.
Proof.
  intros from to lambda Dfrom Dto; apply Rle_trans with (1 := placing_error from to lambda Dfrom Dto).
  apply Rle_trans with (2 := coordinate_error_at_least from to lambda Dfrom Dto).
  assert (0 <= Rabs lambda * (Rabs from + Rabs to))
    by (apply Rmult_le_pos; [| pose proof (Rabs_pos from); pose proof (Rabs_pos to)]; try apply Rabs_pos; lra).
  pose proof (Rabs_pos from); pose proof tiny_positive; pose proof floor_and_tiny; unfold u in *; lra.
Qed.

(* So the error is also twice what a rounding of the end costs. *)
Lemma error_exceeds_roundings : forall from to lambda, is_double from -> is_double to ->
  2 * u * Rabs (placed from to lambda) <= coordinate_error from to lambda.
Proof.
  intros from to lambda Dfrom Dto; pose proof (placing_error from to lambda Dfrom Dto) as near.
  apply Rle_trans with (2 := coordinate_error_at_least from to lambda Dfrom Dto).
  assert (0 <= Rabs lambda * (Rabs from + Rabs to))
    by (apply Rmult_le_pos; [| pose proof (Rabs_pos from); pose proof (Rabs_pos to)]; try apply Rabs_pos; lra).
  pose proof (Rabs_pos from); pose proof tiny_positive; pose proof floor_and_tiny.
  assert (Rabs (from + lambda * (to - from)) <= Rabs from + Rabs lambda * (Rabs from + Rabs to)) as exact.
  { apply Rle_trans with (1 := Rabs_triang _ _); rewrite Rabs_mult; apply Rplus_le_compat_l, Rmult_le_compat_l; [apply Rabs_pos |].
    pose proof (magnitude from); pose proof (magnitude to); apply Rabs_le; lra. }
  set (P := placed from to lambda) in *; set (X := from + lambda * (to - from)) in *.
  assert (Rabs P <= Rabs X + Rabs (P - X)) by (replace P with (X + (P - X)) at 1 by ring; apply Rabs_triang).
  unfold u in *; lra.
Qed.

(* hit-outside-box: the place of a hit at s in [lower, upper], by axis; ends x, y with their own error e. *)
Definition per_hit := 8 * u. (* 0x8p-53 *)
Definition per_coordinate_error := 257 / 256. (* 0x1.01p0 *)
Definition hit_error x y e := fl (fl (fl (per_hit * fl (Rabs x + Rabs y)) + fl (per_coordinate_error * e)) + floor).

Section Hit.

Variables x y X Y e s : R.
Hypotheses (x_is_double : is_double x) (y_is_double : is_double y).
Hypotheses (near_x : Rabs (x - X) <= e) (near_y : Rabs (y - Y) <= e) (s_in_range : 0 <= s <= 1).

(* What the limits are wide of the exact place, with the rounding of their own sum with the error. *)
Lemma hit_is_near : forall t, 0 <= t <= 1 ->
  Rabs (placed x y t - (X + t * (Y - X))) + 2 * u * (Rabs x + Rabs y) + u * e <= hit_error x y e * (1 - 2 * u).
Proof.
  intros t Ht; pose proof tiny_positive; pose proof floor_and_tiny as hfloor.
  pose proof (placing_error x y t x_is_double y_is_double) as placing.
  assert (is_double (Rabs x)) as Dx by now apply generic_format_abs.
  assert (is_double (Rabs y)) as Dy by now apply generic_format_abs.
  pose proof (Rabs_pos x) as px; pose proof (Rabs_pos y) as py; pose proof (Rabs_pos (x - X)).
  rewrite (Rabs_pos_eq t) in placing by lra.
  assert (t * (Rabs x + Rabs y) <= Rabs x + Rabs y) by nra.
  assert (Rabs (placed x y t - (X + t * (Y - X))) <= (4 * u + 8 * u * u) * (Rabs x + Rabs y) + 2 * tiny + e).
  { apply within in placing; apply within in near_x; apply within in near_y.
    assert (- e <= x + t * (y - x) - (X + t * (Y - X)) <= e)
      by (replace (x + t * (y - x) - (X + t * (Y - X))) with ((x - X) * (1 - t) + (y - Y) * t) by ring; nra).
    apply Rabs_le; unfold u in *; lra. }
  unfold hit_error; set (f := Rabs x) in *; set (g := Rabs y) in *.
  pose proof (sum_at_least f g (f + g) Dx Dy ltac:(lra)) as reach; set (r := fl (f + g)) in *.
  assert (0 <= r) by (unfold u in *; lra).
  pose proof (product_at_least per_hit r ltac:(unfold per_hit, u; lra) ltac:(assumption)) as times_8.
  pose proof (product_at_least per_coordinate_error e ltac:(unfold per_coordinate_error; lra) ltac:(lra)) as times_e.
  assert (0 <= fl (per_hit * r))
    by (replace 0 with (fl 0) by (apply fl_of_double, generic_format_0); apply fl_monotone, Rmult_le_pos;
        [unfold per_hit, u; lra | assumption]).
  assert (0 <= fl (per_coordinate_error * e))
    by (replace 0 with (fl 0) by (apply fl_of_double, generic_format_0); apply fl_monotone, Rmult_le_pos;
        [unfold per_coordinate_error; lra | lra]).
  pose proof (sum_at_least (fl (per_hit * r)) _ (fl (per_hit * r) + fl (per_coordinate_error * e)) (fl_is_double _)
    (fl_is_double (per_coordinate_error * e)) ltac:(lra)) as both.
  set (q := fl (fl (per_hit * r) + fl (per_coordinate_error * e))) in *.
  assert (0 <= q) by (unfold u in *; lra).
  pose proof (sum_at_least q floor (q + floor) (fl_is_double _) (power_is_double (-1000) ltac:(easy))
    ltac:(pose proof (bpow_gt_0 radix2 (-1000)); fold floor in *; lra)) as total.
  unfold per_hit, per_coordinate_error, u in *; lra.
Qed.

Lemma hit_limits : forall t, 0 <= t <= 1 ->
  fl (placed x y t - hit_error x y e) <= X + t * (Y - X) <= fl (placed x y t + hit_error x y e).
Proof.
  intros t Ht; pose proof (hit_is_near t Ht) as near.
  set (q := placed x y t) in *; set (h := hit_error x y e) in *; set (P := X + t * (Y - X)) in *.
  assert (is_double q) as Dq by apply fl_is_double; assert (is_double h) as Dh by apply fl_is_double.
  assert (is_double (- h)) as Dh' by now apply generic_format_opp.
  pose proof (Rabs_pos x); pose proof (Rabs_pos y); pose proof (Rabs_pos (x - X)); pose proof (Rabs_pos (q - P)).
  assert (0 <= h) by (unfold u in *; lra).
  assert (Rabs P <= Rabs x + Rabs y + e) as size_P.
  { pose proof (magnitude x); pose proof (magnitude y); apply within in near_x; apply within in near_y.
    apply Rabs_le; unfold P; split; nra. }
  assert (Rabs (q - P) <= h) as near_q by (unfold u in *; lra).
  assert (Rabs q <= Rabs x + Rabs y + e + h) as size_q
    by (apply within in size_P; apply within in near_q; apply Rabs_le; lra).
  pose proof (magnitude (q - P)); apply within in size_q.
  split.
  - pose proof (sum_error q (- h) Dq Dh') as rounded; change (q + - h) with (q - h) in rounded.
    assert (u * Rabs (q - h) <= u * (Rabs x + Rabs y + e + 2 * h))
      by (apply Rmult_le_compat_l; [unfold u; lra | apply Rabs_le; lra]).
    apply within in rounded; unfold u in *; lra.
  - pose proof (sum_error q h Dq Dh) as rounded.
    assert (u * Rabs (q + h) <= u * (Rabs x + Rabs y + e + 2 * h))
      by (apply Rmult_le_compat_l; [unfold u; lra | apply Rabs_le; lra]).
    apply within in rounded; unfold u in *; lra.
Qed.

(* Both limits beyond a side: so is the hit. *)
Theorem hit_is_below : forall lower upper low, 0 <= lower -> lower <= s <= upper -> upper <= 1 ->
  fl (placed x y lower + hit_error x y e) < low -> fl (placed x y upper + hit_error x y e) < low -> X + s * (Y - X) < low.
Proof.
  intros lower upper low Hl Hs Hu below below'.
  pose proof (hit_limits lower ltac:(lra)); pose proof (hit_limits upper ltac:(lra)).
  destruct (Rle_or_lt 0 (Y - X)); nra.
Qed.

Theorem hit_is_above : forall lower upper high, 0 <= lower -> lower <= s <= upper -> upper <= 1 ->
  high < fl (placed x y lower - hit_error x y e) -> high < fl (placed x y upper - hit_error x y e) -> high < X + s * (Y - X).
Proof.
  intros lower upper high Hl Hs Hu above above'.
  pose proof (hit_limits lower ltac:(lra)); pose proof (hit_limits upper ltac:(lra)).
  destruct (Rle_or_lt 0 (Y - X)); nra.
Qed.

End Hit.

Print Assumptions ends_are_near.
Print Assumptions hit_is_below.
Print Assumptions hit_is_above.
