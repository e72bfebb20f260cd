(* Constants simplified away (SPEC section 3, "stands"): the value of an expression of which some leaves are
   known, and the leaves that are still there. `evaluate` and `reduced` in exact/solid/expression.hpp. *)

From Coq Require Import List Bool Permutation.
From Groundtruth Require Import shapes.
Import ListNotations.
Set Implicit Arguments.

Inductive truth := No | Open | Yes.

Definition either (a b : truth) : truth :=
  match a, b with Yes, _ | _, Yes => Yes | No, No => No | _, _ => Open end.
Definition both (a b : truth) : truth :=
  match a, b with No, _ | _, No => No | Yes, Yes => Yes | _, _ => Open end.
Definition any (truths : list truth) : truth := fold_right either No truths.
Definition all (truths : list truth) : truth := fold_right both Yes truths.

Section Standing.
Variable L : Type.
Implicit Types s t : shape L.
Implicit Types known : L -> truth.

Fixpoint evaluate known s : truth :=
  match s with
  | Leaf leaf => known leaf
  | Union ss => any (map (evaluate known) ss)
  | Intersection ss => all (map (evaluate known) ss)
  end.

Fixpoint standing known s : list L :=
  match evaluate known s with
  | Open =>
    match s with
    | Leaf leaf => [leaf]
    | Union ss | Intersection ss => flat_map (standing known) ss
    end
  | _ => []
  end.

Definition respects (v : L -> bool) known : Prop :=
  forall leaf, match known leaf with Yes => v leaf = true | No => v leaf = false | Open => True end.
(* `more` knows what `known` does, and perhaps more. *)
Definition refines (more known : L -> truth) : Prop :=
  forall leaf, known leaf <> Open -> more leaf = known leaf.

Lemma any_app a b : any (a ++ b) = either (any a) (any b).
Proof. induction a as [| x a IH]; simpl; [now destruct (any b) |]. rewrite IH. now destruct x, (any a), (any b). Qed.
Lemma all_app a b : all (a ++ b) = both (all a) (all b).
Proof. induction a as [| x a IH]; simpl; [now destruct (all b) |]. rewrite IH. now destruct x, (all a), (all b). Qed.
Lemma any_permuted a b : Permutation a b -> any a = any b.
Proof.
  induction 1 as [| x a b _ IH | x y a | a b c _ one _ two]; simpl; trivial.
  - now rewrite IH.
  - now destruct x, y, (any a).
  - now rewrite one.
Qed.
Lemma all_permuted a b : Permutation a b -> all a = all b.
Proof.
  induction 1 as [| x a b _ IH | x y a | a b c _ one _ two]; simpl; trivial.
  - now rewrite IH.
  - now destruct x, y, (all a).
  - now rewrite one.
Qed.

Lemma any_yes truths : any truths = Yes <-> In Yes truths.
Proof.
  induction truths as [| x rest IH]; simpl; [easy |].
  rewrite <- IH. destruct x, (any rest); simpl; intuition easy.
Qed.
Lemma all_no truths : all truths = No <-> In No truths.
Proof.
  induction truths as [| x rest IH]; simpl; [easy |].
  rewrite <- IH. destruct x, (all rest); simpl; intuition easy.
Qed.
Lemma any_no truths : any truths = No <-> Forall (eq No) truths.
Proof.
  induction truths as [| x rest IH]; simpl; [easy |].
  rewrite Forall_cons_iff, <- IH. destruct x, (any rest); simpl; intuition easy.
Qed.
Lemma all_yes truths : all truths = Yes <-> Forall (eq Yes) truths.
Proof.
  induction truths as [| x rest IH]; simpl; [easy |].
  rewrite Forall_cons_iff, <- IH. destruct x, (all rest); simpl; intuition easy.
Qed.
Lemma any_open truths : any truths = Open -> In Open truths.
Proof. induction truths as [| x rest IH]; simpl; [easy |]. destruct x, (any rest); simpl; auto; easy. Qed.
Lemma all_open truths : all truths = Open -> In Open truths.
Proof. induction truths as [| x rest IH]; simpl; [easy |]. destruct x, (all rest); simpl; auto; easy. Qed.

(* What is found with some leaves known holds however the others turn out. *)
Theorem known_values_hold known v s : respects v known ->
  match evaluate known s with Yes => value v s = true | No => value v s = false | Open => True end.
Proof.
  intros agrees. induction s as [leaf | ss IH | ss IH] using shape_induction; simpl.
  - apply agrees.
  - induction IH as [| s ss one _ rest]; simpl in *; trivial.
    destruct (evaluate known s), (any _); simpl; trivial; rewrite ?one, ?rest; trivial; apply orb_true_r.
  - induction IH as [| s ss one _ rest]; simpl in *; trivial.
    destruct (evaluate known s), (all _); simpl; trivial; rewrite ?one, ?rest; trivial; apply andb_false_r.
Qed.

Lemma standing_is_open known s leaf : In leaf (standing known s) -> evaluate known s = Open.
Proof. destruct s; simpl; [destruct (known _) | destruct (any _) | destruct (all _)]; easy. Qed.

Lemma standing_leaf_is_open known s leaf : In leaf (standing known s) -> known leaf = Open /\ In leaf (leaves s).
Proof.
  induction s as [one | ss IH | ss IH] using shape_induction; simpl.
  - destruct (known one) eqn:open; simpl; try easy. intros [<- | []]. split; [assumption | now left].
  - rewrite Forall_forall in IH. destruct (any _); try easy. intros inside.
    apply in_flat_map in inside as (s & operand & below). destruct (IH s operand below).
    split; trivial. now apply leaves_of_operand with s.
  - rewrite Forall_forall in IH. destruct (all _); try easy. intros inside.
    apply in_flat_map in inside as (s & operand & below). destruct (IH s operand below).
    split; trivial. now apply leaves_of_operand with s.
Qed.

Lemma open_operand known ss :
  any (map (evaluate known) ss) = Open \/ all (map (evaluate known) ss) = Open ->
  exists s, In s ss /\ evaluate known s = Open.
Proof.
  intros open. assert (some : In Open (map (evaluate known) ss)) by (destruct open; [now apply any_open | now apply all_open]).
  apply in_map_iff in some as (s & value_of_s & inside). now exists s.
Qed.

(* An expression that is not constant has a leaf left. *)
Theorem open_has_a_standing_leaf known s : evaluate known s = Open -> exists leaf, In leaf (standing known s).
Proof.
  induction s as [leaf | ss IH | ss IH] using shape_induction; simpl; intros open; rewrite open.
  1: exists leaf; now left.
  all: rewrite Forall_forall in IH; destruct (open_operand known ss) as (s & operand & open_s); [tauto |];
    destruct (IH s operand open_s) as (leaf & below); exists leaf; apply in_flat_map; now exists s.
Qed.

Lemma open_with_standing_leaves known v s : respects v known -> evaluate known s = Open ->
  (forall leaf, In leaf (standing known s) -> v leaf = true) -> value v s = true.
Proof.
  intros agrees. induction s as [leaf | ss IH | ss IH] using shape_induction; simpl; intros open; rewrite open; intros stand.
  - apply stand. now left.
  - rewrite Forall_forall in IH. destruct (open_operand known ss) as (s & operand & open_s); [tauto |].
    apply existsb_exists. exists s. split; trivial. apply IH; trivial.
    intros leaf below. apply stand. apply in_flat_map. now exists s.
  - rewrite Forall_forall in IH. apply forallb_forall. intros s operand.
    destruct (evaluate known s) eqn:value_of_s.
    + assert (no : all (map (evaluate known) ss) = No) by (apply all_no; rewrite <- value_of_s; now apply in_map).
      congruence.
    + apply IH; trivial. intros leaf below. apply stand. apply in_flat_map. now exists s.
    + assert (sure := known_values_hold s agrees). now rewrite value_of_s in sure.
Qed.

(* Standing leaves decide: if all of them hold, so does the expression, unless it is known not to. *)
Theorem standing_leaves_decide known v s : respects v known -> evaluate known s <> No ->
  (forall leaf, In leaf (standing known s) -> v leaf = true) -> value v s = true.
Proof.
  intros agrees possible stand. destruct (evaluate known s) eqn:value_of_s; [easy | |].
  - now apply open_with_standing_leaves with known.
  - assert (sure := known_values_hold s agrees). now rewrite value_of_s in sure.
Qed.

Theorem evaluate_refined more known s : refines more known ->
  evaluate known s <> Open -> evaluate more s = evaluate known s.
Proof.
  intros finer. induction s as [leaf | ss IH | ss IH] using shape_induction; simpl; [apply finer | |];
    rewrite Forall_forall in IH; intros sure.
  - destruct (any (map (evaluate known) ss)) eqn:value_of_all; [| easy |].
    + apply any_no. apply any_no in value_of_all. rewrite Forall_map, Forall_forall in *.
      intros s inside. specialize (value_of_all s inside). rewrite IH; congruence.
    + apply any_yes. apply any_yes in value_of_all. apply in_map_iff in value_of_all as (s & yes & inside).
      apply in_map_iff. exists s. split; trivial. rewrite IH; congruence.
  - destruct (all (map (evaluate known) ss)) eqn:value_of_all; [| easy |].
    + apply all_no. apply all_no in value_of_all. apply in_map_iff in value_of_all as (s & no & inside).
      apply in_map_iff. exists s. split; trivial. rewrite IH; congruence.
    + apply all_yes. apply all_yes in value_of_all. rewrite Forall_map, Forall_forall in *.
      intros s inside. specialize (value_of_all s inside). rewrite IH; congruence.
Qed.

(* A leaf that is swallowed stays so when more leaves are replaced (faces.md, 1). *)
Theorem standing_refined more known s leaf : refines more known ->
  In leaf (standing more s) -> In leaf (standing known s).
Proof.
  intros finer. induction s as [one | ss IH | ss IH] using shape_induction; intros stands.
  all: assert (open := standing_is_open more _ leaf stands).
  all: match type of open with evaluate _ ?s = _ =>
         assert (was_open : evaluate known s = Open)
           by (destruct (evaluate known s) eqn:was; trivial; rewrite (evaluate_refined s finer) in open; congruence)
       end.
  all: simpl in *; rewrite open in stands; rewrite was_open; trivial; rewrite Forall_forall in IH;
    apply in_flat_map in stands as (s & operand & below); apply in_flat_map; exists s; auto.
Qed.

(* The order of operands is no matter for what is known, nor for which leaves stand. *)
Theorem evaluate_reordered known s t : reordered s t -> evaluate known s = evaluate known t.
Proof.
  induction 1 as [ | s t u _ one _ two | ss ts swapped | ss ts swapped | s t a b _ IH | s t a b _ IH]; simpl; trivial.
  - congruence.
  - now apply any_permuted, Permutation_map.
  - now apply all_permuted, Permutation_map.
  - rewrite !map_app, !any_app. simpl. now rewrite IH.
  - rewrite !map_app, !all_app. simpl. now rewrite IH.
Qed.

Theorem standing_reordered known s t : reordered s t -> Permutation (standing known s) (standing known t).
Proof.
  intros order. assert (same := evaluate_reordered known order).
  induction order as [ | s t u first one second two | ss ts swapped | ss ts swapped | s t a b below IH | s t a b below IH];
    simpl in *; trivial.
  - apply Permutation_trans with (standing known t); [apply one | apply two]; now apply evaluate_reordered.
  - rewrite same. match goal with |- context [any ?x] => destruct (any x) end; trivial. now apply Permutation_flat_map.
  - rewrite same. match goal with |- context [all ?x] => destruct (all x) end; trivial. now apply Permutation_flat_map.
  - rewrite same. match goal with |- context [any ?x] => destruct (any x) end; trivial. rewrite !flat_map_app. simpl.
    apply Permutation_app_head, Permutation_app_tail, IH. now apply evaluate_reordered.
  - rewrite same. match goal with |- context [all ?x] => destruct (all x) end; trivial. rewrite !flat_map_app. simpl.
    apply Permutation_app_head, Permutation_app_tail, IH. now apply evaluate_reordered.
Qed.
End Standing.

Print Assumptions known_values_hold.
Print Assumptions open_has_a_standing_leaf.
Print Assumptions standing_leaves_decide.
Print Assumptions standing_refined.
Print Assumptions evaluate_reordered.
Print Assumptions standing_reordered.
