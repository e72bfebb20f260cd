(* Interior points computed (faces.md, 3): if a generic direction is in the local shape and no leaf bounds, the local
   shape is everything. The walk from that direction towards one that is missing is lemma 1's. *)

From Coq Require Import List Bool ZArith QArith Qabs Lqa.
From Groundtruth Require Import shapes standing faces rewriting simplifications generic same_faces samples finding_faces phi.
Import ListNotations.
Open Scope Q_scope.

Definition open_leaves (s : shape half_space) (p : vector) : list half_space := filter (is_open p) (leaves s).
Definition generic_at (s : shape half_space) (p : vector) : vector := generic (map normal (open_leaves s p)).
Definition interior_found (s : shape half_space) (p : vector) : bool :=
  cone s p (generic_at s p) && negb (existsb (bounds_found s p) (standing (at_point p) s)).

Lemma dot_cross_swap a b c : dot (cross a b) c == dot a (cross b c).
Proof. unfold dot, cross. cbn [local_shape.x local_shape.y local_shape.z]. ring. Qed.

(* A direction in the planes of g and h, if it is also in the plane of v and g's and h's line. *)
Definition plane_through (v : vector) (g h : half_space) : vector := cross v (cross (normal g) (normal h)).

Lemma plane_through_has_a_normal v g h : same_plane g h = false -> ~ dot (normal g) v == 0 ->
  ~ (x (plane_through v g h) == 0 /\ y (plane_through v g h) == 0 /\ z (plane_through v g h) == 0).
Proof.
  intros other nonzero (a & b & c). set (k := cross (normal g) (normal h)).
  assert (positive := not_same_plane g h other). fold k in positive.
  assert (identity : dot (normal g) v * dot k k == dot (cross (normal g) k) (plane_through v g h)
                     + dot (normal g) k * dot v k).
  { unfold plane_through. fold k. unfold dot, cross. cbn [local_shape.x local_shape.y local_shape.z]. ring. }
  assert (in_plane : dot (normal g) k == 0)
    by (unfold k, dot, cross; cbn [local_shape.x local_shape.y local_shape.z]; ring).
  assert (zero : dot (cross (normal g) k) (plane_through v g h) == 0) by (unfold dot; rewrite a, b, c; ring).
  rewrite in_plane, zero in identity. apply nonzero.
  assert (product : dot (normal g) v * dot k k == 0) by lra. apply Qmult_integral in product as [e | e]; trivial. lra.
Qed.

Lemma in_both_planes v g h w : dot (normal g) w == 0 -> dot (normal h) w == 0 -> dot (plane_through v g h) w == 0.
Proof.
  intros one two. unfold plane_through. rewrite dot_cross_swap.
  assert (e : dot v (cross (cross (normal g) (normal h)) w)
              == dot (normal g) w * dot (normal h) v - dot (normal h) w * dot (normal g) v)
    by (unfold dot, cross; cbn [local_shape.x local_shape.y local_shape.z]; ring).
  rewrite e, one, two. ring.
Qed.

Lemma plane_through_holds v g h : dot (plane_through v g h) v == 0.
Proof. unfold plane_through, dot, cross. cbn [local_shape.x local_shape.y local_shape.z]. ring. Qed.

(* A direction that is missing can be moved off finitely many planes, and still is. *)
Lemma missing_is_open s p v planes : cone s p v = false ->
  (forall n, In n planes -> ~ (x n == 0 /\ y n == 0 /\ z n == 0)) ->
  exists w, cone s p w = false /\ forall n, In n planes -> ~ dot n w == 0.
Proof.
  intros missing normals. set (g := generic planes).
  destruct (a_little_keeps_sides (leaves s ++ map (fun n => HalfSpace 0 n 0) planes) v g) as (e & some & keeps).
  exists (plus v (scaled e g)). specialize (keeps e ltac:(lra) ltac:(lra)). split.
  - apply not_true_iff_false. intros inside. apply not_true_iff_false in missing. apply missing.
    revert inside. apply value_is_monotone. intros h below. unfold holds_along. destruct (at_point p h); trivial.
    rewrite !Qle_bool_iff. destruct (keeps h ltac:(apply in_or_app; now left)) as (up & _). intros less.
    destruct (Qlt_le_dec 0 (dot (normal h) v)) as [above |]; trivial. specialize (up above). lra.
  - intros n there zero. destruct (keeps (HalfSpace 0 n 0)) as (up & down).
    { apply in_or_app. right. apply in_map_iff. now exists n. }
    cbn [normal] in up, down.
    destruct (Qlt_le_dec 0 (dot n v)) as [above |]; [specialize (up above); lra |].
    destruct (Qlt_le_dec (dot n v) 0) as [below |]; [specialize (down below); lra |].
    rewrite dot_plus, dot_scaled in zero. assert (nonzero := generic_is_in_no_plane planes n there (normals n there)).
    fold g in nonzero. apply nonzero. assert (product : e * dot n g == 0) by lra.
    apply Qmult_integral in product as [no |]; trivial. lra.
Qed.

(* The local shape along a segment of directions. *)
Definition turned (v u : vector) (l : Q) : vector := plus v (scaled l u).
Definition along_turn (p v u : vector) (h : half_space) : course :=
  match at_point p h with
  | Yes => Course (local_shape.number h) (-1) 0
  | No => Course (local_shape.number h) 1 0
  | Open => Course (local_shape.number h) (dot (normal h) v) (dot (normal h) u)
  end.

Lemma is_in_turn s p v u l : is_in (mapped (along_turn p v u) s) l <-> cone s p (turned v u l) = true.
Proof.
  unfold is_in, cone. rewrite value_mapped. rewrite (value_extensional s _ (holds_along p (turned v u l))); [tauto |].
  intros h _. unfold holds_at, holds_along, along_turn, turned, recursion.delta.
  destruct (at_point p h); apply eq_iff_eq_true; rewrite ?Qle_bool_iff, ?dot_plus, ?dot_scaled;
    cbn [at_origin slope]; split; try easy; intros; try lra; try (exfalso; lra).
Qed.

Lemma leaves_mapped {L M} (f : L -> M) s : leaves (mapped f s) = map f (leaves s).
Proof.
  induction s as [leaf | ss IH | ss IH] using shape_induction; simpl; trivial;
    induction IH as [| s ss same _ rest]; simpl; trivial; now rewrite map_app, same, rest.
Qed.

Lemma parallel_side i h u : same_plane i h = true -> 0 < dot (normal i) u ->
  dot (normal h) (normal i) <= 0 -> dot (normal h) u <= 0.
Proof.
  unfold same_plane. rewrite !andb_true_iff, !Qeq_bool_iff. intros ((a & b) & c) above against.
  assert (identity : dot (normal i) (normal i) * dot (normal h) u == dot (normal i) u * dot (normal h) (normal i)
    + (y (normal i) * z (normal h) - z (normal i) * y (normal h)) * (y (normal i) * z u - z (normal i) * y u)
    + (z (normal i) * x (normal h) - x (normal i) * z (normal h)) * (z (normal i) * x u - x (normal i) * z u)
    + (x (normal i) * y (normal h) - y (normal i) * x (normal h)) * (x (normal i) * y u - y (normal i) * x u))
    by (unfold dot; ring).
  rewrite a, b, c in identity.
  assert (square : 0 < dot (normal i) (normal i)).
  { assert (sq : forall q : Q, 0 <= q * q) by (intros q; nra).
    assert (sx := sq (x (normal i))). assert (sy := sq (y (normal i))). assert (sz := sq (z (normal i))).
    destruct (Qlt_le_dec 0 (dot (normal i) (normal i))) as [| none]; trivial. exfalso.
    assert (root : forall q : Q, q * q == 0 -> q == 0) by (intros q e; apply Qmult_integral in e; tauto).
    unfold dot in none. assert (zx : x (normal i) == 0) by (apply root; lra).
    assert (zy : y (normal i) == 0) by (apply root; lra). assert (zz : z (normal i) == 0) by (apply root; lra).
    unfold dot in above. rewrite zx, zy, zz in above. lra. }
  destruct (Qlt_le_dec 0 (dot (normal h) u)) as [more |]; trivial. exfalso. nra.
Qed.

(* Leaves whose planes do not hold w, at their values there. *)
Definition beside_all (p w : vector) (h : half_space) : truth :=
  match at_point p h with
  | Open => if Qeq_bool (dot (normal h) w) 0 then Open else if Qle_bool (dot (normal h) w) 0 then Yes else No
  | known => known
  end.

(* Where the walk enters the local shape some leaf bounds. *)
Lemma entered_where_a_leaf_bounds s p w u : cone s p w = true ->
  (forall g h, In g (open_leaves s p) -> In h (open_leaves s p) -> same_plane g h = false ->
     ~ (dot (normal g) w == 0 /\ dot (normal h) w == 0)) ->
  (forall far, 0 < far -> exists t, 0 < t /\ t <= far /\ cone s p (plus w (scaled t u)) = false) ->
  exists i, bounds s p i.
Proof.
  intros inside apart leaving.
  destruct (a_little_keeps_sides (leaves s) w u) as (e & some & keeps).
  destruct (leaving e some) as (t & from & to & outside).
  assert (possible : evaluate (beside_all p w) s <> No).
  { intros no. assert (agrees : respects (holds_along p w) (beside_all p w)).
    { intros h. unfold beside_all, holds_along. destruct (at_point p h); trivial.
      destruct (Qeq_bool _ 0); trivial. destruct (Qle_bool _ 0) eqn:side; trivial. }
    assert (sure := known_values_hold s agrees). rewrite no in sure. unfold cone in inside. congruence. }
  assert (agrees : forall h, In h (leaves s) ->
    match beside_all p w h with Yes => holds_along p (plus w (scaled t u)) h = true
    | No => holds_along p (plus w (scaled t u)) h = false | Open => True end).
  { intros h below. unfold beside_all, holds_along. destruct (at_point p h); trivial.
    destruct (Qeq_bool (dot (normal h) w) 0) eqn:zero; trivial. apply Qeq_bool_neq in zero.
    rewrite <- (le_by_sides _ _ _ (keeps t ltac:(lra) to h below) zero). now destruct (Qle_bool _ 0). }
  set (v_ := fun h => match beside_all p w h with Yes => true | No => false | Open => holds_along p (plus w (scaled t u)) h end).
  assert (same_value : value v_ s = false).
  { rewrite <- outside. apply value_extensional. intros h below. unfold v_. specialize (agrees h below).
    destruct (beside_all p w h); congruence. }
  destruct (existsb (fun i => negb (v_ i)) (standing (beside_all p w) s)) eqn:fails.
  2: { exfalso. apply not_true_iff_false in same_value. apply same_value.
       apply standing_leaves_decide with (beside_all p w); trivial.
       - intros h. unfold v_. now destruct (beside_all p w h).
       - intros i stands. destruct (v_ i) eqn:holds; trivial. exfalso. apply not_true_iff_false in fails. apply fails.
         apply existsb_exists. exists i. split; trivial. now rewrite holds. }
  apply existsb_exists in fails as (i & stands & fails). exists i. apply negb_true_iff in fails.
  destruct (standing_leaf_is_open _ _ _ stands) as (known & below).
  assert (open : at_point p i = Open) by (unfold beside_all in known; now destruct (at_point p i)).
  assert (in_plane : dot (normal i) w == 0).
  { unfold beside_all in known. rewrite open in known. destruct (Qeq_bool _ 0) eqn:zero; [now apply Qeq_bool_iff |].
    now destruct (Qle_bool _ 0). }
  assert (rises : 0 < dot (normal i) u).
  { unfold v_ in fails. rewrite known in fails. unfold holds_along in fails. rewrite open in fails.
    rewrite <- not_true_iff_false, Qle_bool_iff, dot_plus, dot_scaled, in_plane in fails.
    destruct (Qlt_le_dec 0 (dot (normal i) u)); trivial. exfalso. apply fails. nra. }
  assert (is_open_ : forall h, In h (leaves s) -> at_point p h = Open -> In h (open_leaves s p))
    by (intros h there open_h; apply filter_In; split; trivial; now apply is_open_iff).
  assert (off_ : forall h, In h (leaves s) -> at_point p h = Open -> same_plane i h = false -> ~ dot (normal h) w == 0)
    by (intros h there open_h other zero; apply (apart i h); auto).
  assert (flat := open_has_normal p i open).
  split; trivial. exists w. split; trivial. split; trivial. split; trivial. split.
  - assert (off_w : off (filter (crosses p i) (leaves s)) w).
    { intros h. rewrite filter_In, crosses_iff. intros (there & open_h & other). auto. }
    destruct (outward_is_near s p i w open in_plane off_w) as (f & some_f & near). exists f. split; trivial.
    intros r from_r to_r. rewrite near by trivial. apply not_true_iff_false. intros holds.
    apply not_true_iff_false in outside. apply outside. revert holds. apply value_is_monotone.
    intros h there. unfold outward, holds_along. destruct (at_point p h) eqn:open_h; trivial.
    destruct (same_plane i h) eqn:plane.
    + rewrite !Qle_bool_iff, dot_plus, dot_scaled, (in_same_plane i h w plane flat in_plane). intros against.
      assert (side := parallel_side i h u plane rises against). nra.
    + intros less. rewrite <- less. symmetry. apply le_by_sides; auto. apply keeps; trivial. lra.
  - revert stands. apply standing_extensional. intros h there. unfold beside_all, beside.
    destruct (at_point p h) eqn:open_h; trivial. destruct (same_plane i h) eqn:plane.
    + assert (zero := in_same_plane i h w plane flat in_plane). apply Qeq_bool_iff in zero. now rewrite zero.
    + assert (nonzero := off_ h there open_h plane). destruct (Qeq_bool _ 0) eqn:zero; trivial.
      exfalso. apply nonzero. now apply Qeq_bool_iff.
Qed.

(* No leaf bounds, and a generic direction is in: the local shape is everything. *)
Theorem unbounded_is_everything s p g : (forall h, In h (open_leaves s p) -> ~ dot (normal h) g == 0) ->
  cone s p g = true -> (forall i, ~ bounds s p i) -> forall v, cone s p v = true.
Proof.
  intros generic_ inside none v. destruct (cone s p v) eqn:missing; trivial. exfalso.
  set (hs := open_leaves s p).
  set (planes := flat_map (fun g_ => map (plane_through g g_) (filter (fun h => negb (same_plane g_ h)) hs)) hs).
  destruct (missing_is_open s p v planes missing) as (far & missing_far & off_far).
  { intros n there. apply in_flat_map in there as (a & in_a & there). apply in_map_iff in there as (b & <- & there).
    apply filter_In in there as (_ & other). apply negb_true_iff in other. apply plane_through_has_a_normal; auto. }
  set (u := plus g (scaled (-1) far)).
  set (t := mapped (along_turn p far u) s).
  assert (at_end : is_in t 1).
  { apply is_in_turn. rewrite <- inside. apply value_extensional. intros h _. unfold holds_along.
    destruct (at_point p h); trivial. apply eq_iff_eq_true. rewrite !Qle_bool_iff. unfold turned, u.
    rewrite !dot_plus, !dot_scaled, dot_plus, dot_scaled. split; lra. }
  assert (right_ := @entry_is_right 1 t 0 ltac:(lra)). destruct (entry 1 t 0) as [h | |] eqn:found; simpl in right_; [| | easy].
  2: { apply (right_ 1); trivial; lra. }
  assert (met := @entry_is_start_or_crossing 1 t 0 h ltac:(lra) found).
  destruct right_ as ((from & to) & member_ & before & _).
  assert (beyond : 0 < place h).
  { destruct (Qlt_le_dec 0 (place h)) as [| not]; trivial. exfalso.
    assert (zero : place h == 0) by lra. assert (there := is_in_same zero member_). apply is_in_turn in there.
    rewrite <- not_true_iff_false in missing_far. apply missing_far. rewrite <- there. apply value_extensional.
    intros q _. unfold holds_along, turned. destruct (at_point p q); trivial. apply eq_iff_eq_true.
    rewrite !Qle_bool_iff, dot_plus, dot_scaled. split; lra. }
  set (w := turned far u (place h)). apply is_in_turn in member_. fold w in member_.
  destruct (entered_where_a_leaf_bounds s p w (scaled (-1) u)) as (i & bounding); trivial.
  - intros a b in_a in_b other (zero_a & zero_b).
    assert (zero := in_both_planes g a b w zero_a zero_b).
    assert (off_ : ~ dot (plane_through g a b) far == 0).
    { apply off_far. apply in_flat_map. exists a. split; trivial. apply in_map_iff. exists b. split; trivial.
      apply filter_In. split; trivial. now rewrite other. }
    assert (g_in := plane_through_holds g a b).
    unfold w, turned, u in zero. rewrite dot_plus, dot_scaled, dot_plus, dot_scaled, g_in in zero.
    assert (product : (1 - place h) * dot (plane_through g a b) far == 0) by lra.
    apply Qmult_integral in product as [at_g | e]; [| now apply off_].
    apply (generic_ a in_a). rewrite <- zero_a. unfold w, turned, u. rewrite !dot_plus, !dot_scaled, dot_plus, dot_scaled.
    assert (one : place h == 1) by lra. rewrite one. ring.
  - intros reach some. destruct (below_both reach (place h) some beyond) as (r & above & at_reach & at_place).
    exists r. split; trivial. split; trivial. apply not_true_iff_false. intros there.
    apply (before (place h - r)); try lra. apply is_in_turn. rewrite <- there. apply value_extensional.
    intros q _. unfold holds_along. destruct (at_point p q); trivial. apply eq_iff_eq_true. rewrite !Qle_bool_iff.
    unfold w, turned. rewrite !dot_plus, !dot_scaled. split; lra.
  - now apply (none i).
Qed.

Theorem interior_found_iff s p : interior_found s p = true <-> interior s p.
Proof.
  unfold interior_found. rewrite andb_true_iff, negb_true_iff. split.
  - intros (inside & none). apply interior_iff_local_shape_is_everything.
    apply unbounded_is_everything with (generic_at s p); trivial.
    + intros h there. apply generic_is_in_no_plane; [now apply in_map |].
      apply filter_In in there as (_ & open). apply is_open_iff in open. now apply open_normal_is_not_zero with p.
    + intros i bounding. apply not_true_iff_false in none. apply none, existsb_exists. exists i.
      split; [now apply bounding_leaf_stands | now apply bounds_found_iff].
  - intros inside. split; [now apply interior_iff_local_shape_is_everything |]. apply not_true_iff_false. intros some.
    apply existsb_exists in some as (i & _ & bounding). apply bounds_found_iff in bounding.
    revert bounding. now apply interior_points_have_no_face.
Qed.

Print Assumptions unbounded_is_everything.
Print Assumptions interior_found_iff.
