(* The surface's axes (SPEC section 4): Q = q_y q_x is orthogonal and right-handed, with the columns that the
   code uses, and takes (0, 0, 1) to -n / |n|. With the source's signs it does not (erratum surface-frame-sign). *)

From Coq Require Import Reals Psatz.
Open Scope R_scope.

Record vector := V { vx : R; vy : R; vz : R }.

Definition dot a b := vx a * vx b + vy a * vy b + vz a * vz b.
Definition cross a b :=
  V (vy a * vz b - vz a * vy b) (vz a * vx b - vx a * vz b) (vx a * vy b - vy a * vx b).

(* Rotations about the axes by angles with these cosines and sines. *)
Definition about_x c s v := V (vx v) (c * vy v - s * vz v) (s * vy v + c * vz v).
Definition about_y c s v := V (c * vx v + s * vz v) (vy v) (- s * vx v + c * vz v).

Section Upright.

Variables x y z : R.
Hypothesis upright : 0 < - z.

Definition n := V x y z.
Definition r := sqrt (x * x + z * z).
Definition l := sqrt (x * x + y * y + z * z).

Definition X := V (- z / r) 0 (x / r).
Definition Y := V (- x * y / (r * l)) (r * r / (r * l)) (- y * z / (r * l)).
Definition Z := V (- x / l) (- y / l) (- z / l).

Lemma r_squared : r * r = x * x + z * z.
Proof. apply sqrt_sqrt; nra. Qed.
Lemma l_squared : l * l = x * x + y * y + z * z.
Proof. apply sqrt_sqrt; nra. Qed.
Lemma r_positive : 0 < r.
Proof. apply sqrt_lt_R0; nra. Qed.
Lemma l_positive : 0 < l.
Proof. apply sqrt_lt_R0; nra. Qed.

(* phi_x = atan2(y, r), phi_y = atan2(-x, -z): their cosines and sines. *)
Lemma angles_are_angles : (r / l) * (r / l) + (y / l) * (y / l) = 1 /\ (- z / r) * (- z / r) + (- x / r) * (- x / r) = 1.
Proof.
  pose proof r_positive; pose proof l_positive; pose proof r_squared as r2; pose proof l_squared as l2.
  split.
  - transitivity ((r * r + y * y) / (l * l)); [field; lra |].
    rewrite r2, l2; field; nra.
  - transitivity ((x * x + z * z) / (r * r)); [field; lra |].
    rewrite r2; field; nra.
Qed.

Definition Q v := about_y (- z / r) (- x / r) (about_x (r / l) (y / l) v).
Definition Q_as_written v := about_y (- z / r) (- (- x / r)) (about_x (r / l) (- (y / l)) v).

Theorem columns_of_Q : Q (V 1 0 0) = X /\ Q (V 0 1 0) = Y /\ Q (V 0 0 1) = Z.
Proof.
  pose proof r_positive; pose proof l_positive.
  unfold Q, X, Y, Z, about_x, about_y; simpl; repeat split; f_equal; field; lra.
Qed.

Theorem axes_are_orthonormal :
  dot X X = 1 /\ dot Y Y = 1 /\ dot Z Z = 1 /\ dot X Y = 0 /\ dot Y Z = 0 /\ dot Z X = 0.
Proof.
  pose proof r_positive; pose proof l_positive; pose proof r_squared as r2; pose proof l_squared as l2.
  unfold dot, X, Y, Z; simpl; repeat split.
  - transitivity ((x * x + z * z) / (r * r)); [field; lra | rewrite r2; field; nra].
  - transitivity ((y * y * (x * x + z * z) + r * r * (r * r)) / (r * r * (l * l))); [field; lra |].
    rewrite r2, l2; field; nra.
  - transitivity ((x * x + y * y + z * z) / (l * l)); [field; lra | rewrite l2; field; nra].
  - field; lra.
  - transitivity (y * ((x * x + z * z) - r * r) / (r * (l * l))); [field; lra | rewrite r2; field; nra].
  - field; lra.
Qed.

Theorem axes_are_right_handed : cross X Y = Z /\ cross Y Z = X /\ cross Z X = Y.
Proof.
  pose proof r_positive; pose proof l_positive; pose proof r_squared as r2; pose proof l_squared as l2.
  unfold cross, X, Y, Z; simpl; repeat split; f_equal.
  all: try (field; lra).
  - transitivity (- y * (x * x + z * z) / (r * r * l)); [field; lra | rewrite r2; field; nra].
  - transitivity (- z * (r * r + y * y) / (r * (l * l))); [field; lra | rewrite r2, l2; field; split; nra].
  - transitivity (x * (r * r + y * y) / (r * (l * l))); [field; lra | rewrite r2, l2; field; split; nra].
  - transitivity ((x * x + z * z) / (r * l)); [field; lra | rewrite r2; field; split; nra].
Qed.

Theorem Q_keeps_lengths_and_angles : forall a b, dot (Q a) (Q b) = dot a b.
Proof.
  intros [ax ay az] [bx b_y bz].
  destruct angles_are_angles as [about_x_unit about_y_unit].
  unfold Q, dot, about_x, about_y; simpl.
  set (c := r / l) in *; set (s := y / l) in *; set (C := - z / r) in *; set (S := - x / r) in *.
  transitivity ((C * C + S * S) * ax * bx + (c * c + s * s) * ay * b_y + (c * c + s * s) * az * bz
    + (C * C + S * S - 1) * (s * ay + c * az) * (s * b_y + c * bz)); [ring |].
  rewrite about_x_unit, about_y_unit; ring.
Qed.

Theorem Q_takes_down_to_the_normal : Q (V 0 0 1) = V (- x / l) (- y / l) (- z / l).
Proof. apply columns_of_Q. Qed.

(* Refuted: the source's signs. *)
Theorem as_written_down_is : Q_as_written (V 0 0 1) = V (x / l) (y / l) (- z / l).
Proof.
  pose proof r_positive; pose proof l_positive.
  unfold Q_as_written, about_x, about_y; simpl; f_equal; field; lra.
Qed.

Theorem as_written_is_not_parallel : cross (Q_as_written (V 0 0 1)) n = V 0 0 0 -> x = 0 /\ y = 0.
Proof.
  pose proof l_positive; rewrite as_written_down_is.
  unfold cross, n; simpl; intros parallel; injection parallel as first second _.
  assert (y * z = 0) by (apply (Rmult_eq_reg_r (2 / l)); [| apply Rgt_not_eq, Rdiv_lt_0_compat; lra];
    rewrite Rmult_0_l, <- first; field; lra).
  assert (x * z = 0) by (apply (Rmult_eq_reg_r (- (2 / l))); [| apply Rlt_not_eq, Ropp_lt_gt_0_contravar, Rdiv_lt_0_compat; lra];
    rewrite Rmult_0_l, <- second; field; lra).
  split; nra.
Qed.

End Upright.

Print Assumptions columns_of_Q.
Print Assumptions axes_are_orthonormal.
Print Assumptions axes_are_right_handed.
Print Assumptions Q_keeps_lengths_and_angles.
Print Assumptions Q_takes_down_to_the_normal.
Print Assumptions as_written_is_not_parallel.
