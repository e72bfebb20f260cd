(* Lemma clip-in-pairs (proofs-notes/rounding-of-forces.md, section 9), slips onto the band's edge, onto the line that is left
   without a brake, and onto a corner. As clip_in_pairs.v. *)

From Coq Require Import Reals Psatz.
From Groundtruth Require Import clip_in_pairs.
Open Scope R_scope.

Section Edges.

(* l = |n|, k = |g|, f >= |F|; one component of g, g x n, F and of the part along the normal (pressed_part in clip_in_pairs.v). *)
Variables l k f mu B g g' c c' F F' pressed pressed' : R.
Hypotheses (l_pos : 0 < l) (k_pos : 0 < k) (f_pos : 0 < f) (mu_pos : 0 <= mu) (B_pos : 0 <= B).
Hypotheses (g_size : Rabs g <= k) (c_size : Rabs c <= k * l) (F_size : Rabs F <= (1 + eps) * f).
Hypotheses (g_near : Rabs (g' - g) <= 128 * eps * k) (c_near : Rabs (c' - c) <= 130 * eps * (k * l)) (F_near : Rabs (F' - F) <= 8 * eps * f).
Hypotheses (pressed_near : Rabs (pressed' - pressed) <= 16 * eps * f).

(* |g|^2 and |g| as computed. *)
Variables kk' k' : R.
Hypotheses (kk_near : Rabs (kk' - k * k) <= 260 * eps * (k * k)) (k'_pos : 0 <= k') (k_root : Rabs (k' * k' - kk') <= 4 * eps * (k * k)).

Lemma length_near : Rabs (k' - k) <= 264 * eps * k.
Proof.
  apply cancel with k; [assumption |]. apply root_moves; [lra | assumption |].
  replace (k' * k' - k * k) with ((k' * k' - kk') + (kk' - k * k)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra.
Qed.

Lemma g'_size : Rabs g' <= (1 + / 1000) * k.
Proof. apply Rle_trans with (1 := moved _ _ _ _ g_near g_size). unfold eps; lra. Qed.
Lemma c'_size : Rabs c' <= (1 + / 1000) * (k * l).
Proof. assert (0 < k * l) by now apply Rmult_lt_0_compat. apply Rle_trans with (1 := moved _ _ _ _ c_near c_size). unfold eps; lra. Qed.

(* F + ((+-B |g| - alpha) / |g|^2) g *)
Theorem band_edge_is_near : forall al al' sg edge' diff' m m' x' r', B <= (1 + eps) * f -> Rabs al <= (1 + eps) * (k * f) -> Rabs (al' - al) <= 138 * eps * (k * f) ->
  sg = 1 \/ sg = -1 -> Rabs (edge' - B * k') <= eps * (2 * (k * f)) -> Rabs (diff' - (sg * edge' - al')) <= eps * (3 * (k * f)) ->
  m * (k * k) = sg * (B * k) - al -> Rabs (m' * kk' - diff') <= eps * (3 * (k * f)) ->
  Rabs (x' - m' * g') <= eps * (4 * f) -> Rabs (r' - (F' + x')) <= eps * (6 * f) -> Rabs (r' - (F + m * g)) <= per_clip * f.
Proof.
  intros al al' sg edge' diff' m m' x' r' B_most al_size al_near which edge_near diff_near m_is m_near x_near r_near.
  assert (0 < k * k) by now apply Rmult_lt_0_compat. assert (0 < k * f) by now apply Rmult_lt_0_compat. pose proof length_near as root.
  assert (Rabs (B * k' - B * k) <= 265 * eps * (k * f)) as e1.
  { replace (B * k' - B * k) with (B * (k' - k)) by ring. rewrite Rabs_mult, (Rabs_pos_eq B) by assumption.
    apply Rle_trans with ((1 + eps) * f * (264 * eps * k)); [apply Rmult_le_compat; trivial; apply Rabs_pos | unfold eps; lra]. }
  assert (Rabs (sg * (B * k) - al) <= (21 / 10) * (k * f)) as a_size.
  { assert (0 <= B * k <= (1 + eps) * (k * f)) by (split; [apply Rmult_le_pos; lra | apply Rle_trans with ((1 + eps) * f * k); [apply Rmult_le_compat_r |]; lra]).
    apply within in al_size. apply Rabs_le. unfold eps in *. destruct which as [-> | ->]; lra. }
  assert (Rabs (diff' - (sg * (B * k) - al)) <= 408 * eps * (k * f)) as d_near.
  { apply within in edge_near. apply within in diff_near. apply within in al_near. apply within in e1. apply Rabs_le. destruct which as [-> | ->]; unfold eps in *; lra. }
  pose proof (quotient_moves _ (k * k) m diff' kk' m' _ (260 * eps) _ ltac:(assumption) d_near kk_near ltac:(unfold eps; lra) m_is m_near) as near.
  assert (Rabs (m' - m) * k <= 980 * eps * f) as m_off.
  { apply cancel with k; [assumption |]. rewrite Rmult_assoc. apply Rle_trans with (1 := near). unfold eps in *. lra. }
  assert (Rabs m * k <= 21 / 10 * f) as m_size.
  { apply cancel with k; [assumption |]. replace (Rabs m * k * k) with (Rabs (sg * (B * k) - al)) by (rewrite <- m_is, Rabs_mult, (Rabs_pos_eq (k * k)) by lra; ring). lra. }
  assert (Rabs (m' * g' - m * g) <= 1310 * eps * f) as product.
  { replace (m' * g' - m * g) with ((m' - m) * g' + m * (g' - g)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult.
    assert (Rabs (m' - m) * Rabs g' <= (1 + / 1000) * (980 * eps * f)).
    { apply Rle_trans with (Rabs (m' - m) * ((1 + / 1000) * k)); [apply Rmult_le_compat_l; [apply Rabs_pos | apply g'_size] | lra]. }
    assert (Rabs m * Rabs (g' - g) <= 128 * eps * (21 / 10 * f)).
    { apply Rle_trans with (Rabs m * (128 * eps * k)); [apply Rmult_le_compat_l; [apply Rabs_pos | assumption] | unfold eps in *; lra]. }
    unfold eps in *. lra. }
  apply within in product. apply within in x_near. apply within in r_near. apply within in F_near. apply Rabs_le. unfold per_clip, eps in *. lra.
Qed.

(* (beta / (|g|^2 |n|^2)) g x n and the part along the normal *)
Theorem line_is_near : forall be be' area' a a' x' r', Rabs be <= (1 + eps) * (k * l * f) -> Rabs (be' - be) <= 144 * eps * (k * l * f) ->
  Rabs (area' - k * l * (k * l)) <= 264 * eps * (k * l * (k * l)) -> a * (k * l * (k * l)) = be -> Rabs (a' * area' - be') <= eps * (2 * (k * l * f)) ->
  Rabs (x' - a' * c') <= eps * (2 * f) -> Rabs (r' - (x' + pressed')) <= eps * (6 * f) -> Rabs (r' - (a * c + pressed)) <= per_clip * f.
Proof.
  intros be be' area' a a' x' r' be_size be_near area_near a_is a_near x_near r_near.
  assert (0 < k * l) as kl by now apply Rmult_lt_0_compat. assert (0 < k * l * f) by now apply Rmult_lt_0_compat.
  set (q := k * l) in *. assert (0 < q * q) by now apply Rmult_lt_0_compat.
  pose proof (quotient_moves _ (q * q) a be' area' a' _ (264 * eps) _ ltac:(assumption) be_near area_near ltac:(unfold eps; lra) a_is a_near) as near.
  assert (Rabs (a' - a) * q <= 425 * eps * f) as a_off.
  { apply cancel with q; [assumption |]. rewrite Rmult_assoc. apply Rle_trans with (1 := near). unfold eps in *. lra. }
  assert (Rabs a * q <= (1 + eps) * f) as a_size.
  { apply cancel with q; [assumption |]. replace (Rabs a * q * q) with (Rabs be) by (rewrite <- a_is, Rabs_mult, (Rabs_pos_eq (q * q)) by lra; ring). lra. }
  assert (Rabs (a' * c' - a * c) <= 566 * eps * f) as product.
  { replace (a' * c' - a * c) with ((a' - a) * c' + a * (c' - c)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult.
    assert (Rabs (a' - a) * Rabs c' <= (1 + / 1000) * (425 * eps * f)).
    { apply Rle_trans with (Rabs (a' - a) * ((1 + / 1000) * q)); [apply Rmult_le_compat_l; [apply Rabs_pos | apply c'_size] | lra]. }
    assert (Rabs a * Rabs (c' - c) <= 130 * eps * ((1 + eps) * f)).
    { apply Rle_trans with (Rabs a * (130 * eps * q)); [apply Rmult_le_compat_l; [apply Rabs_pos | assumption] | unfold eps in *; lra]. }
    unfold eps in *. lra. }
  apply within in product. apply within in x_near. apply within in r_near. apply within in pressed_near. apply Rabs_le. unfold per_clip, eps in *. lra.
Qed.

(* +-(B / |g|) g, +-(root of sigma / (|g| |n|^2)) g x n and the part along the normal; S^2 = sigma = mu^2 D^2 - B^2 |n|^2. `condition`
   is mu |D| / S, of which the code has more than half. *)
Theorem corner_is_near : forall D limit' sigma' S S' condition area' h h' y y' sa sb z' x' r', Rabs D <= (1 + eps) * (l * f) ->
  0 < S -> S * S = mu * mu * (D * D) - B * B * (l * l) -> S * condition = mu * Rabs D -> 1 <= condition -> / 8388608 * (mu * (l * f)) <= S ->
  Rabs (limit' - mu * D) <= 12 * eps * (mu * (l * f)) -> Rabs (sigma' - (limit' * limit' - B * B * (l * l))) <= 30 * eps * (mu * mu * (D * D)) ->
  0 <= S' -> Rabs (S' * S' - sigma') <= 5 * eps * (S * S) ->
  h * k = B -> Rabs (h' * k' - B) <= eps * (2 * B) -> Rabs (area' - k * l * l) <= 270 * eps * (k * l * l) ->
  y * (k * l * l) = S -> Rabs (y' * area' - S') <= eps * (2 * (mu * (l * f))) ->
  (sa = 1 \/ sa = -1) -> (sb = 1 \/ sb = -1) ->
  Rabs (z' - sa * h' * g') <= eps * (2 * (mu * f)) -> Rabs (x' - sb * y' * c') <= eps * (2 * (mu * f)) ->
  Rabs (r' - (z' + x' + pressed')) <= eps * (10 * (f * (1 + mu))) ->
  Rabs (r' - (sa * h * g + sb * y * c + pressed)) <= per_clip / 2 * (f * (1 + mu * (1 + condition))).
Proof.
  intros D limit' sigma' S S' condition area' h h' y y' sa sb z' x' r' D_size S_some S_is c_is c_least S_least limit_near sigma_near S'_pos S_root
    h_is h_near area_near y_is y_near which which' z_near x_near r_near.
  assert (0 < l * f) as lf by now apply Rmult_lt_0_compat. set (m := mu * (l * f)) in *. assert (0 <= m) as m_pos by (apply Rmult_le_pos; lra).
  set (d := mu * Rabs D) in *. assert (d <= (1 + eps) * m) as d_most.
  { unfold d, m. apply Rle_trans with (mu * ((1 + eps) * (l * f))); [now apply Rmult_le_compat_l | lra]. }
  assert (0 <= d) as d_pos by (apply Rmult_le_pos; [assumption | apply Rabs_pos]).
  assert (d * d = mu * mu * (D * D)) as dd by (unfold d, Rabs; destruct (Rcase_abs D); ring).
  assert (0 <= B * B * (l * l)) as K_pos by (apply Rmult_le_pos; apply Rle_0_sqr). rewrite <- dd in S_is, sigma_near.
  assert (S <= d) as S_most by (apply Rnot_lt_le; intros more; assert (d * d < S * S) by (apply Rmult_le_0_lt_compat; lra); lra).
  assert (0 <= S * condition) by lra.
  (* the root *)
  assert (Rabs (limit' * limit' - d * d) <= 12 * eps * m * (2 * d + 12 * eps * m)) as squares.
  { rewrite dd. replace (limit' * limit' - mu * mu * (D * D)) with ((limit' - mu * D) * (limit' + mu * D)) by ring. rewrite Rabs_mult.
    apply Rmult_le_compat; try apply Rabs_pos; [assumption |]. replace (limit' + mu * D) with ((limit' - mu * D) + 2 * (mu * D)) by ring.
    apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_mult 2), (Rabs_mult mu), (Rabs_pos_eq 2), (Rabs_pos_eq mu) by lra. fold d. lra. }
  assert (d * d <= (1 + eps) * m * d) as d_square by (apply Rmult_le_compat_r; assumption).
  assert (m <= 8388608 * d) by lra. assert (m * m <= 8388608 * (m * d)) as m_square.
  { replace (8388608 * (m * d)) with (m * (8388608 * d)) by ring. now apply Rmult_le_compat_l. }
  assert (0 <= m * d) by now apply Rmult_le_pos. assert (S * S <= d * d) by (apply Rmult_le_compat; lra).
  assert (Rabs (S' * S' - S * S) <= (80 * eps * m * condition) * S) as roots.
  { replace (80 * eps * m * condition * S) with (80 * eps * (m * d)) by (rewrite <- c_is; ring). rewrite S_is in *.
    apply within in squares. apply within in sigma_near. apply within in S_root. apply Rabs_le. unfold eps in *. lra. }
  pose proof (root_moves S S' _ ltac:(lra) S'_pos roots) as S_near. apply cancel in S_near; [| assumption].
  (* across *)
  assert (0 < k * l) as kl by now apply Rmult_lt_0_compat. assert (0 < k * l * l) as kll by now apply Rmult_lt_0_compat.
  pose proof (quotient_moves _ (k * l * l) y S' area' y' _ (270 * eps) _ ltac:(assumption) S_near area_near ltac:(unfold eps; lra) y_is y_near) as near.
  rewrite (Rabs_pos_eq S) in near by lra.
  assert (0 <= mu * f) as mf by (apply Rmult_le_pos; lra). assert (m = mu * f * l) as ml by (unfold m; ring).
  assert (0 <= mu * f * condition) by (apply Rmult_le_pos; lra).
  assert (Rabs (y' - y) * (k * l) <= eps * (mu * f) * (82 * condition + 280)) as y_off.
  { apply cancel with l; [assumption |]. rewrite Rmult_assoc. apply Rle_trans with (1 := near).
    replace (eps * (mu * f) * (82 * condition + 280) * l) with (82 * (eps * m * condition) + 280 * (eps * m)) by (rewrite ml; ring).
    assert (0 <= eps * m * condition) by (rewrite ml; repeat apply Rmult_le_pos; unfold eps; lra). unfold eps in *. lra. }
  assert (Rabs y * (k * l) <= (1 + eps) * (mu * f)) as y_size.
  { apply cancel with l; [assumption |]. replace (Rabs y * (k * l) * l) with (Rabs S) by (rewrite <- y_is, Rabs_mult, (Rabs_pos_eq (k * l * l)) by lra; ring).
    rewrite (Rabs_pos_eq S) by lra. replace ((1 + eps) * (mu * f) * l) with ((1 + eps) * m) by (rewrite ml; ring). lra. }
  assert (Rabs (y' * c' - y * c) <= eps * (mu * f) * (84 * condition + 420)) as across.
  { replace (y' * c' - y * c) with ((y' - y) * c' + y * (c' - c)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult.
    assert (Rabs (y' - y) * Rabs c' <= (1 + / 1000) * (eps * (mu * f) * (82 * condition + 280))).
    { apply Rle_trans with (Rabs (y' - y) * ((1 + / 1000) * (k * l))); [apply Rmult_le_compat_l; [apply Rabs_pos | apply c'_size] | lra]. }
    assert (Rabs y * Rabs (c' - c) <= 130 * eps * ((1 + eps) * (mu * f))).
    { apply Rle_trans with (Rabs y * (130 * eps * (k * l))); [apply Rmult_le_compat_l; [apply Rabs_pos | assumption] | unfold eps in *; lra]. }
    unfold eps in *. lra. }
  (* ahead *)
  assert (B <= (1 + eps) * (mu * f)) as B_most.
  { apply cancel with l; [assumption |]. replace ((1 + eps) * (mu * f) * l) with ((1 + eps) * m) by (rewrite ml; ring). apply Rle_trans with (2 := d_most).
    apply Rnot_lt_le. intros more.
    assert (d * d < B * l * (B * l)) by (apply Rmult_le_0_lt_compat; lra). assert (0 < S * S) by now apply Rmult_lt_0_compat. assert (B * l * (B * l) = B * B * (l * l)) by ring. lra. }
  pose proof (quotient_moves B k h B k' h' 0 (264 * eps) _ k_pos ltac:(rewrite Rminus_diag_eq, Rabs_R0; [lra | reflexivity]) length_near ltac:(unfold eps; lra) h_is h_near) as h_off.
  rewrite (Rabs_pos_eq B) in h_off by assumption.
  assert (Rabs h * k <= B) as h_size by (rewrite <- (Rabs_pos_eq k) by lra; rewrite <- Rabs_mult, h_is, Rabs_pos_eq; lra).
  assert (Rabs (h' * g' - h * g) <= 410 * eps * (mu * f)) as ahead.
  { replace (h' * g' - h * g) with ((h' - h) * g' + h * (g' - g)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite !Rabs_mult.
    assert (Rabs (h' - h) * Rabs g' <= Rabs (h' - h) * ((1 + / 1000) * k)) by (apply Rmult_le_compat_l; [apply Rabs_pos | apply g'_size]).
    assert (Rabs h * Rabs (g' - g) <= Rabs h * (128 * eps * k)) by (apply Rmult_le_compat_l; [apply Rabs_pos | assumption]).
    unfold eps in *. lra. }
  assert (Rabs (sa * h' * g' - sa * h * g) <= 410 * eps * (mu * f)) as ahead' by (destruct which as [-> | ->];
    [replace (1 * h' * g' - 1 * h * g) with (h' * g' - h * g) by ring | replace (-1 * h' * g' - -1 * h * g) with (- (h' * g' - h * g)) by ring; rewrite Rabs_Ropp]; assumption).
  assert (Rabs (sb * y' * c' - sb * y * c) <= eps * (mu * f) * (84 * condition + 420)) as across' by (destruct which' as [-> | ->];
    [replace (1 * y' * c' - 1 * y * c) with (y' * c' - y * c) by ring | replace (-1 * y' * c' - -1 * y * c) with (- (y' * c' - y * c)) by ring; rewrite Rabs_Ropp]; assumption).
  apply within in ahead'. apply within in across'. apply within in z_near. apply within in x_near. apply within in r_near. apply within in pressed_near.
  apply Rabs_le. unfold per_clip, eps in *. lra.
Qed.

End Edges.

Print Assumptions band_edge_is_near.
Print Assumptions line_is_near.
Print Assumptions corner_is_near.
