(* The face rule computed (SPEC section 3; faces.md, 8): that some direction shows a leaf to bound is decided by
   trying one direction in each sector of its plane. *)

From Coq Require Import List Bool Arith ZArith QArith Qabs Lqa.
From Groundtruth Require Import shapes standing faces rewriting simplifications generic same_faces samples.
Import ListNotations.
Open Scope Q_scope.

(* Two directions that span the plane with normal n. *)
Definition basis (n : vector) : vector * vector :=
  if Qeq_bool (z n) 0 then
    if Qeq_bool (y n) 0 then (Vector 0 1 0, Vector 0 0 1) else (Vector (y n) (- x n) 0, Vector 0 0 1)
  else (Vector (z n) 0 (- x n), Vector 0 (z n) (- y n)).

Definition is_open (p : vector) (h : half_space) : bool :=
  match at_point p h with Open => true | _ => false end.

(* Where the line t a + b meets the planes. *)
Definition meetings (a b : vector) (hs : list half_space) : list Q :=
  flat_map (fun h => if Qeq_bool (dot (normal h) a) 0 then [] else [- dot (normal h) b / dot (normal h) a]) hs.

Definition directions (hs : list half_space) (n : vector) : list vector :=
  let (a, b) := basis n in
  let on_line := map (fun t => plus (scaled t a) b) (samples (meetings a b hs)) in
  on_line ++ map (scaled (-1)) on_line.

(* A little outward of v from the face of leaf i. *)
Definition outward (p v : vector) (i h : half_space) : bool :=
  match at_point p h with
  | Yes => true
  | No => false
  | Open => Qle_bool (dot (normal h) (if same_plane i h then normal i else v)) 0
  end.

Definition rationals_are_same (a b : Q) : {a = b} + {a <> b}.
Proof. decide equality; [apply Pos.eq_dec | apply Z.eq_dec]. Defined.
Definition vectors_are_same (a b : vector) : {a = b} + {a <> b}.
Proof. decide equality; apply rationals_are_same. Defined.
Definition half_spaces_are_same (g h : half_space) : {g = h} + {g <> h}.
Proof. decide equality; [apply rationals_are_same | apply vectors_are_same | apply Nat.eq_dec]. Defined.

Definition crosses (p : vector) (i h : half_space) : bool := is_open p h && negb (same_plane i h).

Definition shows_bound (s : shape half_space) (p : vector) (i : half_space) (v : vector) : bool :=
  forallb (fun h => negb (crosses p i h) || negb (Qeq_bool (dot (normal h) v) 0)) (leaves s)
  && cone s p v && negb (value (outward p v i) s)
  && if in_dec half_spaces_are_same i (standing (beside p v i) s) then true else false.

Definition bounds_found (s : shape half_space) (p : vector) (i : half_space) : bool :=
  is_open p i && existsb (shows_bound s p i) (directions (filter (crosses p i) (leaves s)) (normal i)).

Definition counts_found (u : option vector) (i : half_space) : bool :=
  match u with Some u => negb (Qle_bool 0 (dot (normal i) u)) | None => true end.

Definition admissible_leaves (s : shape half_space) (p : vector) (u : option vector) : list half_space :=
  let stand := filter (counts_found u) (standing (at_point p) s) in
  match filter (bounds_found s p) stand with [] => stand | bounding => bounding end.

Lemma is_open_iff p h : is_open p h = true <-> at_point p h = Open.
Proof. unfold is_open. destruct (at_point p h); split; easy. Qed.

Lemma basis_spans n v : ~ (x n == 0 /\ y n == 0 /\ z n == 0) -> dot n v == 0 ->
  exists s t, forall m, dot m v == s * dot m (fst (basis n)) + t * dot m (snd (basis n)).
Proof.
  intros normal_ in_plane. unfold basis. destruct (Qeq_bool (z n) 0) eqn:flat.
  - apply Qeq_bool_iff in flat. destruct (Qeq_bool (y n) 0) eqn:level.
    + apply Qeq_bool_iff in level. assert (zero : x v == 0).
      { assert (x n * x v == 0) as product by (unfold dot in in_plane; rewrite level, flat in in_plane; lra).
        apply Qmult_integral in product as [e | e]; trivial. exfalso. apply normal_. now split. }
      exists (y v), (z v). intros m. unfold dot. cbn [fst snd local_shape.x local_shape.y local_shape.z]. rewrite zero. ring.
    + apply Qeq_bool_neq in level. exists (x v / y n), (z v). intros m.
      assert (sum : y v == - x n * (x v / y n)).
      { unfold dot in in_plane. rewrite flat in in_plane.
        setoid_replace (y v) with ((x n * x v + y n * y v + 0 * z v) / y n - x n * (x v / y n)) by (field; trivial).
        rewrite in_plane. field. trivial. }
      unfold dot. cbn [fst snd local_shape.x local_shape.y local_shape.z]. rewrite sum. field. trivial.
  - apply Qeq_bool_neq in flat. exists (x v / z n), (y v / z n). intros m.
    assert (sum : z v == - x n * (x v / z n) - y n * (y v / z n)).
    { unfold dot in in_plane.
      setoid_replace (z v) with ((x n * x v + y n * y v + z n * z v) / z n - x n * (x v / z n) - y n * (y v / z n))
        by (field; trivial).
      rewrite in_plane. field. trivial. }
    unfold dot. cbn [fst snd local_shape.x local_shape.y local_shape.z]. rewrite sum. field. trivial.
Qed.

Lemma basis_is_in_plane n : dot n (fst (basis n)) == 0 /\ dot n (snd (basis n)) == 0.
Proof.
  unfold basis. destruct (Qeq_bool (z n) 0) eqn:flat; [apply Qeq_bool_iff in flat; destruct (Qeq_bool (y n) 0) eqn:level |];
    try apply Qeq_bool_iff in level; unfold dot; cbn [fst snd local_shape.x local_shape.y local_shape.z];
    rewrite ?flat, ?level; split; ring.
Qed.

Lemma directions_are_in_plane hs n v : In v (directions hs n) -> dot n v == 0.
Proof.
  unfold directions. destruct (basis_is_in_plane n) as (one & two). destruct (basis n) as (a, b). simpl in one, two.
  intros inside. apply in_app_or in inside.
  assert (on_line : forall v, In v (map (fun t => plus (scaled t a) b) (samples (meetings a b hs))) -> dot n v == 0).
  { intros w there. apply in_map_iff in there as (t & <- & _). rewrite dot_plus, dot_scaled, one, two. ring. }
  destruct inside as [there | there]; [auto |].
  apply in_map_iff in there as (w & <- & there). rewrite dot_scaled, (on_line w there). ring.
Qed.

(* A direction on the line t a + b, or opposite, has a sample on its side of every plane. *)
Lemma sample_on_line a b hs t sign : (sign == 1 \/ sign == -1) ->
  (forall h, In h hs -> ~ dot (normal h) (plus (scaled t a) b) == 0) ->
  exists c, In c (samples (meetings a b hs)) /\ forall h, In h hs ->
    same_side (normal h) (scaled sign (plus (scaled t a) b)) (scaled sign (plus (scaled c a) b)).
Proof.
  intros one off.
  destruct (samples_are_in_every_gap (meetings a b hs) t) as (c & inside & gap).
  { intros r meets same. apply in_flat_map in meets as (h & there & meets).
    destruct (Qeq_bool (dot (normal h) a) 0) eqn:along; [easy |]. apply Qeq_bool_neq in along.
    destruct meets as [<- | []]. apply (off h there). rewrite dot_plus, dot_scaled, same. field. trivial. }
  exists c. split; trivial. intros h there. specialize (off h there).
  set (p := dot (normal h) a) in *. set (q := dot (normal h) b) in *.
  assert (at_ : forall t, dot (normal h) (plus (scaled t a) b) == t * p + q) by (intros; rewrite dot_plus, dot_scaled; reflexivity).
  rewrite at_ in off.
  assert (sides : (0 < t * p + q -> 0 < c * p + q) /\ (t * p + q < 0 -> c * p + q < 0)).
  { destruct (Qeq_bool p 0) eqn:along.
    - apply Qeq_bool_iff in along. rewrite along. split; intros; lra.
    - assert (meets : In (- q / p) (meetings a b hs)).
      { apply in_flat_map. exists h. split; trivial. fold p q. rewrite along. now left. }
      apply Qeq_bool_neq in along. destruct (gap _ meets) as (up & down). set (r := - q / p) in *.
      assert (q_is : q == - (r * p)) by (unfold r; field; trivial).
      destruct (Qlt_le_dec 0 p) as [rises | falls]; [| assert (p < 0) by (destruct (Qlt_le_dec p 0); trivial; exfalso; apply along; lra)].
      + split; intros order; rewrite q_is in *.
        * assert (r < t) by nra. specialize (down H). nra.
        * assert (t < r) by nra. specialize (up H). nra.
      + split; intros order; rewrite q_is in *.
        * assert (t < r) by nra. specialize (up H0). nra.
        * assert (r < t) by nra. specialize (down H0). nra. }
  unfold same_side. rewrite !dot_scaled, !at_. destruct one as [-> | ->]; split; intros; destruct sides as (up & down).
  - assert (0 < c * p + q) by (apply up; lra). lra.
  - assert (c * p + q < 0) by (apply down; lra). lra.
  - assert (c * p + q < 0) by (apply down; lra). lra.
  - assert (0 < c * p + q) by (apply up; lra). lra.
Qed.

Lemma crosses_iff p i h : crosses p i h = true <-> at_point p h = Open /\ same_plane i h = false.
Proof. unfold crosses. rewrite andb_true_iff, is_open_iff, negb_true_iff. tauto. Qed.

Definition off (hs : list half_space) (v : vector) : Prop := forall h, In h hs -> ~ dot (normal h) v == 0.

Lemma same_side_nonzero n v w : same_side n v w -> ~ dot n v == 0 -> ~ dot n w == 0.
Proof.
  intros (up & down) nonzero zero. apply nonzero.
  destruct (Qlt_le_dec 0 (dot n v)) as [a |]; [specialize (up a); lra |].
  destruct (Qlt_le_dec (dot n v) 0) as [a |]; [specialize (down a); lra | lra].
Qed.

Theorem directions_reach_every_sector hs n v : ~ (x n == 0 /\ y n == 0 /\ z n == 0) -> dot n v == 0 -> off hs v ->
  exists w, In w (directions hs n) /\ forall h, In h hs -> same_side (normal h) v w.
Proof.
  intros normal_ in_plane off_v. destruct (basis_spans n v normal_ in_plane) as (s & t & spans).
  unfold directions. destruct (basis n) as (a, b). cbn [fst snd] in spans.
  destruct (a_little_keeps_sides hs v b) as (e & some & keeps).
  assert (exists r, 0 <= r /\ r <= e /\ ~ t + r == 0) as (r & from & to & tilted).
  { destruct (Qeq_dec (t + e) 0); [exists 0 | exists e]; split; try lra; split; try lra. }
  assert (sides := keeps r from to). set (u := t + r) in *.
  assert (nonzero : forall h, In h hs -> ~ s * dot (normal h) a + u * dot (normal h) b == 0).
  { intros h there zero. apply (same_side_nonzero _ _ _ (sides h there) (off_v h there)).
    rewrite dot_plus, dot_scaled, spans. unfold u in zero. lra. }
  assert (moved : forall h, dot (normal h) (plus v (scaled r b)) == u * dot (normal h) (plus (scaled (s / u) a) b)).
  { intros h. rewrite !dot_plus, !dot_scaled, spans. unfold u. field. exact tilted. }
  assert (off_line : forall h, In h hs -> ~ dot (normal h) (plus (scaled (s / u) a) b) == 0).
  { intros h there zero. apply (nonzero h there). rewrite dot_plus, dot_scaled in zero.
    transitivity (u * (s / u * dot (normal h) a + dot (normal h) b)); [field; trivial | rewrite zero; ring]. }
  destruct (Qlt_le_dec 0 u) as [positive | not_positive].
  - destruct (sample_on_line a b hs (s / u) 1 ltac:(left; reflexivity) off_line) as (c & inside & gap).
    exists (plus (scaled c a) b). split.
    + apply in_or_app. left. apply in_map_iff. now exists c.
    + intros h there. destruct (sides h there) as (up & down), (gap h there) as (up' & down').
      rewrite moved in up, down. rewrite !dot_scaled in up', down'.
      set (q := dot (normal h) (plus (scaled (s / u) a) b)) in *.
      split; intros order; [specialize (up order) | specialize (down order)].
      * assert (0 < q) by nra. assert (0 < 1 * q) by lra. specialize (up' H0). lra.
      * assert (q < 0) by nra. assert (1 * q < 0) by lra. specialize (down' H0). lra.
  - assert (negative : u < 0) by (destruct (Qlt_le_dec u 0); trivial; exfalso; apply tilted; lra).
    destruct (sample_on_line a b hs (s / u) (-1) ltac:(right; reflexivity) off_line) as (c & inside & gap).
    exists (scaled (-1) (plus (scaled c a) b)). split.
    + apply in_or_app. right. apply in_map, in_map_iff. now exists c.
    + intros h there. destruct (sides h there) as (up & down), (gap h there) as (up' & down').
      rewrite moved in up, down. rewrite (dot_scaled (normal h) (-1) (plus (scaled (s / u) a) b)) in up', down'.
      set (q := dot (normal h) (plus (scaled (s / u) a) b)) in *.
      split; intros order; [specialize (up order); apply up' | specialize (down order); apply down']; nra.
Qed.

Lemma outward_is_near s p i v : at_point p i = Open -> dot (normal i) v == 0 ->
  off (filter (crosses p i) (leaves s)) v ->
  exists e, 0 < e /\ forall t, 0 < t -> t < e -> cone s p (plus v (scaled t (normal i))) = value (outward p v i) s.
Proof.
  intros open in_plane off_v. assert (flat := open_has_normal p i open).
  destruct (a_little_keeps_sides (leaves s) v (normal i)) as (e & some & keeps). exists e. split; trivial.
  intros t from to. apply value_extensional. intros h below. unfold holds_along, outward.
  destruct (at_point p h) eqn:open_h; trivial. destruct (same_plane i h) eqn:plane.
  - assert (zero := in_same_plane i h v plane flat in_plane).
    apply eq_iff_eq_true. rewrite !Qle_bool_iff, dot_plus, dot_scaled, zero. split; nra.
  - symmetry. apply le_by_sides; [apply keeps; trivial; lra |]. apply off_v, filter_In.
    split; trivial. now apply crosses_iff.
Qed.

Theorem shows_bound_iff s p i v : at_point p i = Open -> dot (normal i) v == 0 ->
  (shows_bound s p i v = true <-> bounds_along s p i v).
Proof.
  intros open in_plane. unfold shows_bound, bounds_along. rewrite !andb_true_iff, negb_true_iff.
  assert (generic_iff : forallb (fun h => negb (crosses p i h) || negb (Qeq_bool (dot (normal h) v) 0)) (leaves s) = true
                        <-> off (filter (crosses p i) (leaves s)) v).
  { rewrite forallb_forall. unfold off. split; intros all_ h.
    - rewrite filter_In. intros (below & crosses_) zero. specialize (all_ h below). rewrite crosses_ in all_. simpl in all_.
      apply Qeq_bool_iff in zero. now rewrite zero in all_.
    - intros below. destruct (crosses p i h) eqn:crosses_; trivial. simpl. apply negb_true_iff, not_true_iff_false.
      rewrite Qeq_bool_iff. apply all_, filter_In. now split. }
  rewrite generic_iff.
  assert (spelt : off (filter (crosses p i) (leaves s)) v <->
    forall h, In h (leaves s) -> at_point p h = Open -> same_plane i h = false -> ~ dot (normal h) v == 0).
  { unfold off. split; intros all_ h.
    - intros below open_h other. apply all_, filter_In. split; trivial. now apply crosses_iff.
    - rewrite filter_In, crosses_iff. intros (below & open_h & other). auto. }
  rewrite <- spelt. destruct (in_dec half_spaces_are_same i (standing (beside p v i) s)) as [stands | falls].
  - split.
    + intros (((off_v & inside) & outside) & _). split; trivial. split; trivial. split; trivial. split; trivial.
      destruct (outward_is_near s p i v open in_plane off_v) as (e & some & near). exists e. split; trivial.
      intros t from to. now rewrite near.
    + intros (_ & off_v & inside & (e & some & outside) & _). split; trivial. split; [now split |].
      destruct (outward_is_near s p i v open in_plane off_v) as (f & some_f & near).
      destruct (below_both e f some some_f) as (u & above & at_e & at_f).
      assert (half : u / 2 * 2 == u) by field. rewrite <- (near (u / 2)) by lra. apply outside; lra.
  - split; [intros (_ & no); easy | intros (_ & _ & _ & _ & stands); easy].
Qed.

Lemma shows_bound_on_same_sides s p i v w : at_point p i = Open -> dot (normal i) v == 0 -> dot (normal i) w == 0 ->
  (forall h, In h (filter (crosses p i) (leaves s)) -> same_side (normal h) v w) ->
  shows_bound s p i v = true -> shows_bound s p i w = true.
Proof.
  intros open in_plane in_plane_w sides. assert (flat := open_has_normal p i open).
  unfold shows_bound. rewrite !andb_true_iff. intros (((off_v & inside) & outside) & stands).
  rewrite forallb_forall in off_v.
  assert (nonzero : forall h, In h (leaves s) -> at_point p h = Open -> same_plane i h = false -> ~ dot (normal h) v == 0).
  { intros h below open_h other zero. specialize (off_v h below).
    rewrite (proj2 (crosses_iff p i h) (conj open_h other)) in off_v. apply Qeq_bool_iff in zero. now rewrite zero in off_v. }
  assert (sides_ : forall h, In h (leaves s) -> at_point p h = Open -> same_plane i h = false -> same_side (normal h) v w)
    by (intros h below open_h other; apply sides, filter_In; split; trivial; now apply crosses_iff).
  assert (same : forall h, In h (leaves s) -> at_point p h = Open -> same_plane i h = false ->
                 Qle_bool (dot (normal h) v) 0 = Qle_bool (dot (normal h) w) 0)
    by (intros; apply le_by_sides; auto).
  split; [split; [split |] |].
  - apply forallb_forall. intros h below. destruct (crosses p i h) eqn:c; trivial. simpl.
    apply crosses_iff in c as (open_h & other). apply negb_true_iff, not_true_iff_false. rewrite Qeq_bool_iff.
    apply (same_side_nonzero _ v); auto.
  - rewrite <- inside. symmetry. apply value_extensional. intros h below. unfold holds_along.
    destruct (at_point p h) eqn:open_h; trivial. destruct (same_plane i h) eqn:plane; auto.
    assert (a := in_same_plane i h v plane flat in_plane). assert (b := in_same_plane i h w plane flat in_plane_w).
    apply eq_iff_eq_true. rewrite !Qle_bool_iff. split; lra.
  - rewrite <- outside. f_equal. symmetry. apply value_extensional. intros h below. unfold outward.
    destruct (at_point p h) eqn:open_h; trivial. destruct (same_plane i h) eqn:plane; auto.
  - destruct (in_dec half_spaces_are_same i (standing (beside p v i) s)) as [there |]; [| easy].
    destruct (in_dec _ i (standing (beside p w i) s)) as [| gone]; trivial. exfalso. apply gone. revert there.
    apply standing_extensional. intros h below. unfold beside.
    destruct (at_point p h) eqn:open_h; trivial. destruct (same_plane i h) eqn:plane; trivial. now rewrite same.
Qed.

Lemma open_normal_is_not_zero p i : at_point p i = Open -> ~ (x (normal i) == 0 /\ y (normal i) == 0 /\ z (normal i) == 0).
Proof.
  intros open (a & b & c). assert (flat := open_has_normal p i open). unfold has_no_normal in flat.
  apply Qeq_bool_iff in a, b, c. rewrite a, b, c in flat. easy.
Qed.

Theorem bounds_found_iff s p i : bounds_found s p i = true <-> bounds s p i.
Proof.
  unfold bounds_found, bounds. rewrite andb_true_iff, is_open_iff, existsb_exists. split; intros (open & some).
  - split; trivial. destruct some as (v & tried & shows). exists v. apply shows_bound_iff; trivial.
    now apply directions_are_in_plane in tried.
  - split; trivial. destruct some as (v & along). assert (in_plane := proj1 along).
    assert (off_v : off (filter (crosses p i) (leaves s)) v).
    { intros h. rewrite filter_In, crosses_iff. intros (below & open_h & other). now apply along. }
    destruct (directions_reach_every_sector _ _ v (open_normal_is_not_zero p i open) in_plane off_v) as (w & tried & sides).
    exists w. split; trivial. apply shows_bound_on_same_sides with v; trivial.
    + now apply directions_are_in_plane in tried.
    + now apply shows_bound_iff.
Qed.

Lemma counts_found_iff u i : counts_found u i = true <-> counts u i.
Proof.
  destruct u as [u |]; simpl; [| tauto]. rewrite negb_true_iff, <- not_true_iff_false, Qle_bool_iff. split; intros; lra.
Qed.

Lemma bounding_leaf_stands s p h : bounds s p h -> In h (standing (at_point p) s).
Proof.
  intros (_ & v & _ & _ & _ & _ & stands). revert stands. apply standing_refined. intros g known. unfold beside.
  now destruct (at_point p g).
Qed.

(* SPEC section 3, rules 1 and 2, are computed. *)
Theorem admissible_leaves_are_right s p u i : In i (admissible_leaves s p u) <-> admissible s p u i.
Proof.
  unfold admissible_leaves, admissible. set (stand := filter (counts_found u) (standing (at_point p) s)).
  assert (stand_iff : forall h, In h stand <-> In h (standing (at_point p) s) /\ counts u h)
    by (intros h; unfold stand; rewrite filter_In, counts_found_iff; tauto).
  assert (bound_iff : forall h, In h (filter (bounds_found s p) stand) <-> bounds s p h /\ counts u h).
  { intros h. rewrite filter_In, bounds_found_iff, stand_iff. split; [tauto |]. intros (bounding & counted).
    split; trivial. split; trivial. now apply bounding_leaf_stands. }
  destruct (filter (bounds_found s p) stand) as [| one rest] eqn:found.
  - rewrite stand_iff. split.
    + intros (stands & counted). right. split; [| now split]. intros h rule_1. now apply bound_iff in rule_1.
    + intros [rule_1 | (_ & stands)]; [| tauto]. now apply bound_iff in rule_1.
  - rewrite bound_iff. split; [now left |]. intros [rule_1 | (none & _)]; trivial.
    exfalso. apply (none one). apply bound_iff. now left.
Qed.

Print Assumptions directions_reach_every_sector.
Print Assumptions bounds_found_iff.
Print Assumptions admissible_leaves_are_right.
