(* Lemma slip-signs (proofs-notes/rounding-of-forces.md, section 3): the signs that slips use are right wherever the
   decisions before them were certain. fast/surface.hpp, with_sign_of; fast/surface_in_pairs.hpp, with_sign_of. *)

From Coq Require Import Reals Psatz.
From Groundtruth Require Import clip counted.
Open Scope R_scope.

(* Cases 1 and 2 of a slip: the force is beyond the band, in case 2 also beyond the corners. *)
Theorem slips_are_beyond_the_band : forall m B x y, 0 <= B -> B < m ->
  let s := sqrt (m * m - B * B) in
  ~ (Rabs x <= B /\ x * x + y * y <= m * m) ->
  (Rabs y <= s \/ s < Rabs y /\ B * Rabs y <= Rabs x * s) -> 0 < B -> B < Rabs x.
Proof.
  intros m B x y B_pos some s slips which braked. pose proof (s_squared m B B_pos some) as s2. pose proof (s_positive m B B_pos some) as s_pos.
  fold s in s2, s_pos. pose proof (Rabs_pos x). pose proof (Rabs_pos y). pose proof (square_of_magnitude x). pose proof (square_of_magnitude y).
  apply Rnot_le_lt. intros inside. destruct which as [between | (beyond & beside)].
  - apply slips. split; [assumption |]. nra.
  - assert (Rabs x * s <= B * s) by (apply Rmult_le_compat_r; lra). nra.
Qed.

(* Where a^2 certainly exceeds a number that is not negative, by more than what the size of the comparison leaves room for,
   then a, known within E, has the sign of its value. *)
Theorem sign_is_right : forall value a E near other margin, Rabs (value - a) <= E -> Rabs value + E <= near -> 0 <= other ->
  3 / 2 * (E * near) <= margin -> margin < a * a - other -> 0 < value * a.
Proof.
  intros value a E near other margin known enough pos least certain. pose proof (Rabs_pos (value - a)). pose proof (Rabs_pos value).
  assert (Rabs a <= near).
  { replace a with (value - (value - a)) by ring. unfold Rminus at 1. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp. lra. }
  pose proof (Rabs_pos a). assert (Rabs a * Rabs a = a * a) as square by apply square_of_magnitude.
  assert (0 <= E * near) by (apply Rmult_le_pos; lra).
  assert (E < Rabs a).
  { apply Rnot_le_lt. intros small. assert (Rabs a * Rabs a <= E * near) by (apply Rmult_le_compat; lra). lra. }
  apply counted.within in known. unfold Rabs in *. destruct (Rcase_abs a); nra.
Qed.

(* Counted numbers: `value` stands for a after n roundings, its square has the size of counted-square, and the comparison
   with it is certain if it exceeds twice its own error. *)
Theorem counted_sign_is_right : forall unit n value size a near other k all computed, 0 <= unit <= u -> 0 <= n -> 2 * n + 2 <= k <= most_roundings ->
  counted unit n value size a -> Rabs value + 2 * (n * unit * (1 + second_orders) * size) <= near -> size * near <= all * (1 + / 1000) -> 0 <= other -> 0 < all ->
  let error := k * unit * (1 + second_orders) * all in
  Rabs (computed - (other - a * a)) <= error -> 199 / 100 * error < - computed -> 0 < value * a.
Proof.
  intros unit n value size a near other k all computed unit_small n_pos k_range is near_is all_is other_pos all_pos error computed_near certain.
  assert (0 <= size) as size_pos by apply is. pose proof (error_is_bound unit unit_small n value size a ltac:(lra) is) as known.
  set (E := n * unit * (1 + second_orders) * size) in *. apply counted.within in computed_near.
  assert (0 <= unit * (1 + second_orders)) as e_pos by (apply Rmult_le_pos; [lra | unfold second_orders; lra]).
  set (e := unit * (1 + second_orders)) in *.
  assert (E = n * (e * size)) as EE by (unfold E, e; ring). assert (error = k * (e * all)) as ee by (unfold error, e; ring).
  assert (0 <= e * size) by (apply Rmult_le_pos; lra). assert (0 <= E) by (rewrite EE; apply Rmult_le_pos; lra).
  apply (sign_is_right value a E near other (3 / 2 * (E * near))); trivial; try lra.
  assert (E * near <= 1001 / 1000 * (n * (e * all))).
  { rewrite EE. replace (n * (e * size) * near) with (n * e * (size * near)) by ring.
    replace (1001 / 1000 * (n * (e * all))) with (n * e * (all * (1 + / 1000))) by field. apply Rmult_le_compat_l; [now apply Rmult_le_pos | assumption]. }
  assert (0 <= e * all) by (apply Rmult_le_pos; lra). assert (2 * (n * (e * all)) <= error) by (rewrite ee; nra).
  assert (error <= 0 \/ 0 < error) as [none | some] by lra; [| lra].
  assert (0 <= n * (e * all)) by (apply Rmult_le_pos; lra). lra.
Qed.

Print Assumptions slips_are_beyond_the_band.
Print Assumptions sign_is_right.
Print Assumptions counted_sign_is_right.
