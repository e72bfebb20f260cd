(* Lemma 3: which leaves are faces of the solid at a point (SPEC section 3; proofs-notes/faces.md). *)

From Coq Require Import List Bool Permutation QArith Qabs Lqa.
From Groundtruth Require Import shapes standing.
From Groundtruth Require Export local_shape.
Import ListNotations.
Open Scope Q_scope.

Definition same_plane (g h : half_space) : bool :=
  let a := normal g in let b := normal h in
  Qeq_bool (y a * z b) (z a * y b) && Qeq_bool (z a * x b) (x a * z b) && Qeq_bool (x a * y b) (y a * x b).

(* Leaves of another plane than that of i replaced by their values at v. *)
Definition beside (p v : vector) (i h : half_space) : truth :=
  match at_point p h with
  | Open => if same_plane i h then Open else if Qle_bool (dot (normal h) v) 0 then Yes else No
  | known => known
  end.

Definition bounds_along (s : shape half_space) (p : vector) (i : half_space) (v : vector) : Prop :=
  dot (normal i) v == 0
  /\ (forall h, In h (leaves s) -> at_point p h = Open -> same_plane i h = false -> ~ dot (normal h) v == 0)
  /\ cone s p v = true
  /\ (exists e, 0 < e /\ forall t, 0 < t -> t < e -> cone s p (plus v (scaled t (normal i))) = false)
  /\ In i (standing (beside p v i) s).
Definition bounds (s : shape half_space) (p : vector) (i : half_space) : Prop :=
  at_point p i = Open /\ exists v, bounds_along s p i v.

(* Rules 1 and 2; a leaf counts if the start is met, or the leaf entered by segments in the direction u. *)
Definition counts (u : option vector) (i : half_space) : Prop :=
  match u with Some u => dot (normal i) u < 0 | None => True end.
Definition admissible (s : shape half_space) (p : vector) (u : option vector) (i : half_space) : Prop :=
  (bounds s p i /\ counts u i)
  \/ ((forall h, ~ (bounds s p h /\ counts u h)) /\ In i (standing (at_point p) s) /\ counts u i).

Theorem interior_points_have_no_face s p i : interior s p -> ~ bounds s p i.
Proof.
  rewrite interior_iff_local_shape_is_everything. intros everywhere (_ & v & _ & _ & _ & (e & some & outside) & _).
  assert (false_ := outside (e / 2) ltac:(apply Qlt_shift_div_l; lra) ltac:(apply Qlt_shift_div_r; lra)).
  now rewrite everywhere in false_.
Qed.

(* A leaf that bounds lies on the topological border, at points of its plane as near as one likes. *)
Theorem bounding_leaf_is_on_the_border s p i v : bounds_along s p i v ->
  exists far, 0 < far /\ forall t, 0 < t -> t <= far -> member s (plus p (scaled t v)) /\ ~ interior s (plus p (scaled t v)).
Proof.
  intros (_ & _ & in_cone & (e0 & some0 & outside) & _).
  destruct (solid_is_local_shape s p) as (e & some & near).
  assert (half : 0 < e / 2) by (apply Qlt_shift_div_l; lra). assert (halves : e / 2 + e / 2 == e) by field.
  destruct (scaled_within v _ half) as (far & positive & small). exists far. split; trivial. intros t from to.
  assert (small_t := small t (Qlt_le_weak _ _ from) to). split.
  - apply near; [apply within_less with (e / 2); trivial; lra |]. now rewrite local_shape_is_a_cone.
  - intros (f & some_f & inside).
    destruct (scaled_within (normal i) _ half) as (a & positive_a & small_a).
    destruct (scaled_within (normal i) _ some_f) as (b & positive_b & small_b).
    destruct (small_enough e0 1 some0 ltac:(lra)) as (c & positive_c & small_c).
    destruct (below_both a b positive_a positive_b) as (ab & above_ab & at_a' & at_b').
    destruct (below_both ab (t * c) above_ab ltac:(nra)) as (u & above & at_ab & at_c).
    assert (at_a : u <= a) by lra. assert (at_b : u <= b) by lra.
    assert (there := inside _ (small_b u ltac:(lra) at_b)).
    set (w := plus (scaled t v) (scaled u (normal i))).
    assert (moved : member s (plus p w))
      by (revert there; apply member_same; unfold w, plus, scaled; simpl; ring).
    assert (small_w : within e w).
    { apply within_less with (e / 2 + e / 2); [lra |]. apply within_plus; trivial. apply small_a; lra. }
    apply near in moved; trivial.
    assert (ratio : u / t <= c) by (apply Qle_shift_div_r; lra).
    assert (positive_ratio : 0 < u / t) by (apply Qlt_shift_div_l; lra).
    assert (cone s p (scaled t (plus v (scaled (u / t) (normal i)))) = true) as absurd.
    { rewrite <- moved. apply value_extensional. intros h _. unfold holds_along. destruct (at_point p h); trivial.
      apply eq_iff_eq_true. rewrite !Qle_bool_iff.
      assert (same : dot (normal h) (scaled t (plus v (scaled (u / t) (normal i)))) == dot (normal h) w)
        by (unfold w, dot, plus, scaled; simpl; field; lra).
      now rewrite same. }
    rewrite local_shape_is_a_cone in absurd by assumption. rewrite outside in absurd; try easy. lra.
Qed.

(* "No ghost contacts": if the points of leaf i's plane near p are interior, or not in S, leaf i does not bound. *)
Theorem seams_are_no_faces s p i e : 0 < e ->
  (forall v, dot (normal i) v == 0 -> within e v -> member s (plus p v) -> interior s (plus p v)) -> ~ bounds s p i.
Proof.
  intros some seam (_ & v & along). destruct (bounding_leaf_is_on_the_border s p i v along) as (far & positive & border).
  destruct (scaled_within v e some) as (t & above & small).
  destruct (below_both t far above positive) as (u & from & to & to'). destruct (border u from to') as (inside & not_interior).
  apply not_interior, seam; trivial; [| apply small; lra].
  destruct along as (in_plane & _). transitivity (u * dot (normal i) v); [unfold dot, scaled; simpl; ring |].
  rewrite in_plane. ring.
Qed.

Lemma member_is_possible s p : member s p -> evaluate (at_point p) s <> No.
Proof.
  intros inside no. assert (agrees : respects (contains p) (at_point p)).
  { intros h. unfold at_point, contains. destruct (Qlt_le_dec 0 (delta h p)) as [out | not_out].
    - apply not_true_iff_false. rewrite Qle_bool_iff. lra.
    - destruct (Qlt_le_dec (delta h p) 0); [now apply Qle_bool_iff |].
      destruct (has_no_normal h); trivial. now apply Qle_bool_iff. }
  assert (sure := known_values_hold s agrees). rewrite no in sure. unfold member in inside. congruence.
Qed.

Lemma cone_respects p v : respects (holds_along p v) (at_point p).
Proof. intros h. unfold holds_along. now destruct (at_point p h). Qed.

(* Rule 2 finds a leaf at a border point where the range starts ... *)
Theorem border_has_a_standing_leaf s p : member s p -> ~ interior s p -> exists i, In i (standing (at_point p) s).
Proof.
  intros inside border. destruct (standing (at_point p) s) as [| i rest] eqn:stand; [| exists i; now left].
  exfalso. apply border. apply interior_iff_local_shape_is_everything. intros v.
  apply standing_leaves_decide with (at_point p); [apply cone_respects | now apply member_is_possible |].
  now rewrite stand.
Qed.

(* ... and an entered one where S is met in the direction u for the first time. *)
Theorem first_point_has_an_entered_leaf s p u : member s p ->
  (forall far, 0 < far -> exists t, 0 < t /\ t <= far /\ ~ member s (plus p (scaled (- t) u))) ->
  exists i, In i (standing (at_point p) s) /\ dot (normal i) u < 0.
Proof.
  intros inside first.
  destruct (existsb (fun i => negb (Qle_bool 0 (dot (normal i) u))) (standing (at_point p) s)) eqn:entered.
  - apply existsb_exists in entered as (i & stands & entered). exists i. split; trivial.
    apply negb_true_iff, not_true_iff_false in entered. rewrite Qle_bool_iff in entered. lra.
  - exfalso. set (back := scaled (-1) u).
    assert (in_cone : cone s p back = true).
    { apply standing_leaves_decide with (at_point p); [apply cone_respects | now apply member_is_possible |].
      intros i stands. unfold holds_along. rewrite (proj1 (standing_leaf_is_open _ _ _ stands)). apply Qle_bool_iff.
      assert (not_entered : negb (Qle_bool 0 (dot (normal i) u)) = false).
      { apply not_true_iff_false. intros enters. apply not_true_iff_false in entered. apply entered.
        apply existsb_exists. now exists i. }
      apply negb_false_iff in not_entered. rewrite Qle_bool_iff in not_entered.
      assert (opposite : dot (normal i) back == - dot (normal i) u) by (unfold back, dot, scaled; simpl; ring). lra. }
    destruct (solid_is_local_shape s p) as (e & some & near).
    destruct (scaled_within back e some) as (far & positive & small).
    destruct (first far positive) as (t & from & to & outside). apply outside.
    assert (there : member s (plus p (scaled t back))).
    { apply near; [apply small; lra |]. now rewrite local_shape_is_a_cone. }
    revert there. apply member_same; unfold back, plus, scaled; simpl; ring.
Qed.

(* An admissible leaf always exists, at the start ... *)
Theorem some_leaf_is_admissible_at_the_start s p : member s p -> ~ interior s p ->
  ~ forall i, ~ admissible s p None i.
Proof.
  intros inside border none. destruct (border_has_a_standing_leaf s p inside border) as (i & stands).
  apply (none i). right. split; [| now split]. intros h rule_1. apply (none h). now left.
Qed.

(* ... and beyond it. *)
Theorem some_leaf_is_admissible_beyond s p u : member s p ->
  (forall far, 0 < far -> exists t, 0 < t /\ t <= far /\ ~ member s (plus p (scaled (- t) u))) ->
  ~ forall i, ~ admissible s p (Some u) i.
Proof.
  intros inside first none. destruct (first_point_has_an_entered_leaf s p u inside first) as (i & stands & entered).
  apply (none i). right. split; [| now split]. intros h rule_1. apply (none h). now left.
Qed.

Lemma reordered_back {L} (s t : shape L) : reordered s t -> reordered t s.
Proof.
  induction 1; try (constructor; trivial; now apply Permutation_sym). now apply twice_reordered with t.
Qed.

Lemma bounds_reordered s t p i : reordered s t -> bounds s p i -> bounds t p i.
Proof.
  intros order (open & v & in_plane & generic & inside & (e & some & outside) & stands).
  assert (same : forall w, cone t p w = cone s p w)
    by (intros w; symmetry; now apply order_is_no_matter_for_membership).
  split; trivial. exists v. split; trivial. split; [| split; [| split]].
  - intros h below. apply generic. revert below. apply Permutation_in, Permutation_sym.
    now apply order_is_no_matter_for_leaves.
  - now rewrite same.
  - exists e. split; trivial. intros a from to. rewrite same. auto.
  - revert stands. now apply Permutation_in, standing_reordered.
Qed.

(* Operands in another order: the same leaves are admissible. *)
Theorem order_is_no_matter_for_faces s t p u i : reordered s t -> admissible s p u i -> admissible t p u i.
Proof.
  intros order [(one & counted) | (none & stands & counted)].
  - left. split; trivial. now apply bounds_reordered with s.
  - right. split; [| split; trivial].
    + intros h (bounding & counted_h). apply (none h). split; trivial. apply bounds_reordered with t; trivial.
      now apply reordered_back.
    + revert stands. now apply Permutation_in, standing_reordered.
Qed.

Print Assumptions interior_points_have_no_face.
Print Assumptions bounding_leaf_is_on_the_border.
Print Assumptions seams_are_no_faces.
Print Assumptions some_leaf_is_admissible_at_the_start.
Print Assumptions some_leaf_is_admissible_beyond.
Print Assumptions order_is_no_matter_for_faces.
