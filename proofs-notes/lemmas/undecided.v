(* Lemma 7: what is handed to the exact stage (fast/undecided.cpp, with fast/sieved.cpp): the contenders without half-spaces
   that certainly hold, or certainly do not, wherever that can matter. First point, local shape there and admissible leaves
   are those of the contenders (proofs-notes/rounding.md, "What is certain of parts"). Of limits it is taken what
   numbers/clip_interval.v proves. *)

From Coq Require Import List Bool QArith Lqa.
From Groundtruth Require Import shapes standing faces rewriting simplifications same_faces phi unions.
Import ListNotations.
Open Scope Q_scope.
Set Implicit Arguments.

(* Simplifier: leaves with a settled truth are constants. *)
Section Pruned.
Variable settled : half_space -> truth.

Fixpoint pruned (s : shape half_space) : shape half_space :=
  match s with
  | Leaf h => match settled h with Yes => everything | No => nothing | Open => Leaf h end
  | Union ss => Union (map pruned ss)
  | Intersection ss => Intersection (map pruned ss)
  end.

Variable p : vector.
Hypothesis right_at_p : forall h, settled h <> Open -> at_point p h = settled h.

Lemma pruned_value known s : here p known -> evaluate known (pruned s) = evaluate known s.
Proof.
  intros near. induction s as [h | ss IH | ss IH] using shape_induction; simpl.
  - destruct (settled h) eqn:e; simpl; trivial; symmetry; rewrite near; rewrite right_at_p; congruence.
  - f_equal. rewrite map_map. apply map_ext_in. now rewrite Forall_forall in IH.
  - f_equal. rewrite map_map. apply map_ext_in. now rewrite Forall_forall in IH.
Qed.

Theorem pruned_is_alike s : alike (here p) s (pruned s).
Proof.
  intros known near. split; [symmetry; now apply pruned_value |].
  induction s as [h | ss IH | ss IH] using shape_induction; intros leaf.
  - simpl. destruct (settled h) eqn:e; simpl; try tauto.
    + assert (known_h : known h = No) by (rewrite near; rewrite right_at_p; congruence). rewrite known_h. tauto.
    + assert (known_h : known h = Yes) by (rewrite near; rewrite right_at_p; congruence). rewrite known_h. tauto.
  - change (pruned (Union ss)) with (Union (map pruned ss)). rewrite !stands_in_union. change (Union (map pruned ss)) with (pruned (Union ss)).
    rewrite (pruned_value (Union ss) near). rewrite Forall_forall in IH. apply and_iff_compat_l. split.
    + intros (s & inside & stands). exists (pruned s). split; [now apply in_map | now apply (IH s inside)].
    + intros (t & inside & stands). apply in_map_iff in inside as (s & <- & inside). exists s. split; trivial. now apply (IH s inside).
  - change (pruned (Intersection ss)) with (Intersection (map pruned ss)). rewrite !stands_in_intersection.
    change (Intersection (map pruned ss)) with (pruned (Intersection ss)).
    rewrite (pruned_value (Intersection ss) near). rewrite Forall_forall in IH. apply and_iff_compat_l. split.
    + intros (s & inside & stands). exists (pruned s). split; [now apply in_map | now apply (IH s inside)].
    + intros (t & inside & stands). apply in_map_iff in inside as (s & <- & inside). exists s. split; trivial. now apply (IH s inside).
Qed.
End Pruned.

Section Handed.
Variables (from toward_ : vector) (first last : Q).
Hypothesis range : first <= last.
Definition place (l : Q) : vector := plus from (scaled l toward_).

(* The sieve, here and in exact/solid/sieve.cpp: one sign at both ends, one sign between them. *)
Definition settled_by_ends (h : half_space) : truth :=
  let a := local_shape.delta h (place first) in let b := local_shape.delta h (place last) in
  if Qlt_le_dec a 0 then if Qlt_le_dec b 0 then Yes else Open
  else if Qlt_le_dec 0 a then if Qlt_le_dec 0 b then No else Open else Open.

Lemma delta_between h l : first <= l -> l <= last ->
  let d x := local_shape.delta h (place x) in (d l <= d first \/ d l <= d last) /\ (d first <= d l \/ d last <= d l).
Proof.
  intros from_l to_l d. set (slope := dot (normal h) toward_).
  assert (affine : forall x y, d y == d x + (y - x) * slope) by (intros; unfold d, slope, place, local_shape.delta, dot, plus, scaled; simpl; ring).
  assert (one := affine first l). assert (two := affine l last).
  destruct (Qlt_le_dec slope 0) as [falls | rises].
  - assert ((l - first) * slope <= 0) by nra. assert ((last - l) * slope <= 0) by nra. split; [left | right]; lra.
  - assert (0 <= (l - first) * slope) by nra. assert (0 <= (last - l) * slope) by nra. split; [right | left]; lra.
Qed.

Theorem sieved_is_alike s l : first <= l -> l <= last -> alike (here (place l)) s (pruned settled_by_ends s).
Proof.
  intros from_l to_l. apply pruned_is_alike. intros h. unfold settled_by_ends. destruct (delta_between h from_l to_l) as (above & below).
  destruct (Qlt_le_dec (local_shape.delta h (place first)) 0).
  - destruct (Qlt_le_dec (local_shape.delta h (place last)) 0); [intros _; apply strictly_inside; destruct above; lra | easy].
  - destruct (Qlt_le_dec 0 (local_shape.delta h (place first))); [| easy]. destruct (Qlt_le_dec 0 (local_shape.delta h (place last))); [| easy].
    intros _. unfold at_point. destruct (Qlt_le_dec 0 (local_shape.delta h (place l))); trivial. destruct below; lra.
Qed.

(* What is known of a leaf that the range leaves open (OpenLeaf): limits of where it is crossed, clip_interval.v's
   crossing_is_between_limits; or nothing. *)
Inductive turn := Enters | Leaves | Undecided.
Record open_leaf := OpenLeaf { leaf : half_space; way : turn; low : Q; high : Q }.
Definition is_true (o : open_leaf) : Prop := forall l, first <= l -> l <= last ->
  let d := local_shape.delta (leaf o) (place l) in
  match way o with
  | Enters => (d <= 0 -> low o < l) /\ (0 <= d -> l < high o)
  | Leaves => (0 <= d -> low o < l) /\ (d <= 0 -> l < high o)
  | Undecided => True
  end.

(* A contender that is a cell: certain leaves are gone, the others open; no point before `lower`, which is the start
   of the range or the lower limit of a leaf that is entered. *)
Variables (lower upper : Q).
Definition holds (o : open_leaf) : bool :=
  match way o with
  | Enters => if Qlt_le_dec (high o) lower then true else false
  | Leaves => if Qlt_le_dec upper (low o) then true else false
  | Undecided => false
  end.

Theorem cell_handed_on_is_alike os l : (forall o, In o os -> is_true o) -> first <= l -> l <= last -> l <= upper ->
  lower <= first \/ (exists o, In o os /\ way o = Enters /\ low o == lower /\ low o <= high o) ->
  alike (here (place l)) (cell (map leaf os)) (cell (map leaf (filter (fun o => negb (holds o)) os))).
Proof.
  intros true_ from_l to_l before start.
  assert (as_filter : alike (here (place l)) (cell (map leaf os)) (cell (map leaf (filter (fun o => negb (holds o)) os)))).
  { destruct (Qlt_le_dec l lower) as [early | late].
    - destruct start as [at_start | (o & inside & enters & is_lower & ordered)]; [lra |].
      assert (no : at_point (place l) (leaf o) = No).
      { assert (t := true_ o inside l from_l to_l). rewrite enters in t. destruct t as (t & _). unfold at_point.
        destruct (Qlt_le_dec 0 (local_shape.delta (leaf o) (place l))); trivial. specialize (t ltac:(lra)). lra. }
      assert (absorbed : forall ks, In (leaf o) ks -> alike (here (place l)) (cell ks) nothing).
      { intros ks i. apply intersection_absorbed with (Leaf (leaf o)); [now apply in_map |]. intros known near. simpl. rewrite near; congruence. }
      apply alike_transitive with nothing; [apply absorbed; now apply in_map |]. apply alike_symmetric, absorbed, in_map, filter_In.
      split; trivial. unfold holds. rewrite enters. destruct (Qlt_le_dec (high o) lower); trivial. lra.
    - enough (general : forall earlier, alike (here (place l)) (Intersection (earlier ++ map (@Leaf half_space) (map leaf os)))
        (Intersection (earlier ++ map (@Leaf half_space) (map leaf (filter (fun o => negb (holds o)) os))))) by apply (general []).
      clear start. induction os as [| o rest IH]; intros earlier; simpl; [apply alike_reflexive |].
      assert (true' : forall q, In q rest -> is_true q) by (intros q i; apply true_; now right).
      destruct (holds o) eqn:gone; simpl.
      + apply alike_transitive with (Intersection (earlier ++ map (@Leaf half_space) (map leaf rest))); [| now apply IH].
        apply intersection_drops. intros known near. left. simpl.
        assert (strict : local_shape.delta (leaf o) (place l) < 0).
        { assert (t := true_ o (or_introl eq_refl) l from_l to_l). unfold holds in gone. destruct (way o); try easy.
          - destruct (Qlt_le_dec (high o) lower); try easy. destruct t as (_ & t).
            destruct (Qlt_le_dec (local_shape.delta (leaf o) (place l)) 0); trivial. specialize (t ltac:(lra)). lra.
          - destruct (Qlt_le_dec upper (low o)); try easy. destruct t as (t & _).
            destruct (Qlt_le_dec (local_shape.delta (leaf o) (place l)) 0); trivial. specialize (t ltac:(lra)). lra. }
        rewrite near; rewrite (strictly_inside (leaf o) (place l) strict); congruence.
      + specialize (IH true' (earlier ++ [Leaf (leaf o)])). now rewrite <- !app_assoc in IH. }
  exact as_filter.
Qed.
End Handed.

(* All contenders together: S and T operand by operand alike at each place up to `upper`, which the entry does not pass. *)
Section Together.
Variable Part : Type.
Variables (solid handed : Part -> shape half_space) (from toward_ : vector) (first last upper : Q) (contenders : list Part).
Hypothesis range : first <= last.
Hypothesis each_is_alike : forall part l, In part contenders -> first <= l -> l <= last -> l <= upper ->
  alike (here (place from toward_ l)) (solid part) (handed part).
Let whole : shape half_space := Union (map solid contenders).
Let given : shape half_space := Union (map handed contenders).

Theorem given_is_alike l : first <= l -> l <= last -> l <= upper -> alike (here (place from toward_ l)) whole given.
Proof.
  intros from_l to_l before. enough (general : forall parts, (forall part, In part parts -> alike (here (place from toward_ l)) (solid part) (handed part)) ->
    forall earlier, alike (here (place from toward_ l)) (Union (earlier ++ map solid parts)) (Union (earlier ++ map handed parts))).
  { apply (general contenders) with (earlier := []). intros part inside. now apply each_is_alike. }
  intros parts. induction parts as [| part rest IH]; intros each earlier; simpl; [apply alike_reflexive |].
  apply alike_transitive with (Union (earlier ++ handed part :: map solid rest)).
  - apply alike_in_union, each. now left.
  - assert (IH' := IH (fun q i => each q (or_intror i)) (earlier ++ [handed part])). now rewrite <- !app_assoc in IH'.
Qed.

Lemma same_member l : first <= l -> l <= last -> l <= upper -> (member whole (place from toward_ l) <-> member given (place from toward_ l)).
Proof.
  intros from_l to_l before. set (p := place from toward_ l).
  assert (same_ := given_is_alike from_l to_l before). fold p in same_.
  assert (by_cone : forall s, member s p <-> cone s p (Vector 0 0 0) = true).
  { intros s. unfold member, cone. rewrite (value_extensional s (contains p) (holds_along p (Vector 0 0 0))); [tauto |].
    intros h _. unfold holds_along, at_point, contains. apply eq_iff_eq_true. rewrite Qle_bool_iff.
    destruct (Qlt_le_dec 0 (local_shape.delta h p)); [split; intros; [lra | easy] |].
    destruct (Qlt_le_dec (local_shape.delta h p) 0); [split; intros; [trivial | lra] |].
    destruct (has_no_normal h); [split; intros; [trivial | lra] |]. rewrite Qle_bool_iff. split; intros; trivial.
    unfold dot. simpl. lra. }
  now rewrite !by_cone, (same_local_shape_here _ _ _ (Vector 0 0 0) same_).
Qed.

(* `upper` is the end of the range, or some contender is met no later. *)
Hypothesis entry_in_time : upper == last \/ exists l, (first <= l /\ l <= last /\ l <= upper) /\ member whole (place from toward_ l).

Theorem given_has_the_entry : agree (entry last (along from toward_ whole) first) (entry last (along from toward_ given) first).
Proof.
  apply answers_agree_up_to with upper last (along from toward_ whole) (along from toward_ given) first; try (now apply entry_is_right).
  - intros l from_l to_l before. rewrite !is_in_along. now apply same_member.
  - destruct entry_in_time as [e | (l & bounds_ & there)]; [now left | right]. exists l. split; trivial. now apply is_in_along.
Qed.

Corollary given_has_the_admissible_leaves h u i : entry last (along from toward_ whole) first = Found h ->
  (admissible whole (place from toward_ (recursion.place h)) u i <-> admissible given (place from toward_ (recursion.place h)) u i).
Proof.
  intros found. assert (right_ := entry_is_right (along from toward_ whole) range). rewrite found in right_.
  destruct right_ as ((from_h & to_h) & _ & none & _). apply alike_here_have_the_same_faces, given_is_alike; trivial.
  destruct entry_in_time as [e | (l & (from_l & to_l & before) & there)]; [lra |].
  destruct (Qlt_le_dec l (recursion.place h)) as [less |]; [| lra]. exfalso. apply (none l from_l less). now apply is_in_along.
Qed.
End Together.

Print Assumptions sieved_is_alike.
Print Assumptions cell_handed_on_is_alike.
Print Assumptions given_is_alike.
Print Assumptions given_has_the_entry.
Print Assumptions given_has_the_admissible_leaves.
