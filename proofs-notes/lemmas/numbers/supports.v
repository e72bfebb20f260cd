(* Lemma exact-zeros (proofs-notes/rounding-of-forces.md, section 12): outside of its support a vector is 0. The sets of
   fast/support.hpp by their bits, and what fast/step_support.hpp and fast/step_support.cpp say of a step's vectors. *)

From Coq Require Import Reals Psatz NArith.
From Groundtruth Require Import surface frames.
Open Scope R_scope.

Inductive axis := x_ | y_ | z_.
Definition bit k := match k with x_ => 0%N | y_ => 1%N | z_ => 2%N end.
Definition on k v := match k with x_ => vx v | y_ => vy v | z_ => vz v end.

(* Support: a number below 8. *)
Definition has s k := N.testbit s (bit k).
Definition shows s v := forall k, has s k = false -> on k v = 0.
Definition nowhere := 0%N.

Definition joined a b := N.lor a b.
Definition next a := N.land (N.lor (N.shiftr a 1) (N.shiftl a 2)) 7.
Definition previous a := N.land (N.lor (N.shiftr a 2) (N.shiftl a 1)) 7.
Definition crossed a b := N.lor (N.land (next a) (previous b)) (N.land (previous a) (next b)).
Definition meet a b := negb (N.eqb (N.land a b) 0).

Definition after k := match k with x_ => y_ | y_ => z_ | z_ => x_ end.

Lemma below_8 : forall s, (s < 8)%N -> s = 0%N \/ s = 1%N \/ s = 2%N \/ s = 3%N \/ s = 4%N \/ s = 5%N \/ s = 6%N \/ s = 7%N.
Proof. intros; lia. Qed.

Lemma next_has : forall s k, (s < 8)%N -> has (next s) k = has s (after k) /\ has (previous s) k = has s (after (after k)).
Proof. intros s k small. destruct (below_8 s small) as [-> | [-> | [-> | [-> | [-> | [-> | [-> | ->]]]]]]]; destruct k; split; reflexivity. Qed.

Lemma crossed_has : forall a b k, (a < 8)%N -> (b < 8)%N ->
  has (crossed a b) k = orb (andb (has a (after k)) (has b (after (after k)))) (andb (has a (after (after k))) (has b (after k))).
Proof.
  intros a b k Ha Hb. unfold crossed, has at 1. rewrite N.lor_spec, !N.land_spec.
  destruct (next_has a k Ha) as (na & pa). destruct (next_has b k Hb) as (nb & pb). unfold has in na, pa, nb, pb.
  now rewrite na, pa, nb, pb.
Qed.

Lemma shows_sum : forall s t a b, shows s a -> shows t b -> shows (joined s t) (plus a b).
Proof.
  intros s t a b Ha Hb k none. unfold has, joined in none. rewrite N.lor_spec in none. apply Bool.orb_false_elim in none as (one & other).
  pose proof (Ha k one). pose proof (Hb k other). destruct k; simpl in *; lra.
Qed.

Lemma shows_times : forall s t a, shows s a -> shows s (times t a).
Proof. intros s t a Ha k none. pose proof (Ha k none) as zero. destruct k; simpl in *; rewrite zero; ring. Qed.

Lemma zero_times : forall a, shows nowhere (times 0 a).
Proof. intros a k _. destruct k; simpl; ring. Qed.

Lemma shows_cross : forall s t a b, (s < 8)%N -> (t < 8)%N -> shows s a -> shows t b -> shows (crossed s t) (cross a b).
Proof.
  intros s t a b Hs Ht Ha Hb k none. rewrite crossed_has in none by assumption. apply Bool.orb_false_elim in none as (one & other).
  apply Bool.andb_false_iff in one. apply Bool.andb_false_iff in other.
  destruct k; simpl in *; destruct one as [f1 | f1], other as [f2 | f2];
    (try apply Ha in f1); (try apply Hb in f1); (try apply Ha in f2); (try apply Hb in f2); simpl in *; rewrite ?f1, ?f2; ring.
Qed.

Lemma shows_dot : forall s t a b, meet s t = false -> shows s a -> shows t b -> dot a b = 0.
Proof.
  intros s t a b apart Ha Hb. unfold meet in apart. apply Bool.negb_false_iff, N.eqb_eq in apart.
  assert (forall k, on k a * on k b = 0) as each.
  { intros k. assert (N.testbit (N.land s t) (bit k) = false) as none by (rewrite apart; apply N.bits_0).
    rewrite N.land_spec in none. apply Bool.andb_false_iff in none as [none | none]; [rewrite (Ha k none) | rewrite (Hb k none)]; ring. }
  pose proof (each x_) as one. pose proof (each y_) as two. pose proof (each z_) as three. simpl in *. unfold dot. rewrite one, two, three. ring.
Qed.

Lemma shows_more : forall s t v, shows s v -> (forall k, has t k = false -> has s k = false) -> shows t v.
Proof. intros s t v shown more k none. apply shown, more, none. Qed.

Lemma nothing_shows : forall s v, shows nowhere v -> shows s v.
Proof. intros s v shown k _. now apply shown. Qed.

(* SurfaceSupport::clipped, by the formulas of without_axes.v; each coefficient is what it is. *)
Section Clipped.

Variables n g F : vector.
Variables sn sg sF : N.
Hypotheses (n_small : (sn < 8)%N) (g_small : (sg < 8)%N) (F_small : (sF < 8)%N).
Hypotheses (n_shown : shows sn n) (g_shown : shows sg g) (F_shown : shows sF F).

Definition may_pull_along := meet sg sF.
Definition may_pull_across := meet sg (crossed sn sF).
Definition may_turn := negb (N.eqb (crossed sn sF) 0).
Definition rightward := if may_pull_across then crossed sg sn else nowhere.

Theorem pulls_only_where_it_may : (may_pull_along = false -> dot g F = 0) /\ (may_pull_across = false -> dot g (cross n F) = 0)
  /\ (may_turn = false -> dot (cross n F) (cross n F) = 0).
Proof.
  pose proof (shows_cross sn sF n F n_small F_small n_shown F_shown) as turning. repeat split; intros none.
  - now apply (shows_dot sg sF).
  - now apply (shows_dot sg (crossed sn sF)).
  - apply Bool.negb_false_iff, N.eqb_eq in none. rewrite none in turning.
    pose proof (turning x_ eq_refl) as one. pose proof (turning y_ eq_refl) as two. pose proof (turning z_ eq_refl) as three.
    simpl in *. unfold dot. simpl. rewrite one, two, three. ring.
Qed.

(* The part along g x n: times beta, or something with its sign. *)
Lemma rightward_shown : forall t, (dot g (cross n F) = 0 -> t = 0) -> shows rightward (times t (cross g n)).
Proof.
  intros t with_beta. unfold rightward. destruct may_pull_across eqn:may; [apply shows_times, shows_cross; assumption |].
  rewrite (with_beta (proj1 (proj2 pulls_only_where_it_may) may)). apply zero_times.
Qed.

Theorem band_edge_shown : forall t, shows (joined sF sg) (plus F (times t g)).
Proof. intros. apply shows_sum; [assumption | now apply shows_times]. Qed.

Theorem line_without_brake_shown : forall t p, (dot g (cross n F) = 0 -> t = 0) ->
  shows (joined rightward sn) (plus (times t (cross g n)) (times p n)).
Proof. intros. apply shows_sum; [now apply rightward_shown | now apply shows_times]. Qed.

Theorem corner_shown : forall (has_brake : bool) r t p, (has_brake = false -> r = 0) -> (dot g (cross n F) = 0 -> t = 0) ->
  shows (joined (joined (if has_brake then sg else nowhere) rightward) sn) (plus (plus (times r g) (times t (cross g n))) (times p n)).
Proof.
  intros has_brake r t p no_brake with_beta. apply shows_sum; [apply shows_sum | now apply shows_times]; [| now apply rightward_shown].
  destruct has_brake; [now apply shows_times | rewrite no_brake by trivial; apply zero_times].
Qed.

Theorem circle_shown : forall (has_friction : bool) rho p, (has_friction = false -> rho = 0) ->
  shows (if has_friction then joined sF sn else sn) (plus (times rho F) (times p n)).
Proof.
  intros has_friction rho p no_friction. destruct has_friction; [apply shows_sum; now apply shows_times |].
  rewrite no_friction by trivial. apply shows_more with (joined nowhere sn); [| intros k; now rewrite <- (N.lor_0_l sn) at 1].
  apply shows_sum; [apply zero_times | now apply shows_times].
Qed.

End Clipped.

(* StepSupport: the load on the pebble, and where the strut goes. v = w_t - v, less omega x arm. *)
Theorem load_shown : forall arm v omega down k d t sa sv so sd, (sa < 8)%N -> (so < 8)%N ->
  shows sa arm -> shows sv v -> shows so omega -> shows sd down ->
  let velocity := plus v (times (-1) (cross omega arm)) in
  let s_velocity := joined sv (crossed so sa) in
  shows s_velocity velocity /\ shows (joined (joined sa s_velocity) sd) (plus (plus (times k arm) (times d velocity)) (times t down)).
Proof.
  intros arm v omega down k d t sa sv so sd a_small o_small Ha Hv Ho Hd velocity s_velocity.
  assert (shows s_velocity velocity) by (apply shows_sum; [assumption | now apply shows_times, shows_cross]).
  split; [assumption |]. apply shows_sum; [apply shows_sum |]; now apply shows_times.
Qed.

Theorem way_and_move_shown : forall clipped arm velocity down c d h t sc sa sv sd,
  shows sc clipped -> shows sa arm -> shows sv velocity -> shows sd down ->
  let spring := plus (times c clipped) (times t down) in
  let mapped := plus (times c (plus (times h clipped) (times d (plus arm (times (- h) velocity))))) (times t down) in
  shows (joined sc sd) spring /\ shows (joined (joined sc sd) sa) (plus spring (times (-1) arm)) /\
  shows (joined (joined sc (joined sa sv)) sd) mapped.
Proof.
  intros clipped arm velocity down c d h t sc sa sv sd Hc Ha Hv Hd spring mapped.
  assert (shows (joined sc sd) spring) by (apply shows_sum; now apply shows_times).
  repeat split; [assumption | apply shows_sum; [assumption | now apply shows_times] |].
  apply shows_sum; [| now apply shows_times]. apply shows_times, shows_sum; [now apply shows_times |].
  apply shows_times, shows_sum; [assumption | now apply shows_times].
Qed.

(* support_of_axes: products known as pairs without rounding are equal iff the pairs are; squares of equal sizes. *)
Theorem equal_products : forall ab cd high low high' low', high + low = ab -> high' + low' = cd -> high = high' /\ low = low' -> ab = cd.
Proof. intros. lra. Qed.

Theorem equal_squares : forall a b c d, Rabs a = Rabs c /\ Rabs b = Rabs d \/ Rabs a = Rabs d /\ Rabs b = Rabs c ->
  a * a + b * b - (c * c + d * d) = 0.
Proof.
  intros a b c d same. assert (forall x, x * x = Rabs x * Rabs x) as sizes by (intros x; unfold Rabs; destruct (Rcase_abs x); ring).
  rewrite (sizes a), (sizes b), (sizes c), (sizes d). destruct same as [(-> & ->) | (-> & ->)]; ring.
Qed.

Print Assumptions pulls_only_where_it_may.
Print Assumptions band_edge_shown.
Print Assumptions line_without_brake_shown.
Print Assumptions corner_shown.
Print Assumptions circle_shown.
Print Assumptions load_shown.
Print Assumptions way_and_move_shown.
Print Assumptions equal_squares.
