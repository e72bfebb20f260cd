(* Lemma 7: the search of fast/search.cpp and fast/search_kernels_body.hpp as a model (proofs-notes/rounding.md, "What
   is certain of parts"). Whatever the order of visits and whatever the index passes by, the contenders that are left
   hold the entry point of the whole solid, its local shape there and its admissible leaves; and if one contender is
   left of which one leaf alone can be open, that leaf is the admissible one. What a visit or a box claims
   (`is_true_of`, `passes`) is what the rounding lemmas prove of it. *)

From Coq Require Import List Bool Permutation QArith Lqa.
From Groundtruth Require Import shapes standing faces rewriting simplifications finding_faces same_faces phi unions.
Import ListNotations.
Open Scope Q_scope.
Set Implicit Arguments.

(* Of a visit: no point of the part comes before `lower`, some point no later than `upper` if that is not beyond what
   was asked for. *)
Record meeting := Meeting { lower : Q; upper : Q }.

(* The index: boxes in boxes, or squares with lists of parts. A part may stand in it more than once. *)
Inductive tree (Part : Type) : Type :=
| Visit (part : Part)
| Box (children : list (tree Part)).
Arguments Box {Part}.

Fixpoint parts_of {Part} (t : tree Part) : list Part :=
  match t with Visit part => [part] | Box children => flat_map parts_of children end.

Section Search.
Variable Part : Type.
Variable solid : Part -> shape half_space.
Variables (from toward_ : vector) (first last : Q).
Hypothesis range : first <= last.

Definition place_at (l : Q) : vector := plus from (scaled l toward_).
Definition meets (part : Part) (l : Q) : Prop := (first <= l /\ l <= last) /\ member (solid part) (place_at l).

Definition is_true_of (now : Q) (m : meeting) (part : Part) : Prop :=
  (forall l, meets part l -> l <= now -> lower m <= l)
  /\ (upper m <= now -> exists l, meets part l /\ l <= upper m).
(* A box that is certainly met later than `now`, or not at all. *)
Definition passes (now : Q) (t : tree Part) : Prop :=
  forall part l, In part (parts_of t) -> meets part l -> now < l.

Record state := State { open : list (tree Part); bound : Q; contenders : list (Part * meeting) }.

Definition least (a b : Q) : Q := if Qlt_le_dec a b then a else b.

Inductive step : state -> state -> Prop :=
| passed t before after now kept : passes now t ->
    step (State (before ++ t :: after) now kept) (State (before ++ after) now kept)
| opened children before after now kept :
    step (State (before ++ Box children :: after) now kept) (State (children ++ before ++ after) now kept)
| met_before part before after now kept : In part (map fst kept) ->
    step (State (before ++ Visit part :: after) now kept) (State (before ++ after) now kept)
| too_late part m before after now kept : is_true_of now m part -> now < lower m ->
    step (State (before ++ Visit part :: after) now kept) (State (before ++ after) now kept)
| contends part m before after now kept : is_true_of now m part -> lower m <= now ->
    step (State (before ++ Visit part :: after) now kept) (State (before ++ after) (least (upper m) now) ((part, m) :: kept)).

Inductive steps : state -> state -> Prop :=
| done s : steps s s
| more s t u : step s t -> steps t u -> steps s u.

Variable all : list Part.

Definition is_kept (s : state) (part : Part) (l : Q) : Prop := exists m, In (part, m) (contenders s) /\ lower m <= l.
Record invariant (s : state) : Prop := {
  in_range : bound s <= last;
  nothing_lost : forall part l, In part all -> meets part l -> l <= bound s ->
    In part (flat_map parts_of (open s)) \/ is_kept s part l;
  bound_is_met : bound s == last \/ exists part l, In part all /\ meets part l /\ l <= bound s;
  kept_are_true : forall part m, In (part, m) (contenders s) -> is_true_of (bound s) m part;
  kept_are_parts : forall part m, In (part, m) (contenders s) -> In part all;
  open_are_parts : forall part, In part (flat_map parts_of (open s)) -> In part all }.

Lemma open_split (before after : list (tree Part)) t part :
  In part (flat_map (@parts_of Part) (before ++ t :: after))
  <-> In part (parts_of t) \/ In part (flat_map (@parts_of Part) (before ++ after)).
Proof. rewrite !flat_map_app. simpl. rewrite !in_app_iff. tauto. Qed.

Lemma least_is_least a b : (least a b <= a /\ least a b <= b) /\ (least a b = a /\ a < b \/ least a b = b).
Proof. unfold least. destruct (Qlt_le_dec a b); split; try split; try lra; tauto. Qed.

Lemma true_until now sooner m part : is_true_of now m part -> sooner <= now -> is_true_of sooner m part.
Proof. intros (early & certain) less. split; [intros l meets_ at_most; apply early; trivial; lra | intros at_most; apply certain; lra]. Qed.

Lemma step_keeps_invariant s t : step s t -> invariant s -> invariant t.
Proof.
  intros moved [in_range_ lost met true_ kept_ open_].
  destruct moved as [t before after now kept out | children before after now kept | part before after now kept seen
    | part m before after now kept (early & certain) late | part m before after now kept (early & certain) soon];
    cbn [open bound contenders] in *; constructor; cbn [open bound contenders]; trivial.
  - intros q l inside meets_ at_most. destruct (lost q l inside meets_ at_most) as [there | k]; [| now right].
    apply open_split in there as [there | there]; [| now left].
    exfalso. specialize (out q l there meets_). lra.
  - intros q there. apply open_, open_split. now right.
  - intros q l inside meets_ at_most. destruct (lost q l inside meets_ at_most) as [there | k]; [| now right].
    left. apply open_split in there. rewrite flat_map_app. apply in_or_app. now simpl in there.
  - intros q there. apply open_, open_split. rewrite flat_map_app in there. apply in_app_or in there. now simpl.
  - intros q l inside meets_ at_most. destruct (lost q l inside meets_ at_most) as [there | k]; [| now right].
    apply open_split in there as [[<- | []] | there]; [| now left]. right.
    apply in_map_iff in seen as ((q & n) & e & seen). simpl in e. subst q. exists n. split; [exact seen |].
    now apply (true_ part n seen).
  - intros q there. apply open_, open_split. now right.
  - intros q l inside meets_ at_most. destruct (lost q l inside meets_ at_most) as [there | k]; [| now right].
    apply open_split in there as [[<- | []] | there]; [| now left].
    exfalso. specialize (early l meets_ at_most). lra.
  - intros q there. apply open_, open_split. now right.
  - destruct (least_is_least (upper m) now). lra.
  - destruct (least_is_least (upper m) now) as ((small & small') & _).
    intros q l inside meets_ at_most. destruct (lost q l inside meets_ ltac:(lra)) as [there | k].
    + apply open_split in there as [[<- | []] | there]; [| now left].
      right. exists m. split; [now left |]. apply early; trivial. lra.
    + right. destruct k as (n & there & less). exists n. split; trivial. now right.
  - assert (is_part : In part all) by (apply open_, open_split; left; now left).
    destruct (least_is_least (upper m) now) as (_ & [(-> & less) | ->]); [| exact met].
    right. destruct (certain ltac:(lra)) as (l & meets_ & at_most). now exists part, l.
  - destruct (least_is_least (upper m) now) as ((small & small') & _).
    intros q n [e | there].
    + inversion e; subst q n. apply true_until with now; [now split | lra].
    + apply true_until with now; [now apply true_ | lra].
  - intros q n [e | there]; [inversion e; subst q n; apply open_, open_split; left; now left | now apply (kept_ q n)].
  - intros q there. apply open_, open_split. now right.
Qed.

Lemma steps_keep_invariant s t : steps s t -> invariant s -> invariant t.
Proof. induction 1 as [| s t u one _ IH]; trivial. intros inv. now apply IH, step_keeps_invariant with s. Qed.

(* The range against every part that the index holds, and `drop_late_ones()` at the end. *)
Definition start (index : list (tree Part)) : state := State index last [].
Definition left_over (s : state) : list Part :=
  map fst (filter (fun pm => Qle_bool (lower (snd pm)) (bound s)) (contenders s)).

Section Finished.
Variable index : list (tree Part).
(* Of a part that is in no box, the range holds no point (those apart from the index are trees of their own). *)
Hypothesis index_is_whole : forall part l, In part all -> meets part l -> In part (flat_map (@parts_of Part) index).
Hypothesis index_has_parts : forall part, In part (flat_map (@parts_of Part) index) -> In part all.
Variable finished : state.
Hypothesis searched : steps (start index) finished.
Hypothesis nothing_is_open : open finished = [].

Let whole : shape half_space := Union (map solid all).
Let contending : shape half_space := Union (map solid (left_over finished)).

Lemma finished_invariant : invariant finished.
Proof.
  apply steps_keep_invariant with (start index); trivial. constructor; simpl; try easy; try lra; try (left; reflexivity).
  intros part l inside meets_ _. left. now apply index_is_whole with l.
Qed.

Lemma left_over_are_parts part : In part (left_over finished) -> In part all.
Proof.
  intros inside. apply in_map_iff in inside as ((q & m) & e & there). simpl in e. subst q. apply filter_In in there as (there & _).
  now apply (kept_are_parts finished_invariant) with m.
Qed.

Lemma met_parts_are_left_over part l : In part all -> meets part l -> l <= bound finished -> In part (left_over finished).
Proof.
  intros inside meets_ at_most. assert (inv := finished_invariant).
  destruct (nothing_lost inv inside meets_ at_most) as [there | (m & there & less)]; [now rewrite nothing_is_open in there |].
  apply in_map_iff. exists (part, m). split; trivial. apply filter_In. split; trivial. apply Qle_bool_iff. simpl. lra.
Qed.

Lemma member_of_union parts l : member (Union (map solid parts)) (place_at l) <-> exists part, In part parts /\ member (solid part) (place_at l).
Proof.
  unfold member. simpl. rewrite existsb_exists. split.
  - intros (s & inside & holds). apply in_map_iff in inside as (part & <- & inside). now exists part.
  - intros (part & inside & holds). exists (solid part). split; trivial. now apply in_map.
Qed.

Lemma same_members l : first <= l -> l <= last -> l <= bound finished ->
  (member whole (place_at l) <-> member contending (place_at l)).
Proof.
  intros from_ to at_most. unfold whole, contending. rewrite !member_of_union. split; intros (part & inside & holds); exists part; split; trivial.
  - apply met_parts_are_left_over with l; trivial. repeat split; trivial.
  - now apply left_over_are_parts.
Qed.

Theorem search_keeps_the_entry :
  agree (entry last (along from toward_ whole) first) (entry last (along from toward_ contending) first).
Proof.
  apply answers_agree_up_to with (bound finished) last (along from toward_ whole) (along from toward_ contending) first;
    try (now apply entry_is_right).
  - intros l from_ to at_most. rewrite !is_in_along. now apply same_members.
  - destruct (bound_is_met finished_invariant) as [e | (part & l & inside & ((from_ & to) & holds) & at_most)]; [now left |].
    right. exists l. split; [tauto |]. apply is_in_along. apply member_of_union. now exists part.
Qed.

(* No contender: a miss. *)
Corollary no_contender_is_a_miss : left_over finished = [] -> entry last (along from toward_ whole) first = Miss.
Proof.
  intros none. assert (same_ := search_keeps_the_entry). unfold contending in same_. rewrite none in same_.
  assert (right_ := entry_is_right (along from toward_ whole) range).
  destruct (entry last (along from toward_ whole) first); simpl in *; easy.
Qed.

(* The entry point is no later than the bound. *)
Lemma entry_is_within_bound h : entry last (along from toward_ whole) first = Found h -> place h <= bound finished.
Proof.
  intros found. assert (right_ := entry_is_right (along from toward_ whole) range). rewrite found in right_.
  destruct right_ as ((from_ & to) & _ & none & _).
  destruct (bound_is_met finished_invariant) as [e | (part & l & inside & ((from_l & to_l) & holds) & at_most)]; [lra |].
  destruct (Qlt_le_dec l (place h)) as [less |]; [| lra]. exfalso. apply (none l); trivial.
  apply is_in_along, member_of_union. now exists part.
Qed.

Theorem contenders_are_alike_at_the_entry l : first <= l -> l <= last -> l <= bound finished ->
  alike (here (place_at l)) whole contending.
Proof.
  intros from_ to at_most. set (p := place_at l).
  apply alike_transitive with (1 := @union_of_members_is_alike Part solid p all).
  apply alike_symmetric. apply alike_transitive with (1 := @union_of_members_is_alike Part solid p (left_over finished)).
  apply same_operands_are_alike. intros s. rewrite !in_map_iff. split; intros (part & e & inside); exists part; split; trivial;
    apply filter_In in inside as (inside & holds); apply filter_In; split; trivial.
  - now apply left_over_are_parts.
  - apply met_parts_are_left_over with l; trivial. repeat split; trivial.
Qed.

(* ... so that what is handed to the exact stage has the same faces there. *)
Corollary contenders_have_the_admissible_leaves h u i : entry last (along from toward_ whole) first = Found h ->
  (admissible whole (place_at (place h)) u i <-> admissible contending (place_at (place h)) u i).
Proof.
  intros found. assert (at_most := entry_is_within_bound found).
  assert (right_ := entry_is_right (along from toward_ whole) range). rewrite found in right_. destruct right_ as ((from_ & to) & _).
  now apply alike_here_have_the_same_faces, contenders_are_alike_at_the_entry.
Qed.

(* The search ends at once where the range starts in a part's interior: so it does in the solid's. *)
Theorem starts_inside_the_solid part p : In part all -> interior (solid part) p -> interior whole p.
Proof.
  intros inside (e & some & near). exists e. split; trivial. intros v small. specialize (near v small).
  unfold member in *. simpl. apply existsb_exists. exists (solid part). split; trivial. now apply in_map.
Qed.

(* `sole_face`: one contender, certainly met beyond the start, of whose leaves only `face` can be open between its limits. *)
Theorem sole_face_is_admissible part m face :
  contenders finished = [(part, m)] -> upper m <= bound finished -> first < lower m ->
  (forall l g, lower m <= l -> l <= upper m -> In g (leaves (solid part)) -> at_point (place_at l) g = Open -> g = face) ->
  exists h, entry last (along from toward_ whole) first = Found h /\ lower m <= place h /\ place h <= upper m
            /\ forall i, admissible whole (place_at (place h)) (Some toward_) i <-> i = face.
Proof.
  intros one at_most beyond sole.
  destruct (kept_are_true finished_invariant part m) as (early & certain); [rewrite one; now left |]. destruct (certain at_most) as (l & meets_ & l_upper).
  assert (is_part : In part all) by (apply (kept_are_parts finished_invariant) with m; rewrite one; now left).
  assert (lower_l : lower m <= l) by (apply early; trivial; lra).
  assert (only : left_over finished = [part]).
  { unfold left_over. rewrite one. simpl. replace (Qle_bool (lower m) (bound finished)) with true; trivial.
    symmetry. apply Qle_bool_iff. lra. }
  assert (right_ := entry_is_right (along from toward_ whole) range).
  destruct (entry last (along from toward_ whole) first) as [h | |] eqn:found; [| | easy].
  2: { exfalso. destruct meets_ as ((a & b) & holds). apply (right_ l a b). apply is_in_along, member_of_union. now exists part. }
  destruct right_ as ((from_ & to) & there & none & _). apply is_in_along in there.
  assert (place_l : place h <= l).
  { destruct (Qlt_le_dec l (place h)) as [less |]; trivial. exfalso. destruct meets_ as ((a & b) & holds).
    apply (none l a less). apply is_in_along, member_of_union. now exists part. }
  assert (holds : member (solid part) (place_at (place h))).
  { assert (c : member contending (place_at (place h))) by (apply (same_members from_ to); trivial; lra).
    apply member_of_union in c as (q & inside & c). rewrite only in inside. now destruct inside as [<- | []]. }
  assert (lower_h : lower m <= place h) by (apply early; [repeat split; trivial | lra]).
  exists h. split; trivial. split; trivial. split; [lra |]. set (p := place_at (place h)) in *.
  assert (stand : forall i, In i (standing (at_point p) whole) -> i = face).
  { intros i stands. assert (near := @contenders_are_alike_at_the_entry (place h) from_ to ltac:(lra)).
    destruct (near (at_point p)) as (_ & same_); [now intros g _ |].
    apply same_ in stands. unfold contending in stands. rewrite only in stands. apply stands_in_union in stands as (_ & s & [<- | []] & stands).
    apply standing_leaf_is_open in stands as (open_ & below). apply (sole (place h) i); trivial; lra. }
  assert (admissible_stand : forall i, admissible whole p (Some toward_) i -> i = face).
  { intros i [(bounding & _) | (_ & stands & _)]; apply stand; [now apply bounding_leaf_stands | assumption]. }
  destruct (first_point_has_an_entered_leaf whole p toward_ there) as (i & stands & enters).
  { intros far some. destruct (below_both far (place h - first) some ltac:(lra)) as (t & above & at_far & at_start).
    exists t. split; trivial. split; trivial. intros inside. apply (none (place h - t)); try lra. apply is_in_along.
    revert inside. unfold p, place_at. apply member_same; unfold plus, scaled; simpl; ring. }
  assert (i = face) by now apply stand. subst i.
  intros i. split; [apply admissible_stand |]. intros ->.
  destruct (bounds_found whole p face) eqn:bounding.
  - left. apply bounds_found_iff in bounding. split; trivial.
  - right. split; [| now split]. intros g (bounds_ & counts_).
    assert (g = face) by (apply stand; now apply bounding_leaf_stands). subst g.
    apply bounds_found_iff in bounds_. congruence.
Qed.
End Finished.
End Search.

Print Assumptions search_keeps_the_entry.
Print Assumptions no_contender_is_a_miss.
Print Assumptions starts_inside_the_solid.
Print Assumptions contenders_are_alike_at_the_entry.
Print Assumptions contenders_have_the_admissible_leaves.
Print Assumptions sole_face_is_admissible.
