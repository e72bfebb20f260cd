(* A direction within a face may be turned a little, out of any planes that it happens to lie in (faces.md, 2). *)

From Coq Require Import List Bool QArith Qabs Lqa.
From Groundtruth Require Import shapes standing faces.
Import ListNotations.
Open Scope Q_scope.

Definition cross (a b : vector) : vector :=
  Vector (y a * z b - z a * y b) (z a * x b - x a * z b) (x a * y b - y a * x b).

Lemma dot_plus n v w : dot n (plus v w) == dot n v + dot n w.
Proof. unfold dot, plus. simpl. ring. Qed.
Lemma dot_scaled n t v : dot n (scaled t v) == t * dot n v.
Proof. unfold dot, scaled. simpl. ring. Qed.

Lemma not_same_plane g h : same_plane g h = false ->
  0 < dot (cross (normal g) (normal h)) (cross (normal g) (normal h)).
Proof.
  intros other. destruct (Qlt_le_dec 0 (dot (cross (normal g) (normal h)) (cross (normal g) (normal h)))) as [| small]; trivial.
  exfalso. apply not_true_iff_false in other. apply other. clear other. unfold same_plane.
  assert (zero : forall a b c : Q, a * a + b * b + c * c <= 0 -> a == 0 /\ b == 0 /\ c == 0).
  { intros a b c sum. assert (sq : forall q : Q, 0 <= q * q) by (intros q; nra).
    assert (sa := sq a). assert (sb := sq b). assert (sc := sq c).
    assert (root : forall q : Q, q * q == 0 -> q == 0) by (intros q e; apply Qmult_integral in e; tauto).
    split; [| split]; apply root; lra. }
  destruct (zero _ _ _ small) as (a & b & c). unfold cross in a, b, c. cbn [local_shape.x local_shape.y local_shape.z] in a, b, c.
  rewrite !andb_true_iff, !Qeq_bool_iff. split; [split |]; lra.
Qed.

(* A direction of the plane of i that leaves the plane of h. *)
Definition away (i h : half_space) : vector := cross (normal i) (cross (normal i) (normal h)).

Lemma away_is_in_plane i h : dot (normal i) (away i h) == 0.
Proof. unfold away, dot, cross. simpl. ring. Qed.

Lemma away_leaves i h : same_plane i h = false -> dot (normal h) (away i h) < 0.
Proof.
  intros other. assert (positive := not_same_plane i h other).
  assert (is : dot (normal h) (away i h) == - dot (cross (normal i) (normal h)) (cross (normal i) (normal h)))
    by (unfold away, dot, cross; simpl; ring).
  lra.
Qed.

Definition same_side (n v w : vector) : Prop := (0 < dot n v -> 0 < dot n w) /\ (dot n v < 0 -> dot n w < 0).

Lemma a_little_keeps_sides hs v w : exists e, 0 < e /\
  forall r, 0 <= r -> r <= e -> forall h, In h hs -> same_side (normal h) v (plus v (scaled r w)).
Proof.
  induction hs as [| h hs (e & some & keeps)].
  - exists 1. split; [lra | easy].
  - assert (exists f, 0 < f /\ forall r, 0 <= r -> r <= f -> same_side (normal h) v (plus v (scaled r w))) as (f & some_f & keeps_f).
    { set (a := dot (normal h) v). set (b := dot (normal h) w).
      assert (abs := Qabs_nonneg b). assert (high := Qle_Qabs b).
      assert (low : - b <= Qabs b) by (rewrite <- Qabs_opp; apply Qle_Qabs).
      assert (room : exists f, 0 < f /\ (a == 0 \/ Qabs b * f < Qabs a)).
      { destruct (Qlt_le_dec 0 (Qabs a)) as [some_a | none].
        - destruct (small_enough (Qabs a) (Qabs b) some_a abs) as (f & ? & ?). exists f. auto.
        - exists 1. split; [lra |]. left. assert (h1 := Qle_Qabs a).
          assert (h2 : - a <= Qabs a) by (rewrite <- Qabs_opp; apply Qle_Qabs). lra. }
      destruct room as (f & some_f & room). exists f. split; trivial. intros r from to.
      assert (moved : dot (normal h) (plus v (scaled r w)) == a + r * b) by (rewrite dot_plus, dot_scaled; reflexivity).
      unfold same_side. rewrite moved. fold a.
      assert (r * b <= Qabs b * f) by nra. assert (- (r * b) <= Qabs b * f) by nra.
      split; intros sign; destruct room as [zero | room]; try lra.
      - rewrite (Qabs_pos a) in room by lra. lra.
      - rewrite (Qabs_neg a) in room by lra. lra. }
    destruct (below_both e f some some_f) as (u & above & at_e & at_f). exists u. split; trivial.
    intros r from to g [<- | inside]; [apply keeps_f; lra | apply keeps; trivial; lra].
Qed.

(* v can be turned within the plane of i so that it keeps its side of every plane, and lies in no other plane. *)
Theorem direction_can_be_made_generic i hs v : dot (normal i) v == 0 ->
  exists w, dot (normal i) w == 0 /\ forall h, In h hs ->
    same_side (normal h) v w /\ (same_plane i h = false -> ~ dot (normal h) w == 0).
Proof.
  intros in_plane.
  assert (forall more, exists w, dot (normal i) w == 0 /\ (forall h, In h (hs ++ more) -> same_side (normal h) v w)
            /\ forall h, In h hs -> same_plane i h = false -> ~ dot (normal h) w == 0) as all_.
  { induction hs as [| h hs IH]; intros more.
    - exists v. split; trivial. split; [| easy]. intros; split; auto.
    - destruct (IH (h :: more)) as (w & in_plane_w & sides & generic).
      destruct (Qeq_dec (dot (normal h) w) 0) as [zero | nonzero].
      + destruct (same_plane i h) eqn:plane.
        * exists w. split; trivial. split.
          -- intros g inside. apply sides. apply in_or_app. destruct inside as [<- | inside]; [right; now left |].
             apply in_app_or in inside as [l | r]; [now left | right; now right].
          -- intros g [<- | inside] other; [congruence | now apply generic].
        * destruct (a_little_keeps_sides (h :: hs ++ more) w (away i h)) as (e & some & keeps).
          exists (plus w (scaled e (away i h))). split; [rewrite dot_plus, dot_scaled, away_is_in_plane, in_plane_w; ring |].
          split.
          -- intros g inside. assert (one := keeps e ltac:(lra) ltac:(lra) g inside).
             assert (two : same_side (normal g) v w).
             { apply sides. apply in_or_app. destruct inside as [<- | inside]; [right; now left |].
               apply in_app_or in inside as [l | r]; [now left | right; now right]. }
             unfold same_side in *. split; intros; [apply one, two | apply one, two]; trivial.
          -- intros g inside other. destruct inside as [<- | inside].
             ++ rewrite dot_plus, dot_scaled, zero. assert (less := away_leaves i h plane). nra.
             ++ assert (one := keeps e ltac:(lra) ltac:(lra) g (or_intror (in_or_app _ _ _ (or_introl inside)))).
                assert (was := generic g inside other). intros now_zero. apply was.
                destruct (Qlt_le_dec 0 (dot (normal g) w)); [exfalso; assert (b := proj1 one); specialize (b ltac:(trivial)); lra |].
                destruct (Qlt_le_dec (dot (normal g) w) 0); [exfalso; assert (b := proj2 one); specialize (b ltac:(trivial)); lra | lra].
      + exists w. split; trivial. split.
        * intros g inside. apply sides. apply in_or_app. destruct inside as [<- | inside]; [right; now left |].
          apply in_app_or in inside as [l | r]; [now left | right; now right].
        * intros g [<- | inside] other; [trivial | now apply generic]. }
  destruct (all_ []) as (w & in_plane_w & sides & generic). exists w. split; trivial. intros h inside.
  split; [apply sides; rewrite app_nil_r; trivial | now apply generic].
Qed.
Print Assumptions direction_can_be_made_generic.
