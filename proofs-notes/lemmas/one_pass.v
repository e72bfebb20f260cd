(* Lemma 2: of an intersection of half-spaces, bounds for entry and exit in one pass find what the recursive
   algorithm finds, for any number of them. The source's single loop does not (erratum
   single-pass-intersection; proofs-notes/entry-point.md, 4). *)

From Coq Require Import List Bool QArith Qminmax Lqa.
From Groundtruth Require Import shapes phi.
Import ListNotations.
Open Scope Q_scope.

Definition crossing (c : course) : Q := - at_origin c / slope c.

(* Narrows [enters, exits], half-space by half-space; the leaf is the last that moved the entry. *)
Fixpoint one_pass (cs : list course) (enters : hit) (exits : Q) : answer :=
  match cs with
  | [] => if Qlt_le_dec exits (place enters) then Miss else Found enters
  | c :: rest =>
    if Qlt_le_dec (slope c) 0 then
      if Qlt_le_dec (place enters) (crossing c) then one_pass rest (Hit (crossing c) (Some c)) exits
      else one_pass rest enters exits
    else if Qlt_le_dec 0 (slope c) then one_pass rest enters (Qmin exits (crossing c))
    else if Qlt_le_dec 0 (at_origin c) then Miss else one_pass rest enters exits
  end.

Lemma holds_iff c l : is_in (Leaf c) l <-> delta c l <= 0.
Proof. apply is_in_leaf. Qed.

Lemma falling_leaf_holds c l : slope c < 0 -> (delta c l <= 0 <-> crossing c <= l).
Proof.
  intros falls. assert (meets : delta c (crossing c) == 0) by (unfold delta, crossing; field; lra).
  unfold delta in *. split; intros; nra.
Qed.

Lemma rising_leaf_holds c l : 0 < slope c -> (delta c l <= 0 <-> l <= crossing c).
Proof.
  intros rises. assert (meets : delta c (crossing c) == 0) by (unfold delta, crossing; field; lra).
  unfold delta in *. split; intros; nra.
Qed.

Lemma crossing_meets c : slope c < 0 -> delta c (crossing c) == 0.
Proof. intros falls. unfold delta, crossing. field. lra. Qed.

Definition all_hold (cs : list course) (l : Q) : Prop := forall c, In c cs -> delta c l <= 0.

Lemma all_hold_cons c cs l : all_hold (c :: cs) l <-> delta c l <= 0 /\ all_hold cs l.
Proof.
  unfold all_hold. split.
  - intros all. split; [apply all; now left | intros d inside; apply all; now right].
  - intros (one & rest) d [<- | inside]; auto.
Qed.

(* A leaf that is named is met and entered at the hit; the points at which all hold are those of [hit, exit]. *)
Lemma one_pass_is_right cs : forall enters exits,
  match one_pass cs enters exits with
  | Found h => (forall l, (place enters <= l /\ l <= exits /\ all_hold cs l) -> place h <= l)
               /\ place enters <= place h /\ place h <= exits /\ all_hold cs (place h)
               /\ (h = enters \/ exists c, face h = Some c /\ In c cs /\ delta c (place h) == 0 /\ slope c < 0)
  | Miss => forall l, ~ (place enters <= l /\ l <= exits /\ all_hold cs l)
  | OutOfFuel => False
  end.
Proof.
  induction cs as [| c cs IH]; intros enters exits; simpl.
  - destruct (Qlt_le_dec exits (place enters)).
    + intros l (? & ? & _). lra.
    + split; [tauto |]. split; [lra |]. split; [lra |]. split; [easy | now left].
  - destruct (Qlt_le_dec (slope c) 0) as [falls | flat].
    + destruct (Qlt_le_dec (place enters) (crossing c)) as [later | sooner].
      * specialize (IH (Hit (crossing c) (Some c)) exits). destruct (one_pass _ _ _) as [h | |]; simpl in *; trivial.
        -- destruct IH as (least & from & to & all & name). split; [| split; [lra | split; [assumption | split]]].
           ++ intros l (? & ? & both). apply all_hold_cons in both. apply least.
              rewrite <- falling_leaf_holds by assumption. tauto.
           ++ apply all_hold_cons. rewrite falling_leaf_holds by assumption. tauto.
           ++ right. destruct name as [-> | (d & named & inside & rest)].
              ** exists c. split; [reflexivity |]. split; [now left |]. split; trivial. now apply crossing_meets.
              ** exists d. auto.
        -- intros l (? & ? & both). apply all_hold_cons in both. apply (IH l).
           rewrite <- falling_leaf_holds by assumption. tauto.
      * specialize (IH enters exits). destruct (one_pass _ _ _) as [h | |]; simpl in *; trivial.
        -- destruct IH as (least & from & to & all & name). split; [| split; [assumption | split; [assumption | split]]].
           ++ intros l (? & ? & both). apply all_hold_cons in both. apply least. tauto.
           ++ apply all_hold_cons. rewrite falling_leaf_holds by assumption. split; trivial. lra.
           ++ destruct name as [-> | (d & named & inside & rest)]; [now left |]. right. exists d. auto.
        -- intros l (? & ? & both). apply all_hold_cons in both. apply (IH l). tauto.
    + destruct (Qlt_le_dec 0 (slope c)) as [rises | level].
      * specialize (IH enters (Qmin exits (crossing c))). destruct (one_pass _ _ _) as [h | |]; simpl in *; trivial.
        -- destruct IH as (least & from & to & all & name). apply Q.min_glb_iff in to.
           split; [| split; [assumption | split; [tauto | split]]].
           ++ intros l (? & ? & both). apply all_hold_cons in both. apply least.
              rewrite Q.min_glb_iff, <- rising_leaf_holds by assumption. tauto.
           ++ apply all_hold_cons. rewrite rising_leaf_holds by assumption. tauto.
           ++ destruct name as [-> | (d & named & inside & rest)]; [now left |]. right. exists d. auto.
        -- intros l (? & ? & both). apply all_hold_cons in both. apply (IH l).
           rewrite Q.min_glb_iff, <- rising_leaf_holds by assumption. tauto.
      * assert (constant : forall l, delta c l == at_origin c).
        { intros l. unfold delta. assert (zero : slope c == 0) by lra. rewrite zero. ring. }
        destruct (Qlt_le_dec 0 (at_origin c)) as [out | inside_].
        -- intros l (_ & _ & both). apply all_hold_cons in both. rewrite constant in both. lra.
        -- specialize (IH enters exits). destruct (one_pass _ _ _) as [h | |]; simpl in *; trivial.
           ++ destruct IH as (least & from & to & all & name).
              split; [| split; [assumption | split; [assumption | split]]].
              ** intros l (? & ? & both). apply all_hold_cons in both. apply least. tauto.
              ** apply all_hold_cons. rewrite constant. tauto.
              ** destruct name as [-> | (d & named & inside & rest)]; [now left |]. right. exists d. auto.
           ++ intros l (? & ? & both). apply all_hold_cons in both. apply (IH l). tauto.
Qed.

Definition intersection_of (cs : list course) : shape course := Intersection (map (@Leaf course) cs).

Lemma is_in_intersection_of cs l : is_in (intersection_of cs) l <-> all_hold cs l.
Proof.
  unfold intersection_of. rewrite is_in_intersection. unfold all_hold. split.
  - intros all c inside. apply is_in_leaf. apply all. now apply in_map.
  - intros all s inside. apply in_map_iff in inside as (c & <- & inside). apply is_in_leaf. auto.
Qed.

Theorem one_pass_finds_the_entry cs first last : first <= last ->
  agree (one_pass cs (Hit first None) last) (entry last (intersection_of cs) first).
Proof.
  intros range. assert (pass := one_pass_is_right cs (Hit first None) last).
  assert (phi := entry_is_right (intersection_of cs) range).
  destruct (one_pass _ _ _) as [h | |], (entry _ _ _) as [k | |]; simpl in *; trivial.
  - destruct pass as (least & from & to & all & _), phi as ((from' & to') & member & none & _).
    rewrite is_in_intersection_of in member. assert (place h <= place k) by (apply least; tauto).
    destruct (Qlt_le_dec (place h) (place k)) as [less | more]; [| lra].
    exfalso. apply (none (place h)); trivial. now apply is_in_intersection_of.
  - destruct pass as (least & from & to & all & _). apply (phi (place h)); trivial. now apply is_in_intersection_of.
  - destruct phi as ((from & to) & member & _). apply (pass (place k)). rewrite is_in_intersection_of in member. tauto.
Qed.

(* The leaf of one pass is met at the hit, and entered there if the hit is beyond the start. *)
Theorem one_pass_names_an_entered_leaf cs first last h :
  one_pass cs (Hit first None) last = Found h -> first < place h ->
  exists c, face h = Some c /\ In c cs /\ delta c (place h) == 0 /\ slope c < 0.
Proof.
  intros found beyond. assert (pass := one_pass_is_right cs (Hit first None) last). rewrite found in pass.
  destruct pass as (_ & _ & _ & _ & [-> | name]); [simpl in beyond; lra | exact name].
Qed.

(* x <= 0 and x >= 1, from x = -1 to x = 2. *)
Definition up_to_zero := Course 0 (-1) 3.
Definition from_one := Course 1 2 (-3).

Theorem single_loop_is_refuted :
  round (map (entry 1) [Leaf up_to_zero; Leaf from_one]) (Hit 0 None) = Found (Hit ((-2) / (-3)) (Some from_one))
  /\ entry 1 (intersection_of [up_to_zero; from_one]) 0 = Miss
  /\ ~ is_in (intersection_of [up_to_zero; from_one]) ((-2) / (-3)).
Proof. split; [reflexivity |]. split; [reflexivity |]. unfold is_in. now vm_compute. Qed.

Print Assumptions one_pass_finds_the_entry.
Print Assumptions one_pass_names_an_entered_leaf.
Print Assumptions single_loop_is_refuted.
