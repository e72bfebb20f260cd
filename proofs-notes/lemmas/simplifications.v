(* Lemma 7: each simplification of fast/compile_options.hpp with the condition under which divide.cpp and fold.cpp
   make it, and what it preserves (proofs-notes/scene-rewriting.md, 3). *)

From Coq Require Import List Bool QArith Lqa.
From Groundtruth Require Import shapes standing phi rewriting faces.
Import ListNotations.
Open Scope Q_scope.

(* What may be known of leaves in working out entry and faces: their truths at a point, and more. *)
Definition somewhere (known : half_space -> truth) : Prop := exists p, refines known (at_point p).

Definition cell (hs : list half_space) : shape half_space := Intersection (map (@Leaf half_space) hs).

Lemma point_outside_cell hs p : ~ member (cell hs) p -> evaluate (at_point p) (cell hs) = No.
Proof.
  intros outside. destruct (evaluate (at_point p) (cell hs)) eqn:known; trivial; exfalso; apply outside;
    apply forallb_forall; intros s inside; apply in_map_iff in inside as (h & <- & inside); simpl;
    unfold contains; apply Qle_bool_iff.
  all: destruct (Qlt_le_dec 0 (local_shape.delta h p)) as [out | ]; trivial.
  all: assert (no : at_point p h = No) by (unfold at_point; destruct (Qlt_le_dec 0 (local_shape.delta h p)); trivial; lra).
  all: assert (false_ : evaluate (at_point p) (cell hs) = No)
         by (simpl; apply all_no; rewrite <- no, map_map; now apply (in_map (at_point p))).
  all: congruence.
Qed.

Lemma strictly_inside h p : local_shape.delta h p < 0 -> at_point p h = Yes.
Proof. intros. unfold at_point. destruct (Qlt_le_dec 0 _); [lra |]. destruct (Qlt_le_dec _ 0); [trivial | lra]. Qed.

Lemma member_or_not s p : {member s p} + {~ member s p}.
Proof. unfold member. destruct (value (contains p) s); [now left | now right]. Qed.

(* constants: a half-space without normal. *)
Theorem half_space_without_normal_is_constant h known : has_no_normal h = true -> somewhere known ->
  evaluate known (Leaf h) = if Qlt_le_dec (offset h) 0 then No else Yes.
Proof.
  intros flat (p & finer). simpl. apply andb_true_iff in flat as flats. destruct flats as (flats & zero_z).
  apply andb_true_iff in flats as (zero_x & zero_y). apply Qeq_bool_eq in zero_x, zero_y, zero_z.
  assert (level : local_shape.delta h p == - offset h)
    by (unfold local_shape.delta, dot; rewrite zero_x, zero_y, zero_z; ring).
  assert (at_p : at_point p h = if Qlt_le_dec (offset h) 0 then No else Yes).
  { unfold at_point. rewrite flat.
    destruct (Qlt_le_dec 0 _), (Qlt_le_dec (offset h) 0), (Qlt_le_dec (local_shape.delta h p) 0); trivial; lra. }
  rewrite <- at_p. apply finer. rewrite at_p. now destruct (Qlt_le_dec (offset h) 0).
Qed.

(* empty_cells *)
Theorem empty_cell_can_go hs before after : (forall p, ~ member (cell hs) p) ->
  alike somewhere (Union (before ++ cell hs :: after)) (Union (before ++ after)).
Proof.
  intros empty. apply union_drops. intros known (p & finer). left.
  assert (no := point_outside_cell hs p (empty p)). rewrite <- no. apply evaluate_refined; [assumption | congruence].
Qed.

(* buried_parts: every point of the cell is strictly inside a half-space of the union. *)
Theorem buried_cell_can_go hs g before after : In (Leaf g) (before ++ after) ->
  (forall p, member (cell hs) p -> local_shape.delta g p < 0) ->
  alike somewhere (Union (before ++ cell hs :: after)) (Union (before ++ after)).
Proof.
  intros ground buried. apply union_drops. intros known (p & finer).
  destruct (member_or_not (cell hs) p) as [inside | outside].
  - right. simpl. apply any_yes. assert (yes := strictly_inside g p (buried p inside)).
    apply in_map_iff. exists (Leaf g). split; trivial. simpl. rewrite finer; congruence.
  - left. assert (no := point_outside_cell hs p outside). rewrite <- no. apply evaluate_refined; [assumption | congruence].
Qed.

(* redundant_half_spaces: every point of the other half-spaces is strictly inside this one. *)
Theorem redundant_half_space_can_go h before after :
  (forall p, member (cell (before ++ after)) p -> local_shape.delta h p < 0) ->
  alike somewhere (cell (before ++ h :: after)) (cell (before ++ after)).
Proof.
  intros redundant. unfold cell. rewrite !map_app. simpl. apply intersection_drops. intros known (p & finer).
  rewrite <- map_app. fold (cell (before ++ after)).
  destruct (member_or_not (cell (before ++ after)) p) as [inside | outside].
  - left. assert (yes := strictly_inside h p (redundant p inside)). simpl. rewrite finer; congruence.
  - right. assert (no := point_outside_cell _ p outside). rewrite <- no. apply evaluate_refined; [assumption | congruence].
Qed.

(* Strictness matters: were Delta <= 0 enough, leaf 0, canonical at the origin, would be lost. *)
Definition left_0 := HalfSpace 0 (Vector 1 0 0) 0.
Definition front_1 := HalfSpace 1 (Vector 0 1 0) 0.
Definition left_2 := HalfSpace 2 (Vector 1 0 0) 0.
Definition origin := Vector 0 0 0.

Lemma loses_leaf_0 s t : existsb (fun h => Nat.eqb (number h) 0) (standing (at_point origin) s) = true ->
  existsb (fun h => Nat.eqb (number h) 0) (standing (at_point origin) t) = false -> ~ alike somewhere s t.
Proof.
  intros stands lost a. destruct (a (at_point origin)) as (_ & same_leaves); [exists origin; now intros h _ |].
  apply existsb_exists in stands as (h & inside & is_0). apply not_true_iff_false in lost. apply lost.
  apply existsb_exists. exists h. split; trivial. now apply same_leaves.
Qed.

Theorem touching_half_space_must_stay : (forall p, member (cell [left_2]) p -> local_shape.delta left_0 p <= 0)
  /\ ~ alike somewhere (cell [left_0; left_2]) (cell [left_2]).
Proof.
  split; [| now apply loses_leaf_0]. intros p inside. unfold member in inside. simpl in inside.
  apply andb_true_iff in inside as (inside & _). now apply Qle_bool_iff in inside.
Qed.

Theorem touching_cell_must_stay : (forall p, member (cell [left_0; front_1]) p -> local_shape.delta left_2 p <= 0)
  /\ ~ alike somewhere (Union [cell [left_0; front_1]; Leaf left_2]) (Union [Leaf left_2]).
Proof.
  split; [| now apply loses_leaf_0]. intros p inside. unfold member in inside. simpl in inside.
  apply andb_true_iff in inside as (inside & _). now apply Qle_bool_iff in inside.
Qed.

(* What alike expressions share: points, the local shape, interior points, the leaves that stand. *)
Definition as_truth (b : bool) : truth := if b then Yes else No.

Lemma decided_value {L} (v : L -> bool) s : evaluate (fun leaf => as_truth (v leaf)) s = as_truth (value v s).
Proof.
  assert (agrees : respects v (fun leaf => as_truth (v leaf))) by (intros leaf; now destruct (v leaf)).
  assert (sure := known_values_hold s agrees).
  destruct (evaluate (fun leaf => as_truth (v leaf)) s) eqn:known; try now rewrite sure.
  destruct (open_has_a_standing_leaf _ _ known) as (leaf & stands).
  apply standing_leaf_is_open in stands as (open & _). now destruct (v leaf).
Qed.

Lemma alike_values s t v : alike somewhere s t -> somewhere (fun h => as_truth (v h)) -> value v s = value v t.
Proof.
  intros a there. destruct (a _ there) as (same & _). rewrite !decided_value in same.
  now destruct (value v s), (value v t).
Qed.

Theorem alike_have_the_same_points s t p : alike somewhere s t -> (member s p <-> member t p).
Proof.
  intros a. unfold member. rewrite (alike_values s t (contains p) a); [tauto |]. exists p. intros h open.
  unfold at_point, contains in *. destruct (Qlt_le_dec 0 (local_shape.delta h p)) as [out | not_out].
  - replace (Qle_bool _ 0) with false; trivial. symmetry. apply not_true_iff_false. rewrite Qle_bool_iff. lra.
  - replace (Qle_bool _ 0) with true; [| symmetry; now apply Qle_bool_iff].
    destruct (Qlt_le_dec _ 0); trivial. now destruct (has_no_normal h).
Qed.

Theorem alike_have_the_same_local_shape s t p v : alike somewhere s t -> cone s p v = cone t p v.
Proof.
  intros a. apply alike_values; trivial. exists p. intros h open. unfold holds_along. now destruct (at_point p h).
Qed.

Theorem alike_have_the_same_interior s t p : alike somewhere s t -> (interior s p <-> interior t p).
Proof.
  intros a. rewrite !interior_iff_local_shape_is_everything.
  split; intros all v; [rewrite <- (alike_have_the_same_local_shape s t) | rewrite (alike_have_the_same_local_shape s t)]; auto.
Qed.

Theorem alike_have_the_same_standing_leaves s t p i : alike somewhere s t ->
  (In i (standing (at_point p) s) <-> In i (standing (at_point p) t)).
Proof. intros a. apply a. exists p. now intros h _. Qed.

(* A face stays a face when leaves are left out. *)
Theorem faces_remain s t p i : alike somewhere s t -> incl (leaves t) (leaves s) -> bounds s p i -> bounds t p i.
Proof.
  intros a fewer (open & v & in_plane & generic & inside & (e & some & outside) & stands).
  split; trivial. exists v. split; trivial. split; [| split; [| split]].
  - intros h below. apply generic. now apply fewer.
  - now rewrite <- (alike_have_the_same_local_shape s t).
  - exists e. split; trivial. intros r from to. rewrite <- (alike_have_the_same_local_shape s t) by trivial. auto.
  - destruct (a (beside p v i)) as (_ & same_leaves); [| now apply same_leaves].
    exists p. intros h known. unfold beside. now destruct (at_point p h).
Qed.

(* Phi, by the recursive algorithm along the segment from `from` in the direction u. *)
Definition course_of (from u : vector) (h : half_space) : course :=
  Course (local_shape.number h) (local_shape.delta h from) (dot (normal h) u).
Definition along (from u : vector) : shape half_space -> shape course := mapped (course_of from u).

Lemma is_in_along from u s l : is_in (along from u s) l <-> member s (plus from (scaled l u)).
Proof.
  unfold is_in, along, member. rewrite value_mapped. rewrite (value_extensional s _ (contains (plus from (scaled l u)))).
  - tauto.
  - intros h _. unfold holds_at, contains. apply eq_iff_eq_true. rewrite !Qle_bool_iff.
    assert (same_delta : recursion.delta (course_of from u h) l == local_shape.delta h (plus from (scaled l u)))
      by (unfold recursion.delta, course_of, local_shape.delta, dot, plus, scaled; simpl; ring).
    now rewrite same_delta.
Qed.

Theorem alike_have_the_same_entry s t from u first last : first <= last -> alike somewhere s t ->
  agree (entry last (along from u s) first) (entry last (along from u t) first).
Proof.
  intros range a. apply entry_depends_on_members_only; trivial. intros l _ _. rewrite !is_in_along.
  now apply alike_have_the_same_points.
Qed.

(* hierarchy, grid: a part that the range does not reach is passed by ... *)
Theorem part_out_of_reach_can_be_passed_by part before after from u first last : first <= last ->
  (forall l, first <= l -> l <= last -> ~ member part (plus from (scaled l u))) ->
  agree (entry last (along from u (Union (before ++ part :: after))) first)
        (entry last (along from u (Union (before ++ after))) first).
Proof.
  intros range out. apply entry_depends_on_members_only; trivial. intros l from_ to. rewrite !is_in_along.
  unfold member. simpl. rewrite !existsb_app. simpl.
  assert (no := out l from_ to). unfold member in no. apply not_true_iff_false in no. now rewrite no.
Qed.

(* ... and one that holds all of it need not be looked at in an intersection. *)
Theorem part_around_the_range_is_true part before after from u first last : first <= last ->
  (forall l, first <= l -> l <= last -> member part (plus from (scaled l u))) ->
  agree (entry last (along from u (Intersection (before ++ part :: after))) first)
        (entry last (along from u (Intersection (before ++ after))) first).
Proof.
  intros range inside. apply entry_depends_on_members_only; trivial. intros l from_ to. rewrite !is_in_along.
  unfold member. simpl. rewrite !forallb_app. simpl.
  assert (yes := inside l from_ to). unfold member in yes. now rewrite yes.
Qed.

Print Assumptions half_space_without_normal_is_constant.
Print Assumptions empty_cell_can_go.
Print Assumptions buried_cell_can_go.
Print Assumptions redundant_half_space_can_go.
Print Assumptions touching_half_space_must_stay.
Print Assumptions touching_cell_must_stay.
Print Assumptions alike_have_the_same_points.
Print Assumptions alike_have_the_same_local_shape.
Print Assumptions alike_have_the_same_interior.
Print Assumptions alike_have_the_same_standing_leaves.
Print Assumptions faces_remain.
Print Assumptions alike_have_the_same_entry.
Print Assumptions part_out_of_reach_can_be_passed_by.
Print Assumptions part_around_the_range_is_true.
