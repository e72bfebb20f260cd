(* The recursive algorithm for the entry point (SPEC section 3; proofs-notes/entry-point.md, 2) over the rationals,
   and what its answers must be. Lemma 1, in phi.v, says that they are.

   The restart loop of an intersection is given fuel: one round more than it has leaves. *)

From Coq Require Import List Bool QArith.
From Groundtruth Require Import shapes.
Import ListNotations.
Open Scope Q_scope.
Set Implicit Arguments.

(* `repeat split` would unfold an inequality. *)
Ltac conjuncts := lazymatch goal with |- _ /\ _ => split; conjuncts | |- _ => idtac end.

(* A half-space along the segment: Delta(x(l)) = at_origin + slope l. *)
Record course := Course { number : nat; at_origin : Q; slope : Q }.
Definition delta (c : course) (l : Q) : Q := at_origin c + slope c * l.
Definition holds_at (l : Q) (c : course) : bool := Qle_bool (delta c l) 0.
Definition is_in (s : shape course) (l : Q) : Prop := value (holds_at l) s = true.

(* Where the shape is entered, and the leaf whose plane is met there, if one is named. *)
Record hit := Hit { place : Q; face : option course }.
Inductive answer := Found (h : hit) | Miss | OutOfFuel.

Section Algorithm.
Variable last : Q.

Definition half_space_entry (c : course) (first : Q) : answer :=
  if Qlt_le_dec 0 (delta c first) then
    if Qlt_le_dec (slope c) 0 then
      let crossing := - at_origin c / slope c in
      if Qlt_le_dec last crossing then Miss else Found (Hit crossing (Some c))
    else Miss
  else Found (Hit first (if Qlt_le_dec (delta c first) 0 then None else Some c)).

Definition earlier (one other : answer) : answer :=
  match one, other with
  | OutOfFuel, _ | _, OutOfFuel => OutOfFuel
  | Miss, any | any, Miss => any
  | Found h, Found k => if Qlt_le_dec (place k) (place h) then Found k else Found h
  end.

Definition moved (now next : hit) : hit :=
  if Qlt_le_dec (place now) (place next) then next
  else match face now with None => Hit (place now) (face next) | Some _ => now end.

Fixpoint round (operands : list (Q -> answer)) (now : hit) : answer :=
  match operands with
  | [] => Found now
  | ask :: rest =>
    match ask (place now) with Found next => round rest (moved now next) | other => other end
  end.

Fixpoint rounds (fuel : nat) (operands : list (Q -> answer)) (now : hit) : answer :=
  match fuel with
  | O => OutOfFuel
  | S fuel =>
    match round operands now with
    | Found next => if Qlt_le_dec (place now) (place next) then rounds fuel operands next else Found next
    | other => other
    end
  end.

Fixpoint entry (s : shape course) (first : Q) : answer :=
  match s with
  | Leaf c => half_space_entry c first
  | Union ss => fold_right earlier Miss (map (fun s => entry s first) ss)
  | Intersection ss => rounds (S (length (flat_map leaves ss))) (map entry ss) (Hit first None)
  end.

(* What an answer must be. A named leaf lies at the hit, and is entered there if the hit is beyond the start;
   if none is named the hit is the start. *)
Definition named (s : shape course) (first : Q) (h : hit) : Prop :=
  match face h with
  | Some c => In c (leaves s) /\ delta c (place h) == 0 /\ (first < place h -> slope c < 0)
  | None => place h == first
  end.

Definition right (s : shape course) (first : Q) (a : answer) : Prop :=
  match a with
  | Found h => (first <= place h /\ place h <= last) /\ is_in s (place h)
               /\ (forall l, first <= l -> l < place h -> ~ is_in s l) /\ named s first h
  | Miss => forall l, first <= l -> l <= last -> ~ is_in s l
  | OutOfFuel => False
  end.

Lemma is_in_leaf c l : is_in (Leaf c) l <-> delta c l <= 0.
Proof. unfold is_in, holds_at; simpl. apply Qle_bool_iff. Qed.

Lemma is_in_union ss l : is_in (Union ss) l <-> exists s, In s ss /\ is_in s l.
Proof. unfold is_in; simpl. apply existsb_exists. Qed.

Lemma is_in_intersection ss l : is_in (Intersection ss) l <-> forall s, In s ss -> is_in s l.
Proof. unfold is_in; simpl. apply forallb_forall. Qed.

Lemma is_in_same s l m : l == m -> is_in s l -> is_in s m.
Proof.
  intros same. apply value_is_monotone. intros c _. unfold holds_at.
  rewrite !Qle_bool_iff. unfold delta. now rewrite same.
Qed.
End Algorithm.

Print Assumptions is_in_same.
