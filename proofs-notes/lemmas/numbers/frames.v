(* Vectors by their coordinates along any three orthonormal, right-handed axes: dot and cross products are those of the
   coordinates. What clipping-without-axes and load-without-rotation (proofs-notes/rounding-of-forces.md, 4 and 5) stand on. *)

From Coq Require Import Reals Psatz.
From Groundtruth Require Import surface.
Open Scope R_scope.

Definition plus a b := V (vx a + vx b) (vy a + vy b) (vz a + vz b).
Definition times t a := V (t * vx a) (t * vy a) (t * vz a).

Record frame := { axis_x : vector; axis_y : vector; axis_z : vector }.

Definition is_frame f :=
  (dot (axis_x f) (axis_x f) = 1 /\ dot (axis_y f) (axis_y f) = 1 /\ dot (axis_z f) (axis_z f) = 1) /\
  (dot (axis_x f) (axis_y f) = 0 /\ dot (axis_y f) (axis_z f) = 0 /\ dot (axis_z f) (axis_x f) = 0) /\
  (cross (axis_x f) (axis_y f) = axis_z f /\ cross (axis_y f) (axis_z f) = axis_x f /\ cross (axis_z f) (axis_x f) = axis_y f).

Theorem surface_is_a_frame : forall x y z, 0 < - z ->
  is_frame {| axis_x := X x z; axis_y := Y x y z; axis_z := Z x y z |}.
Proof.
  intros x y z upright. destruct (axes_are_orthonormal x y z upright) as (xx & yy & zz & xy & yz & zx).
  destruct (axes_are_right_handed x y z upright) as (cz & cx & cy). repeat split; assumption.
Qed.

Section In.

Variable f : frame.
Hypothesis ok : is_frame f.

(* The vector with these coordinates. *)
Definition at_ a b c := plus (plus (times a (axis_x f)) (times b (axis_y f))) (times c (axis_z f)).

Theorem dot_by_coordinates : forall a b c a' b' c', dot (at_ a b c) (at_ a' b' c') = a * a' + b * b' + c * c'.
Proof.
  intros. destruct ok as ((xx & yy & zz) & (xy & yz & zx) & _).
  transitivity (a * a' * dot (axis_x f) (axis_x f) + b * b' * dot (axis_y f) (axis_y f) + c * c' * dot (axis_z f) (axis_z f)
    + (a * b' + b * a') * dot (axis_x f) (axis_y f) + (b * c' + c * b') * dot (axis_y f) (axis_z f)
    + (c * a' + a * c') * dot (axis_z f) (axis_x f)).
  - unfold dot, at_, plus, times; simpl; ring.
  - rewrite xx, yy, zz, xy, yz, zx; ring.
Qed.

Theorem cross_by_coordinates : forall a b c a' b' c',
  cross (at_ a b c) (at_ a' b' c') = at_ (b * c' - c * b') (c * a' - a * c') (a * b' - b * a').
Proof.
  intros. destruct ok as (_ & _ & (xy & yz & zx)).
  transitivity (plus (plus (times (b * c' - c * b') (cross (axis_y f) (axis_z f))) (times (c * a' - a * c') (cross (axis_z f) (axis_x f))))
    (times (a * b' - b * a') (cross (axis_x f) (axis_y f)))).
  - unfold cross, at_, plus, times; simpl; f_equal; ring.
  - now rewrite xy, yz, zx.
Qed.

Lemma plus_by_coordinates : forall a b c a' b' c', plus (at_ a b c) (at_ a' b' c') = at_ (a + a') (b + b') (c + c').
Proof. intros; unfold at_, plus, times; simpl; f_equal; ring. Qed.

Lemma times_by_coordinates : forall t a b c, times t (at_ a b c) = at_ (t * a) (t * b) (t * c).
Proof. intros; unfold at_, plus, times; simpl; f_equal; ring. Qed.

End In.

Print Assumptions surface_is_a_frame.
Print Assumptions cross_by_coordinates.
