(* Lemma 7, duplicates: an operand written like an earlier one can go. The value stays, and of each leaf that goes
   there is a twin, earlier and so with a smaller number, that stands iff it stood (scene-rewriting.md, 4). *)

From Coq Require Import List Bool.
From Groundtruth Require Import shapes standing rewriting.
Import ListNotations.
Set Implicit Arguments.

Section Duplicates.
Variable L : Type.
Implicit Types s t : shape L.
Implicit Types known : L -> truth.

(* The leaf of the earlier operand that is written like this one, and so has its truth wherever it is asked for. *)
Variable twin : L -> L.

Lemma evaluate_twins known t : (forall leaf, In leaf (leaves t) -> known (twin leaf) = known leaf) ->
  evaluate known (mapped twin t) = evaluate known t.
Proof.
  induction t as [leaf | ss IH | ss IH] using shape_induction; simpl; intros alike_; [apply alike_; now left | |];
    f_equal; rewrite map_map; apply map_ext_in; rewrite Forall_forall in IH; intros s inside; apply IH; trivial;
    intros leaf below; apply alike_; now apply leaves_of_operand with s.
Qed.

Lemma standing_twins known t : (forall leaf, In leaf (leaves t) -> known (twin leaf) = known leaf) ->
  forall leaf, In leaf (standing known t) -> In (twin leaf) (standing known (mapped twin t)).
Proof.
  intros twins leaf stands. assert (open := standing_is_open known t leaf stands).
  revert twins leaf stands open. induction t as [one | ss IH | ss IH] using shape_induction; intros twins leaf stands open.
  - assert (same : known (twin one) = known one) by (apply twins; now left). simpl in *.
    rewrite open in stands. destruct stands as [<- | []]. rewrite same, open. now left.
  - rewrite Forall_forall in IH. assert (same := evaluate_twins known (Union ss) twins).
    apply stands_in_union in stands as (_ & s & inside & below).
    change (mapped twin (Union ss)) with (Union (map (mapped twin) ss)) in *. apply stands_in_union. split; [congruence |].
    exists (mapped twin s). split; [now apply in_map |]. apply IH; trivial; [| now apply standing_is_open with leaf].
    intros other there. apply twins. simpl. now apply leaves_of_operand with s.
  - rewrite Forall_forall in IH. assert (same := evaluate_twins known (Intersection ss) twins).
    apply stands_in_intersection in stands as (_ & s & inside & below).
    change (mapped twin (Intersection ss)) with (Intersection (map (mapped twin) ss)) in *.
    apply stands_in_intersection. split; [congruence |].
    exists (mapped twin s). split; [now apply in_map |]. apply IH; trivial; [| now apply standing_is_open with leaf].
    intros other there. apply twins. simpl. now apply leaves_of_operand with s.
Qed.

(* `all_of` before, `left` after: what a duplicate t leaves behind. *)
Definition only_twins_go known t all_of left_over : Prop :=
  evaluate known all_of = evaluate known left_over
  /\ (forall leaf, In leaf (standing known left_over) -> In leaf (standing known all_of))
  /\ (forall leaf, In leaf (standing known all_of) ->
        In leaf (standing known left_over) \/ In leaf (leaves t) /\ In (twin leaf) (standing known left_over)).

Variable t : shape L.
Variables before after : list (shape L).
Variable known : L -> truth.
Hypothesis written_alike : forall leaf, In leaf (leaves t) -> known (twin leaf) = known leaf.
Hypothesis written_before : In (mapped twin t) before.

Theorem duplicate_in_union_can_go : only_twins_go known t (Union (before ++ t :: after)) (Union (before ++ after)).
Proof.
  assert (value_ : evaluate known (Union (before ++ t :: after)) = evaluate known (Union (before ++ after))).
  { simpl. rewrite !map_app, !any_app. simpl. rewrite <- (evaluate_twins known t written_alike).
    apply (in_map (evaluate known)) in written_before. revert written_before.
    generalize (map (evaluate known) before), (evaluate known (mapped twin t)), (any (map (evaluate known) after)).
    intros truths one others there. apply in_split in there as (a & b & ->). rewrite any_app. simpl.
    now destruct (any a), one, (any b), others. }
  split; [exact value_ |]. split; intros leaf; rewrite !stands_in_union, value_.
  - intros (open & s & inside & below). split; trivial. exists s. split; trivial.
    apply in_app_or in inside as [i | i]; apply in_or_app; [now left | right; now right].
  - intros (open & s & inside & below). apply in_app_or in inside as [i | [<- | i]].
    + left. split; trivial. exists s. split; trivial. apply in_or_app. now left.
    + right. split; [now apply (standing_leaf_is_open known t) |]. split; trivial.
      exists (mapped twin t). split; [apply in_or_app; now left | now apply standing_twins].
    + left. split; trivial. exists s. split; trivial. apply in_or_app. now right.
Qed.

Theorem duplicate_in_intersection_can_go :
  only_twins_go known t (Intersection (before ++ t :: after)) (Intersection (before ++ after)).
Proof.
  assert (value_ : evaluate known (Intersection (before ++ t :: after)) = evaluate known (Intersection (before ++ after))).
  { simpl. rewrite !map_app, !all_app. simpl. rewrite <- (evaluate_twins known t written_alike).
    apply (in_map (evaluate known)) in written_before. revert written_before.
    generalize (map (evaluate known) before), (evaluate known (mapped twin t)), (all (map (evaluate known) after)).
    intros truths one others there. apply in_split in there as (a & b & ->). rewrite all_app. simpl.
    now destruct (all a), one, (all b), others. }
  split; [exact value_ |]. split; intros leaf; rewrite !stands_in_intersection, value_.
  - intros (open & s & inside & below). split; trivial. exists s. split; trivial.
    apply in_app_or in inside as [i | i]; apply in_or_app; [now left | right; now right].
  - intros (open & s & inside & below). apply in_app_or in inside as [i | [<- | i]].
    + left. split; trivial. exists s. split; trivial. apply in_or_app. now left.
    + right. split; [now apply (standing_leaf_is_open known t) |]. split; trivial.
      exists (mapped twin t). split; [apply in_or_app; now left | now apply standing_twins].
    + left. split; trivial. exists s. split; trivial. apply in_or_app. now right.
Qed.
End Duplicates.

Print Assumptions duplicate_in_union_can_go.
Print Assumptions duplicate_in_intersection_can_go.
