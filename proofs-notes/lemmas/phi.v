(* Lemma 1: the recursive algorithm (recursion.v; proofs-notes/entry-point.md, 2 to 4) is total and right on any
   positive n-ary expression over the rationals, whatever the order of operands. That no loop runs out of fuel is
   part of the theorem. *)

From Coq Require Import List Bool Permutation QArith Lqa Lia.
From Groundtruth Require Export recursion.
From Groundtruth Require Import shapes.
Import ListNotations.
Open Scope Q_scope.
Set Implicit Arguments.

Section Proof.
Variable last : Q.
Local Notation half_space_entry := (half_space_entry last).
Local Notation entry := (entry last).
Local Notation right := (right last).

Lemma half_space_entry_is_right c first : first <= last -> right (Leaf c) first (half_space_entry c first).
Proof.
  intros range. unfold half_space_entry.
  destruct (Qlt_le_dec 0 (delta c first)) as [out | inside].
  - destruct (Qlt_le_dec (slope c) 0) as [falls | rises].
    + set (x := - at_origin c / slope c).
      assert (meets : delta c x == 0) by (unfold delta, x; field; lra).
      assert (before : forall l, l < x -> ~ is_in (Leaf c) l).
      { intros l less. rewrite is_in_leaf. unfold delta in *. nra. }
      assert (first < x) by (unfold delta in *; nra).
      destruct (Qlt_le_dec last x) as [far | near]; simpl.
      * intros l _ bound. apply before. lra.
      * unfold named; simpl. conjuncts; try lra.
        -- rewrite is_in_leaf. lra.
        -- intros l _. apply before.
        -- now left.
    + simpl. intros l from _. rewrite is_in_leaf. unfold delta in *. nra.
  - simpl. conjuncts; try lra.
    + now rewrite is_in_leaf.
    + intros l; lra.
    + unfold named; simpl. destruct (Qlt_le_dec (delta c first) 0) as [strict | not]; simpl.
      * reflexivity.
      * split; [now left |]. split; lra.
Qed.

Section TwoOperands.
Variables s t u : shape course.
Variable first : Q.
Hypothesis both : forall l, is_in u l <-> is_in s l \/ is_in t l.
Hypothesis named_by_s : forall h, named s first h -> named u first h.
Hypothesis named_by_t : forall h, named t first h -> named u first h.

Lemma earlier_is_right a b : right s first a -> right t first b -> right u first (earlier a b).
Proof.
  destruct a as [h | |], b as [k | |]; simpl; try tauto.
  - intros (range & member & none & name) (range' & member' & none' & name').
    destruct (Qlt_le_dec (place k) (place h)) as [less | more]; simpl.
    + split; [assumption |]. split; [apply both; now right |]. split; [| now apply named_by_t].
      intros l from before. rewrite both. intros [b | b]; [apply (none l) | apply (none' l)]; trivial; lra.
    + split; [assumption |]. split; [apply both; now left |]. split; [| now apply named_by_s].
      intros l from before. rewrite both. intros [b | b]; [apply (none l) | apply (none' l)]; trivial; lra.
  - intros (range & member & none & name) misses.
    split; [assumption |]. split; [apply both; now left |]. split; [| now apply named_by_s].
    intros l from before. rewrite both. intros [b | b]; [apply (none l) | apply (misses l)]; trivial; lra.
  - intros misses (range & member & none & name).
    split; [assumption |]. split; [apply both; now right |]. split; [| now apply named_by_t].
    intros l from before. rewrite both. intros [b | b]; [apply (misses l) | apply (none l)]; trivial; lra.
  - intros misses misses' l from to. rewrite both. intros [b | b]; [apply (misses l) | apply (misses' l)]; trivial.
Qed.
End TwoOperands.

Lemma named_above s u first h : (forall c, In c (leaves s) -> In c (leaves u)) -> named s first h -> named u first h.
Proof. intros above. unfold named. destruct (face h) as [c |]; trivial. intros (below & rest). auto. Qed.

Lemma union_is_right ss first :
  (forall s, In s ss -> right s first (entry s first)) ->
  right (Union ss) first (fold_right earlier Miss (map (fun s => entry s first) ss)).
Proof.
  induction ss as [| s ss IH]; intros all.
  - simpl. intros l _ _. rewrite is_in_union. intros (s & [] & _).
  - simpl map. simpl fold_right. apply earlier_is_right with s (Union ss).
    + intros l. unfold is_in. simpl. apply orb_true_iff.
    + intros h. apply named_above. intros c below. simpl. apply in_or_app. now left.
    + intros h. apply named_above. intros c below. simpl. apply in_or_app. now right.
    + apply all. now left.
    + apply IH. intros t inside. apply all. now right.
Qed.

(* How many leaves of the intersection lie ahead: each can move the loop once. *)
Definition is_ahead (l : Q) (c : course) : bool :=
  if Qlt_le_dec (slope c) 0 then if Qlt_le_dec 0 (delta c l) then true else false else false.
Definition ahead (cs : list course) (l : Q) : nat := length (filter (is_ahead l) cs).

Lemma is_ahead_iff l c : is_ahead l c = true <-> slope c < 0 /\ 0 < delta c l.
Proof.
  unfold is_ahead. destruct (Qlt_le_dec (slope c) 0), (Qlt_le_dec 0 (delta c l)); split; intros;
    try easy; try (exfalso; lra).
Qed.

Lemma ahead_falls cs l m : l <= m -> (ahead cs m <= ahead cs l)%nat.
Proof.
  intros further. unfold ahead. induction cs as [| c cs IH]; simpl; trivial.
  destruct (is_ahead m c) eqn:later.
  - assert (sooner : is_ahead l c = true).
    { apply is_ahead_iff in later. apply is_ahead_iff. unfold delta in *. split; nra. }
    rewrite sooner. simpl. lia.
  - destruct (is_ahead l c); simpl; lia.
Qed.

Lemma ahead_falls_at_a_crossing cs l m c :
  l < m -> In c cs -> delta c m == 0 -> slope c < 0 -> (ahead cs m < ahead cs l)%nat.
Proof.
  intros further inside meets falls. induction cs as [| d cs IH]; [easy |]. simpl in inside.
  assert (rest := ahead_falls cs (Qlt_le_weak _ _ further)). unfold ahead in *. simpl.
  destruct inside as [-> | inside].
  - assert (sooner : is_ahead l c = true) by (apply is_ahead_iff; unfold delta in *; split; nra).
    assert (later : is_ahead m c = false).
    { destruct (is_ahead m c) eqn:eq; trivial. apply is_ahead_iff in eq. lra. }
    rewrite sooner, later. simpl. lia.
  - specialize (IH inside). destruct (is_ahead m d) eqn:later.
    + assert (sooner : is_ahead l d = true).
      { apply is_ahead_iff in later. apply is_ahead_iff. unfold delta in *. split; nra. }
      rewrite sooner. simpl. lia.
    + destruct (is_ahead l d); simpl; lia.
Qed.

Section Loop.
Variable all : list (shape course).
Variable first : Q.
Hypothesis operands_are_right : forall s, In s all -> forall from, from <= last -> right s from (entry s from).

(* No point of the intersection lies before `now`. *)
Definition invariant (now : hit) : Prop :=
  (first <= place now /\ place now <= last)
  /\ (forall l, first <= l -> l < place now -> ~ is_in (Intersection all) l)
  /\ named (Intersection all) first now.

Lemma moved_keeps_invariant s now next : In s all ->
  invariant now -> right s (place now) (Found next) -> invariant (moved now next).
Proof.
  intros inside (range & none & name) (range' & member & none' & name'). unfold moved.
  destruct (Qlt_le_dec (place now) (place next)) as [moves | stays].
  - split; [split; lra |]. split.
    + intros l from less is_member. destruct (Qlt_le_dec l (place now)) as [b | b].
      * now apply (none l).
      * apply (none' l); trivial. rewrite is_in_intersection in is_member. now apply is_member.
    + unfold named in *. destruct (face next) as [c |]; [| lra].
      destruct name' as (below & meets & entered). split; [| split; trivial].
      * now apply leaves_of_operand with s.
      * intros _. now apply entered.
  - destruct (face now) as [c |] eqn:was; [split; tauto |].
    split; [assumption |]. split; [assumption |]. unfold named in *. simpl. rewrite was in name.
    destruct (face next) as [c |]; trivial. destruct name' as (below & meets & entered).
    split; [now apply leaves_of_operand with s |]. split.
    + assert (same : place next == place now) by lra. unfold delta in *. now rewrite <- same.
    + intros; lra.
Qed.

Lemma round_is_right ss now : incl ss all -> invariant now ->
  match round (map entry ss) now with
  | Found next => invariant next /\ place now <= place next
                  /\ (place next <= place now -> forall s, In s ss -> is_in s (place now))
  | Miss => forall l, first <= l -> l <= last -> ~ is_in (Intersection all) l
  | OutOfFuel => False
  end.
Proof.
  revert now. induction ss as [| s ss IH]; intros now within inv; simpl.
  - split; [assumption |]. split; [lra | easy].
  - assert (inside : In s all) by (apply within; now left).
    assert (asked := @operands_are_right s inside (place now) (proj2 (proj1 inv))).
    destruct (entry s (place now)) as [next | |] eqn:found; [| | easy].
    + assert (kept := @moved_keeps_invariant s now next inside inv asked).
      assert (later : place now <= place (moved now next)
                      /\ (place (moved now next) <= place now -> place next <= place now)).
      { unfold moved. destruct (Qlt_le_dec (place now) (place next)); [split; lra |].
        destruct (face now); simpl; split; lra. }
      specialize (IH (moved now next) (fun t b => within t (or_intror b)) kept).
      destruct (round (map entry ss) (moved now next)) as [end_ | |]; trivial.
      destruct IH as (ends & up & members). split; [assumption |]. split; [lra |].
      intros stays t [<- | below].
      * destruct asked as (range & member & _). apply is_in_same with (place next); trivial. lra.
      * apply is_in_same with (place (moved now next)); [lra |]. apply members; trivial. lra.
    + intros l from to member. destruct (Qlt_le_dec l (place now)) as [before | after].
      * now apply (proj1 (proj2 inv) l).
      * apply (asked l); trivial. rewrite is_in_intersection in member. now apply member.
Qed.

Lemma rounds_are_right fuel now : invariant now ->
  (ahead (flat_map leaves all) (place now) < fuel)%nat ->
  right (Intersection all) first (rounds fuel (map entry all) now).
Proof.
  revert now. induction fuel as [| fuel IH]; intros now inv enough; [lia |]. simpl.
  assert (ran := round_is_right (incl_refl all) inv).
  destruct (round (map entry all) now) as [next | |]; trivial.
  destruct ran as (ends & up & members). destruct (Qlt_le_dec (place now) (place next)) as [moves | stays].
  - assert (above := proj1 (proj1 inv)). apply IH; trivial. destruct ends as (range & _ & name). unfold named in name.
    destruct (face next) as [c |]; [| lra].
    destruct name as (below & meets & entered).
    assert (falls : slope c < 0) by (apply entered; lra).
    assert (less := ahead_falls_at_a_crossing _ moves below meets falls). simpl in less. lia.
  - destruct ends as (range & none & name). split; [assumption |]. split; [| split; assumption].
    apply is_in_intersection. intros s inside. apply is_in_same with (place now); [lra |]. now apply members.
Qed.
End Loop.

Lemma ahead_of_all cs l : (ahead cs l <= length cs)%nat.
Proof. unfold ahead. induction cs as [| c cs IH]; simpl; trivial. destruct (is_ahead l c); simpl; lia. Qed.

(* Lemma restart-loop-ends, and that what it finds is the smallest. *)
Theorem entry_is_right s : forall first, first <= last -> right s first (entry s first).
Proof.
  induction s as [c | ss IH | ss IH] using shape_induction; intros first range.
  - now apply half_space_entry_is_right.
  - rewrite Forall_forall in IH. apply union_is_right. auto.
  - rewrite Forall_forall in IH. cbn [entry]. apply rounds_are_right; [auto | | ].
    + split; [simpl; split; lra |]. split; [intros l; simpl; lra |]. unfold named. simpl. reflexivity.
    + assert (some := ahead_of_all (flat_map leaves ss) first). simpl. lia.
Qed.
End Proof.

(* Two answers agree: both a miss, or the same place. *)
Definition agree (a b : answer) : Prop :=
  match a, b with
  | Found h, Found k => place h == place k
  | Miss, Miss => True
  | _, _ => False
  end.

Theorem right_answers_agree last s t first a b :
  (forall l, first <= l -> l <= last -> (is_in s l <-> is_in t l)) ->
  right last s first a -> right last t first b -> agree a b.
Proof.
  intros same. destruct a as [h | |], b as [k | |]; simpl; try tauto.
  - intros (range & member & none & _) (range' & member' & none' & _).
    destruct (Qlt_le_dec (place h) (place k)) as [less | more].
    + exfalso. apply (none' (place h)); try lra. apply same; tauto.
    + destruct (Qlt_le_dec (place k) (place h)) as [less | less]; [| lra].
      exfalso. apply (none (place k)); try lra. apply same; tauto.
  - intros (range & member & _) none. apply (none (place h)); try tauto. apply same; tauto.
  - intros none (range & member & _). apply (none (place k)); try tauto. apply same; tauto.
Qed.

Corollary entry_depends_on_members_only last s t first : first <= last ->
  (forall l, first <= l -> l <= last -> (is_in s l <-> is_in t l)) -> agree (entry last s first) (entry last t first).
Proof. intros range same. apply right_answers_agree with last s t first; trivial; now apply entry_is_right. Qed.

Theorem order_is_no_matter last s t first : first <= last -> reordered s t ->
  agree (entry last s first) (entry last t first).
Proof.
  intros range order. apply entry_depends_on_members_only; trivial. intros l _ _. unfold is_in.
  now rewrite (order_is_no_matter_for_membership _ order).
Qed.

(* A node asked from further on, but not beyond what it found, would answer the same (`Recursion::entry`). *)
Theorem remembered_answers_hold last s first later : first <= later -> later <= last ->
  match entry last s first with Found h => later <= place h | _ => True end ->
  agree (entry last s first) (entry last s later).
Proof.
  intros further range before.
  assert (old := @entry_is_right last s first ltac:(lra)). assert (new := @entry_is_right last s later range).
  apply right_answers_agree with last s s later; try tauto.
  destruct (entry last s first) as [h | |]; simpl in *; trivial.
  - destruct old as (bounds & member & none & name). conjuncts; try lra; trivial.
    + intros l from less. apply none; lra.
    + unfold named in *. destruct (face h) as [c |]; [| lra].
      destruct name as (below & meets & entered). conjuncts; trivial. intros less. apply entered. lra.
  - intros l from to. apply old; lra.
Qed.

(* The place found is the start or the crossing of a leaf that is entered there (entry-point.md, 1). *)
Corollary entry_is_start_or_crossing last s first h : first <= last -> entry last s first = Found h ->
  place h == first \/ exists c, In c (leaves s) /\ delta c (place h) == 0 /\ slope c < 0.
Proof.
  intros range found. assert (answer := entry_is_right s range). rewrite found in answer.
  destruct answer as (bounds & _ & _ & name). unfold named in name. destruct (face h) as [c |]; [| now left].
  destruct name as (below & meets & entered). destruct (Qlt_le_dec first (place h)) as [less | not]; [| left; lra].
  right. exists c. auto.
Qed.

Print Assumptions entry_is_right.
Print Assumptions entry_depends_on_members_only.
Print Assumptions order_is_no_matter.
Print Assumptions remembered_answers_hold.
Print Assumptions entry_is_start_or_crossing.
