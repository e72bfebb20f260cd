(* Positive Boolean expressions of leaves (SPEC section 2): membership, monotonicity, the order of operands.

   Everything is the intersection of no operands, nothing the union of none. A leaf is of any type L; a
   valuation says of each leaf whether it holds at the point in question. *)

From Coq Require Import List Bool Permutation.
Import ListNotations.
Set Implicit Arguments.

Inductive shape (L : Type) : Type :=
| Leaf (leaf : L)
| Union (operands : list (shape L))
| Intersection (operands : list (shape L)).

Arguments Union {L}.
Arguments Intersection {L}.

Definition everything {L} : shape L := Intersection [].
Definition nothing {L} : shape L := Union [].

Section Induction.
Variable L : Type.
Variable P : shape L -> Prop.
Hypothesis of_leaf : forall leaf, P (Leaf leaf).
Hypothesis of_union : forall operands, Forall P operands -> P (Union operands).
Hypothesis of_intersection : forall operands, Forall P operands -> P (Intersection operands).

Fixpoint shape_induction (s : shape L) : P s :=
  let all := fix all (ss : list (shape L)) : Forall P ss :=
    match ss with
    | [] => Forall_nil P
    | s :: rest => Forall_cons s (shape_induction s) (all rest)
    end in
  match s with
  | Leaf leaf => of_leaf leaf
  | Union operands => of_union (all operands)
  | Intersection operands => of_intersection (all operands)
  end.
End Induction.

Fixpoint value {L} (holds : L -> bool) (s : shape L) : bool :=
  match s with
  | Leaf leaf => holds leaf
  | Union operands => existsb (value holds) operands
  | Intersection operands => forallb (value holds) operands
  end.

Fixpoint leaves {L} (s : shape L) : list L :=
  match s with
  | Leaf leaf => [leaf]
  | Union operands | Intersection operands => flat_map leaves operands
  end.

(* The same expression with other leaves. *)
Fixpoint mapped {L M} (f : L -> M) (s : shape L) : shape M :=
  match s with
  | Leaf leaf => Leaf (f leaf)
  | Union operands => Union (map (mapped f) operands)
  | Intersection operands => Intersection (map (mapped f) operands)
  end.

Lemma value_mapped {L M} (f : L -> M) s v : value v (mapped f s) = value (fun leaf => v (f leaf)) s.
Proof.
  induction s as [leaf | ss IH | ss IH] using shape_induction; simpl; trivial;
    induction IH as [| s ss same _ rest]; simpl; trivial; now rewrite same, rest.
Qed.

Section Membership.
Variable L : Type.
Implicit Types s t : shape L.

Lemma leaves_of_operand s ss leaf : In s ss -> In leaf (leaves s) -> In leaf (flat_map leaves ss).
Proof. intros inside below. apply in_flat_map. exists s. now split. Qed.

(* The expression is positive: what holds more often makes it hold more often. *)
Theorem value_is_monotone s (v w : L -> bool) :
  (forall leaf, In leaf (leaves s) -> v leaf = true -> w leaf = true) -> value v s = true -> value w s = true.
Proof.
  induction s as [leaf | ss IH | ss IH] using shape_induction; simpl; intros more.
  - apply more. now left.
  - rewrite Forall_forall in IH. rewrite !existsb_exists. intros (s & inside & true_at).
    exists s. split; [assumption |]. apply IH; try assumption.
    intros leaf below. apply more. now apply leaves_of_operand with s.
  - rewrite Forall_forall in IH. rewrite !forallb_forall. intros all s inside.
    apply IH; auto. intros leaf below. apply more. now apply leaves_of_operand with s.
Qed.

Lemma value_extensional s (v w : L -> bool) :
  (forall leaf, In leaf (leaves s) -> v leaf = w leaf) -> value v s = value w s.
Proof.
  intros same. apply eq_iff_eq_true. split; apply value_is_monotone; intros leaf below;
    rewrite (same leaf below); trivial.
Qed.

(* The same expression with operands in another order, at any depth. *)
Inductive reordered : shape L -> shape L -> Prop :=
| same_order s : reordered s s
| twice_reordered s t u : reordered s t -> reordered t u -> reordered s u
| union_reordered ss ts : Permutation ss ts -> reordered (Union ss) (Union ts)
| intersection_reordered ss ts : Permutation ss ts -> reordered (Intersection ss) (Intersection ts)
| in_union s t before after : reordered s t ->
    reordered (Union (before ++ s :: after)) (Union (before ++ t :: after))
| in_intersection s t before after : reordered s t ->
    reordered (Intersection (before ++ s :: after)) (Intersection (before ++ t :: after)).

Theorem order_is_no_matter_for_membership s t v : reordered s t -> value v s = value v t.
Proof.
  induction 1 as [ | s t u _ one _ two | ss ts swapped | ss ts swapped | | ]; simpl; auto.
  - now rewrite one.
  - apply eq_iff_eq_true. rewrite !existsb_exists.
    split; intros (s & inside & true_at); exists s; split; auto.
    + now apply Permutation_in with ss.
    + now apply Permutation_in with ts; [apply Permutation_sym |].
  - apply eq_iff_eq_true. rewrite !forallb_forall. split; intros all s inside; apply all.
    + now apply Permutation_in with ts; [apply Permutation_sym |].
    + now apply Permutation_in with ss.
  - rewrite !existsb_app. simpl. now rewrite IHreordered.
  - rewrite !forallb_app. simpl. now rewrite IHreordered.
Qed.

Theorem order_is_no_matter_for_leaves s t : reordered s t -> Permutation (leaves s) (leaves t).
Proof.
  induction 1 as [ | s t u _ one _ two | ss ts swapped | ss ts swapped | | ]; simpl; auto.
  - now apply Permutation_trans with (leaves t).
  - now apply Permutation_flat_map.
  - now apply Permutation_flat_map.
  - rewrite !flat_map_app. simpl. now apply Permutation_app_head, Permutation_app_tail.
  - rewrite !flat_map_app. simpl. now apply Permutation_app_head, Permutation_app_tail.
Qed.
End Membership.

Print Assumptions value_is_monotone.
Print Assumptions order_is_no_matter_for_membership.
Print Assumptions order_is_no_matter_for_leaves.
