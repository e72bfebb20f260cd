(* Lemma decisions-in-doubles (proofs-notes/rounding-of-forces.md, section 8), its last part: where a comparison in doubles
   exceeds its margin it is right. fast/surface_in_doubles.hpp: is_at_most, decide, decide_slip, is_pressed, holds. What is
   compared is known as surface_products.v says; rounding is as in sizes.v, without underflow. *)

From Coq Require Import Reals Psatz.
From Groundtruth Require Import surface sizes.
Open Scope R_scope.

Definition margin_part := / 17592186044416. (* 0x1p-44 *)
Definition line_part := / 1237940039285380274899124224. (* 0x1p-90 *)

Lemma rd_positive : forall x, 0 <= x -> (1 - u) * x <= rd x <= (1 + u) * x.
Proof. intros x pos. pose proof (rd_near x x ltac:(rewrite Rabs_pos_eq; lra)) as near. apply within in near. lra. Qed.

(* is_at_most (a', b', sizes): yes, and no. *)
Theorem comparison_is_right : forall a b a' b' sizes ea eb, Rabs (a' - a) <= ea -> Rabs (b' - b) <= eb -> 0 <= sizes ->
  ea + eb <= 511 * u * sizes ->
  (rd (margin_part * sizes) < rd (b' - a') -> a < b) /\ (rd (b' - a') < - rd (margin_part * sizes) -> b < a).
Proof.
  intros a b a' b' sizes ea eb Ha Hb pos enough. apply within in Ha. apply within in Hb.
  pose proof (rd_near (b' - a') _ (Rle_refl _)) as d. apply within in d. pose proof (rd_positive (margin_part * sizes) ltac:(unfold margin_part; lra)) as m.
  pose proof (within _ _ (Rle_refl (Rabs (b' - a')))).
  split; intros certain; unfold Rabs in d; destruct (Rcase_abs (b' - a')); unfold margin_part, u in *; lra.
Qed.

(* A square of what is known within c u W; the error is parted between the square and W^2. *)
Lemma square_near : forall x x' c kappa W, Rabs (x' - x) <= c * u * W -> 1 <= kappa <= 1000 -> 0 <= c <= 100 -> 0 <= W ->
  Rabs (rd (x' * x') - x * x) <= (kappa + 2) * u * rd (x' * x') + (c * c / kappa + / 100) * u * (W * W).
Proof.
  intros x x' c kappa W near Hk Hc HW. assert (0 <= x' * x') as pos by apply Rle_0_sqr. pose proof (rd_positive _ pos) as s.
  set (q := Rabs x'). assert (q * q = x' * x') as qq by (unfold q, Rabs; destruct (Rcase_abs x'); ring). assert (0 <= q) by apply Rabs_pos.
  assert (0 < u) by (unfold u; lra). assert (0 <= W * W) by now apply Rmult_le_pos.
  assert (Rabs (x' * x' - x * x) <= c * u * W * (2 * q + c * u * W)) as square.
  { replace (x' * x' - x * x) with ((x' - x) * (x' + x)) by ring. rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; [assumption |].
    replace (x' + x) with (2 * x' - (x' - x)) by ring. unfold Rminus at 1. apply Rle_trans with (1 := Rabs_triang _ _).
    rewrite Rabs_Ropp, Rabs_mult, (Rabs_pos_eq 2) by lra. fold q. lra. }
  assert (2 * (c * W * q) <= kappa * (q * q) + c * c / kappa * (W * W)) as parted.
  { assert (0 <= (kappa * q - c * W) * (kappa * q - c * W)) by apply Rle_0_sqr. apply Rmult_le_reg_l with kappa; [lra |].
    replace (kappa * (kappa * (q * q) + c * c / kappa * (W * W))) with (kappa * kappa * (q * q) + c * c * (W * W)) by (field; lra). lra. }
  assert (u * (2 * (c * W * q)) <= u * (kappa * (q * q) + c * c / kappa * (W * W))) as parted' by (apply Rmult_le_compat_l; lra).
  assert (c * u * W * (c * u * W) <= / 100 * u * (W * W)).
  { replace (c * u * W * (c * u * W)) with (c * c * u * (u * (W * W))) by ring. replace (/ 100 * u * (W * W)) with (/ 100 * (u * (W * W))) by ring.
    apply Rmult_le_compat_r; [apply Rmult_le_pos; lra |]. assert (c * c <= 10000) by nra. unfold u; lra. }
  rewrite qq in parted'. apply within in square. set (y := x' * x') in *.
  assert (kappa * u * y <= kappa * u * ((1 + 2 * u) * rd y)) as grown.
  { apply Rmult_le_compat_l; [apply Rmult_le_pos; lra |]. unfold u in *; lra. }
  assert (kappa * u * (2 * u) * rd y <= / 100 * u * rd y).
  { apply Rmult_le_compat_r; [unfold u in *; lra |]. unfold u; lra. }
  apply Rabs_le. unfold u in *; lra.
Qed.

(* A product of factors that are not negative, each off by a part of itself. *)
Lemma product_part : forall x x' y y' p q, 0 <= x -> 0 <= y -> 0 <= p <= 200 -> 0 <= q <= 200 ->
  (1 - p * u) * x <= x' <= (1 + p * u) * x -> (1 - q * u) * y <= y' <= (1 + q * u) * y ->
  (1 - (p + q + 2) * u) * (x * y) <= rd (x' * y') <= (1 + (p + q + 2) * u) * (x * y).
Proof.
  intros x x' y y' p q Hx Hy Hp Hq Nx Ny. assert (0 <= x * y) by now apply Rmult_le_pos.
  assert (0 < u <= / 1000000000000) by (unfold u; lra).
  assert (0 <= p * u <= / 1000000000) by (split; [apply Rmult_le_pos; lra | apply Rle_trans with (200 * u); [apply Rmult_le_compat_r |]; lra]).
  assert (0 <= q * u <= / 1000000000) by (split; [apply Rmult_le_pos; lra | apply Rle_trans with (200 * u); [apply Rmult_le_compat_r |]; lra]).
  assert (0 <= x') by (apply Rle_trans with ((1 - p * u) * x); [apply Rmult_le_pos |]; lra).
  assert (0 <= y') by (apply Rle_trans with ((1 - q * u) * y); [apply Rmult_le_pos |]; lra).
  assert ((1 - p * u) * x * ((1 - q * u) * y) <= x' * y') as low by (apply Rmult_le_compat; try (apply Rmult_le_pos; lra); lra).
  assert (x' * y' <= (1 + p * u) * x * ((1 + q * u) * y)) as high by (apply Rmult_le_compat; lra).
  pose proof (rd_positive (x' * y') ltac:(now apply Rmult_le_pos)) as r.
  set (P := p * u) in *. set (Q := q * u) in *. assert (P * Q <= / 100 * u).
  { unfold P. replace (p * u * Q) with (p * Q * u) by ring. apply Rmult_le_compat_r; [lra |].
    apply Rle_trans with (200 * / 1000000000); [apply Rmult_le_compat |]; lra. }
  assert (0 <= P * Q) by (apply Rmult_le_pos; lra).
  replace ((1 - P) * x * ((1 - Q) * y)) with ((1 - P - Q + P * Q) * (x * y)) in low by ring.
  replace ((1 + P) * x * ((1 + Q) * y)) with ((1 + P + Q + P * Q) * (x * y)) in high by ring.
  replace ((p + q + 2) * u) with (P + Q + 2 * u) by (unfold P, Q; ring). set (z := x' * y') in *.
  assert ((1 - u) * ((1 - P - Q + P * Q) * (x * y)) <= (1 - u) * z) by (apply Rmult_le_compat_l; lra).
  assert ((1 + u) * z <= (1 + u) * ((1 + P + Q + P * Q) * (x * y))) by (apply Rmult_le_compat_l; lra).
  assert (u * P <= / 100 * u /\ u * Q <= / 100 * u /\ u * (P * Q) <= / 100 * u) as (uP & uQ & uPQ).
  { repeat split; rewrite (Rmult_comm _ u); apply Rmult_le_compat_l; lra. }
  split.
  - apply Rle_trans with ((1 - u) * ((1 - P - Q + P * Q) * (x * y))); [| lra].
    replace ((1 - u) * ((1 - P - Q + P * Q) * (x * y))) with ((1 - u) * (1 - P - Q + P * Q) * (x * y)) by ring.
    apply Rmult_le_compat_r; [assumption |]. assert (0 <= u * P) by (apply Rmult_le_pos; lra). assert (0 <= u * Q) by (apply Rmult_le_pos; lra). lra.
  - apply Rle_trans with ((1 + u) * ((1 + P + Q + P * Q) * (x * y))); [lra |].
    replace ((1 + u) * ((1 + P + Q + P * Q) * (x * y))) with ((1 + u) * (1 + P + Q + P * Q) * (x * y)) by ring.
    apply Rmult_le_compat_r; [assumption |]. lra.
Qed.

(* As the code has them, of a computed |n|^2, |g|^2 and n.F: mu^2 (n.F)^2, the band, and the floors. *)
Definition limit_of mu D' := rd (rd (mu * mu) * rd (D' * D')).
Definition band_of B nn' := rd (rd (B * B) * nn').
Definition floor_of gg' f := rd (gg' * rd (f * f)).
Definition disc_floor_of mu nn' f := rd (rd (1 + rd (mu * mu)) * rd (nn' * rd (f * f))).

Lemma part_of : forall x' x p, Rabs (x' - x) <= p * u * x -> (1 - p * u) * x <= x' <= (1 + p * u) * x.
Proof. intros x' x p near. apply within in near. lra. Qed.

Lemma limit_near : forall mu D D' W, 0 <= W -> Rabs (D' - D) <= 6 * u * W ->
  0 <= limit_of mu D' /\ Rabs (limit_of mu D' - mu * mu * (D * D)) <= 22 * u * limit_of mu D' + 23 / 10 * u * (mu * mu * (W * W)).
Proof.
  intros mu D D' W W_pos near. pose proof (square_near D D' 6 16 W near ltac:(lra) ltac:(lra) W_pos) as s. pose proof (Rle_0_sqr D') as pos. pose proof (Rle_0_sqr mu) as mu_pos.
  unfold Rsqr in *. pose proof (rd_positive _ pos) as sq. pose proof (rd_positive _ mu_pos) as m. set (q := rd (D' * D')) in *.
  assert (0 <= q) as q_pos by (unfold u in *; lra).
  pose proof (product_part (mu * mu) (rd (mu * mu)) q q 1 0 mu_pos q_pos ltac:(lra) ltac:(lra) ltac:(lra) ltac:(lra)) as p.
  change (rd (rd (mu * mu) * q)) with (limit_of mu D') in p. set (m2 := mu * mu) in *. set (L := limit_of mu D') in *.
  assert (0 <= m2 * q) by now apply Rmult_le_pos. assert (0 <= m2 * (W * W)) by (apply Rmult_le_pos; [assumption | now apply Rmult_le_pos]).
  split; [unfold u in *; lra |]. apply within in s.
  assert (Rabs (m2 * q - m2 * (D * D)) <= m2 * (18 * u * q + 226 / 100 * u * (W * W))) as moved.
  { replace (m2 * q - m2 * (D * D)) with (m2 * (q - D * D)) by ring. rewrite Rabs_mult, (Rabs_pos_eq m2) by assumption.
    apply Rmult_le_compat_l; [assumption |]. apply Rabs_le. assert (0 <= W * W) by now apply Rmult_le_pos. unfold u in *; lra. }
  apply within in moved. apply Rabs_le. unfold u in *; lra.
Qed.

Lemma floors : forall mu gg' nn' k l f, Rabs (gg' - k * k) <= 132 * u * (k * k) -> Rabs (nn' - l * l) <= 4 * u * (l * l) ->
  let G := k * f * (k * f) in let N := l * f * (l * f) in
  0 <= G /\ 0 <= N /\ (1 - 140 * u) * G <= floor_of gg' f <= (1 + 140 * u) * G /\ (1 - 8 * u) * N <= rd (nn' * rd (f * f))
  /\ (1 - 20 * u) * ((1 + mu * mu) * N) <= disc_floor_of mu nn' f.
Proof.
  intros mu gg' nn' k l f gg nn G N. pose proof (Rle_0_sqr k) as Hk. pose proof (Rle_0_sqr l) as Hl. pose proof (Rle_0_sqr f) as Hf. pose proof (Rle_0_sqr mu) as Hm.
  unfold Rsqr in *. pose proof (rd_positive _ Hf) as nf. pose proof (rd_positive _ Hm) as nm.
  pose proof (product_part (k * k) gg' (f * f) (rd (f * f)) 132 1 Hk Hf ltac:(lra) ltac:(lra) (part_of _ _ _ gg) ltac:(lra)) as one.
  pose proof (product_part (l * l) nn' (f * f) (rd (f * f)) 4 1 Hl Hf ltac:(lra) ltac:(lra) (part_of _ _ _ nn) ltac:(lra)) as two.
  pose proof (rd_positive (1 + rd (mu * mu)) ltac:(unfold u in *; lra)) as three.
  pose proof (product_part (1 + mu * mu) (rd (1 + rd (mu * mu))) (l * l * (f * f)) (rd (nn' * rd (f * f))) 3 7 ltac:(lra) ltac:(now apply Rmult_le_pos)
    ltac:(lra) ltac:(lra) ltac:(unfold u in *; lra) ltac:(lra)) as four. fold (disc_floor_of mu nn' f) in four. fold (floor_of gg' f) in one.
  assert (k * k * (f * f) = G) as kf by (unfold G; ring). assert (l * l * (f * f) = N) as lf by (unfold N; ring). rewrite kf in one. rewrite lf in two, four.
  assert (0 <= G) by (rewrite <- kf; now apply Rmult_le_pos). assert (0 <= N) by (rewrite <- lf; now apply Rmult_le_pos).
  assert (0 <= (1 + mu * mu) * N) by (apply Rmult_le_pos; lra). unfold u in *. repeat split; lra.
Qed.

Lemma band_near : forall B nn' l p, 0 <= p <= 140 -> Rabs (nn' - l * l) <= p * u * (l * l) ->
  0 <= band_of B nn' /\ Rabs (band_of B nn' - B * B * (l * l)) <= (p + 4) * u * band_of B nn'.
Proof.
  intros B nn' l p Hp near. pose proof (Rle_0_sqr B) as HB. pose proof (Rle_0_sqr l) as Hl. unfold Rsqr in *. pose proof (rd_positive _ HB) as nB.
  pose proof (product_part (B * B) (rd (B * B)) (l * l) nn' 1 p HB Hl ltac:(lra) ltac:(lra) ltac:(lra) (part_of _ _ _ near)) as b.
  fold (band_of B nn') in b. set (b' := band_of B nn') in *. set (K := B * B * (l * l)) in *. assert (0 <= K) by now apply Rmult_le_pos.
  assert (0 < u <= / 1000000000000) by (unfold u; lra). assert (0 <= p * u <= 140 * u) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_r]; lra).
  replace ((1 + p + 2) * u) with (p * u + 3 * u) in b by ring. replace ((p + 4) * u) with (p * u + 4 * u) by ring.
  set (P := p * u) in *.
  assert (0 <= b') by (apply Rle_trans with ((1 - (P + 3 * u)) * K); [apply Rmult_le_pos; lra | lra]). split; [assumption |].
  assert ((P + 3 * u) * K <= (P + 4 * u) * b').
  { apply Rle_trans with ((P + 4 * u) * ((1 - (P + 3 * u)) * K)); [| apply Rmult_le_compat_l; lra]. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; [assumption |].
    assert ((P + 4 * u) * (P + 3 * u) <= 144 * u * / 100000000) by (apply Rmult_le_compat; lra). lra. }
  apply Rabs_le. lra.
Qed.

Section Surface.

(* Exact, and as computed (') : alpha, D, |T|^2, |g|^2 = k^2, |n|^2 = l^2; f, mu and B are doubles. *)
Variables al al' D D' tt tt' gg' nn' k l f mu B : R.
Hypotheses (k_pos : 0 <= k) (l_pos : 0 <= l) (f_pos : 0 <= f).
Hypotheses (al_near : Rabs (al' - al) <= 70 * u * (k * f)) (D_near : Rabs (D' - D) <= 6 * u * (l * f)).
Hypotheses (tt_near : Rabs (tt' - tt) <= 21 * u * tt' + 3 * u * (l * f * (l * f))) (tt_pos : 0 <= tt').
Hypotheses (gg_near : Rabs (gg' - k * k) <= 132 * u * (k * k)) (nn_near : Rabs (nn' - l * l) <= 4 * u * (l * l)).

Let limit := limit_of mu D'.
Let floor := floor_of gg' f.
Let disc_floor := disc_floor_of mu nn' f.

(* |F'_x| <= B: alpha^2 against B^2 |g|^2. *)
Theorem band_is_decided :
  let a := rd (al' * al') in let b := band_of B gg' in let sizes := rd (rd (a + b) + floor) in
  (rd (margin_part * sizes) < rd (b - a) -> al * al < B * B * (k * k)) /\ (rd (b - a) < - rd (margin_part * sizes) -> B * B * (k * k) < al * al).
Proof.
  intros a b sizes. destruct (floors mu gg' nn' k l f gg_near nn_near) as (HG & _ & nF & _ & _). fold floor in nF.
  pose proof (square_near al al' 70 256 (k * f) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(now apply Rmult_le_pos)) as na. fold a in na.
  destruct (band_near B gg' k 132 ltac:(lra) gg_near) as (b_pos & nb). fold b in b_pos, nb.
  assert (0 <= a) as a_pos by (pose proof (rd_positive _ (Rle_0_sqr al')); pose proof (Rle_0_sqr al'); unfold Rsqr, a, u in *; lra).
  set (G := k * f * (k * f)) in *. assert (0 <= floor) by (unfold u in *; lra).
  pose proof (rd_positive (a + b) ltac:(lra)) as s1. pose proof (rd_positive (rd (a + b) + floor) ltac:(unfold u in *; lra)) as s2. fold sizes in s2.
  apply (comparison_is_right _ _ _ _ sizes _ _ na nb); unfold u in *; lra.
Qed.

(* |F'_xy| <= mu N: |T|^2 against mu^2 D^2. *)
Theorem disc_is_decided :
  let sizes := rd (rd (tt' + limit) + disc_floor) in
  (rd (margin_part * sizes) < rd (limit - tt') -> tt < mu * mu * (D * D)) /\ (rd (limit - tt') < - rd (margin_part * sizes) -> mu * mu * (D * D) < tt).
Proof.
  intros sizes. destruct (floors mu gg' nn' k l f gg_near nn_near) as (_ & HN & _ & _ & nF). fold disc_floor in nF.
  destruct (limit_near mu D D' (l * f) ltac:(now apply Rmult_le_pos) D_near) as (L_pos & nL). fold limit in L_pos, nL.
  set (N := l * f * (l * f)) in *. assert (0 <= mu * mu * N) by (apply Rmult_le_pos; [apply Rle_0_sqr | assumption]).
  pose proof (rd_positive (tt' + limit) ltac:(lra)) as s1. pose proof (rd_positive (rd (tt' + limit) + disc_floor) ltac:(unfold u in *; lra)) as s2. fold sizes in s2.
  apply (comparison_is_right _ _ _ _ sizes _ _ tt_near nL); unfold u in *; lra.
Qed.

(* B < mu N: B^2 |n|^2 against mu^2 D^2. *)
Theorem corner_is_decided :
  let band := band_of B nn' in let sizes := rd (rd (limit + band) + disc_floor) in
  (rd (margin_part * sizes) < rd (band - limit) -> mu * mu * (D * D) < B * B * (l * l)) /\
  (rd (band - limit) < - rd (margin_part * sizes) -> B * B * (l * l) < mu * mu * (D * D)).
Proof.
  intros band sizes. destruct (floors mu gg' nn' k l f gg_near nn_near) as (_ & HN & _ & _ & nF). fold disc_floor in nF.
  destruct (limit_near mu D D' (l * f) ltac:(now apply Rmult_le_pos) D_near) as (L_pos & nL). fold limit in L_pos, nL.
  destruct (band_near B nn' l 4 ltac:(lra) nn_near) as (b_pos & nb). fold band in b_pos, nb.
  set (N := l * f * (l * f)) in *. assert (0 <= mu * mu * N) by (apply Rmult_le_pos; [apply Rle_0_sqr | assumption]).
  pose proof (rd_positive (limit + band) ltac:(lra)) as s1. pose proof (rd_positive (rd (limit + band) + disc_floor) ltac:(unfold u in *; lra)) as s2. fold sizes in s2.
  apply (comparison_is_right _ _ _ _ sizes _ _ nL nb); unfold u in *; lra.
Qed.

(* Whether it is pressed, and the signs of slips: certain where the square exceeds what an error can make of 0. *)
Theorem sign_by_square : forall x x' c W Y, Rabs (x' - x) <= c * u * W -> 0 <= c <= 80 -> 0 <= W -> (1 - 200 * u) * (W * W) <= Y ->
  rd (line_part * Y) < rd (x' * x') -> 0 < x' * x.
Proof.
  intros x x' c W Y near Hc HW least certain. pose proof (Rle_0_sqr x') as pos. unfold Rsqr in pos. pose proof (rd_positive _ pos) as s.
  assert (0 <= W * W) by now apply Rmult_le_pos. pose proof (rd_positive (line_part * Y) ltac:(unfold line_part, u in *; lra)) as m.
  assert (c * u * W * (c * u * W) < x' * x').
  { replace (c * u * W * (c * u * W)) with (c * c * (u * u * (W * W))) by ring.
    assert (c * c * (u * u * (W * W)) <= 6400 * (u * u * (W * W))) by (apply Rmult_le_compat_r; [repeat apply Rmult_le_pos; unfold u; lra | nra]).
    unfold line_part, u in *. lra. }
  apply within in near. assert (0 <= c * u * W) by (repeat apply Rmult_le_pos; unfold u; lra). nra.
Qed.

Theorem pressed_is_decided : rd (line_part * rd (nn' * rd (f * f))) < rd (D' * D') -> 0 < D' * D.
Proof.
  destruct (floors mu gg' nn' k l f gg_near nn_near) as (_ & HN & _ & nF & _). apply (sign_by_square D D' 6 (l * f)); trivial; [lra | now apply Rmult_le_pos | unfold u in *; lra].
Qed.

Theorem line_is_decided : rd (line_part * floor) < rd (al' * al') -> 0 < al' * al.
Proof.
  destruct (floors mu gg' nn' k l f gg_near nn_near) as (HG & _ & nF & _). fold floor in nF.
  apply (sign_by_square al al' 70 (k * f)); trivial; [lra | now apply Rmult_le_pos | unfold u in *; lra].
Qed.

(* F'_z <= F_m, pressed: D^2 against F_m^2 |n|^2. *)
Theorem holding_is_decided : forall most,
  let a := rd (D' * D') in let b := band_of most nn' in let sizes := rd (rd (a + b) + rd (nn' * rd (f * f))) in
  (rd (margin_part * sizes) < rd (b - a) -> D * D < most * most * (l * l)) /\ (rd (b - a) < - rd (margin_part * sizes) -> most * most * (l * l) < D * D).
Proof.
  intros most a b sizes. destruct (floors mu gg' nn' k l f gg_near nn_near) as (_ & HN & _ & nF & _).
  pose proof (square_near D D' 6 16 (l * f) ltac:(lra) ltac:(lra) ltac:(lra) ltac:(now apply Rmult_le_pos)) as na. fold a in na.
  destruct (band_near most nn' l 4 ltac:(lra) nn_near) as (b_pos & nb). fold b in b_pos, nb.
  assert (0 <= a) as a_pos by (pose proof (rd_positive _ (Rle_0_sqr D')); pose proof (Rle_0_sqr D'); unfold Rsqr, a, u in *; lra).
  set (N := l * f * (l * f)) in *. set (c := rd (nn' * rd (f * f))) in *.
  pose proof (rd_positive (a + b) ltac:(lra)) as s1. pose proof (rd_positive (rd (a + b) + c) ltac:(unfold u in *; lra)) as s2. fold sizes in s2.
  apply (comparison_is_right _ _ _ _ sizes _ _ na nb); unfold u in *; lra.
Qed.

End Surface.

Print Assumptions band_is_decided.
Print Assumptions disc_is_decided.
Print Assumptions corner_is_decided.
Print Assumptions holding_is_decided.
