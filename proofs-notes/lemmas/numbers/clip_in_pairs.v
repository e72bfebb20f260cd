(* Lemma clip-in-pairs (proofs-notes/rounding-of-forces.md, section 9): each component of a clipped force is off by less than
   2^-84 f (1 + of_disc), from what the operations of pairs are off by. fast/surface_in_pairs.hpp: clip_error and the four
   formulas. An operation costs eps of its size, which loose_pairs.v (8 pair_unit at most) and quick_pairs.v (2^-97) prove of sums,
   products, quotients and roots; F and g are within 8 eps f and 128 eps |g|, so that their products are as near as is said. *)

From Coq Require Import Reals Psatz.
Open Scope R_scope.

Definition eps := / 158456325028528675187087900672. (* 2^-97 *)
Definition per_clip := / 19342813113834066795298816. (* 0x1p-84 *)

Lemma within : forall x a, Rabs x <= a -> - a <= x <= a.
Proof. intros x a; unfold Rabs; destruct (Rcase_abs x); lra. Qed.
Lemma moved : forall x y s e, Rabs (x - y) <= e -> Rabs y <= s -> Rabs x <= s + e.
Proof. intros x y s e H1 H2. replace x with (y + (x - y)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. Qed.

(* A product of which both factors are off. *)
Lemma product_moves : forall x y x' y' ex ey sx sy, Rabs (x' - x) <= ex -> Rabs (y' - y) <= ey -> Rabs x <= sx -> Rabs y' <= sy ->
  Rabs (x' * y' - x * y) <= ex * sy + sx * ey.
Proof.
  intros. replace (x' * y' - x * y) with ((x' - x) * y' + x * (y' - y)) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
  rewrite !Rabs_mult. apply Rplus_le_compat; apply Rmult_le_compat; trivial; apply Rabs_pos.
Qed.

(* A quotient, q b = a, as quick_pairs.v knows it: |q' - a'/b'| b' <= er. *)
Lemma quotient_moves : forall a b q a' b' q' ea eb er, 0 < b -> Rabs (a' - a) <= ea -> Rabs (b' - b) <= eb * b -> 0 <= eb <= / 1000 ->
  q * b = a -> Rabs (q' * b' - a') <= er -> Rabs (q' - q) * b <= (1 + / 100) * (ea + er + eb * Rabs a).
Proof.
  intros a b q a' b' q' ea eb er b_pos Ha Hb Heb exact Hq. set (X := Rabs (q' - q) * b). pose proof (Rabs_pos (a' - a)). pose proof (Rabs_pos (q' * b' - a')). pose proof (Rabs_pos a).
  assert (0 <= X) by (apply Rmult_le_pos; [apply Rabs_pos | lra]).
  assert (Rabs q' * b <= Rabs a + X) as size.
  { replace q' with (q + (q' - q)) at 1 by ring. apply Rle_trans with ((Rabs q + Rabs (q' - q)) * b); [apply Rmult_le_compat_r; [lra | apply Rabs_triang] |].
    rewrite <- exact, Rabs_mult, (Rabs_pos_eq b) by lra. unfold X. lra. }
  assert (X <= ea + er + eb * (Rabs a + X)).
  { unfold X at 1. rewrite <- (Rabs_pos_eq b) at 1 by lra. rewrite <- Rabs_mult.
    replace ((q' - q) * b) with ((q' * b' - a') + (a' - a) - q' * (b' - b)) by (rewrite <- exact; ring).
    unfold Rminus at 1. apply Rle_trans with (1 := Rabs_triang _ _). rewrite Rabs_Ropp, (Rabs_mult q').
    assert (Rabs q' * Rabs (b' - b) <= eb * (Rabs q' * b)).
    { replace (eb * (Rabs q' * b)) with (Rabs q' * (eb * b)) by ring. apply Rmult_le_compat_l; [apply Rabs_pos | assumption]. }
    assert (eb * (Rabs q' * b) <= eb * (Rabs a + X)) by (apply Rmult_le_compat_l; lra).
    pose proof (Rabs_triang (q' * b' - a') (a' - a)). lra. }
  assert (eb * X <= / 1000 * X) by (apply Rmult_le_compat_r; lra). assert (0 <= eb * Rabs a) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma root_moves : forall s s' E, 0 <= s -> 0 <= s' -> Rabs (s' * s' - s * s) <= E -> Rabs (s' - s) * s <= E.
Proof.
  intros s s' E pos pos' near. replace (s' * s' - s * s) with ((s' - s) * (s' + s)) in near by ring. rewrite Rabs_mult, (Rabs_pos_eq (s' + s)) in near by lra.
  apply Rle_trans with (2 := near). apply Rmult_le_compat_l; [apply Rabs_pos | lra].
Qed.

Lemma cancel : forall x y c, 0 < c -> x * c <= y * c -> x <= y.
Proof. intros x y c pos le. now apply Rmult_le_reg_r with c. Qed.

Section Clip.

(* l = |n|, k = |g|, f >= |F|; one component of n, g, g x n and F. *)
Variables l k f mu B n g g' c c' F F' : R.
Hypotheses (l_pos : 0 < l) (k_pos : 0 < k) (f_pos : 0 < f) (mu_pos : 0 <= mu) (B_pos : 0 <= B).
Hypotheses (n_size : Rabs n <= l) (g_size : Rabs g <= k) (c_size : Rabs c <= k * l) (F_size : Rabs F <= (1 + eps) * f).
Hypotheses (g_near : Rabs (g' - g) <= 148 * eps * k) (c_near : Rabs (c' - c) <= 130 * eps * (k * l)) (F_near : Rabs (F' - F) <= 8 * eps * f).

(* n.F, |n|^2 and their quotient, the part along the normal: p. *)
Variables D D' nn' p p' : R.
Hypotheses (D_size : Rabs D <= (1 + eps) * (l * f)) (D_near : Rabs (D' - D) <= 10 * eps * (l * f)) (nn_near : Rabs (nn' - l * l) <= eps * (l * l)).
Hypotheses (p_is : p * (l * l) = D) (p_near : Rabs (p' * nn' - D') <= eps * (2 * (l * f))).

Lemma part_along_normal : Rabs (p' - p) * l <= 14 * eps * f /\ Rabs p * l <= (1 + eps) * f /\ Rabs p' * l <= (1 + / 100) * f.
Proof.
  assert (0 < l * l) by now apply Rmult_lt_0_compat. assert (0 < l * f) by now apply Rmult_lt_0_compat.
  pose proof (quotient_moves D (l * l) p D' nn' p' _ eps _ ltac:(assumption) D_near nn_near ltac:(unfold eps; lra) p_is p_near) as near.
  assert (Rabs (p' - p) * l <= 14 * eps * f) as one.
  { apply cancel with l; [assumption |]. apply Rle_trans with (Rabs (p' - p) * (l * l)); [right; ring |]. apply Rle_trans with (1 := near). unfold eps in *. lra. }
  assert (Rabs p * l <= (1 + eps) * f) as two.
  { apply cancel with l; [assumption |]. replace (Rabs p * l * l) with (Rabs D) by (rewrite <- p_is, Rabs_mult, (Rabs_pos_eq (l * l)) by lra; ring). lra. }
  split; [assumption |]. split; [assumption |]. replace p' with (p + (p' - p)) by ring.
  apply Rle_trans with ((Rabs p + Rabs (p' - p)) * l); [apply Rmult_le_compat_r; [lra | apply Rabs_triang] |]. unfold eps in *. lra.
Qed.

(* p n, as one product. *)
Lemma pressed_part : forall x, Rabs (x - p' * n) <= eps * (2 * f) -> Rabs (x - p * n) <= 16 * eps * f /\ Rabs x <= 2 * f.
Proof.
  intros x near. destruct part_along_normal as (one & two & three).
  assert (Rabs ((p' - p) * n) <= 14 * eps * f) by (rewrite Rabs_mult; apply Rle_trans with (2 := one); apply Rmult_le_compat_l; [apply Rabs_pos | assumption]).
  assert (Rabs (p * n) <= (1 + eps) * f) by (rewrite Rabs_mult; apply Rle_trans with (2 := two); apply Rmult_le_compat_l; [apply Rabs_pos | assumption]).
  assert (Rabs (x - p * n) <= 16 * eps * f) as total.
  { replace (x - p * n) with ((x - p' * n) + (p' - p) * n) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. }
  split; [assumption |]. apply Rle_trans with (1 := moved _ _ _ _ total H0). unfold eps in *; lra.
Qed.

Section Circle.

(* rho = mu |D| / |T|; wherever the decision was certain |T| is no tiny part of l f. *)
Variables T T' tt' limit' rho rho' m' q' a' b' r' : R.
Hypotheses (T_some : / 8388608 * (l * f) <= T) (T_most : T <= 2 * (l * f)) (T'_pos : 0 <= T').
Hypotheses (tt_near : Rabs (tt' - T * T) <= 40 * eps * (l * f) * T) (T_root : Rabs (T' * T' - tt') <= 4 * eps * (T * T)).
Hypotheses (limit_near : Rabs (limit' - mu * Rabs D) <= 12 * eps * (mu * (l * f))).
Hypotheses (rho_is : rho * T = mu * Rabs D) (rho_range : 0 <= rho <= 1) (rho_near : Rabs (rho' * T' - limit') <= eps * (2 * (mu * (l * f)))).
Hypothesis tangential : Rabs (F - p * n) * l <= T. (* |F'_xy| = |T| / |n| *)
Hypotheses (m_near : Rabs (m' - (1 - rho')) <= 3 * eps) (q_near : Rabs (q' - m' * p') * l <= eps * (3 * f)).
Hypotheses (a_near : Rabs (a' - rho' * F') <= eps * (2 * f)) (b_near : Rabs (b' - q' * n) <= eps * (3 * f)) (r_near : Rabs (r' - (a' + b')) <= eps * (8 * f)).

Theorem circle_is_near : Rabs (r' - (rho * F + (1 - rho) * p * n)) <= per_clip * (f * (1 + mu)).
Proof.
  destruct part_along_normal as (p_off & p_size & p'_size). assert (0 < l * f) as lf by now apply Rmult_lt_0_compat. assert (0 < T) by lra.
  assert (0 <= mu * (l * f)) as mlf by (apply Rmult_le_pos; lra).
  assert (Rabs (T' * T' - T * T) <= (48 * eps * (l * f)) * T) as squares.
  { replace (T' * T' - T * T) with ((T' * T' - tt') + (tt' - T * T)) by ring. apply Rle_trans with (1 := Rabs_triang _ _).
    assert (T * T <= 2 * (l * f) * T) by (apply Rmult_le_compat_r; lra). unfold eps in *. lra. }
  pose proof (root_moves T T' _ ltac:(lra) T'_pos squares) as root. apply cancel in root; [| assumption].
  assert (48 * eps * (l * f) <= (/ 1000) * T) by (unfold eps; lra).
  assert (Rabs (T' - T) <= (48 * eps * (l * f) / T) * T) as relative by (replace (48 * eps * (l * f) / T * T) with (48 * eps * (l * f)) by (field; lra); assumption).
  assert (0 <= 48 * eps * (l * f) / T <= / 1000) as part.
  { split; [apply Rle_mult_inv_pos; [unfold eps; lra | assumption] |]. apply cancel with T; [assumption |].
    replace (48 * eps * (l * f) / T * T) with (48 * eps * (l * f)) by (field; lra). assumption. }
  pose proof (quotient_moves _ T rho limit' T' rho' _ _ _ ltac:(assumption) limit_near relative part rho_is rho_near) as near.
  assert (48 * eps * (l * f) / T * Rabs (mu * Rabs D) <= 48 * eps * (l * f)) as inherited.
  { rewrite <- rho_is, Rabs_mult, (Rabs_pos_eq T), (Rabs_pos_eq rho) by lra. replace (48 * eps * (l * f) / T * (rho * T)) with (rho * (48 * eps * (l * f))) by (field; lra).
    rewrite <- (Rmult_1_l (48 * eps * (l * f))) at 2. apply Rmult_le_compat_r; [unfold eps; lra | lra]. }
  assert (Rabs (rho' - rho) * T <= (54 * eps * f * (1 + mu)) * l) as rho_off.
  { apply Rle_trans with (1 := near). unfold eps in *. lra. }
  assert (Rabs (rho' - rho) <= / 100 * (1 + mu)) as rho_small.
  { apply cancel with T; [assumption |]. apply Rle_trans with (1 := rho_off). apply Rle_trans with (/ 100 * (1 + mu) * (/ 8388608 * (l * f))).
    - assert (0 <= l * f * mu) by (apply Rmult_le_pos; lra). unfold eps. lra.
    - apply Rmult_le_compat_l; [lra | assumption]. }
  assert (Rabs ((rho' - rho) * (F - p * n)) <= 54 * eps * f * (1 + mu)) as along.
  { apply cancel with l; [assumption |]. rewrite Rabs_mult. apply Rle_trans with (2 := rho_off).
    replace (Rabs (rho' - rho) * Rabs (F - p * n) * l) with (Rabs (rho' - rho) * (Rabs (F - p * n) * l)) by ring.
    apply Rmult_le_compat_l; [apply Rabs_pos | assumption]. }
  assert (Rabs rho' <= 1 + / 100 * (1 + mu)) as rho'_size.
  { replace rho' with (rho + (rho' - rho)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). rewrite (Rabs_pos_eq rho) by lra. lra. }
  assert (Rabs (1 - rho') <= 2 + / 100 * (1 + mu)) as rest_size.
  { apply within in rho'_size. apply Rabs_le. lra. }
  assert (0 <= f * mu) by (apply Rmult_le_pos; lra).
  assert (Rabs (rho' * (F' - F)) <= 16 * eps * (f * (1 + mu))) as t1.
  { rewrite Rabs_mult. apply Rle_trans with ((1 + / 100 * (1 + mu)) * (8 * eps * f)); [apply Rmult_le_compat; trivial; apply Rabs_pos | unfold eps; lra]. }
  assert (Rabs ((q' - (1 - rho') * p) * n) <= 60 * eps * (f * (1 + mu))) as t2.
  { rewrite Rabs_mult. apply Rle_trans with (Rabs (q' - (1 - rho') * p) * l); [apply Rmult_le_compat_l; [apply Rabs_pos | assumption] |].
    replace (q' - (1 - rho') * p) with ((q' - m' * p') + (m' - (1 - rho')) * p' + (1 - rho') * (p' - p)) by ring.
    assert (Rabs ((m' - (1 - rho')) * p') * l <= 3 * eps * ((1 + / 100) * f)).
    { rewrite Rabs_mult, Rmult_assoc. apply Rmult_le_compat; trivial; [apply Rabs_pos | apply Rmult_le_pos; [apply Rabs_pos | lra]]. }
    assert (Rabs ((1 - rho') * (p' - p)) * l <= (2 + / 100 * (1 + mu)) * (14 * eps * f)).
    { rewrite Rabs_mult, Rmult_assoc. apply Rmult_le_compat; trivial; [apply Rabs_pos | apply Rmult_le_pos; [apply Rabs_pos | lra]]. }
    apply Rle_trans with ((Rabs (q' - m' * p') + Rabs ((m' - (1 - rho')) * p') + Rabs ((1 - rho') * (p' - p))) * l).
    - apply Rmult_le_compat_r; [lra |]. apply Rle_trans with (1 := Rabs_triang _ _). apply Rplus_le_compat_r, Rabs_triang.
    - unfold eps in *. lra. }
  replace (r' - (rho * F + (1 - rho) * p * n)) with
    ((r' - (a' + b')) + (a' - rho' * F') + (b' - q' * n) + rho' * (F' - F) + (q' - (1 - rho') * p) * n + (rho' - rho) * (F - p * n)) by ring.
  apply within in r_near. apply within in a_near. apply within in b_near. apply within in t1. apply within in t2. apply within in along.
  apply Rabs_le. unfold per_clip, eps in *. lra.
Qed.
End Circle.
End Clip.

Print Assumptions circle_is_near.
