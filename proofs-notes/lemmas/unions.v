(* What search.v needs of unions and of answers: operands that do not hold a point leave no trace at it, and answers agree
   where the shapes do up to the entry point. *)

From Coq Require Import List Bool QArith Lqa.
From Groundtruth Require Import shapes standing faces rewriting simplifications same_faces phi.
Import ListNotations.
Open Scope Q_scope.
Set Implicit Arguments.

(* Answers agree where the shapes do, up to a place that is not before the entry point. *)
Lemma answers_agree_up_to (upper last : Q) (s t : shape course) (first : Q) (a b : answer) :
  (forall l, first <= l -> l <= last -> l <= upper -> (is_in s l <-> is_in t l)) ->
  upper == last \/ (exists l, (first <= l /\ l <= last /\ l <= upper) /\ is_in s l) ->
  right last s first a -> right last t first b -> agree a b.
Proof.
  intros same [whole | (w & (from & to & before) & there)] right_a right_b.
  - apply right_answers_agree with last s t first; trivial. intros l from to. apply same; lra.
  - assert (there' : is_in t w) by now apply same.
    destruct a as [h | |], b as [k | |]; simpl in *; try tauto.
    + destruct right_a as (range & member_ & none & _), right_b as (range' & member' & none' & _).
      assert (place h <= w) by (destruct (Qlt_le_dec w (place h)); trivial; exfalso; now apply (none w)).
      assert (place k <= w) by (destruct (Qlt_le_dec w (place k)); trivial; exfalso; now apply (none' w)).
      destruct (Qlt_le_dec (place h) (place k)) as [less | more].
      * exfalso. apply (none' (place h)); try lra. apply same; try lra. assumption.
      * destruct (Qlt_le_dec (place k) (place h)) as [less | less]; [| lra].
        exfalso. apply (none (place k)); try lra. apply same; try lra. assumption.
    + now apply (right_b w).
    + now apply (right_a w).
Qed.

(* A solid without the point is nothing near it. *)
Lemma evaluates_to_no s p : ~ member s p -> evaluate (at_point p) s = No.
Proof.
  intros outside. destruct (evaluate (at_point p) s) eqn:known; trivial; exfalso; apply outside; unfold member;
    apply standing_leaves_decide with (at_point p); try congruence.
  all: try (intros h; unfold at_point, contains; destruct (Qlt_le_dec 0 (local_shape.delta h p)) as [out | not_out];
    [apply not_true_iff_false; rewrite Qle_bool_iff; lra |];
    destruct (Qlt_le_dec (local_shape.delta h p) 0); [now apply Qle_bool_iff |];
    destruct (has_no_normal h); trivial; now apply Qle_bool_iff).
  all: intros h stands; apply standing_leaf_is_open in stands as (open_ & _); unfold at_point, contains in *;
    apply Qle_bool_iff; destruct (Qlt_le_dec 0 (local_shape.delta h p)); [easy | trivial].
Qed.

Section Members.
Variable Part : Type.
Variable solid : Part -> shape half_space.

Lemma union_of_members_is_alike p parts :
  alike (here p) (Union (map solid parts)) (Union (map solid (filter (fun part => value (contains p) (solid part)) parts))).
Proof.
  enough (general : forall before, alike (here p) (Union (before ++ map solid parts))
    (Union (before ++ map solid (filter (fun part => value (contains p) (solid part)) parts)))) by apply (general []).
  induction parts as [| part rest IH]; intros before; cbn [map filter]; [apply alike_reflexive |].
  destruct (value (contains p) (solid part)) eqn:inside; cbn [map].
  - specialize (IH (before ++ [solid part])). now rewrite <- !app_assoc in IH.
  - apply alike_transitive with (Union (before ++ map solid rest)); [| apply IH].
    apply union_drops. intros known near. left.
    assert (no : evaluate (at_point p) (solid part) = No) by (apply evaluates_to_no; unfold member; congruence).
    rewrite <- no. apply evaluate_refined; [exact near | congruence].
Qed.
End Members.

(* Only which parts stand in a union, and not how often or in which order. *)
Lemma same_operands_are_alike p (ss ts : list (shape half_space)) : (forall s, In s ss <-> In s ts) ->
  alike (here p) (Union ss) (Union ts).
Proof.
  intros same_ known _. assert (value_ : evaluate known (Union ss) = evaluate known (Union ts)).
  { simpl. assert (yes : In Yes (map (evaluate known) ss) <-> In Yes (map (evaluate known) ts))
      by (rewrite !in_map_iff; split; intros (s & e & inside); exists s; split; trivial; now apply same_).
    assert (no : any (map (evaluate known) ss) = No <-> any (map (evaluate known) ts) = No)
      by (rewrite !any_no, !Forall_map, !Forall_forall; split; intros all_ s inside; apply all_; now apply same_).
    rewrite <- !any_yes in yes. destruct (any (map (evaluate known) ss)), (any (map (evaluate known) ts)); intuition congruence. }
  split; trivial. intros h. rewrite !stands_in_union, value_.
  split; intros (o & s & inside & stands); split; trivial; exists s; split; trivial; now apply same_.
Qed.

Print Assumptions answers_agree_up_to.
Print Assumptions union_of_members_is_alike.
Print Assumptions same_operands_are_alike.
