(* Lemma decisions-in-doubles (proofs-notes/rounding-of-forces.md, section 8), its second part: the numbers that a surface's
   decisions compare. fast/surface_in_doubles.hpp, SurfaceInDoubles: along_, down_, turning_, across. *)

From Coq Require Import Reals Psatz.
From Groundtruth Require Import surface frames sizes.
Open Scope R_scope.

Section Products.

(* Normal, forward axis and force; g' and F' as they are computed with. *)
Variables n g g' F F' : vector.
Variables l k f : R.
Hypotheses (l_pos : 0 <= l) (k_pos : 0 <= k) (f_pos : 0 <= f).
Hypotheses (n_length : dot n n = l * l) (g_length : dot g g = k * k) (F_size : size F ((1 + 4 * u) * f)).
Hypotheses (g_near : size (minus g' g) (64 * u * k)). (* 2^-47 *)
Hypotheses (F_near : size (minus F' F) (2 * u * f)). (* 2^-52 *)

Lemma of_difference : forall a b, a = plus b (minus a b).
Proof. intros [ax ay az] [bx b_y bz]. unfold minus, plus, times; simpl. f_equal; ring. Qed.

Lemma n_size : size n l. Proof. split; lra. Qed.
Lemma g_size : size g k. Proof. split; lra. Qed.
Lemma g'_size : size g' ((1 + 64 * u) * k).
Proof. rewrite (of_difference g' g). replace ((1 + 64 * u) * k) with (k + 64 * u * k) by ring. apply size_sum; [apply g_size | assumption]. Qed.
Lemma F'_size : size F' ((1 + 6 * u) * f).
Proof. rewrite (of_difference F' F). replace ((1 + 6 * u) * f) with ((1 + 4 * u) * f + 2 * u * f) by ring. now apply size_sum. Qed.

(* A bilinear form of two vectors that are both off. *)
Lemma dot_moves : forall a a' b b' A B e d, size (minus a' a) e -> size (minus b' b) d -> size a A -> size b' B ->
  Rabs (dot a' b' - dot a b) <= e * B + A * d.
Proof.
  intros a a' b b' A B e d Ha Hb Sa Sb. replace (dot a' b' - dot a b) with (dot (minus a' a) b' + dot a (minus b' b))
    by (unfold minus, plus, times, dot; simpl; ring).
  apply Rle_trans with (1 := Rabs_triang _ _). apply Rplus_le_compat; now apply cauchy.
Qed.

Lemma near_by : forall x y z e d, Rabs (x - y) <= e -> Rabs (y - z) <= d -> Rabs (x - z) <= e + d.
Proof. intros x y z e d H1 H2. replace (x - z) with ((x - y) + (y - z)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. Qed.

Lemma kf_pos : 0 <= k * f /\ 0 <= l * f /\ 0 <= k * (l * f).
Proof. repeat split; repeat apply Rmult_le_pos; assumption. Qed.

Theorem along_near : Rabs (dotd g' F' - dot g F) <= 70 * u * (k * f).
Proof.
  destruct kf_pos as (pos & _).
  pose proof (near_by _ (dot g' F') _ _ _ (dot_error _ _ _ _ g'_size F'_size) (dot_moves g g' F F' _ _ _ _ g_near F_near g_size F'_size)) as near.
  apply Rle_trans with (1 := near). unfold u in *. lra.
Qed.

Theorem down_near : Rabs (dotd n F' - dot n F) <= 6 * u * (l * f).
Proof.
  destruct kf_pos as (_ & pos & _). assert (size (minus n n) 0) as same by (split; [lra |]; unfold minus, plus, times, dot; simpl; nra).
  pose proof (near_by _ (dot n F') _ _ _ (dot_error _ _ _ _ n_size F'_size) (dot_moves n n F F' _ _ _ _ same F_near n_size F'_size)) as near.
  apply Rle_trans with (1 := near). unfold u in *. lra.
Qed.

Theorem turning_near : size (minus (crossd n F') (cross n F)) (6 * u * (l * f)).
Proof.
  destruct kf_pos as (_ & pos & _). apply size_more with (37 / 10 * u * (l * ((1 + 6 * u) * f)) + l * (2 * u * f)); [unfold u in *; lra |].
  replace (minus (crossd n F') (cross n F)) with (plus (minus (crossd n F') (cross n F')) (cross n (minus F' F))).
  - apply size_sum; [apply cross_error; [apply n_size | apply F'_size] | apply size_cross; [apply n_size | assumption]].
  - unfold minus, plus, times, cross; simpl. f_equal; ring.
Qed.

Lemma turning_size : size (cross n F) (l * ((1 + 4 * u) * f)).
Proof. apply size_cross; [apply n_size | assumption]. Qed.
Lemma turning'_size : size (crossd n F') ((1 + 10 * u) * (l * f)).
Proof.
  rewrite (of_difference (crossd n F') (cross n F)). replace ((1 + 10 * u) * (l * f)) with (l * ((1 + 4 * u) * f) + 6 * u * (l * f)) by ring.
  apply size_sum; [apply turning_size | apply turning_near].
Qed.

Theorem across_near : Rabs (dotd g' (crossd n F') - dot g (cross n F)) <= 74 * u * (k * (l * f)).
Proof.
  destruct kf_pos as (_ & _ & pos).
  pose proof (near_by _ (dot g' (crossd n F')) _ _ _ (dot_error _ _ _ _ g'_size turning'_size)
    (dot_moves g g' (cross n F) (crossd n F') _ _ _ _ g_near turning_near g_size turning'_size)) as near.
  apply Rle_trans with (1 := near). unfold u in *. lra.
Qed.

Theorem squares_near : Rabs (dotd g' g' - dot g g) <= 132 * u * (k * k) /\ Rabs (dotd n n - dot n n) <= 4 * u * (l * l).
Proof.
  assert (0 <= k * k /\ 0 <= l * l) as (pos & pos') by (split; now apply Rmult_le_pos). split.
  - pose proof (near_by _ (dot g' g') _ _ _ (dot_error _ _ _ _ g'_size g'_size) (dot_moves g g' g g' _ _ _ _ g_near g_near g_size g'_size)) as near.
    apply Rle_trans with (1 := near). unfold u in *. lra.
  - pose proof (dot_error _ _ _ _ n_size n_size) as near. apply Rle_trans with (1 := near). unfold u in *. lra.
Qed.

(* |T|^2, of which a half goes to relative error. *)
Theorem turning_squared_near : Rabs (dotd (crossd n F') (crossd n F') - dot (cross n F) (cross n F))
  <= 20 * u * dot (crossd n F') (crossd n F') + 3 * u * (l * f * (l * f)).
Proof.
  set (T := cross n F). set (T' := crossd n F'). set (s := sqrt (dot T' T')).
  assert (0 <= dot T' T') as pos by (unfold dot; pose proof (Rle_0_sqr (vx T')); pose proof (Rle_0_sqr (vy T')); pose proof (Rle_0_sqr (vz T')); unfold Rsqr in *; lra).
  assert (s * s = dot T' T') as ss by now apply sqrt_sqrt. assert (0 <= s) as s_pos by apply sqrt_pos.
  assert (size T' s) as Ts by (split; lra).
  pose proof (dot_error T' T' s s Ts Ts) as rounded. pose proof turning_near as near. fold T T' in near.
  set (e := 6 * u * (l * f)) in *. destruct kf_pos as (_ & lf & _). assert (0 <= e) by (unfold e, u; lra).
  assert (size T (s + e)) as T_size.
  { rewrite (of_difference T T'). apply size_sum; [assumption |]. destruct near as (e_pos & le). split; [assumption |].
    apply Rle_trans with (2 := le). right. unfold minus, plus, times, dot; simpl; ring. }
  pose proof (dot_moves T T' T T' _ _ _ _ near near T_size Ts) as moved.
  pose proof (near_by _ _ _ _ _ rounded moved) as total. apply Rle_trans with (1 := total). rewrite ss in *.
  assert (2 * (s * e) <= 16 * u * dot T' T' + 9 / 4 * u * (l * f * (l * f))).
  { rewrite <- ss. set (L := l * f) in *. assert (0 <= (4 * s - 3 / 2 * L) * (4 * s - 3 / 2 * L)) as split_ by apply Rle_0_sqr.
    replace (2 * (s * e)) with (u * (12 * (s * L))) by (unfold e; ring).
    replace (16 * u * (s * s) + 9 / 4 * u * (L * L)) with (u * (16 * (s * s) + 9 / 4 * (L * L))) by ring.
    apply Rmult_le_compat_l; [unfold u |]; lra. }
  assert (e * e <= / 10 * u * (l * f * (l * f))).
  { unfold e. assert (0 <= l * f * (l * f)) by now apply Rmult_le_pos. unfold u in *; lra. }
  assert (0 <= u * dot T' T') by (apply Rmult_le_pos; [unfold u; lra | assumption]).
  assert (0 <= u * (l * f * (l * f))) by (apply Rmult_le_pos; [unfold u; lra | now apply Rmult_le_pos]). lra.
Qed.

Corollary turning_squared_by_computed : Rabs (dotd (crossd n F') (crossd n F') - dot (cross n F) (cross n F))
  <= 21 * u * dotd (crossd n F') (crossd n F') + 3 * u * (l * f * (l * f)).
Proof.
  pose proof turning_squared_near as near. set (T' := crossd n F') in *. set (d := dot T' T') in *.
  assert (0 <= d) as pos by (unfold d, dot; pose proof (Rle_0_sqr (vx T')); pose proof (Rle_0_sqr (vy T')); pose proof (Rle_0_sqr (vz T')); unfold Rsqr in *; lra).
  assert (sqrt d * sqrt d = d) as ss by now apply sqrt_sqrt.
  assert (size T' (sqrt d)) as Ts by (split; [apply sqrt_pos | fold d; lra]).
  pose proof (dot_error T' T' _ _ Ts Ts) as rounded. fold d in rounded. rewrite ss in rounded. apply within in rounded.
  apply Rle_trans with (1 := near). unfold u in *. lra.
Qed.

End Products.

Print Assumptions along_near.
Print Assumptions across_near.
Print Assumptions turning_squared_by_computed.
