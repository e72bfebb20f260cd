(* Lemma clipping-without-axes (proofs-notes/rounding-of-forces.md, section 4): the decisions and the clipped force of SPEC
   section 4 from n, g and F in any axes, without the surface's own. fast/surface.hpp, ForceOnSurface;
   fast/surface_in_doubles.hpp, fast/surface_in_pairs.hpp. *)

From Coq Require Import Reals Psatz.
From Groundtruth Require Import surface clip frames.
Open Scope R_scope.

Notation dot := surface.dot.

(* g of a clip is r X, as is that of a step in the wheel's axes: n x y. *)
Theorem forward_is_along_X : forall x y z, 0 < - z ->
  cross (V x y z) (V 0 1 0) = V (- z) 0 x /\ V (- z) 0 x = times (r x z) (X x z).
Proof.
  intros x y z upright. pose proof (r_positive x z upright). split; unfold cross, times, X; simpl; f_equal; try ring; field; lra.
Qed.

Section Surface.

Variable f : frame.
Hypothesis ok : is_frame f.
Variables l k x y z mu B : R. (* |n|, |g|, F', friction, brake *)
Hypotheses (l_pos : 0 < l) (k_pos : 0 < k) (mu_pos : 0 <= mu) (B_pos : 0 <= B).

Let n := at_ f 0 0 (- l).
Let g := at_ f k 0 0.
Let F := at_ f x y z.
Let T := cross n F.
Let alpha := dot g F.
Let beta := dot g T.
Let D := dot n F.
Let nn := dot n n.
Let gg := dot g g.
Let sigma := mu * mu * (D * D) - B * B * nn.
Let m := mu * Rabs z. (* the disc's radius *)
Let s := sqrt (m * m - B * B).

Lemma products : alpha = k * x /\ beta = k * l * y /\ D = - (l * z) /\ dot T T = l * l * (x * x + y * y)
  /\ nn = l * l /\ gg = k * k /\ cross g n = at_ f 0 (k * l) 0.
Proof.
  unfold alpha, beta, D, T, nn, gg, n, g, F. rewrite !cross_by_coordinates, !dot_by_coordinates by assumption.
  repeat split; try ring. f_equal; ring.
Qed.

Lemma radius_squared : m * m = mu * mu * (z * z).
Proof. unfold m. replace (mu * Rabs z * (mu * Rabs z)) with (mu * mu * (Rabs z * Rabs z)) by ring. now rewrite square_of_magnitude. Qed.

Lemma sigma_is : sigma = l * l * (m * m - B * B).
Proof. destruct products as (_ & _ & HD & _ & Hn & _). unfold sigma. rewrite HD, Hn, radius_squared. ring. Qed.

Lemma scaled_iff : forall c p q, 0 < c -> (p <= q <-> c * p <= c * q).
Proof. intros c p q pos. split; intros le; [apply Rmult_le_compat_l; lra | now apply Rmult_le_reg_l with c]. Qed.

Theorem decisions_without_axes :
  (Rabs x <= B <-> alpha * alpha <= B * B * gg) /\
  (x * x + y * y <= m * m <-> dot T T <= mu * mu * (D * D)) /\
  (B < m <-> 0 < sigma) /\
  (B < m -> (Rabs y <= s <-> beta * beta <= gg * sigma)) /\
  (B < m -> (B * Rabs y <= Rabs x * s <-> B * B * (beta * beta) <= alpha * alpha * sigma)).
Proof.
  assert (0 <= m) as m_pos by (apply Rmult_le_pos; [assumption | apply Rabs_pos]).
  destruct (decisions_by_squares m B m_pos B_pos x y) as (band & disc & between & beside).
  destruct products as (Ha & Hb & HD & HT & _ & Hg & _). rewrite sigma_is, Ha, Hb, HD, HT, Hg.
  assert (0 < l * l) as ll by nra. assert (0 < k * k) as kk by nra. assert (0 < k * k * (l * l)) as kl by nra.
  replace (k * x * (k * x)) with (k * k * (x * x)) by ring. replace (k * l * y * (k * l * y)) with (k * k * (l * l) * (y * y)) by ring.
  split; [| split; [| split; [| split]]].
  - rewrite band. replace (B * B * (k * k)) with (k * k * (B * B)) by ring. now apply scaled_iff.
  - replace (mu * mu * (- (l * z) * - (l * z))) with (l * l * (m * m)) by (rewrite radius_squared; ring). now apply scaled_iff.
  - rewrite disc. split; intros less; [apply Rmult_lt_0_compat; lra |]. apply Rmult_lt_reg_l with (l * l); [assumption | lra].
  - intros some. fold s in between. rewrite (between some).
    replace (k * k * (l * l * (m * m - B * B))) with (k * k * (l * l) * (m * m - B * B)) by ring. now apply scaled_iff.
  - intros some. fold s in beside. rewrite (beside some). replace (B * B * (k * k * (l * l) * (y * y))) with (k * k * (l * l) * (B * B * (y * y))) by ring.
    replace (k * k * (x * x) * (l * l * (m * m - B * B))) with (k * k * (l * l) * (x * x * (m * m - B * B))) by ring. now apply scaled_iff.
Qed.

Lemma sign_of_scaled : forall c a, 0 < c -> sign (c * a) = sign a.
Proof. intros c a pos. unfold sign. destruct (Rlt_dec (c * a) 0), (Rlt_dec a 0); trivial; nra. Qed.

Lemma lengths : sqrt gg = k /\ sqrt (dot T T) = l * sqrt (x * x + y * y) /\ (B < m -> sqrt sigma = l * s).
Proof.
  destruct products as (_ & _ & _ & HT & _ & Hg & _). rewrite sigma_is, HT, Hg.
  split; [apply sqrt_square; lra |]. split.
  - rewrite sqrt_mult_alt, sqrt_square by nra. reflexivity.
  - intros _. rewrite sqrt_mult_alt, sqrt_square by nra. reflexivity.
Qed.

(* Q (H_x, H_y, F'_z) for each of clip.v's cases. *)
Theorem onto_band_edge : at_ f (sign x * B) y z = plus F (times ((sign alpha * (B * sqrt gg) - alpha) / gg) g).
Proof.
  destruct products as (Ha & _ & _ & _ & _ & Hg & _). destruct lengths as (Hl & _). rewrite Hl, Ha, Hg, sign_of_scaled by assumption.
  unfold F, g. rewrite times_by_coordinates, plus_by_coordinates. f_equal; field; lra.
Qed.

Theorem onto_line_without_brake : at_ f 0 y z = plus (times (beta / (gg * nn)) (cross g n)) (times (D / nn) n).
Proof.
  destruct products as (_ & Hb & HD & _ & Hn & Hg & Hc). rewrite Hb, HD, Hn, Hg, Hc. unfold n. rewrite !times_by_coordinates, plus_by_coordinates. f_equal; field; lra.
Qed.

Theorem onto_corner : B < m -> at_ f (sign x * B) (sign y * s) z =
  plus (plus (times (sign alpha * (B / sqrt gg)) g) (times (sign beta * (sqrt sigma / (sqrt gg * nn))) (cross g n))) (times (D / nn) n).
Proof.
  intros some. destruct products as (Ha & Hb & HD & _ & Hn & _ & Hc). destruct lengths as (Hl & _ & Hs).
  rewrite Hl, (Hs some), Ha, Hb, HD, Hn, Hc. rewrite (sign_of_scaled k x), (sign_of_scaled (k * l) y) by nra.
  unfold n, g. rewrite !times_by_coordinates, !plus_by_coordinates. f_equal; field; lra.
Qed.

Theorem onto_circle : 0 < x * x + y * y ->
  let rho := mu * Rabs D / sqrt (dot T T) in
  at_ f (m * x / sqrt (x * x + y * y)) (m * y / sqrt (x * x + y * y)) z = plus (times rho F) (times ((1 - rho) * (D / nn)) n).
Proof.
  intros some rho. destruct products as (_ & _ & HD & _ & Hn & _). destruct lengths as (_ & HT & _).
  assert (0 < sqrt (x * x + y * y)) by now apply sqrt_lt_R0.
  assert (rho = m / sqrt (x * x + y * y)) as ->.
  { unfold rho, m. rewrite HT, HD, Rabs_Ropp, Rabs_mult, (Rabs_pos_eq l) by lra. field. split; lra. }
  rewrite HD, Hn. unfold F, n. rewrite !times_by_coordinates, plus_by_coordinates. f_equal; field; lra.
Qed.

(* As counted numbers have it: rho (T x n) / |n|^2 and the part along the normal. *)
Theorem onto_circle_by_turning : forall rho,
  plus (times rho F) (times ((1 - rho) * (D / nn)) n) = plus (times (rho / nn) (cross T n)) (times (D / nn) n).
Proof.
  intros rho. destruct products as (_ & _ & HD & _ & Hn & _). rewrite HD, Hn. unfold T, n, F.
  rewrite !cross_by_coordinates, !times_by_coordinates, !plus_by_coordinates by assumption. f_equal; field; lra.
Qed.

End Surface.

Print Assumptions forward_is_along_X.
Print Assumptions decisions_without_axes.
Print Assumptions onto_band_edge.
Print Assumptions onto_line_without_brake.
Print Assumptions onto_corner.
Print Assumptions onto_circle.
Print Assumptions onto_circle_by_turning.
