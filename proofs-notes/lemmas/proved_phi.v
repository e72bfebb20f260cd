(* Lemmas 1 and 3 as one computation: what an entry ask is answered (SPEC section 3). Extracted to OCaml by
   oracle/proved (entry-point.md, 7). *)

From Coq Require Import List Bool Arith ZArith QArith Qabs Lqa Lia.
From Groundtruth Require Import shapes standing faces simplifications finding_faces interior phi.
Import ListNotations.
Open Scope Q_scope.

Inductive reply :=
| Misses
| Inside (lambda : Q)
| Border (lambda : Q) (canonical : half_space) (admissible_ : list half_space).

Definition toward (from to : vector) : vector := Vector (x to - x from) (y to - y from) (z to - z from).
Definition point (from to : vector) (l : Q) : vector :=
  let p := plus from (scaled l (toward from to)) in Vector (Qred (x p)) (Qred (y p)) (Qred (z p)).

Definition smaller (g h : half_space) : half_space :=
  if (local_shape.number h <? local_shape.number g)%nat then h else g.

(* Entered leaves count beyond the start. *)
Definition entered (from to : vector) (first l : Q) : option vector :=
  if Qlt_le_dec first l then Some (toward from to) else None.

Definition border (s : shape half_space) (from to : vector) (first l : Q) : reply :=
  match admissible_leaves s (point from to l) (entered from to first l) with
  | [] => Misses
  | one :: rest => Border l (fold_right smaller one rest) (one :: rest)
  end.

Definition reply_to (s : shape half_space) (from to : vector) (first last : Q) : reply :=
  match entry last (along from (toward from to) s) first with
  | Miss | OutOfFuel => Misses
  | Found h =>
    let l := Qred (place h) in
    if Qlt_le_dec first l then border s from to first l
    else if interior_found s (point from to l) then Inside l
    else border s from to first l
  end.

Local Opaque Qred.
Lemma member_at_point s from to l : member s (point from to l) <-> member s (plus from (scaled l (toward from to))).
Proof. split; apply member_same; first [apply Qred_correct | symmetry; apply Qred_correct]. Qed.

Definition is_smallest (c : half_space) (hs : list half_space) : Prop :=
  In c hs /\ forall h, In h hs -> (local_shape.number c <= local_shape.number h)%nat.

Lemma smallest_of one rest : is_smallest (fold_right smaller one rest) (one :: rest).
Proof.
  unfold is_smallest. induction rest as [| g rest (inside & least_)]; cbn [fold_right].
  - split; [now left |]. intros h [<- | []]. lia.
  - set (c := fold_right smaller one rest) in *. unfold smaller. simpl in *.
    destruct (Nat.ltb_spec (local_shape.number c) (local_shape.number g)).
    + split; [tauto |]. intros h [<- | [<- | there]]; [auto | lia | auto].
    + assert (first_ := least_ one (or_introl eq_refl)). split; [auto |].
      intros h [<- | [<- | there]]; [lia | lia |]. specialize (least_ h (or_intror there)). lia.
Qed.

(* SPEC section 3, word by word. *)
Definition is_entry_point (s : shape half_space) (from to : vector) (first last l : Q) : Prop :=
  (first <= l /\ l <= last) /\ member s (point from to l)
  /\ forall sooner, first <= sooner -> sooner < l -> ~ member s (point from to sooner).

Definition reply_is_right (s : shape half_space) (from to : vector) (first last : Q) (r : reply) : Prop :=
  match r with
  | Misses => forall l, first <= l -> l <= last -> ~ member s (point from to l)
  | Inside l => is_entry_point s from to first last l /\ l == first /\ interior s (point from to l)
  | Border l c hs =>
    is_entry_point s from to first last l /\ (l == first -> ~ interior s (point from to l))
    /\ (forall i, In i hs <-> admissible s (point from to l) (entered from to first l) i) /\ is_smallest c hs
  end.

Lemma border_is_right s from to first last l : is_entry_point s from to first last l ->
  (l == first -> ~ interior s (point from to l)) -> reply_is_right s from to first last (border s from to first l).
Proof.
  intros is_entry on_border. unfold border. set (p := point from to l) in *.
  assert (right_ := admissible_leaves_are_right s p (entered from to first l)).
  destruct (admissible_leaves s p (entered from to first l)) as [| one rest] eqn:found.
  - exfalso. assert (none : forall i, ~ admissible s p (entered from to first l) i)
      by (intros i admissible_; now apply right_ in admissible_).
    destruct is_entry as ((from_ & to_) & inside & before). revert none. unfold entered.
    destruct (Qlt_le_dec first l) as [beyond | at_start].
    + intros none. apply (some_leaf_is_admissible_beyond s p (toward from to) inside); trivial.
      intros far some. destruct (below_both far (l - first) some ltac:(lra)) as (t & above & at_far & at_start).
      exists t. split; trivial. split; trivial. intros there. apply (before (l - t)); try lra.
      apply member_at_point. revert there. unfold p, toward. apply member_same; unfold plus, scaled, point;
        cbn [local_shape.x local_shape.y local_shape.z]; rewrite ?Qred_correct; unfold plus, scaled, toward;
        cbn [local_shape.x local_shape.y local_shape.z]; ring.
    + intros none. apply (some_leaf_is_admissible_at_the_start s p inside); trivial. apply on_border. lra.
  - simpl. split; trivial. split; trivial. split; trivial. apply smallest_of.
Qed.

(* The proved answer: total, the smallest lambda, inside or the admissible leaves, the canonical one among them. *)
Theorem reply_to_is_right s from to first last : first <= last ->
  reply_is_right s from to first last (reply_to s from to first last).
Proof.
  intros range. unfold reply_to.
  assert (right_ := @entry_is_right last (along from (toward from to) s) first range).
  destruct (entry last (along from (toward from to) s) first) as [h | |]; [| | easy].
  - destruct right_ as ((from_ & to_) & inside & before & _). assert (same := Qred_correct (place h)).
    assert (is_entry : is_entry_point s from to first last (Qred (place h))).
    { split; [split; lra |]. split.
      - apply member_at_point. apply is_in_along. apply is_in_same with (place h); [symmetry; exact same | assumption].
      - intros l from_l to_l there. apply (before l); [lra | lra |]. apply is_in_along. exact (proj1 (member_at_point s from to l) there). }
    destruct (Qlt_le_dec first (Qred (place h))) as [beyond | at_start].
    + apply border_is_right with (last := last); trivial. intros start. lra.
    + destruct (interior_found s _) eqn:found.
      * apply interior_found_iff in found. simpl. split; trivial. split; trivial. destruct is_entry as ((a & _) & _). lra.
      * apply border_is_right with (last := last); trivial. intros _ inside_.
        apply interior_found_iff in inside_. congruence.
  - intros l from_l to_l there. apply (right_ l from_l to_l). apply is_in_along. exact (proj1 (member_at_point s from to l) there).
Qed.

Print Assumptions reply_to_is_right.
