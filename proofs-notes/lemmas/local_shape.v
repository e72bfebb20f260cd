(* The solid near a point: its local shape, and when the point is interior (SPEC section 3; proofs-notes/faces.md, 3). *)

From Coq Require Import List Bool QArith Qabs Lqa.
From Groundtruth Require Import shapes standing.
Import ListNotations.
Open Scope Q_scope.

Record vector := Vector { x : Q; y : Q; z : Q }.
Definition dot (a b : vector) : Q := x a * x b + y a * y b + z a * z b.
Definition plus (a b : vector) : vector := Vector (x a + x b) (y a + y b) (z a + z b).
Definition scaled (t : Q) (a : vector) : vector := Vector (t * x a) (t * y a) (t * z a).
Definition within (e : Q) (v : vector) : Prop := Qabs (x v) <= e /\ Qabs (y v) <= e /\ Qabs (z v) <= e.

Record half_space := HalfSpace { number : nat; normal : vector; offset : Q }.
Definition delta (h : half_space) (p : vector) : Q := dot (normal h) p - offset h.
Definition contains (p : vector) (h : half_space) : bool := Qle_bool (delta h p) 0.
Definition member (s : shape half_space) (p : vector) : Prop := value (contains p) s = true.
Definition interior (s : shape half_space) (p : vector) : Prop :=
  exists e, 0 < e /\ forall v, within e v -> member s (plus p v).

Definition has_no_normal (h : half_space) : bool :=
  Qeq_bool (x (normal h)) 0 && Qeq_bool (y (normal h)) 0 && Qeq_bool (z (normal h)) 0.
(* Open: the leaf is one of A, the leaves whose planes pass through p. *)
Definition at_point (p : vector) (h : half_space) : truth :=
  if Qlt_le_dec 0 (delta h p) then No
  else if Qlt_le_dec (delta h p) 0 then Yes
  else if has_no_normal h then Yes else Open.

(* The local shape L, a cone of directions. *)
Definition holds_along (p v : vector) (h : half_space) : bool :=
  match at_point p h with Yes => true | No => false | Open => Qle_bool (dot (normal h) v) 0 end.
Definition cone (s : shape half_space) (p v : vector) : bool := value (holds_along p v) s.

(* Every leaf of the solid is known, open or not, as it is near p. *)
Lemma product_within a b e : Qabs b <= e -> - (Qabs a * e) <= a * b /\ a * b <= Qabs a * e.
Proof.
  rewrite Qabs_Qle_condition. intros (low & high).
  destruct (Qlt_le_dec a 0) as [negative | positive].
  - rewrite (Qabs_neg a) by lra. split; nra.
  - rewrite (Qabs_pos a) by lra. split; nra.
Qed.

Definition size (v : vector) : Q := Qabs (x v) + Qabs (y v) + Qabs (z v).

Lemma size_is_positive v : 0 <= size v.
Proof.
  unfold size. assert (a := Qabs_nonneg (x v)). assert (b := Qabs_nonneg (y v)). assert (c := Qabs_nonneg (z v)). lra.
Qed.

Lemma dot_within n v e : within e v -> - (size n * e) <= dot n v /\ dot n v <= size n * e.
Proof.
  intros (a & b & c). unfold dot, size.
  assert (one := product_within (x n) _ _ a). assert (two := product_within (y n) _ _ b).
  assert (three := product_within (z n) _ _ c). split; lra.
Qed.

Lemma small_enough (room weight : Q) : 0 < room -> 0 <= weight -> exists e, 0 < e /\ weight * e < room.
Proof.
  intros some positive. exists (room / (weight + 1)).
  assert (e_times : (weight + 1) * (room / (weight + 1)) == room) by (field; lra).
  assert (0 < room / (weight + 1)) by (apply Qlt_shift_div_l; lra).
  split; lra.
Qed.

Lemma below_both (a b : Q) : 0 < a -> 0 < b -> exists u, 0 < u /\ u <= a /\ u <= b.
Proof. intros. destruct (Qlt_le_dec a b); [exists a | exists b]; split; try lra; split; lra. Qed.

Lemma delta_plus h p v : delta h (plus p v) == delta h p + dot (normal h) v.
Proof. unfold delta, dot, plus. simpl. ring. Qed.

Lemma leaf_near_point p h : exists e, 0 < e /\ forall v, within e v -> contains (plus p v) h = holds_along p v h.
Proof.
  unfold holds_along, at_point, contains. assert (positive := size_is_positive (normal h)).
  destruct (Qlt_le_dec 0 (delta h p)) as [out | not_out].
  - destruct (small_enough _ _ out positive) as (e & some & small). exists e. split; trivial. intros v near.
    apply not_true_iff_false. rewrite Qle_bool_iff, delta_plus. assert (d := dot_within (normal h) v e near). lra.
  - destruct (Qlt_le_dec (delta h p) 0) as [inside | on].
    + destruct (small_enough (- delta h p) (size (normal h))) as (e & some & small); [lra | assumption |].
      exists e. split; trivial. intros v near. rewrite Qle_bool_iff, delta_plus.
      assert (d := dot_within (normal h) v e near). lra.
    + exists 1. split; [lra |]. intros v _. destruct (has_no_normal h) eqn:flat.
      * apply andb_true_iff in flat as (flat & zero_z). apply andb_true_iff in flat as (zero_x & zero_y).
        apply Qeq_bool_eq in zero_x, zero_y, zero_z. rewrite Qle_bool_iff, delta_plus. unfold dot.
        rewrite zero_x, zero_y, zero_z. lra.
      * apply eq_iff_eq_true. rewrite !Qle_bool_iff, delta_plus. split; lra.
Qed.

Lemma within_less e f v : e <= f -> within e v -> within f v.
Proof. intros less (a & b & c). unfold within. split; [lra | split; lra]. Qed.

Lemma within_plus e f v w : within e v -> within f w -> within (e + f) (plus v w).
Proof.
  intros (a & b & c) (a' & b' & c'). unfold within, plus. cbn [local_shape.x local_shape.y local_shape.z].
  split; [| split]; match goal with |- Qabs (?p + ?q) <= _ => assert (both_ := Qabs_triangle p q); lra end.
Qed.

Lemma leaves_near_point p hs :
  exists e, 0 < e /\ forall v, within e v -> forall h, In h hs -> contains (plus p v) h = holds_along p v h.
Proof.
  induction hs as [| h hs (e & some & near)].
  - exists 1. split; [lra | easy].
  - destruct (leaf_near_point p h) as (f & some_f & near_f). destruct (Qlt_le_dec e f).
    + exists e. split; trivial. intros v small g [<- | inside]; [apply near_f | now apply near].
      apply within_less with e; trivial. lra.
    + exists f. split; trivial. intros v small g [<- | inside]; [now apply near_f | apply near; trivial].
      now apply within_less with f.
Qed.

(* Near p the solid is p + L. *)
Theorem solid_is_local_shape s p :
  exists e, 0 < e /\ forall v, within e v -> (member s (plus p v) <-> cone s p v = true).
Proof.
  destruct (leaves_near_point p (leaves s)) as (e & some & near). exists e. split; trivial. intros v small.
  unfold member, cone. rewrite (value_extensional s _ (holds_along p v)); [tauto |]. now apply near.
Qed.

Theorem local_shape_is_a_cone s p v t : 0 < t -> cone s p (scaled t v) = cone s p v.
Proof.
  intros positive. apply value_extensional. intros h _. unfold holds_along. destruct (at_point p h); trivial.
  apply eq_iff_eq_true. rewrite !Qle_bool_iff.
  assert (linear : dot (normal h) (scaled t v) == t * dot (normal h) v) by (unfold dot, scaled; simpl; ring).
  rewrite linear. split; nra.
Qed.

Lemma scaled_within v e : 0 < e -> exists t, 0 < t /\ forall u, 0 <= u -> u <= t -> within e (scaled u v).
Proof.
  intros some. destruct (small_enough e (size v) some (size_is_positive v)) as (t & positive & small).
  exists t. split; trivial. intros u from to.
  assert (a := Qabs_nonneg (x v)). assert (b := Qabs_nonneg (y v)). assert (c := Qabs_nonneg (z v)).
  assert (abs : forall q, Qabs (u * q) == u * Qabs q)
    by (intros q; eapply Qeq_trans; [apply Qabs_Qmult |]; rewrite (Qabs_pos u) by assumption; reflexivity).
  unfold within, scaled, size in *. cbn [local_shape.x local_shape.y local_shape.z]. split; [| split]; rewrite abs; nra.
Qed.

(* SPEC section 3: x is interior iff L is all of space. *)
Theorem interior_iff_local_shape_is_everything s p : interior s p <-> forall v, cone s p v = true.
Proof.
  destruct (solid_is_local_shape s p) as (e & some & near). split.
  - intros (f & some_f & inside) v.
    destruct (scaled_within v e some) as (t & positive & small).
    destruct (scaled_within v f some_f) as (t' & positive' & small').
    destruct (below_both t t' positive positive') as (u & above & below & below').
    rewrite <- (local_shape_is_a_cone s p v u above). apply near; [apply small; lra |]. apply inside, small'; lra.
  - intros everywhere. exists e. split; trivial. intros v small. now apply near.
Qed.

Lemma member_same s p q : x p == x q -> y p == y q -> z p == z q -> member s p -> member s q.
Proof.
  intros a b c. apply value_is_monotone. intros h _. unfold contains, delta, dot. now rewrite a, b, c.
Qed.

Print Assumptions solid_is_local_shape.
Print Assumptions local_shape_is_a_cone.
Print Assumptions interior_iff_local_shape_is_everything.
