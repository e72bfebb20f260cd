(* Lemma clip-interval (proofs-notes/rounding.md), its first part: what the kernels compute of Delta at an end is off by at
   most least_error, and Probe::error_bound (fast/cell.hpp) is more than that. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles.
Open Scope R_scope.

Section HalfSpace.

(* The half-space as written, an end as computed and its exact place, and what is known of them. *)
Variables n1 n2 n3 d x1 x2 x3 y1 y2 y3 N D X e : R.
Hypotheses (d_is_double : is_double d) (N_is : Rabs n1 + Rabs n2 + Rabs n3 <= N) (D_is : Rabs d <= D).
Hypotheses (X_1 : Rabs x1 <= X) (X_2 : Rabs x2 <= X) (X_3 : Rabs x3 <= X).
Hypotheses (near_1 : Rabs (x1 - y1) <= e) (near_2 : Rabs (x2 - y2) <= e) (near_3 : Rabs (x3 - y3) <= e).

Definition computed_delta := fl (fl (fl (fl (n1 * x1) + fl (n2 * x2)) + fl (n3 * x3)) - d).
Definition exact_delta := n1 * y1 + n2 * y2 + n3 * y3 - d.

Lemma delta_at_computed_end :
  Rabs (computed_delta - (n1 * x1 + n2 * x2 + n3 * x3 - d)) <= (4 * u + 7 * u * u) * (N * X + D) + 4 * tiny.
Proof.
  pose proof tiny_positive; pose proof (product_near n1 x1) as p1; pose proof (product_near n2 x2) as p2;
    pose proof (product_near n3 x3) as p3.
  set (t1 := Rabs n1 * Rabs x1) in *; set (t2 := Rabs n2 * Rabs x2) in *; set (t3 := Rabs n3 * Rabs x3) in *.
  assert (t1 + t2 + t3 <= N * X).
  { pose proof (Rabs_pos n1); pose proof (Rabs_pos n2); pose proof (Rabs_pos n3); pose proof (Rabs_pos x1).
    apply Rle_trans with ((Rabs n1 + Rabs n2 + Rabs n3) * X); [unfold t1, t2, t3; nra | apply Rmult_le_compat_r; lra]. }
  assert (0 <= t1 /\ 0 <= t2 /\ 0 <= t3) by (repeat split; apply Rmult_le_pos; apply Rabs_pos).
  assert (Rabs (n1 * x1) = t1) as m1 by apply Rabs_mult.
  assert (Rabs (n2 * x2) = t2) as m2 by apply Rabs_mult.
  assert (Rabs (n3 * x3) = t3) as m3 by apply Rabs_mult.
  pose proof (magnitude (n1 * x1)); pose proof (magnitude (n2 * x2)); pose proof (magnitude (n3 * x3)).
  pose proof (magnitude d).
  pose proof (sum_near _ _ _ _ _ _ (t1 + t2) (fl_is_double (n1 * x1)) (fl_is_double (n2 * x2)) p1 p2
    ltac:(apply Rabs_le; lra)) as s1.
  pose proof (sum_near _ _ _ _ _ _ (t1 + t2 + t3) (fl_is_double (fl (n1 * x1) + fl (n2 * x2))) (fl_is_double (n3 * x3)) s1 p3
    ltac:(apply Rabs_le; lra)) as s2.
  pose proof (sum_near _ (- d) _ (- d) _ 0 (t1 + t2 + t3 + Rabs d)
    (fl_is_double (fl (fl (n1 * x1) + fl (n2 * x2)) + fl (n3 * x3)))
    ltac:(apply generic_format_opp; exact d_is_double) s2
    ltac:(rewrite Rminus_diag_eq, Rabs_R0; [lra | reflexivity]) ltac:(apply Rabs_le; lra)) as s3.
  unfold computed_delta; apply Rle_trans with (1 := s3); unfold u; lra.
Qed.

Lemma end_itself : Rabs (n1 * x1 + n2 * x2 + n3 * x3 - d - exact_delta) <= N * e.
Proof.
  unfold exact_delta.
  replace (n1 * x1 + n2 * x2 + n3 * x3 - d - (n1 * y1 + n2 * y2 + n3 * y3 - d))
    with (n1 * (x1 - y1) + n2 * (x2 - y2) + n3 * (x3 - y3)) by ring.
  pose proof (Rabs_pos n1); pose proof (Rabs_pos n2); pose proof (Rabs_pos n3); pose proof (Rabs_pos (x1 - y1)).
  apply Rle_trans with (Rabs (n1 * (x1 - y1)) + Rabs (n2 * (x2 - y2)) + Rabs (n3 * (x3 - y3))).
  - apply Rle_trans with (1 := Rabs_triang _ _); apply Rplus_le_compat_r, Rabs_triang.
  - rewrite !Rabs_mult; apply Rle_trans with ((Rabs n1 + Rabs n2 + Rabs n3) * e); [nra | apply Rmult_le_compat_r; lra].
Qed.

Definition least_error := (4 * u + 7 * u * u) * (N * X + D) + N * e + 4 * tiny.

Lemma delta_error : Rabs (computed_delta - exact_delta) <= least_error.
Proof.
  pose proof delta_at_computed_end as rounding; pose proof end_itself as placing.
  apply within in rounding; apply within in placing; apply Rabs_le; unfold least_error; lra.
Qed.

(* Of use for the size of w. *)
Lemma delta_size : Rabs computed_delta <= (1 + 5 * u) * (N * X + D) + 4 * tiny.
Proof.
  pose proof delta_at_computed_end as rounding; apply within in rounding.
  assert (Rabs (n1 * x1 + n2 * x2 + n3 * x3 - d) <= N * X + D) as exact.
  { apply Rle_trans with (Rabs n1 * Rabs x1 + Rabs n2 * Rabs x2 + Rabs n3 * Rabs x3 + Rabs d).
    - rewrite <- !Rabs_mult; pose proof (magnitude (n1 * x1)); pose proof (magnitude (n2 * x2));
        pose proof (magnitude (n3 * x3)); pose proof (magnitude d); apply Rabs_le; lra.
    - pose proof (Rabs_pos n1); pose proof (Rabs_pos n2); pose proof (Rabs_pos n3); pose proof (Rabs_pos x1).
      apply Rplus_le_compat; [| assumption].
      apply Rle_trans with ((Rabs n1 + Rabs n2 + Rabs n3) * X); [nra | apply Rmult_le_compat_r; lra]. }
  assert (0 <= N * X + D) by (apply Rle_trans with (2 := exact); apply Rabs_pos).
  apply within in exact; apply Rabs_le; unfold u in *; lra.
Qed.

End HalfSpace.

(* Probe::error_bound (fast/cell.hpp), as computed. *)
Definition per_size := 17 * u. (* 0x11p-53 *)
Definition per_coordinate_error := 257 / 256. (* 0x1.01p0 *)
Definition error_floor := bpow radix2 (-960).
Definition error_per_normal_floor := bpow radix2 (-1000).
Definition greatest_usable_error := bpow radix2 900.
Definition error_per_normal X e := fl (fl (per_size * X) + fl (fl (per_coordinate_error * e) + error_per_normal_floor)).
Definition error_bound N D X e := fl (fl (N * error_per_normal X e) + fl (fl (per_size * D) + error_floor)).

Lemma floors_and_tiny : error_floor = bpow radix2 115 * tiny /\ error_per_normal_floor = bpow radix2 75 * tiny.
Proof. unfold error_floor, error_per_normal_floor, tiny; rewrite <- !bpow_plus; easy. Qed.

Lemma error_bound_at_least : forall N D X e, 0 <= N -> 0 <= D -> 0 <= X -> 0 <= e ->
  (17 * u - 100 * u * u) * (N * X + D) + 256.5 / 256 * (N * e) + error_floor / 2 <= error_bound N D X e.
Proof.
  intros N D X e HN HD HX He; pose proof tiny_positive as t.
  destruct floors_and_tiny as [floor floor'].
  assert (bpow radix2 115 = 41538374868278621028243970633760768) as p115 by (simpl; reflexivity).
  assert (bpow radix2 75 = 37778931862957161709568) as p75 by (simpl; reflexivity).
  rewrite p115 in floor; rewrite p75 in floor'.
  assert (0 <= per_size) by (unfold per_size, u; lra).
  assert (0 <= per_coordinate_error) by (unfold per_coordinate_error; lra).
  pose proof (product_at_least per_size X ltac:(assumption) HX) as ofX.
  pose proof (product_at_least per_coordinate_error e ltac:(assumption) He) as ofe.
  pose proof (product_at_least per_size D ltac:(assumption) HD) as ofD.
  pose proof (sum_at_least _ _ ((per_coordinate_error * e) * (1 - u) + error_per_normal_floor - tiny)
    (fl_is_double (per_coordinate_error * e)) (power_is_double (-1000) ltac:(easy))
    ltac:(fold error_per_normal_floor; unfold per_coordinate_error, u in *; lra)) as ofe'.
  fold error_per_normal_floor in ofe'.
  pose proof (sum_at_least _ _ ((per_size * X + per_coordinate_error * e) * (1 - 2 * u) + error_per_normal_floor / 2)
    (fl_is_double (per_size * X)) (fl_is_double (fl (per_coordinate_error * e) + error_per_normal_floor))
    ltac:(unfold per_size, per_coordinate_error, u in *; lra)) as per_normal.
  fold (error_per_normal X e) in per_normal.
  set (a := error_per_normal X e) in *.
  assert (0 <= a) by (unfold per_size, per_coordinate_error, u in *; lra).
  assert (N * ((per_size * X + per_coordinate_error * e) * (1 - 3 * u)) <= N * a)
    by (apply Rmult_le_compat_l; [assumption | unfold per_size, per_coordinate_error, u in *; lra]).
  pose proof (product_at_least N a HN ltac:(assumption)) as ofN.
  assert (0 <= N * X) by (apply Rmult_le_pos; assumption).
  assert (0 <= N * e) by (apply Rmult_le_pos; assumption).
  set (NX := N * X) in *; set (Ne := N * e) in *.
  assert (N * ((per_size * X + per_coordinate_error * e) * (1 - 3 * u)) = (per_size * NX + per_coordinate_error * Ne) * (1 - 3 * u))
    as expand by (unfold NX, Ne; ring).
  rewrite expand in *.
  pose proof (sum_at_least _ _ (per_size * D * (1 - u) - tiny + error_floor) (fl_is_double (per_size * D))
    (power_is_double (-960) ltac:(easy)) ltac:(fold error_floor; unfold per_size, u in *; lra)) as ofD'.
  fold error_floor in ofD'.
  pose proof (sum_at_least _ _ ((per_size * NX + per_coordinate_error * Ne) * (1 - 4 * u) + per_size * D * (1 - 2 * u) + 3 / 4 * error_floor)
    (fl_is_double (N * a)) (fl_is_double (fl (per_size * D) + error_floor))
    ltac:(unfold per_size, per_coordinate_error, u in *; lra)) as total.
  change (error_bound N D X e) with (fl (fl (N * a) + fl (fl (per_size * D) + error_floor))).
  unfold per_size, per_coordinate_error, u in *; lra.
Qed.

Print Assumptions delta_error.
Print Assumptions error_bound_at_least.
