(* Lemma 7: the first place in an expression of cells (fast/first_place.hpp, FirstPlace), and what fast/sieved.cpp, meet(),
   makes of it: read with every error to its advantage an expression is met no later, read with every error against it
   the place that is found is one of the solid (proofs-notes/rounding.md, "What is certain of parts"). *)

From Coq Require Import List Bool QArith Lqa.
From Groundtruth Require Import shapes.
Import ListNotations.
Open Scope Q_scope.
Set Implicit Arguments.

Section FirstPlace.
Variable cell : Type.
Variable inside : cell -> Q -> bool.
Notation is_in s l := (value (fun c => inside c l) s = true).

(* What `first_in` is of a cell, and `earliest` of any node: no place before it, the first one itself iff that is in. *)
Definition is_bound (s : shape cell) (first last : Q) (found : option Q) : Prop :=
  match found with
  | Some n => (first <= n /\ n <= last) /\ (forall l, first <= l -> l < n -> ~ is_in s l) /\ (n == first -> is_in s first)
  | None => forall l, first <= l -> l <= last -> ~ is_in s l
  end.

Variable first_in : cell -> Q -> Q -> option Q.
Hypothesis first_in_is_bound : forall c first last, first <= last -> is_bound (Leaf c) first last (first_in c first last).

(* Unions end where an operand holds at once, and look for the next ones no further than the best; intersections go to the
   latest of their operands. *)
Fixpoint earliest (s : shape cell) (first last : Q) {struct s} : option Q :=
  match s with
  | Leaf c => first_in c first last
  | Union ss =>
    (fix among (ss : list (shape cell)) (last : Q) (best : option Q) : option Q :=
      match ss with
      | [] => best
      | t :: rest =>
        match earliest t first last with
        | None => among rest last best
        | Some n => if Qlt_le_dec first n then among rest n (Some n) else Some n
        end
      end) ss last None
  | Intersection ss =>
    (fix latest (ss : list (shape cell)) (at_ : Q) : option Q :=
      match ss with
      | [] => Some at_
      | t :: rest =>
        match earliest t first last with
        | None => None
        | Some n => latest rest (if Qlt_le_dec at_ n then n else at_)
        end
      end) ss first
  end.

Hypothesis same_place : forall c l m, l == m -> inside c l = inside c m.

Theorem earliest_is_bound : forall s first last, first <= last -> is_bound s first last (earliest s first last).
Proof.
  induction s as [c | ss IH | ss IH] using shape_induction; intros first last range; [now apply first_in_is_bound | |].
  - rewrite Forall_forall in IH.
    enough (general : forall passed rest now best, ss = passed ++ rest -> first <= now -> now <= last ->
      match best with Some n => n == now /\ first < n | None => now == last end ->
      (forall t l, In t passed -> first <= l -> (match best with Some _ => l < now | None => l <= now end) -> ~ is_in t l) ->
      is_bound (Union ss) first last ((fix among (ss : list (shape cell)) (last : Q) (best : option Q) : option Q :=
        match ss with [] => best | t :: rest => match earliest t first last with None => among rest last best
          | Some n => if Qlt_le_dec first n then among rest n (Some n) else Some n end end) rest now best)).
    { apply (general [] ss last None); trivial; try lra. intros t l []. }
    intros passed rest. revert passed. induction rest as [| t rest IHrest]; intros passed now best split_ from_now to_now best_now none.
    + rewrite app_nil_r in split_. subst passed. destruct best as [n |]; simpl.
      * split; [lra |]. split; [| intros; lra]. intros l from_l before there. apply existsb_exists in there as (t & below & holds).
        apply (none t l below from_l ltac:(lra) holds).
      * intros l from_l to_l there. apply existsb_exists in there as (t & below & holds). apply (none t l below from_l ltac:(lra) holds).
    + assert (is_operand : In t ss) by (subst ss; apply in_or_app; right; now left).
      assert (bound := IH t is_operand first now from_now).
      assert (split' : ss = (passed ++ [t]) ++ rest) by (rewrite <- app_assoc; assumption).
      destruct (earliest t first now) as [n |]; simpl in bound.
      * destruct bound as ((from_n & to_n) & before & at_first). destruct (Qlt_le_dec first n) as [later | at_once].
        -- apply (IHrest (passed ++ [t])); [exact split' | lra | lra | split; [reflexivity | exact later] |]. intros u l below from_l less.
           apply in_app_or in below as [below | [<- | []]]; [| now apply before].
           apply (none u l below from_l). destruct best; lra.
        -- simpl. split; [lra |]. split; [intros; lra |]. intros _. apply existsb_exists. exists t. split; trivial. apply at_first. lra.
      * apply (IHrest (passed ++ [t])); [exact split' | exact from_now | exact to_now | exact best_now |]. intros u l below from_l less.
        apply in_app_or in below as [below | [<- | []]]; [now apply none |]. apply bound; trivial. destruct best; lra.
  - rewrite Forall_forall in IH.
    enough (general : forall passed rest at_, ss = passed ++ rest -> first <= at_ -> at_ <= last ->
      (forall l, first <= l -> l < at_ -> exists t, In t passed /\ ~ is_in t l) ->
      (at_ == first -> forall t, In t passed -> is_in t first) ->
      is_bound (Intersection ss) first last ((fix latest (ss : list (shape cell)) (at_ : Q) : option Q :=
        match ss with [] => Some at_ | t :: rest => match earliest t first last with None => None
          | Some n => latest rest (if Qlt_le_dec at_ n then n else at_) end end) rest at_)).
    { apply (general [] ss first); trivial; try lra. intros l from_l less. exfalso. lra. intros _ t []. }
    intros passed rest. revert passed. induction rest as [| t rest IHrest]; intros passed at_ split_ from_at to_at none at_first.
    + rewrite app_nil_r in split_. subst passed. simpl. split; [lra |]. split.
      * intros l from_l less there. destruct (none l from_l less) as (t & below & out). apply out. rewrite forallb_forall in there. now apply there.
      * intros e. apply forallb_forall. now apply at_first.
    + assert (is_operand : In t ss) by (subst ss; apply in_or_app; right; now left).
      assert (bound := IH t is_operand first last range).
      assert (split' : ss = (passed ++ [t]) ++ rest) by (rewrite <- app_assoc; assumption).
      destruct (earliest t first last) as [n |]; simpl in bound.
      * destruct bound as ((from_n & to_n) & before & now_). apply (IHrest (passed ++ [t])); [exact split' | destruct (Qlt_le_dec at_ n); lra | destruct (Qlt_le_dec at_ n); lra | |].
        -- intros l from_l less. destruct (Qlt_le_dec l at_) as [sooner | not_sooner].
           ++ destruct (none l from_l sooner) as (u & below & out). exists u. split; trivial. apply in_or_app. now left.
           ++ exists t. split; [apply in_or_app; right; now left |]. apply before; trivial. destruct (Qlt_le_dec at_ n); lra.
        -- intros e u below. apply in_app_or in below as [below | [<- | []]].
           ++ apply at_first; trivial. destruct (Qlt_le_dec at_ n); lra.
           ++ apply now_. destruct (Qlt_le_dec at_ n); lra.
      * intros l from_l to_l there. simpl in there. rewrite forallb_forall in there. apply (bound l from_l to_l). now apply there.
Qed.

(* `of`: rounds, each from a place further on, until nothing is left or the bound is the place itself. *)
Inductive rounds (s : shape cell) (last : Q) : Q -> option Q -> Prop :=
| none_left first : earliest s first last = None -> rounds s last first None
| arrived first n : earliest s first last = Some n -> n <= first -> rounds s last first (Some n)
| further first n found : earliest s first last = Some n -> first < n -> rounds s last n found -> rounds s last first found.

Theorem first_place_is_right : forall s last first found, rounds s last first found -> first <= last ->
  match found with
  | Some n => (first <= n /\ n <= last) /\ is_in s n /\ forall l, first <= l -> l < n -> ~ is_in s l
  | None => forall l, first <= l -> l <= last -> ~ is_in s l
  end.
Proof.
  intros s last first found run. induction run as [first e | first n e back | first n found e on run IH]; intros range;
    assert (bound := earliest_is_bound s range); rewrite e in bound; simpl in bound; trivial.
  - destruct bound as ((from_n & to_n) & before & now_). assert (same : n == first) by lra.
    split; [lra |]. split; [| exact before]. specialize (now_ same).
    rewrite (value_extensional s _ (fun c => inside c first)); trivial. intros c _. now apply same_place.
  - destruct bound as ((from_n & to_n) & before & _). specialize (IH to_n). destruct found as [m |].
    + destruct IH as (r & there & none). split; [lra |]. split; trivial. intros l from_l less.
      destruct (Qlt_le_dec l n); [now apply before | now apply none].
    + intros l from_l to_l. destruct (Qlt_le_dec l n); [now apply before | now apply IH].
Qed.
End FirstPlace.

(* Readings: `grown` holds wherever the half-space does, `shrunk` only there. *)
Section Readings.
Variable L : Type.
Variables (holds grown shrunk : L -> Q -> bool).
Variable s : shape L.

Theorem met_no_sooner_than_grown : (forall c l, holds c l = true -> grown c l = true) -> forall first lower,
  (forall l, first <= l -> l < lower -> value (fun c => grown c l) s <> true) ->
  forall l, first <= l -> value (fun c => holds c l) s = true -> lower <= l.
Proof.
  intros more first lower none l from_l there. destruct (Qlt_le_dec l lower) as [less |]; trivial. exfalso.
  apply (none l from_l less). revert there. apply value_is_monotone. intros c _. apply more.
Qed.

Theorem met_where_shrunk : (forall c l, shrunk c l = true -> holds c l = true) -> forall l,
  value (fun c => shrunk c l) s = true -> value (fun c => holds c l) s = true.
Proof. intros less l. apply value_is_monotone. intros c _. apply less. Qed.
End Readings.

Print Assumptions earliest_is_bound.
Print Assumptions first_place_is_right.
Print Assumptions met_no_sooner_than_grown.
Print Assumptions met_where_shrunk.
