(* Lemma 4: growing the offsets lowers the entry, so that SPEC section 6 judges soundly and not laxly
   (proofs-notes/tolerance.md, 1). *)

From Coq Require Import List Bool QArith Lqa.
From Groundtruth Require Import shapes phi.
Import ListNotations.
Open Scope Q_scope.

(* The half-space with its offset grown by `by_`: Delta falls by as much. *)
Definition plane_moved (by_ : course -> Q) (c : course) : course :=
  Course (number c) (at_origin c - by_ c) (slope c).
Definition with_planes_moved (by_ : course -> Q) : shape course -> shape course := mapped (plane_moved by_).

Lemma is_in_mapped (f : course -> course) s l : is_in (mapped f s) l <-> value (fun c => holds_at l (f c)) s = true.
Proof. unfold is_in. now rewrite value_mapped. Qed.

Lemma grown_holds_more less more s l : (forall c, less c <= more c) ->
  is_in (with_planes_moved less s) l -> is_in (with_planes_moved more s) l.
Proof.
  intros grows. unfold with_planes_moved. rewrite !is_in_mapped. apply value_is_monotone. intros c _.
  unfold holds_at. rewrite !Qle_bool_iff. specialize (grows c). unfold delta, plane_moved. simpl. lra.
Qed.

(* Answers in order of lambda, a miss counting as infinity. *)
Definition no_later (a b : answer) : Prop :=
  match a, b with
  | Found h, Found k => place h <= place k
  | Found _, Miss | Miss, Miss => True
  | _, _ => False
  end.

Theorem larger_shape_is_entered_no_later last s t first : first <= last ->
  (forall l, first <= l -> l <= last -> is_in s l -> is_in t l) ->
  no_later (entry last t first) (entry last s first).
Proof.
  intros range larger. assert (of_s := entry_is_right s range). assert (of_t := entry_is_right t range).
  destruct (entry last t first) as [h | |], (entry last s first) as [k | |]; simpl in *; trivial.
  - destruct of_s as ((from & to) & member & _), of_t as (_ & _ & none & _).
    destruct (Qlt_le_dec (place k) (place h)) as [less | more]; trivial.
    exfalso. apply (none (place k)); auto.
  - destruct of_s as ((from & to) & member & _). apply (of_t (place k)); auto.
Qed.

Section Judge.
Variable last first : Q.
Hypothesis range : first <= last.
Variable s : shape course.
(* tau times the length of the leaf's normal, rounded outward. *)
Variable tau : course -> Q.

Definition grown := with_planes_moved tau s.
Definition shrunk := with_planes_moved (fun c => - tau c) s.

Theorem growing_lowers_the_entry : (forall c, 0 <= tau c) ->
  no_later (entry last grown first) (entry last s first) /\ no_later (entry last s first) (entry last shrunk first).
Proof.
  intros positive.
  assert (same : forall l, is_in s l <-> is_in (with_planes_moved (fun _ => 0) s) l).
  { intros l. unfold with_planes_moved. rewrite is_in_mapped. unfold is_in.
    replace (value (holds_at l) s) with (value (fun c => holds_at l (plane_moved (fun _ => 0) c)) s); [tauto |].
    apply value_extensional. intros c _. apply eq_iff_eq_true. unfold holds_at. rewrite !Qle_bool_iff.
    unfold delta, plane_moved. simpl. split; lra. }
  split; apply larger_shape_is_entered_no_later; trivial; intros l _ _.
  - rewrite same. apply grown_holds_more. auto.
  - rewrite same. apply grown_holds_more. intros c. specialize (positive c). lra.
Qed.

(* SPEC section 6 with lambda off by at most `error` (its ulps): what is accepted of an implementation. *)
Definition accepted (error : Q) (answer_got : option Q) : Prop :=
  match answer_got with
  | None => entry last shrunk first = Miss
  | Some l => (exists exact, (first <= exact /\ exact <= last) /\ is_in grown exact
                             /\ (exact - error <= l /\ l <= exact + error))
              /\ (forall h, entry last grown first = Found h -> place h - error <= l)
              /\ (forall h, entry last shrunk first = Found h -> l <= place h + error)
  end.

(* Exact, but for an error in lambda, of some shape whose planes lie within tau of those of S. *)
Definition explained (error : Q) (answer_got : option Q) : Prop :=
  exists by_ : course -> Q, (forall c, - tau c <= by_ c /\ by_ c <= tau c) /\
    match answer_got, entry last (with_planes_moved by_ s) first with
    | None, Miss => True
    | Some l, Found h => place h - error <= l /\ l <= place h + error
    | _, _ => False
    end.

Theorem acceptance_is_sound error got : explained error got -> accepted error got.
Proof.
  intros (by_ & close & exact).
  assert (low : no_later (entry last grown first) (entry last (with_planes_moved by_ s) first)).
  { apply larger_shape_is_entered_no_later; trivial. intros l _ _. apply grown_holds_more. firstorder. }
  assert (high : no_later (entry last (with_planes_moved by_ s) first) (entry last shrunk first)).
  { apply larger_shape_is_entered_no_later; trivial. intros l _ _. apply grown_holds_more. firstorder. }
  assert (right_ := entry_is_right (with_planes_moved by_ s) range).
  destruct got as [l |], (entry last (with_planes_moved by_ s) first) as [h | |]; try tauto; simpl.
  - destruct right_ as (bounds & member & _). split; [| split].
    + exists (place h). split; [assumption |]. split; [| assumption].
      revert member. apply grown_holds_more. firstorder.
    + intros k found. rewrite found in low. simpl in low. lra.
    + intros k found. rewrite found in high. simpl in high. lra.
  - destruct (entry last shrunk first); simpl in high; easy.
Qed.

(* An accepted hit lies, but for the error, in S + tau and not behind the entry of S - tau. *)
Theorem acceptance_is_not_lax error got : accepted error got ->
  match got with
  | Some l => (exists exact, (first <= exact /\ exact <= last) /\ is_in grown exact
                             /\ (exact - error <= l /\ l <= exact + error))
              /\ (forall m, first <= m -> m <= last -> m < l - error -> ~ is_in shrunk m)
  | None => forall m, first <= m -> m <= last -> ~ is_in shrunk m
  end.
Proof.
  assert (right_ := entry_is_right shrunk range). destruct got as [l |]; simpl.
  - intros (near & _ & behind). split; [exact near |]. intros m from to before.
    destruct (entry last shrunk first) as [h | |]; simpl in right_; [| now apply right_ | easy].
    specialize (behind h eq_refl). apply right_; trivial. lra.
  - intros misses. rewrite misses in right_. exact right_.
Qed.
End Judge.

Print Assumptions larger_shape_is_entered_no_later.
Print Assumptions growing_lowers_the_entry.
Print Assumptions acceptance_is_sound.
Print Assumptions acceptance_is_not_lax.
