(* Lemma 7, second half: the rewritings of fast/compile.cpp, fold.cpp and divide.cpp, as rules on positive
   expressions (proofs-notes/scene-rewriting.md, 2). Two expressions are alike if, whatever `possible` truths
   their leaves have, they have one value and the same leaves stand. *)

From Coq Require Import List Bool Permutation.
From Groundtruth Require Import shapes standing.
Import ListNotations.
Set Implicit Arguments.

Section Rules.
Variable L : Type.
Implicit Types s t : shape L.
Implicit Types known : L -> truth.

Lemma stands_in_union known ss leaf :
  In leaf (standing known (Union ss)) <-> evaluate known (Union ss) = Open /\ exists s, In s ss /\ In leaf (standing known s).
Proof. simpl. destruct (any _); rewrite ?in_flat_map; intuition easy. Qed.

Lemma stands_in_intersection known ss leaf :
  In leaf (standing known (Intersection ss))
  <-> evaluate known (Intersection ss) = Open /\ exists s, In s ss /\ In leaf (standing known s).
Proof. simpl. destruct (all _); rewrite ?in_flat_map; intuition easy. Qed.

Lemma constant_has_none known s leaf : evaluate known s <> Open -> ~ In leaf (standing known s).
Proof. intros constant stands. apply constant. now apply standing_is_open with leaf. Qed.

Definition same known s t : Prop :=
  evaluate known s = evaluate known t /\ forall leaf, In leaf (standing known s) <-> In leaf (standing known t).

Variable possible : (L -> truth) -> Prop.
Definition alike s t : Prop := forall known, possible known -> same known s t.

Theorem alike_reflexive s : alike s s.
Proof. intros known _. now split. Qed.
Theorem alike_symmetric s t : alike s t -> alike t s.
Proof. intros a known k. destruct (a known k) as (one & two). split; [congruence |]. intros leaf. now rewrite two. Qed.
Theorem alike_transitive s t u : alike s t -> alike t u -> alike s u.
Proof.
  intros a b known k. destruct (a known k) as (one & two), (b known k) as (three & four).
  split; [congruence |]. intros leaf. now rewrite two.
Qed.

(* Rules apply at any depth. *)
Theorem alike_in_union s t before after : alike s t -> alike (Union (before ++ s :: after)) (Union (before ++ t :: after)).
Proof.
  intros a known k. destruct (a known k) as (one & two).
  assert (value_ : evaluate known (Union (before ++ s :: after)) = evaluate known (Union (before ++ t :: after)))
    by (simpl; rewrite !map_app; simpl; now rewrite one).
  split; trivial. intros leaf. rewrite !stands_in_union, value_. apply and_iff_compat_l.
  split; intros (u & inside & below); apply in_app_or in inside as [i | [<- | i]].
  1,4: exists u; split; trivial; apply in_or_app; auto.
  1: exists t. 3: exists s. 1,3: split; [apply in_or_app; right; now left | now apply two].
  all: exists u; split; trivial; apply in_or_app; right; now right.
Qed.

Theorem alike_in_intersection s t before after :
  alike s t -> alike (Intersection (before ++ s :: after)) (Intersection (before ++ t :: after)).
Proof.
  intros a known k. destruct (a known k) as (one & two).
  assert (value_ : evaluate known (Intersection (before ++ s :: after)) = evaluate known (Intersection (before ++ t :: after)))
    by (simpl; rewrite !map_app; simpl; now rewrite one).
  split; trivial. intros leaf. rewrite !stands_in_intersection, value_. apply and_iff_compat_l.
  split; intros (u & inside & below); apply in_app_or in inside as [i | [<- | i]].
  1,4: exists u; split; trivial; apply in_or_app; auto.
  1: exists t. 3: exists s. 1,3: split; [apply in_or_app; right; now left | now apply two].
  all: exists u; split; trivial; apply in_or_app; right; now right.
Qed.

(* An operand that is nothing, or beside which the union is everything anyway, can be left out:
   constants, empty cells, buried parts, parts that the index passes by. *)
Theorem union_drops s before after :
  (forall known, possible known -> evaluate known s = No \/ evaluate known (Union (before ++ after)) = Yes) ->
  alike (Union (before ++ s :: after)) (Union (before ++ after)).
Proof.
  intros condition known k.
  assert (value_ : evaluate known (Union (before ++ s :: after)) = evaluate known (Union (before ++ after))).
  { destruct (condition known k) as [no | yes]; simpl in *; rewrite !map_app, !any_app in *; simpl.
    - rewrite no. now destruct (any (map _ before)), (any (map _ after)).
    - revert yes. now destruct (any (map _ before)), (any (map _ after)), (evaluate known s). }
  split; trivial. intros leaf. rewrite !stands_in_union, value_.
  split; intros (open & u & inside & below); split; trivial; exists u; split; trivial.
  - apply in_app_or in inside as [i | [<- | i]]; try (apply in_or_app; auto).
    exfalso. destruct (condition known k) as [no | yes]; [| congruence].
    revert below. apply constant_has_none. congruence.
  - apply in_app_or in inside as [i | i]; apply in_or_app; [now left | right; now right].
Qed.

(* An operand that is everything, or beside which the intersection is nothing anyway: constants, redundant
   half-spaces. *)
Theorem intersection_drops s before after :
  (forall known, possible known -> evaluate known s = Yes \/ evaluate known (Intersection (before ++ after)) = No) ->
  alike (Intersection (before ++ s :: after)) (Intersection (before ++ after)).
Proof.
  intros condition known k.
  assert (value_ : evaluate known (Intersection (before ++ s :: after)) = evaluate known (Intersection (before ++ after))).
  { destruct (condition known k) as [yes | no]; simpl in *; rewrite !map_app, !all_app in *; simpl.
    - rewrite yes. now destruct (all (map _ before)), (all (map _ after)).
    - revert no. now destruct (all (map _ before)), (all (map _ after)), (evaluate known s). }
  split; trivial. intros leaf. rewrite !stands_in_intersection, value_.
  split; intros (open & u & inside & below); split; trivial; exists u; split; trivial.
  - apply in_app_or in inside as [i | [<- | i]]; try (apply in_or_app; auto).
    exfalso. destruct (condition known k) as [yes | no]; [| congruence].
    revert below. apply constant_has_none. congruence.
  - apply in_app_or in inside as [i | i]; apply in_or_app; [now left | right; now right].
Qed.

(* An operand that decides its operator. *)
Theorem union_absorbed s ss : In s ss -> (forall known, possible known -> evaluate known s = Yes) -> alike (Union ss) everything.
Proof.
  intros inside yes known k.
  assert (value_ : evaluate known (Union ss) = Yes).
  { simpl. apply any_yes. rewrite <- (yes known k). now apply in_map. }
  split; trivial. intros leaf. rewrite stands_in_union, value_. simpl. intuition easy.
Qed.

Theorem intersection_absorbed s ss :
  In s ss -> (forall known, possible known -> evaluate known s = No) -> alike (Intersection ss) nothing.
Proof.
  intros inside no known k.
  assert (value_ : evaluate known (Intersection ss) = No).
  { simpl. apply all_no. rewrite <- (no known k). now apply in_map. }
  split; trivial. intros leaf. rewrite stands_in_intersection, value_. simpl. intuition easy.
Qed.

(* A lone operand is its operator's value. *)
Theorem lone_in_union s : alike (Union [s]) s.
Proof.
  intros known _. assert (value_ : evaluate known (Union [s]) = evaluate known s) by (simpl; now destruct (evaluate known s)).
  split; trivial. intros leaf. rewrite stands_in_union, value_. split.
  - now intros (_ & u & [<- | []] & below).
  - intros stands. split; [now apply standing_is_open with leaf |]. exists s. split; [now left | assumption].
Qed.

Theorem lone_in_intersection s : alike (Intersection [s]) s.
Proof.
  intros known _.
  assert (value_ : evaluate known (Intersection [s]) = evaluate known s) by (simpl; now destruct (evaluate known s)).
  split; trivial. intros leaf. rewrite stands_in_intersection, value_. split.
  - now intros (_ & u & [<- | []] & below).
  - intros stands. split; [now apply standing_is_open with leaf |]. exists s. split; [now left | assumption].
Qed.

(* An operator gives its operands to one of its kind. *)
Theorem union_in_union ss before after : alike (Union (before ++ Union ss :: after)) (Union (before ++ ss ++ after)).
Proof.
  intros known _.
  assert (value_ : evaluate known (Union (before ++ Union ss :: after)) = evaluate known (Union (before ++ ss ++ after))).
  { simpl. now rewrite !map_app, !any_app. }
  split; trivial. intros leaf. rewrite !stands_in_union, value_.
  split; intros (open & u & inside & below); split; trivial.
  - apply in_app_or in inside as [i | [<- | i]].
    + exists u. split; trivial. apply in_or_app. now left.
    + apply stands_in_union in below as (_ & w & i & below). exists w. split; trivial. rewrite !in_app_iff. tauto.
    + exists u. split; trivial. rewrite !in_app_iff. tauto.
  - rewrite !in_app_iff in inside. destruct inside as [i | [i | i]].
    + exists u. split; trivial. apply in_or_app. now left.
    + exists (Union ss). split; [apply in_or_app; right; now left |]. apply stands_in_union. split; [| now exists u].
      simpl in *. rewrite !map_app, !any_app in open.
      assert (open_u := standing_is_open known u leaf below).
      destruct (any (map (evaluate known) ss)) eqn:value_of_ss; trivial.
      * apply any_no in value_of_ss. rewrite Forall_map, Forall_forall in value_of_ss. now rewrite <- value_of_ss in open_u.
      * revert open. now destruct (any (map (evaluate known) before)), (any (map (evaluate known) after)).
    + exists u. split; trivial. apply in_or_app. right. now right.
Qed.

Theorem intersection_in_intersection ss before after :
  alike (Intersection (before ++ Intersection ss :: after)) (Intersection (before ++ ss ++ after)).
Proof.
  intros known _.
  assert (value_ : evaluate known (Intersection (before ++ Intersection ss :: after))
                   = evaluate known (Intersection (before ++ ss ++ after))).
  { simpl. now rewrite !map_app, !all_app. }
  split; trivial. intros leaf. rewrite !stands_in_intersection, value_.
  split; intros (open & u & inside & below); split; trivial.
  - apply in_app_or in inside as [i | [<- | i]].
    + exists u. split; trivial. apply in_or_app. now left.
    + apply stands_in_intersection in below as (_ & w & i & below). exists w. split; trivial. rewrite !in_app_iff. tauto.
    + exists u. split; trivial. rewrite !in_app_iff. tauto.
  - rewrite !in_app_iff in inside. destruct inside as [i | [i | i]].
    + exists u. split; trivial. apply in_or_app. now left.
    + exists (Intersection ss). split; [apply in_or_app; right; now left |]. apply stands_in_intersection.
      split; [| now exists u]. simpl in *. rewrite !map_app, !all_app in open.
      assert (open_u := standing_is_open known u leaf below).
      destruct (all (map (evaluate known) ss)) eqn:value_of_ss; trivial.
      * revert open. now destruct (all (map (evaluate known) before)), (all (map (evaluate known) after)).
      * apply all_yes in value_of_ss. rewrite Forall_map, Forall_forall in value_of_ss. now rewrite <- value_of_ss in open_u.
    + exists u. split; trivial. apply in_or_app. right. now right.
Qed.
End Rules.

Print Assumptions alike_in_union.
Print Assumptions alike_in_intersection.
Print Assumptions union_drops.
Print Assumptions intersection_drops.
Print Assumptions union_absorbed.
Print Assumptions intersection_absorbed.
Print Assumptions lone_in_union.
Print Assumptions lone_in_intersection.
Print Assumptions union_in_union.
Print Assumptions intersection_in_intersection.
