(* Lemma box-by-duality (proofs-notes/rounding.md) with its roundings: fast/box.cpp, ThreeNormals::lower, reach_of and
   box_around; and greatest_delta, by which parts are found buried and half-spaces redundant. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles.
Open Scope R_scope.

Definition per_term := 8 * u. (* 8 * unit *)
Definition floor := bpow radix2 (-1000). (* tiny *)
Definition greatest_slack := / 1073741824. (* 0x1p-30 *)

Section Sum.

(* A number and three products, added up one by one, and their magnitudes beside them. *)
Variables a x1 y1 x2 y2 x3 y3 : R.
Hypothesis Da : is_double a.
Let p1 := fl (x1 * y1).
Let p2 := fl (x2 * y2).
Let p3 := fl (x3 * y3).
Definition sum := fl (fl (fl (a + p1) + p2) + p3).
Definition size := fl (fl (fl (Rabs a + Rabs p1) + Rabs p2) + Rabs p3).
Let exact := a + x1 * y1 + x2 * y2 + x3 * y3.

Lemma sum_is_near : Rabs (sum - exact) <= 5 * u * size + 4 * tiny /\ Rabs sum <= (1 + 8 * u) * size /\ 0 <= size.
Proof.
  pose proof tiny_positive.
  assert (forall x y, Rabs (fl (x * y) - x * y) <= u * (1 + 2 * u) * Rabs (fl (x * y)) + (1 + 2 * u) * tiny) as product.
  { intros x y. pose proof (fl_error (x * y)) as near. set (p := fl (x * y)) in *.
    assert (Rabs (x * y) <= Rabs p + Rabs (p - x * y)).
    { rewrite (Rabs_minus_sym p). replace (x * y) with (p + (x * y - p)) at 1 by ring. apply Rabs_triang. }
    pose proof (Rabs_pos p). unfold u in *; lra. }
  pose proof (product x1 y1) as e1; fold p1 in e1. pose proof (product x2 y2) as e2; fold p2 in e2. pose proof (product x3 y3) as e3; fold p3 in e3.
  assert (is_double p1) as D1 by apply fl_is_double. assert (is_double p2) as D2 by apply fl_is_double. assert (is_double p3) as D3 by apply fl_is_double.
  pose proof (Rabs_pos a); pose proof (Rabs_pos p1); pose proof (Rabs_pos p2); pose proof (Rabs_pos p3).
  pose proof (magnitude a); pose proof (magnitude p1); pose proof (magnitude p2); pose proof (magnitude p3).
  set (A := Rabs a) in *; set (B := Rabs p1) in *; set (C := Rabs p2) in *; set (D := Rabs p3) in *.
  set (M := A + B + C + D). assert (0 <= M) by (unfold M; lra).
  assert (is_double A) by now apply generic_format_abs. assert (is_double B) by now apply generic_format_abs.
  assert (is_double C) by now apply generic_format_abs. assert (is_double D) by now apply generic_format_abs.
  (* the size *)
  pose proof (sum_at_least A B (A + B) ltac:(assumption) ltac:(assumption) ltac:(lra)) as z1.
  pose proof (sum_at_least (fl (A + B)) C ((A + B) * (1 - u) + C) (fl_is_double _) ltac:(assumption) ltac:(unfold u in *; lra)) as z2.
  pose proof (sum_at_least (fl (fl (A + B) + C)) D (((A + B) * (1 - u) + C) * (1 - u) + D) (fl_is_double _) ltac:(assumption)
    ltac:(unfold u in *; lra)) as z3.
  change (fl (fl (fl (A + B) + C) + D)) with size in z3. assert (M * (1 - 3 * u) <= size) as size_least by (unfold M, u in *; lra).
  (* the sum *)
  assert (Rabs (a + p1) <= A + B) as r1 by (apply Rabs_le; lra).
  pose proof (sum_error a p1 Da D1) as s1. set (q1 := fl (a + p1)) in *.
  assert (u * Rabs (a + p1) <= u * (A + B)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in s1; apply within in r1.
  assert (Rabs (q1 + p2) <= (1 + u) * (A + B) + C) as r2 by (apply Rabs_le; unfold u in *; lra).
  pose proof (sum_error q1 p2 (fl_is_double _) D2) as s2. set (q2 := fl (q1 + p2)) in *.
  assert (u * Rabs (q1 + p2) <= u * ((1 + u) * (A + B) + C)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in s2; apply within in r2.
  assert (Rabs (q2 + p3) <= (1 + 3 * u) * M) as r3 by (apply Rabs_le; unfold M, u in *; lra).
  pose proof (sum_error q2 p3 (fl_is_double _) D3) as s3. change (fl (q2 + p3)) with sum in s3.
  assert (u * Rabs (q2 + p3) <= u * ((1 + 3 * u) * M)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in s3; apply within in r3; apply within in e1; apply within in e2; apply within in e3.
  split; [| split].
  - apply Rabs_le. unfold exact, M, u in *; lra.
  - apply Rabs_le. unfold M, u in *; lra.
  - unfold u in *; lra.
Qed.

Lemma floor_covers : 1000000 * tiny <= floor.
Proof.
  unfold floor, tiny. change (-1000)%Z with (75 + -1075)%Z. rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0 | simpl; lra].
Qed.

Lemma per_term_times : per_term * size * (1 - u) - tiny <= fl (per_term * size) <= per_term * size * (1 + u) + tiny.
Proof.
  destruct sum_is_near as (_ & _ & positive). pose proof (fl_error (per_term * size)) as near.
  rewrite (Rabs_pos_eq (per_term * size)) in near by (apply Rmult_le_pos; [unfold per_term, u; lra | assumption]).
  apply within in near. lra.
Qed.

(* bound += 8 unit size + tiny, with twice u |bound| to spare; or sum + 8 unit size + tiny. *)
Definition raised := fl (sum + fl (fl (per_term * size) + floor)).
Definition raised_in_turn := fl (fl (sum + fl (per_term * size)) + floor).

Lemma floor_is_double : is_double floor.
Proof. apply power_is_double. lia. Qed.

Theorem raised_is_above : exact + 3 / 2 * u * Rabs raised + floor / 2 <= raised.
Proof.
  destruct sum_is_near as (near & sum_size & positive). pose proof per_term_times as times. pose proof floor_covers. pose proof tiny_positive.
  set (g := fl (per_term * size)) in *.
  pose proof (sum_error g floor (fl_is_double _) floor_is_double) as one. set (h := fl (g + floor)) in *.
  pose proof (sum_error sum h (fl_is_double _) (fl_is_double _)) as two. change (fl (sum + h)) with raised in two.
  apply within in near. apply within in sum_size.
  assert (Rabs (g + floor) <= per_term * size * (1 + 2 * u) + 2 * floor) as r1 by (apply Rabs_le; unfold per_term, u in *; lra).
  assert (u * Rabs (g + floor) <= u * (per_term * size * (1 + 2 * u) + 2 * floor)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in one.
  assert (Rabs (sum + h) <= (1 + 20 * u) * size + 3 * floor) as r2 by (apply Rabs_le; unfold per_term, u in *; lra).
  assert (u * Rabs (sum + h) <= u * ((1 + 20 * u) * size + 3 * floor)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in two. apply within in r2.
  assert (Rabs raised <= (1 + 22 * u) * size + 4 * floor) by (apply Rabs_le; unfold per_term, u in *; lra).
  assert (u * Rabs raised <= u * ((1 + 22 * u) * size + 4 * floor)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  unfold exact, per_term, u in *; lra.
Qed.

Theorem raised_in_turn_is_above : exact <= raised_in_turn.
Proof.
  destruct sum_is_near as (near & sum_size & positive). pose proof per_term_times as times. pose proof floor_covers. pose proof tiny_positive.
  set (g := fl (per_term * size)) in *.
  pose proof (sum_error sum g (fl_is_double _) (fl_is_double _)) as one. set (h := fl (sum + g)) in *.
  pose proof (sum_error h floor (fl_is_double _) floor_is_double) as two. change (fl (h + floor)) with raised_in_turn in two.
  apply within in near. apply within in sum_size.
  assert (Rabs (sum + g) <= (1 + 18 * u) * size + tiny) as r1 by (apply Rabs_le; unfold per_term, u in *; lra).
  assert (u * Rabs (sum + g) <= u * ((1 + 18 * u) * size + tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in one. apply within in r1.
  assert (Rabs (h + floor) <= (1 + 20 * u) * size + 2 * floor) as r2 by (apply Rabs_le; unfold per_term, u in *; lra).
  assert (u * Rabs (h + floor) <= u * ((1 + 20 * u) * size + 2 * floor)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in two. unfold exact, per_term, u in *; lra.
Qed.
End Sum.

(* |rest| + 8 unit rest_size + tiny. *)
Theorem slack_is_enough : forall a x1 y1 x2 y2 x3 y3, is_double a ->
  Rabs (a + x1 * y1 + x2 * y2 + x3 * y3)
  <= fl (fl (Rabs (sum a x1 y1 x2 y2 x3 y3) + fl (per_term * size a x1 y1 x2 y2 x3 y3)) + floor).
Proof.
  intros a x1 y1 x2 y2 x3 y3 Da.
  destruct (sum_is_near a x1 y1 x2 y2 x3 y3 Da) as (near & sum_size & positive). pose proof (per_term_times a x1 y1 x2 y2 x3 y3 Da) as times.
  pose proof floor_covers. pose proof tiny_positive.
  set (g := fl _) in *. set (z := size a x1 y1 x2 y2 x3 y3) in *.
  assert (is_double (Rabs (sum a x1 y1 x2 y2 x3 y3))) as Ds by apply generic_format_abs, fl_is_double.
  set (s := sum a x1 y1 x2 y2 x3 y3) in *. set (exact := a + x1 * y1 + x2 * y2 + x3 * y3) in *.
  assert (Rabs exact <= Rabs s + Rabs (s - exact)).
  { replace exact with (s + - (s - exact)) at 1 by ring. rewrite <- (Rabs_Ropp (s - exact)). apply Rabs_triang. }
  pose proof (Rabs_pos s).
  assert (0 <= g) by (unfold per_term, u in *; rewrite <- (fl_of_double 0) by apply generic_format_0; apply fl_monotone; lra).
  pose proof (sum_error (Rabs s) g Ds (fl_is_double _)) as one. rewrite (Rabs_pos_eq (Rabs s + g)) in one by lra. apply within in one.
  set (h := fl (Rabs s + g)) in *.
  assert (0 <= h) by (unfold u in *; lra).
  assert (0 < floor) by apply bpow_gt_0.
  pose proof (sum_error h floor (fl_is_double _) floor_is_double) as two. rewrite (Rabs_pos_eq (h + floor)) in two by lra. apply within in two.
  unfold per_term, u in *; lra.
Qed.

(* Weak duality: any weights >= 0 bound a direction in a cell, up to what the normals leave of it. *)
Theorem duality : forall (w1 w2 w3 d1 d2 d3 : R) (n1 n2 n3 : R * R * R) (e1 e2 e3 x y z : R),
  let dot n := fst (fst n) * x + snd (fst n) * y + snd n * z in
  let left e w := e - w n1 - w n2 - w n3 in
  0 <= w1 -> 0 <= w2 -> 0 <= w3 -> dot n1 <= d1 -> dot n2 <= d2 -> dot n3 <= d3 ->
  e1 * x + e2 * y + e3 * z <= w1 * d1 + w2 * d2 + w3 * d3
    + Rabs (e1 - w1 * fst (fst n1) - w2 * fst (fst n2) - w3 * fst (fst n3)) * Rabs x
    + Rabs (e2 - w1 * snd (fst n1) - w2 * snd (fst n2) - w3 * snd (fst n3)) * Rabs y
    + Rabs (e3 - w1 * snd n1 - w2 * snd n2 - w3 * snd n3) * Rabs z.
Proof.
  intros w1 w2 w3 d1 d2 d3 ((a1, b1), c1) ((a2, b2), c2) ((a3, b3), c3) e1 e2 e3 x y z. simpl. intros.
  assert (w1 * (a1 * x + b1 * y + c1 * z) <= w1 * d1) by now apply Rmult_le_compat_l.
  assert (w2 * (a2 * x + b2 * y + c2 * z) <= w2 * d2) by now apply Rmult_le_compat_l.
  assert (w3 * (a3 * x + b3 * y + c3 * z) <= w3 * d3) by now apply Rmult_le_compat_l.
  assert (forall r t, r * t <= Rabs r * Rabs t) as below by (intros; rewrite <- Rabs_mult; apply Rle_abs).
  pose proof (below (e1 - w1 * a1 - w2 * a2 - w3 * a3) x). pose proof (below (e2 - w1 * b1 - w2 * b2 - w3 * b3) y).
  pose proof (below (e3 - w1 * c1 - w2 * c2 - w3 * c3) z). lra.
Qed.

(* With all six directions bounded so, a point of the cell lies within twice the largest bound. *)
Theorem reach_is_enough : forall x y z C, 0 <= C ->
  (forall t, t = x \/ t = y \/ t = z -> Rabs t <= C + greatest_slack * Rabs x + greatest_slack * Rabs y + greatest_slack * Rabs z) ->
  Rabs x <= 2 * C /\ Rabs y <= 2 * C /\ Rabs z <= 2 * C.
Proof.
  intros x y z C positive all. pose proof (all x (or_introl eq_refl)). pose proof (all y (or_intror (or_introl eq_refl))).
  pose proof (all z (or_intror (or_intror eq_refl))). pose proof (Rabs_pos x). pose proof (Rabs_pos y). pose proof (Rabs_pos z).
  unfold greatest_slack in *. lra.
Qed.

Section Limit.

(* limit += slack * reach * (1 + 4 unit), for each axis, then limit += 4 unit |limit|. *)
Variables bound reach s1 s2 s3 exact : R.
Hypotheses (Dbound : is_double bound) (reach_pos : 0 <= reach) (s1_pos : 0 <= s1) (s2_pos : 0 <= s2) (s3_pos : 0 <= s3).
Hypothesis bound_has_room : exact + 3 / 2 * u * Rabs bound + floor / 2 <= bound.
Let added s := fl (fl (s * reach) * (1 + 4 * u)).
Let l1 := fl (bound + added s1).
Let l2 := fl (l1 + added s2).
Let l3 := fl (l2 + added s3).
Definition limit := fl (l3 + fl (4 * u * Rabs l3)).

Lemma added_is_enough : forall s, 0 <= s -> s * reach * (1 + 3 / 2 * u) - 4 * tiny <= added s /\ 0 <= added s.
Proof.
  intros s positive. pose proof tiny_positive. assert (0 <= s * reach) by now apply Rmult_le_pos.
  pose proof (product_at_least s reach positive reach_pos) as one.
  assert (0 <= fl (s * reach)) as two by (rewrite <- (fl_of_double 0) by apply generic_format_0; now apply fl_monotone).
  pose proof (product_at_least (fl (s * reach)) (1 + 4 * u) two ltac:(unfold u; lra)) as three.
  unfold added. split; [unfold u in *; lra |]. rewrite <- (fl_of_double 0) by apply generic_format_0. apply fl_monotone.
  apply Rmult_le_pos; [assumption | unfold u; lra].
Qed.

Theorem limit_is_above : exact + s1 * reach + s2 * reach + s3 * reach <= limit.
Proof.
  pose proof tiny_positive. pose proof floor_covers.
  destruct (added_is_enough s1 s1_pos) as (a1 & a1_pos). destruct (added_is_enough s2 s2_pos) as (a2 & a2_pos).
  destruct (added_is_enough s3 s3_pos) as (a3 & a3_pos).
  assert (0 <= s1 * reach) by now apply Rmult_le_pos. assert (0 <= s2 * reach) by now apply Rmult_le_pos.
  assert (0 <= s3 * reach) by now apply Rmult_le_pos.
  pose proof (sum_error_of_rounded bound (added s1) Dbound (fl_is_double _)) as e1. fold l1 in e1.
  pose proof (sum_error_of_rounded l1 (added s2) (fl_is_double _) (fl_is_double _)) as e2. fold l2 in e2.
  pose proof (sum_error_of_rounded l2 (added s3) (fl_is_double _) (fl_is_double _)) as e3. fold l3 in e3.
  pose proof (fl_error (4 * u * Rabs l3)) as k_near. pose proof (Rabs_pos l3).
  rewrite (Rabs_pos_eq (4 * u * Rabs l3)) in k_near by (apply Rmult_le_pos; [unfold u |]; lra). apply within in k_near.
  set (k := fl (4 * u * Rabs l3)) in *.
  pose proof (sum_error l3 k (fl_is_double _) (fl_is_double _)) as e4. change (fl (l3 + k)) with limit in e4.
  assert (0 <= k) by (unfold k; rewrite <- (fl_of_double 0) by apply generic_format_0; apply fl_monotone; apply Rmult_le_pos; [unfold u |]; lra).
  assert (Rabs (l3 + k) <= Rabs l3 + k) by (apply Rle_trans with (1 := Rabs_triang _ _); rewrite (Rabs_pos_eq k) by assumption; lra).
  assert (u * Rabs (l3 + k) <= u * (Rabs l3 + k)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  (* each partial sum from both sides *)
  assert (Rabs l1 <= Rabs bound + added s1 + u * Rabs l1).
  { replace l1 with (bound + added s1 + (l1 - (bound + added s1))) at 1 by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). apply Rplus_le_compat; [| assumption].
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_pos_eq (added s1)) by assumption. lra. }
  assert (Rabs l1 <= Rabs l2 + added s2 + u * Rabs l2).
  { replace l1 with (l2 + - added s2 + - (l2 - (l1 + added s2))) at 1 by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp. apply Rplus_le_compat; [| assumption].
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, (Rabs_pos_eq (added s2)) by assumption. lra. }
  assert (Rabs l2 <= Rabs l1 + added s2 + u * Rabs l2).
  { replace l2 with (l1 + added s2 + (l2 - (l1 + added s2))) at 1 by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). apply Rplus_le_compat; [| assumption].
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_pos_eq (added s2)) by assumption. lra. }
  assert (Rabs l2 <= Rabs l3 + added s3 + u * Rabs l3).
  { replace l2 with (l3 + - added s3 + - (l3 - (l2 + added s3))) at 1 by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp. apply Rplus_le_compat; [| assumption].
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, (Rabs_pos_eq (added s3)) by assumption. lra. }
  pose proof (Rabs_pos l1). pose proof (Rabs_pos l2). pose proof (Rabs_pos bound).
  apply within in e1; apply within in e2; apply within in e3; apply within in e4.
  set (A1 := added s1) in *; set (A2 := added s2) in *; set (A3 := added s3) in *.
  unfold u in *; lra.
Qed.
End Limit.

(* By a half-space that looks in this very direction: bound + 2 unit |bound| + tiny, then limit += 4 unit |limit|. *)
Theorem one_normal_is_enough : forall d along, 0 < along ->
  let q := fl (d / along) in let b := fl (fl (q + fl (2 * u * Rabs q)) + floor) in
  d / along <= fl (b + fl (4 * u * Rabs b)).
Proof.
  intros d along positive q b. set (x := d / along) in *. pose proof tiny_positive. pose proof floor_covers.
  pose proof (fl_error x) as q_near. fold q in q_near.
  assert (forall c y, 0 <= c <= 8 * u -> c * Rabs y * (1 - u) - tiny <= fl (c * Rabs y) /\ fl (c * Rabs y) <= c * Rabs y * (1 + u) + tiny
          /\ 0 <= fl (c * Rabs y)) as part.
  { intros c y few. pose proof (Rabs_pos y). assert (0 <= c * Rabs y) by (apply Rmult_le_pos; lra).
    pose proof (fl_error (c * Rabs y)) as near. rewrite (Rabs_pos_eq (c * Rabs y)) in near by assumption. apply within in near.
    split; [| split]; [unfold u in *; lra | unfold u in *; lra |].
    rewrite <- (fl_of_double 0) by apply generic_format_0. now apply fl_monotone. }
  destruct (part (2 * u) q ltac:(unfold u; lra)) as (g_least & g_most & g_pos). set (g := fl (2 * u * Rabs q)) in *.
  destruct (part (4 * u) b ltac:(unfold u; lra)) as (k_least & k_most & k_pos). set (k := fl (4 * u * Rabs b)) in *.
  pose proof (sum_error q g (fl_is_double _) (fl_is_double _)) as y_near. set (y := fl (q + g)) in *.
  pose proof (sum_error y floor (fl_is_double _) floor_is_double) as b_near. fold b in b_near.
  pose proof (sum_error b k (fl_is_double _) (fl_is_double _)) as l_near.
  assert (0 < floor) by apply bpow_gt_0. pose proof (Rabs_pos q). pose proof (Rabs_pos b).
  assert (forall a c, 0 <= c -> Rabs (a + c) <= Rabs a + c) as more.
  { intros a c some. apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_pos_eq c) by assumption. lra. }
  pose proof (more q g g_pos). pose proof (more y floor ltac:(lra)). pose proof (more b k k_pos).
  assert (Rabs x <= Rabs q + Rabs (q - x)).
  { rewrite (Rabs_minus_sym q). replace x with (q + (x - q)) at 1 by ring. apply Rabs_triang. }
  assert (Rabs y <= Rabs (q + g) + Rabs (y - (q + g))) by (replace y with ((q + g) + (y - (q + g))) at 1 by ring; apply Rabs_triang).
  assert (Rabs q <= Rabs b + Rabs (q - b)) by (replace q with (b + (q - b)) at 1 by ring; apply Rabs_triang).
  assert (Rabs (q - b) <= g + floor + Rabs (y - (q + g)) + Rabs (b - (y + floor))).
  { replace (q - b) with (- (g + floor) + (- (y - (q + g)) + - (b - (y + floor)))) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, (Rabs_pos_eq (g + floor)) by lra.
    apply Rle_trans with (g + floor + (Rabs (- (y - (q + g))) + Rabs (- (b - (y + floor))))); [apply Rplus_le_compat_l, Rabs_triang |].
    rewrite !Rabs_Ropp. lra. }
  pose proof (magnitude (q - x)). pose proof (magnitude (y - (q + g))). pose proof (magnitude (b - (y + floor))).
  pose proof (magnitude (fl (b + k) - (b + k))). unfold u in *; lra.
Qed.

Print Assumptions raised_is_above.
Print Assumptions raised_in_turn_is_above.
Print Assumptions slack_is_enough.
Print Assumptions duality.
Print Assumptions reach_is_enough.
Print Assumptions limit_is_above.
Print Assumptions one_normal_is_enough.
