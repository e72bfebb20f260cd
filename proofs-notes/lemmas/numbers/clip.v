(* The clip of SPEC section 4 (proofs-notes/clipping.md): the closest point of disc and band, unique, idempotent,
   1-Lipschitz; what it decides with roots, squares decide alike. m = mu N is the disc's radius, B the band. *)

From Coq Require Import Reals Psatz.
Open Scope R_scope.

Definition plane := (R * R)%type.
Definition dot (a b : plane) := fst a * fst b + snd a * snd b.
Definition minus (a b : plane) : plane := (fst a - fst b, snd a - snd b).
Definition square a := dot a a.

Definition border m B (p : plane) := square p <= m * m /\ Rabs (fst p) <= B.
Definition sign x := if Rlt_dec x 0 then -1 else 1.

Definition slip m B x y : plane :=
  let s := sqrt (m * m - B * B) in
  let on_disc := (m * x / sqrt (x * x + y * y), m * y / sqrt (x * x + y * y)) in
  if Rlt_dec B m then
    if Rle_dec (Rabs y) s then (sign x * B, y)
    else if Rle_dec (B * Rabs y) (Rabs x * s) then (sign x * B, sign y * s)
    else on_disc
  else on_disc.

Definition clip m B (F : plane) : plane :=
  let (x, y) := F in
  if Rle_dec (Rabs x) B then if Rle_dec (x * x + y * y) (m * m) then F else slip m B x y else slip m B x y.

(* H is the closest point as far as first order tells; for a convex border that is all. *)
Definition faces m B F H := border m B H /\ forall G, border m B G -> dot (minus F H) (minus G H) <= 0.

Lemma within : forall x a, Rabs x <= a -> - a <= x <= a.
Proof. intros x a; unfold Rabs; destruct (Rcase_abs x); lra. Qed.
Lemma sign_squared : forall x, sign x * sign x = 1.
Proof. intros; unfold sign; destruct (Rlt_dec x 0); lra. Qed.
Lemma sign_times : forall x, sign x * x = Rabs x.
Proof. intros; unfold sign, Rabs; destruct (Rlt_dec x 0), (Rcase_abs x); lra. Qed.
Lemma sign_bounds : forall x g B, Rabs g <= B -> sign x * g <= B.
Proof. intros x g B Hg; apply within in Hg; unfold sign; destruct (Rlt_dec x 0); lra. Qed.
Lemma signed : forall x, x = sign x * Rabs x.
Proof. intros; unfold sign, Rabs; destruct (Rlt_dec x 0), (Rcase_abs x); lra. Qed.
Lemma square_of_magnitude : forall x, Rabs x * Rabs x = x * x.
Proof. intros; unfold Rabs; destruct (Rcase_abs x); lra. Qed.
Lemma magnitude_of_signed : forall x B, 0 <= B -> Rabs (sign x * B) = B.
Proof. intros; unfold sign; destruct (Rlt_dec x 0); [rewrite Rabs_left1 | rewrite Rabs_pos_eq]; lra. Qed.
Lemma along_axis : forall x t a g b, x = t * a -> t * t = 1 -> (a - b) * (t * g - b) = (x - t * b) * (g - t * b).
Proof. intros x t a g b -> unit; transitivity ((a - b) * (t * g - t * t * b)); [rewrite unit |]; ring. Qed.

Section Clip.

Variables m B : R.
Hypotheses (m_positive : 0 <= m) (B_positive : 0 <= B).
Let s := sqrt (m * m - B * B).

Lemma s_squared : B < m -> s * s = m * m - B * B.
Proof. intros; unfold s; apply sqrt_sqrt; nra. Qed.
Lemma s_positive : B < m -> 0 < s.
Proof. intros; unfold s; apply sqrt_lt_R0; nra. Qed.

Lemma case_1 : forall x y, B < Rabs x -> B < m -> Rabs y <= s -> faces m B (x, y) (sign x * B, y).
Proof.
  intros x y outside thin low; pose proof (s_squared thin) as s2; pose proof (s_positive thin).
  pose proof (sign_squared x) as unit; pose proof (square_of_magnitude y) as y2; pose proof (Rabs_pos y).
  split; [split; simpl |].
  - unfold square, dot; simpl.
    replace (sign x * B * (sign x * B)) with (sign x * sign x * (B * B)) by ring; rewrite unit; nra.
  - rewrite magnitude_of_signed; lra.
  - intros [g1 g2] [_ in_band]; simpl in in_band; unfold dot, minus; simpl.
    replace ((x - sign x * B) * (g1 - sign x * B) + (y - y) * (g2 - y))
      with ((Rabs x - B) * (sign x * g1 - B)).
    + pose proof (sign_bounds x g1 B in_band); nra.
    + rewrite (along_axis x (sign x) (Rabs x) g1 B (signed x) unit); ring.
Qed.

Lemma case_2 : forall x y, B < m -> s < Rabs y -> B * Rabs y <= Rabs x * s ->
  faces m B (x, y) (sign x * B, sign y * s).
Proof.
  intros x y thin high flat; pose proof (s_squared thin) as s2; pose proof (s_positive thin) as s_pos.
  pose proof (sign_squared x) as unit; pose proof (sign_squared y) as unit'.
  split; [split; simpl |].
  - unfold square, dot; simpl.
    replace (sign x * B * (sign x * B)) with (sign x * sign x * (B * B)) by ring.
    replace (sign y * s * (sign y * s)) with (sign y * sign y * (s * s)) by ring.
    rewrite unit, unit', s2; lra.
  - rewrite magnitude_of_signed; lra.
  - intros [g1 g2] [in_disc in_band]; unfold square, dot in in_disc; simpl in in_disc, in_band.
    set (a := sign x * g1); set (b := sign y * g2).
    assert (a <= B) by (apply sign_bounds; assumption).
    assert (a * a + b * b <= B * B + s * s).
    { unfold a, b; replace (sign x * g1 * (sign x * g1)) with (sign x * sign x * (g1 * g1)) by ring.
      replace (sign y * g2 * (sign y * g2)) with (sign y * sign y * (g2 * g2)) by ring.
      rewrite unit, unit'; lra. }
    assert (B * (a - B) + s * (b - s) <= 0)
      by (pose proof (Rle_0_sqr (a - B)) as one; pose proof (Rle_0_sqr (b - s)) as two; unfold Rsqr in one, two; lra).
    unfold dot, minus; simpl.
    replace ((x - sign x * B) * (g1 - sign x * B) + (y - sign y * s) * (g2 - sign y * s))
      with ((Rabs x - B) * (a - B) + (Rabs y - s) * (b - s)).
    + set (beta := (Rabs y - s) / s).
      assert (0 < beta) by (apply Rdiv_lt_0_compat; lra).
      assert (Rabs y - s = beta * s) as along_y by (unfold beta; field; lra).
      assert (0 <= Rabs x - B - beta * B).
      { apply Rmult_le_reg_r with s; [lra |]; rewrite Rmult_0_l.
        replace ((Rabs x - B - beta * B) * s) with (Rabs x * s - B * (s + beta * s)) by ring.
        rewrite <- along_y; nra. }
      rewrite along_y; nra.
    + unfold a, b; rewrite (along_axis x (sign x) (Rabs x) g1 B (signed x) unit),
        (along_axis y (sign y) (Rabs y) g2 s (signed y) unit'); ring.
Qed.

Lemma case_3 : forall x y, m * m < x * x + y * y ->
  (m <= B \/ (B < m /\ s < Rabs y /\ Rabs x * s < B * Rabs y)) ->
  faces m B (x, y) (m * x / sqrt (x * x + y * y), m * y / sqrt (x * x + y * y)).
Proof.
  intros x y outside steep; set (l := sqrt (x * x + y * y)).
  assert (l * l = x * x + y * y) as l2 by (apply sqrt_sqrt; nra).
  assert (0 < l) by (apply sqrt_lt_R0; nra).
  assert (m < l) by nra.
  assert (m * x / l * (m * x / l) + m * y / l * (m * y / l) = m * m) as on_disc.
  { transitivity (m * m * (x * x + y * y) / (l * l)); [field; lra | rewrite l2; field; nra]. }
  split; [split; unfold square, dot; simpl; [lra |] |].
  - assert (0 <= Rabs (m * x / l)) by apply Rabs_pos.
    pose proof (square_of_magnitude (m * x / l)) as h2.
    destruct steep as [wide | [thin [high steep]]].
    + apply Rnot_lt_le; intro; pose proof (Rle_0_sqr (m * y / l)) as hy; unfold Rsqr in hy; nra.
    + pose proof (s_squared thin) as s2; pose proof (s_positive thin).
      pose proof (square_of_magnitude x) as x2; pose proof (square_of_magnitude y) as y2.
      pose proof (Rabs_pos x); pose proof (Rabs_pos y).
      assert (Rabs x * s * (Rabs x * s) <= B * Rabs y * (B * Rabs y)) by (apply Rmult_le_compat; nra).
      assert (x * x * (s * s) <= B * B * (y * y)) by (rewrite <- x2, <- y2; lra).
      assert (m * m * (x * x) <= B * B * (l * l)) by (rewrite s2 in *; rewrite l2; lra).
      assert (m * x / l * (m * x / l) * (l * l) = m * m * (x * x)) as scaled by (field; lra).
      apply Rnot_lt_le; intro.
      assert (B * B < m * x / l * (m * x / l)) by nra.
      assert (B * B * (l * l) < m * x / l * (m * x / l) * (l * l)) by (apply Rmult_lt_compat_r; nra).
      lra.
  - intros [g1 g2] [in_disc _]; unfold square, dot in in_disc; simpl in in_disc.
    unfold dot, minus; simpl.
    replace ((x - m * x / l) * (g1 - m * x / l) + (y - m * y / l) * (g2 - m * y / l))
      with ((1 - m / l) * (x * g1 + y * g2 - m * l)).
    + assert (x * g1 + y * g2 <= m * l).
      { apply Rnot_lt_le; intro.
        assert ((x * g1 + y * g2) * (x * g1 + y * g2) <= (x * x + y * y) * (g1 * g1 + g2 * g2))
          by (pose proof (Rle_0_sqr (x * g2 - y * g1)) as cs; unfold Rsqr in cs; nra).
        assert ((m * l) * (m * l) < (x * g1 + y * g2) * (x * g1 + y * g2)) by (apply Rmult_le_0_lt_compat; nra).
        rewrite <- l2 in *; nra. }
      assert (m / l < 1) by (apply Rmult_lt_reg_r with l; [lra |]; replace (m / l * l) with m by (field; lra); lra).
      nra.
    + transitivity ((1 - m / l) * (x * g1 + y * g2 - m / l * (x * x + y * y))); [rewrite <- l2 | ]; field; lra.
Qed.

Lemma clip_faces : forall F, faces m B F (clip m B F).
Proof.
  intros [x y]; unfold clip, slip; fold s.
  destruct (Rle_dec (Rabs x) B) as [in_band | out_of_band];
    destruct (Rle_dec (x * x + y * y) (m * m)) as [in_disc | out_of_disc].
  - split; [split; assumption |]; intros G _; unfold dot, minus; simpl; lra.
  - destruct (Rlt_dec B m) as [thin |]; [| apply case_3; lra].
    pose proof (s_squared thin) as s2; pose proof (s_positive thin).
    pose proof (square_of_magnitude x); pose proof (square_of_magnitude y); pose proof (Rabs_pos x); pose proof (Rabs_pos y).
    destruct (Rle_dec (Rabs y) s) as [low | high]; [exfalso; nra |].
    destruct (Rle_dec (B * Rabs y) (Rabs x * s)) as [flat | steep]; [apply case_2; lra | apply case_3; [lra | right; repeat split; lra]].
  - destruct (Rlt_dec B m) as [thin |].
    + destruct (Rle_dec (Rabs y) s) as [low | high]; [apply case_1; lra |].
      destruct (Rle_dec (B * Rabs y) (Rabs x * s)) as [flat | steep]; [apply case_2; lra |].
      exfalso; pose proof (s_squared thin); pose proof (s_positive thin).
      pose proof (square_of_magnitude x); pose proof (square_of_magnitude y); nra.
    + exfalso; pose proof (square_of_magnitude x); pose proof (Rabs_pos x); nra.
  - destruct (Rlt_dec B m) as [thin |]; [| apply case_3; lra].
    destruct (Rle_dec (Rabs y) s) as [low | high]; [apply case_1; lra |].
    destruct (Rle_dec (B * Rabs y) (Rabs x * s)) as [flat | steep]; [apply case_2; lra | apply case_3; [lra | right; repeat split; lra]].
Qed.

Lemma longer_by : forall F G H, square (minus F G) = square (minus F H) + square (minus G H) - 2 * dot (minus F H) (minus G H).
Proof. intros [] [] []; unfold square, dot, minus; simpl; ring. Qed.

Lemma square_is_not_negative : forall a, 0 <= square a.
Proof. intros []; unfold square, dot; simpl; nra. Qed.

Theorem clip_is_in_border : forall F, border m B (clip m B F).
Proof. intros F; apply clip_faces. Qed.

Theorem clip_is_closest : forall F G, border m B G -> square (minus F (clip m B F)) <= square (minus F G).
Proof.
  intros F G in_border; destruct (clip_faces F) as [_ away]; specialize (away G in_border).
  rewrite (longer_by F G (clip m B F)); pose proof (square_is_not_negative (minus G (clip m B F))); lra.
Qed.

Theorem closest_is_unique : forall F G, border m B G -> square (minus F G) <= square (minus F (clip m B F)) -> G = clip m B F.
Proof.
  intros F G in_border no_farther; destruct (clip_faces F) as [_ away]; specialize (away G in_border).
  rewrite (longer_by F G (clip m B F)) in no_farther.
  destruct G as [g1 g2], (clip m B F) as [h1 h2].
  assert (square (minus (g1, g2) (h1, h2)) <= 0) as close by lra.
  unfold square, dot, minus in close; simpl in close.
  pose proof (Rle_0_sqr (g1 - h1)) as one; pose proof (Rle_0_sqr (g2 - h2)) as two; unfold Rsqr in one, two.
  assert (g1 - h1 = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra).
  assert (g2 - h2 = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra).
  f_equal; lra.
Qed.

Theorem clip_is_idempotent : forall F, clip m B (clip m B F) = clip m B F.
Proof.
  intros F; symmetry; apply closest_is_unique; [apply clip_is_in_border |].
  replace (square (minus (clip m B F) (clip m B F))) with 0 by (unfold square, dot, minus; simpl; ring).
  apply square_is_not_negative.
Qed.

Theorem clip_is_1_Lipschitz : forall F G, square (minus (clip m B F) (clip m B G)) <= square (minus F G).
Proof.
  intros F G; destruct (clip_faces F) as [in_F away_F], (clip_faces G) as [in_G away_G].
  specialize (away_F _ in_G); specialize (away_G _ in_F).
  destruct F as [f1 f2], G as [g1 g2], (clip m B (f1, f2)) as [p1 p2], (clip m B (g1, g2)) as [q1 q2].
  unfold square, dot, minus in *; simpl in *.
  pose proof (Rle_0_sqr (f1 - g1 - (p1 - q1))) as one; pose proof (Rle_0_sqr (f2 - g2 - (p2 - q2))) as two.
  unfold Rsqr in one, two; nra.
Qed.

(* decisions-by-squares *)
Lemma squares_decide : forall a b, 0 <= a -> 0 <= b -> (a <= b <-> a * a <= b * b).
Proof. intros; split; intro; nra. Qed.

Theorem decisions_by_squares : forall x y,
  (Rabs x <= B <-> x * x <= B * B) /\ (B < m <-> B * B < m * m) /\
  (B < m -> (Rabs y <= s <-> y * y <= m * m - B * B)) /\
  (B < m -> (B * Rabs y <= Rabs x * s <-> B * B * (y * y) <= x * x * (m * m - B * B))).
Proof.
  intros x y; pose proof (Rabs_pos x); pose proof (Rabs_pos y).
  repeat split; try (intro; nra); intros.
  - rewrite <- (square_of_magnitude x); nra.
  - rewrite <- (square_of_magnitude x) in *; nra.
  - pose proof (s_squared H1); pose proof (s_positive H1); rewrite <- (square_of_magnitude y); nra.
  - pose proof (s_squared H1); pose proof (s_positive H1); rewrite <- (square_of_magnitude y) in *; nra.
  - pose proof (s_squared H1) as s2; pose proof (s_positive H1).
    rewrite <- (square_of_magnitude y), <- (square_of_magnitude x), <- s2.
    apply squares_decide in H2; [lra | nra | nra].
  - pose proof (s_squared H1) as s2; pose proof (s_positive H1).
    rewrite <- (square_of_magnitude y), <- (square_of_magnitude x), <- s2 in H2.
    apply squares_decide; [nra | nra | lra].
Qed.

End Clip.

Print Assumptions clip_is_in_border.
Print Assumptions clip_is_closest.
Print Assumptions closest_is_unique.
Print Assumptions clip_is_idempotent.
Print Assumptions clip_is_1_Lipschitz.
Print Assumptions decisions_by_squares.
