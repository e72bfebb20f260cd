(* Lemma load-without-rotation (proofs-notes/rounding-of-forces.md, section 5): force, uprightness and strut of SPEC section 5
   in world coordinates, without the wheel's other axes. fast/step_load.hpp, fast/step_strut.hpp, fast/quick_load.hpp,
   fast/quick_strut.hpp. *)

From Coq Require Import Reals Psatz.
From Groundtruth Require Import surface frames.
Open Scope R_scope.

Section Wheel.

Variable f : frame. (* the wheel's axes in world coordinates *)
Hypothesis ok : is_frame f.
Variable N : R. (* |q|^2 *)
Hypothesis N_pos : 0 < N.
Let down := at_ f 0 0 N. (* as the code has it: N times the wheel's z axis *)

(* p, w in wheel coordinates; the arm and the velocity are p and w in world coordinates. *)
Theorem force_without_rotation : forall k_xy k_z d_xy d_z z_zero px py pz wx wy wz,
  let arm := at_ f px py pz in
  let velocity := at_ f wx wy wz in
  let along_strut := (k_z - k_xy) * dot down arm + (d_z - d_xy) * dot down velocity - k_z * z_zero * N in
  plus (plus (times k_xy arm) (times d_xy velocity)) (times (along_strut / (N * N)) down)
  = at_ f (k_xy * px + d_xy * wx) (k_xy * py + d_xy * wy) (k_z * (pz - z_zero) + d_z * wz).
Proof.
  intros. unfold along_strut, arm, velocity, down. rewrite !dot_by_coordinates, !times_by_coordinates, !plus_by_coordinates by assumption.
  f_equal; field; lra.
Qed.

(* How far down the pebble is. *)
Theorem depth_without_rotation : forall px py pz, dot down (at_ f px py pz) = N * pz.
Proof. intros. unfold down. rewrite dot_by_coordinates by assumption. ring. Qed.

Theorem upright_without_rotation : forall t nx ny nz,
  let n := at_ f nx ny nz in
  (0 < - nz <-> dot down n < 0) /\
  (t * t * (nx * nx + ny * ny) <= nz * nz <-> t * t * (dot n n * (N * N)) <= (1 + t * t) * (dot down n * dot down n)).
Proof.
  intros t nx ny nz n. unfold n, down. rewrite !dot_by_coordinates by assumption.
  replace (0 * nx + 0 * ny + N * nz) with (N * nz) by ring. split; [split; intros; nra |].
  assert (0 < N * N) by nra. split; intros le.
  - apply Rmult_le_compat_l with (r := N * N) in le; lra.
  - apply Rmult_le_reg_l with (N * N); lra.
Qed.

(* The strut's line through the frame's place and an offset o, of which only (x, y) matters: T(x, y, z). *)
Theorem end_without_rotation : forall b ox oy oz z,
  let o := at_ f ox oy oz in
  plus b (plus o (times ((z - dot down o / N) / N) down)) = plus b (at_ f ox oy z).
Proof.
  intros. unfold o, down. rewrite dot_by_coordinates, times_by_coordinates, plus_by_coordinates by assumption.
  f_equal; f_equal; field; lra.
Qed.

(* Where it meets the plane n.x = d: in the plane, and (x, y) as they were. *)
Theorem landing_without_rotation : forall b ox oy oz n d, dot n down <> 0 ->
  let o := at_ f ox oy oz in
  let way := (d - dot n b - dot n o) / dot n down in
  dot n (plus b (plus o (times way down))) = d /\ plus o (times way down) = at_ f ox oy (oz + way * N).
Proof.
  intros b ox oy oz n d some o way. split.
  - transitivity (dot n b + dot n o + way * dot n down); [| unfold way; field; assumption].
    generalize (o) (way). intros o' way'. unfold dot, plus, times; simpl; ring.
  - unfold o, down. rewrite times_by_coordinates, plus_by_coordinates. f_equal; ring.
Qed.

(* Return mapping, of the parts that matter: the relocated offset's (x, y). *)
Theorem relocated_without_rotation : forall k_xy d_xy h px py pz wx wy wz cx cy cz, h * k_xy + d_xy <> 0 -> h <> 0 ->
  times (/ (h * k_xy + d_xy)) (plus (times h (at_ f cx cy cz)) (times d_xy (plus (at_ f px py pz) (times (- h) (at_ f wx wy wz)))))
  = at_ f ((cx + d_xy / h * px - d_xy * wx) / (k_xy + d_xy / h)) ((cy + d_xy / h * py - d_xy * wy) / (k_xy + d_xy / h))
      ((cz + d_xy / h * pz - d_xy * wz) / (k_xy + d_xy / h)).
Proof.
  intros. rewrite !times_by_coordinates, !plus_by_coordinates, times_by_coordinates, plus_by_coordinates, times_by_coordinates.
  assert (k_xy + d_xy / h <> 0).
  { intros zero. apply H. replace (h * k_xy + d_xy) with (h * (k_xy + d_xy / h)) by (field; assumption). rewrite zero. ring. }
  f_equal; field; repeat split; trivial; intros zero; apply H; lra.
Qed.

End Wheel.

(* The code's axes: those of the rotation v -> q v q^-1, times N = |q|^2. *)
Section Quaternion.

Variables w x y z : R.
Definition norm_squared := w * w + x * x + (y * y + z * z).
Definition forward := V (w * w + x * x - (y * y + z * z)) (2 * (x * y + w * z)) (2 * (x * z - w * y)).
Definition rightward := V (2 * (x * y - w * z)) (w * w + y * y - (x * x + z * z)) (2 * (y * z + w * x)).
Definition downward := V (2 * (x * z + w * y)) (2 * (y * z - w * x)) (w * w + z * z - (x * x + y * y)).

Theorem axes_of_the_wheel : 0 < norm_squared ->
  is_frame {| axis_x := times (/ norm_squared) forward; axis_y := times (/ norm_squared) rightward; axis_z := times (/ norm_squared) downward |}.
Proof.
  intros some. unfold is_frame, dot, cross, times, forward, rightward, downward, norm_squared in *; simpl.
  repeat split; try (field; lra); f_equal; field; lra.
Qed.
End Quaternion.

Print Assumptions force_without_rotation.
Print Assumptions upright_without_rotation.
Print Assumptions end_without_rotation.
Print Assumptions landing_without_rotation.
Print Assumptions relocated_without_rotation.
Print Assumptions axes_of_the_wheel.
