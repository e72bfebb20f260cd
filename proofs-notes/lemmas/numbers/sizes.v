(* Lemma decisions-in-doubles (proofs-notes/rounding-of-forces.md, section 8), its first part: what dot and cross products of
   doubles are off by, as parts of the lengths. fast/pairs.hpp, dot_in_doubles and cross_in_doubles; fast/surface_in_doubles.hpp.
   Rounding is to 53 bits without underflow: the windows there keep it away. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core Relative.
From Groundtruth Require Import surface frames.
Open Scope R_scope.

Definition u := / 9007199254740992. (* 2^-53 *)
Definition rd := round radix2 (FLX_exp 53) ZnearestE.

Lemma rd_near : forall x s, Rabs x <= s -> Rabs (rd x - x) <= u * s.
Proof.
  intros x s le. pose proof (relative_error_N_FLX radix2 53 ltac:(easy) (fun z => negb (Z.even z)) x) as near.
  apply Rle_trans with (1 := near). apply Rle_trans with (u * Rabs x); [right; unfold u; simpl; lra |].
  apply Rmult_le_compat_l; [unfold u; lra | assumption].
Qed.

Lemma within : forall x a, Rabs x <= a -> - a <= x <= a.
Proof. intros x a; unfold Rabs; destruct (Rcase_abs x); lra. Qed.

(* Of a vector: its length is at most this. *)
Definition size v s := 0 <= s /\ dot v v <= s * s.
Definition minus a b := plus a (times (-1) b).

Lemma bounded_by_squares : forall x s, 0 <= s -> x * x <= s * s -> Rabs x <= s.
Proof. intros x s pos le. apply Rabs_le. split; nra. Qed.

Lemma cauchy : forall a b A B, size a A -> size b B -> Rabs (dot a b) <= A * B.
Proof.
  intros [ax ay az] [bx b_y bz] A B (A_pos & HA) (B_pos & HB). unfold dot in *; simpl in *. apply bounded_by_squares; [now apply Rmult_le_pos |].
  apply Rle_trans with ((ax * ax + ay * ay + az * az) * (bx * bx + b_y * b_y + bz * bz)).
  - assert (0 <= (ax * b_y - ay * bx) * (ax * b_y - ay * bx)) by apply Rle_0_sqr. assert (0 <= (ay * bz - az * b_y) * (ay * bz - az * b_y)) by apply Rle_0_sqr.
    assert (0 <= (ax * bz - az * bx) * (ax * bz - az * bx)) by apply Rle_0_sqr. lra.
  - replace (A * B * (A * B)) with (A * A * (B * B)) by ring. pose proof (Rle_0_sqr ax). pose proof (Rle_0_sqr ay). pose proof (Rle_0_sqr az).
    pose proof (Rle_0_sqr bx). pose proof (Rle_0_sqr b_y). pose proof (Rle_0_sqr bz). unfold Rsqr in *. apply Rmult_le_compat; lra.
Qed.

Definition magnitudes v := V (Rabs (vx v)) (Rabs (vy v)) (Rabs (vz v)).
Lemma size_of_magnitudes : forall v s, size v s -> size (magnitudes v) s.
Proof.
  intros [x y z] s (pos & le). split; [assumption |]. unfold dot, magnitudes in *; simpl in *.
  rewrite <- !Rabs_mult, !Rabs_pos_eq by apply Rle_0_sqr. assumption.
Qed.
Lemma sum_of_products : forall a b A B, size a A -> size b B ->
  Rabs (vx a * vx b) + Rabs (vy a * vy b) + Rabs (vz a * vz b) <= A * B.
Proof.
  intros a b A B Ha Hb. pose proof (cauchy _ _ A B (size_of_magnitudes a A Ha) (size_of_magnitudes b B Hb)) as le.
  apply within in le. unfold dot, magnitudes in le; simpl in le. rewrite !Rabs_mult. lra.
Qed.

Lemma size_sum : forall a b A B, size a A -> size b B -> size (plus a b) (A + B).
Proof.
  intros a b A B Ha Hb. pose proof (cauchy a b A B Ha Hb) as c. apply within in c. destruct Ha as (A_pos & HA). destruct Hb as (B_pos & HB).
  split; [lra |]. unfold dot, plus in *; simpl in *. lra.
Qed.

Lemma size_cross : forall a b A B, size a A -> size b B -> size (cross a b) (A * B).
Proof.
  intros [ax ay az] [bx b_y bz] A B (A_pos & HA) (B_pos & HB). split; [now apply Rmult_le_pos |]. unfold dot, cross in *; simpl in *.
  apply Rle_trans with ((ax * ax + ay * ay + az * az) * (bx * bx + b_y * b_y + bz * bz)).
  - assert (0 <= (ax * bx + ay * b_y + az * bz) * (ax * bx + ay * b_y + az * bz)) by apply Rle_0_sqr. lra.
  - replace (A * B * (A * B)) with (A * A * (B * B)) by ring. pose proof (Rle_0_sqr ax). pose proof (Rle_0_sqr ay). pose proof (Rle_0_sqr az).
    pose proof (Rle_0_sqr bx). pose proof (Rle_0_sqr b_y). pose proof (Rle_0_sqr bz). unfold Rsqr in *. apply Rmult_le_compat; lra.
Qed.

Lemma size_more : forall a A B, A <= B -> size a A -> size a B.
Proof. intros a A B le (pos & HA). split; [lra |]. apply Rle_trans with (1 := HA). apply Rmult_le_compat; lra. Qed.

(* As they are computed. *)
Definition dotd a b := rd (rd (rd (vx a * vx b) + rd (vy a * vy b)) + rd (vz a * vz b)).
Definition detd a b c d := rd (rd (a * b) - rd (c * d)).
Definition crossd a b := V (detd (vy a) (vz b) (vz a) (vy b)) (detd (vz a) (vx b) (vx a) (vz b)) (detd (vx a) (vy b) (vy a) (vx b)).

Lemma dot_error : forall a b A B, size a A -> size b B -> Rabs (dotd a b - dot a b) <= 31 / 10 * u * (A * B).
Proof.
  intros a b A B Ha Hb. pose proof (sum_of_products a b A B Ha Hb) as all. unfold dotd, dot.
  pose proof (rd_near (vx a * vx b) _ (Rle_refl _)) as p. pose proof (rd_near (vy a * vy b) _ (Rle_refl _)) as q. pose proof (rd_near (vz a * vz b) _ (Rle_refl _)) as r.
  pose proof (Rabs_pos (vx a * vx b)). pose proof (Rabs_pos (vy a * vy b)). pose proof (Rabs_pos (vz a * vz b)).
  pose proof (within _ _ (Rle_refl (Rabs (vx a * vx b)))). pose proof (within _ _ (Rle_refl (Rabs (vy a * vy b)))). pose proof (within _ _ (Rle_refl (Rabs (vz a * vz b)))).
  set (x := vx a * vx b) in *. set (y := vy a * vy b) in *. set (z := vz a * vz b) in *.
  apply within in p. apply within in q. apply within in r.
  pose proof (rd_near (rd x + rd y) ((1 + u) * (Rabs x + Rabs y)) ltac:(apply Rabs_le; unfold u in *; lra)) as s. apply within in s.
  pose proof (rd_near (rd (rd x + rd y) + rd z) ((1 + u) * (1 + u) * (Rabs x + Rabs y + Rabs z)) ltac:(apply Rabs_le; unfold u in *; lra)) as t. apply within in t.
  apply Rabs_le. unfold u in *. lra.
Qed.

Lemma det_error : forall a b c d S, Rabs (a * b) + Rabs (c * d) <= S -> Rabs (detd a b c d - (a * b - c * d)) <= 21 / 10 * u * S.
Proof.
  intros a b c d S le. unfold detd. pose proof (rd_near (a * b) _ (Rle_refl _)) as p. pose proof (rd_near (c * d) _ (Rle_refl _)) as q.
  pose proof (within _ _ (Rle_refl (Rabs (a * b)))). pose proof (within _ _ (Rle_refl (Rabs (c * d)))). apply within in p. apply within in q.
  pose proof (rd_near (rd (a * b) - rd (c * d)) ((1 + u) * S) ltac:(apply Rabs_le; unfold u in *; lra)) as r. apply within in r.
  apply Rabs_le. unfold u in *. lra.
Qed.

Lemma size_by_parts : forall v e, (Rabs (vx v) <= e /\ Rabs (vy v) <= e /\ Rabs (vz v) <= e) -> size v (7 / 4 * e).
Proof.
  intros [x y z] e (Hx & Hy & Hz). simpl in *. pose proof (Rabs_pos x). split; [lra |]. unfold dot; simpl.
  apply within in Hx. apply within in Hy. apply within in Hz. nra.
Qed.

Lemma cross_error : forall a b A B, size a A -> size b B -> size (minus (crossd a b) (cross a b)) (37 / 10 * u * (A * B)).
Proof.
  intros a b A B Ha Hb. apply size_more with (7 / 4 * (21 / 10 * u * (A * B))).
  { assert (0 <= u * (A * B)) by (apply Rmult_le_pos; [unfold u; lra | apply Rmult_le_pos; [apply Ha | apply Hb]]). lra. }
  destruct a as [ax ay az], b as [bx b_y bz].
  assert (forall p q r s, size (V p q 0) A -> size (V r s 0) B -> Rabs (p * s) + Rabs (q * r) <= A * B) as two.
  { intros p q r s Hp Hr. pose proof (sum_of_products (V p q 0) (V s r 0) A B Hp) as le. simpl in le. rewrite Rmult_0_l, Rabs_R0 in le.
    apply Rle_trans with (2 := le ltac:(destruct Hr as (pos & HB); split; [assumption |]; unfold dot in *; simpl in *; lra)). lra. }
  assert (forall p q r, size (V p q r) A -> size (V p q 0) A /\ size (V q r 0) A /\ size (V r p 0) A) as parts.
  { intros p q r (pos & le). unfold size, dot in *; simpl in *. pose proof (Rle_0_sqr p). pose proof (Rle_0_sqr q). pose proof (Rle_0_sqr r). unfold Rsqr in *.
    repeat split; lra. }
  assert (forall p q r, size (V p q r) B -> size (V p q 0) B /\ size (V q r 0) B /\ size (V r p 0) B) as parts'.
  { intros p q r (pos & le). unfold size, dot in *; simpl in *. pose proof (Rle_0_sqr p). pose proof (Rle_0_sqr q). pose proof (Rle_0_sqr r). unfold Rsqr in *.
    repeat split; lra. }
  destruct (parts _ _ _ Ha) as (a1 & a2 & a3). destruct (parts' _ _ _ Hb) as (b1 & b2 & b3).
  apply size_by_parts. unfold minus, plus, times, crossd, cross; simpl.
  repeat split; match goal with |- Rabs (detd ?p ?q ?r ?s + _) <= _ =>
    replace (detd p q r s + -1 * (p * q - r * s)) with (detd p q r s - (p * q - r * s)) by ring; apply det_error end.
  - now apply two.
  - now apply two.
  - now apply two.
Qed.

Print Assumptions dot_error.
Print Assumptions cross_error.
