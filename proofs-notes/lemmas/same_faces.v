(* The converse of `faces_remain`: leaving leaves out makes no new face (scene-rewriting.md, 2). *)

From Coq Require Import List Bool QArith Qabs Lqa.
From Groundtruth Require Import shapes standing faces rewriting simplifications generic.
Import ListNotations.
Open Scope Q_scope.

Lemma standing_extensional {L} (s : shape L) known more : (forall h, In h (leaves s) -> known h = more h) ->
  evaluate known s = evaluate more s /\ (forall h, In h (standing known s) -> In h (standing more s)).
Proof.
  induction s as [one | ss IH | ss IH] using shape_induction; intros same.
  - assert (eq : known one = more one) by (apply same; now left). simpl. now rewrite eq.
  - rewrite Forall_forall in IH.
    assert (below : forall s, In s ss -> evaluate known s = evaluate more s
                     /\ (forall h, In h (standing known s) -> In h (standing more s)))
      by (intros s inside; apply IH; trivial; intros h there; apply same; now apply leaves_of_operand with s).
    assert (value_ : evaluate known (Union ss) = evaluate more (Union ss))
      by (simpl; f_equal; apply map_ext_in; intros s inside; now apply below).
    split; trivial. intros h. rewrite !stands_in_union, value_. intros (open & s & inside & stands).
    split; trivial. exists s. split; trivial. now apply (below s inside).
  - rewrite Forall_forall in IH.
    assert (below : forall s, In s ss -> evaluate known s = evaluate more s
                     /\ (forall h, In h (standing known s) -> In h (standing more s)))
      by (intros s inside; apply IH; trivial; intros h there; apply same; now apply leaves_of_operand with s).
    assert (value_ : evaluate known (Intersection ss) = evaluate more (Intersection ss))
      by (simpl; f_equal; apply map_ext_in; intros s inside; now apply below).
    split; trivial. intros h. rewrite !stands_in_intersection, value_. intros (open & s & inside & stands).
    split; trivial. exists s. split; trivial. now apply (below s inside).
Qed.

(* A normal of the plane of i is a multiple of i's. *)
Lemma in_same_plane i h v : same_plane i h = true -> has_no_normal i = false ->
  dot (normal i) v == 0 -> dot (normal h) v == 0.
Proof.
  unfold same_plane. rewrite !andb_true_iff, !Qeq_bool_iff. intros ((a & b) & c) normal_ zero. unfold dot in *.
  assert (root : forall p q : Q, ~ p == 0 -> p * q == 0 -> q == 0) by (intros p q no e; apply Qmult_integral in e; tauto).
  unfold has_no_normal in normal_. rewrite !andb_false_iff in normal_.
  assert (nonzero : ~ x (normal i) == 0 \/ ~ y (normal i) == 0 \/ ~ z (normal i) == 0).
  { rewrite <- !not_true_iff_false, !Qeq_bool_iff in normal_. tauto. }
  destruct nonzero as [n | [n | n]]; apply (root _ _ n).
  - setoid_replace (x (normal i) * (x (normal h) * x v + y (normal h) * y v + z (normal h) * z v))
      with (x (normal h) * (x (normal i) * x v + y (normal i) * y v + z (normal i) * z v)
            + (x (normal i) * y (normal h) - y (normal i) * x (normal h)) * y v
            - (z (normal i) * x (normal h) - x (normal i) * z (normal h)) * z v) by ring.
    rewrite zero, b, c. ring.
  - setoid_replace (y (normal i) * (x (normal h) * x v + y (normal h) * y v + z (normal h) * z v))
      with (y (normal h) * (x (normal i) * x v + y (normal i) * y v + z (normal i) * z v)
            - (x (normal i) * y (normal h) - y (normal i) * x (normal h)) * x v
            + (y (normal i) * z (normal h) - z (normal i) * y (normal h)) * z v) by ring.
    rewrite zero, a, c. ring.
  - setoid_replace (z (normal i) * (x (normal h) * x v + y (normal h) * y v + z (normal h) * z v))
      with (z (normal h) * (x (normal i) * x v + y (normal i) * y v + z (normal i) * z v)
            + (z (normal i) * x (normal h) - x (normal i) * z (normal h)) * x v
            - (y (normal i) * z (normal h) - z (normal i) * y (normal h)) * y v) by ring.
    rewrite zero, a, b. ring.
Qed.
Print Assumptions in_same_plane.

Lemma le_by_sides n v w : same_side n v w -> ~ dot n v == 0 -> Qle_bool (dot n v) 0 = Qle_bool (dot n w) 0.
Proof.
  intros (up & down) nonzero. apply eq_iff_eq_true. rewrite !Qle_bool_iff.
  destruct (Qlt_le_dec 0 (dot n v)) as [above | not]; [specialize (up above); split; lra |].
  destruct (Qlt_le_dec (dot n v) 0) as [below | no]; [specialize (down below); split; lra | exfalso; apply nonzero; lra].
Qed.

Lemma open_has_normal p h : at_point p h = Open -> has_no_normal h = false.
Proof.
  unfold at_point. destruct (Qlt_le_dec 0 _); [easy |]. destruct (Qlt_le_dec _ 0); [easy |].
  now destruct (has_no_normal h).
Qed.

(* Bounding is decided by the sides of the planes of S alone. *)
Theorem bounds_along_same_sides s p i v w : at_point p i = Open -> bounds_along s p i v -> dot (normal i) w == 0 ->
  (forall h, In h (leaves s) -> same_side (normal h) v w) ->
  cone s p w = true /\ (exists e, 0 < e /\ forall t, 0 < t -> t < e -> cone s p (plus w (scaled t (normal i))) = false)
  /\ In i (standing (beside p w i) s).
Proof.
  intros open (in_plane & generic & inside & (e & some & outside) & stands) in_plane_w sides.
  assert (flat := open_has_normal p i open).
  split; [| split].
  - rewrite <- inside. symmetry. apply value_extensional. intros h below. unfold holds_along.
    destruct (at_point p h) eqn:open_h; trivial. destruct (same_plane i h) eqn:plane.
    + assert (a := in_same_plane i h v plane flat in_plane). assert (b := in_same_plane i h w plane flat in_plane_w).
      apply eq_iff_eq_true. rewrite !Qle_bool_iff. split; lra.
    + apply le_by_sides; auto.
  - destruct (a_little_keeps_sides (leaves s) v (normal i)) as (f & some_f & keeps_f).
    destruct (a_little_keeps_sides (leaves s) w (normal i)) as (g & some_g & keeps_g).
    destruct (below_both f g some_f some_g) as (fg & above & at_f & at_g).
    destruct (below_both fg e above some) as (u & above_u & at_fg & at_e).
    exists u. split; trivial. intros t from to. rewrite <- (outside t from ltac:(lra)). symmetry.
    apply value_extensional. intros h below. unfold holds_along.
    destruct (at_point p h) eqn:open_h; trivial. destruct (same_plane i h) eqn:plane.
    + assert (a := in_same_plane i h v plane flat in_plane). assert (b := in_same_plane i h w plane flat in_plane_w).
      apply eq_iff_eq_true. rewrite !Qle_bool_iff, !dot_plus. split; lra.
    + assert (nonzero := generic h below open_h plane).
      assert (sw := sides h below). assert (nonzero_w : ~ dot (normal h) w == 0).
      { destruct sw as (up & down). intros zero. apply nonzero.
        destruct (Qlt_le_dec 0 (dot (normal h) v)) as [a |]; [specialize (up a); lra |].
        destruct (Qlt_le_dec (dot (normal h) v) 0) as [a |]; [specialize (down a); lra | lra]. }
      assert (kv := keeps_f t ltac:(lra) ltac:(lra) h below). assert (kw := keeps_g t ltac:(lra) ltac:(lra) h below).
      rewrite <- (le_by_sides _ _ _ kv nonzero), <- (le_by_sides _ _ _ kw nonzero_w). now apply le_by_sides.
  - revert stands. apply standing_extensional. intros h below. unfold beside.
    destruct (at_point p h) eqn:open_h; trivial. destruct (same_plane i h) eqn:plane; trivial.
    rewrite (le_by_sides (normal h) v w); auto.
Qed.

Definition here (p : vector) (known : half_space -> truth) : Prop := refines known (at_point p).

Lemma alike_anywhere_is_alike_here s t p : alike somewhere s t -> alike (here p) s t.
Proof. intros a known near. apply a. now exists p. Qed.

Lemma same_local_shape_here s t p v : alike (here p) s t -> cone s p v = cone t p v.
Proof.
  intros a. destruct (a (fun h => as_truth (holds_along p v h))) as (same_value & _).
  - intros h known. unfold holds_along. now destruct (at_point p h).
  - rewrite !decided_value in same_value. unfold cone. now destruct (value _ s), (value _ t).
Qed.

Theorem no_new_faces s t p i : alike (here p) s t -> bounds t p i -> bounds s p i.
Proof.
  intros a (open & v & along). split; trivial.
  destruct (direction_can_be_made_generic i (leaves s ++ leaves t) v (proj1 along)) as (w & in_plane & good).
  destruct (bounds_along_same_sides t p i v w open along in_plane) as (inside & (e & some & outside) & stands).
  { intros h below. apply good. apply in_or_app. now right. }
  exists w. split; trivial. split; [| split; [| split]].
  - intros h below _ other. apply good; trivial. apply in_or_app. now left.
  - now rewrite (same_local_shape_here s t).
  - exists e. split; trivial. intros r from to. rewrite (same_local_shape_here s t) by trivial. auto.
  - destruct (a (beside p w i)) as (_ & same_leaves); [| now apply same_leaves].
    intros h known. unfold beside. now destruct (at_point p h).
Qed.

(* Solids alike at p have the same faces there and the same admissible leaves. *)
Theorem alike_here_have_the_same_faces s t p u i : alike (here p) s t ->
  (bounds s p i <-> bounds t p i) /\ (admissible s p u i <-> admissible t p u i).
Proof.
  intros a. assert (b := alike_symmetric a).
  assert (faces_ : forall h, bounds s p h <-> bounds t p h) by (intros h; split; now apply no_new_faces).
  assert (stand : In i (standing (at_point p) s) <-> In i (standing (at_point p) t)) by (apply a; now intros h _).
  split; [apply faces_ |]. unfold admissible. rewrite stand, (faces_ i).
  assert (none : (forall h, ~ (bounds s p h /\ counts u h)) <-> (forall h, ~ (bounds t p h /\ counts u h)))
    by (split; intros all_ h; [rewrite <- faces_ | rewrite faces_]; apply all_).
  now rewrite none.
Qed.

Corollary alike_have_the_same_faces s t p u i : alike somewhere s t ->
  (bounds s p i <-> bounds t p i) /\ (admissible s p u i <-> admissible t p u i).
Proof. intros a. now apply alike_here_have_the_same_faces, alike_anywhere_is_alike_here. Qed.

Print Assumptions bounds_along_same_sides.
Print Assumptions no_new_faces.
Print Assumptions alike_here_have_the_same_faces.
Print Assumptions alike_have_the_same_faces.
