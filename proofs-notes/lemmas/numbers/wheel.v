(* The wheel's step (proofs-notes/wheel.md): a stuck pebble never moves; return mapping is dissipative with the
   pebble at rest; the spring's own relocation, and the pebble's own velocity in the damper, are not. *)

From Coq Require Import Reals Psatz List.
Import ListNotations.
Open Scope R_scope.

(* 1. A stuck pebble never moves, whatever frames, forces and decisions come. *)

Section Sticking.

Variables (Vector Contact Input : Type) (zero : Vector).

Inductive state :=
  | free
  | slip (pebble velocity : Vector) (contact : Contact)
  | stick (pebble velocity : Vector) (contact : Contact).

Inductive event := touches (p : Vector) (c : Contact) | loosens | holds | slides (p w : Vector) (c : Contact) | ends_badly.

(* What SPEC section 5 leaves of a state; `decide` stands for all its decisions and arithmetic. *)
Variable decide : Input -> state -> event.

Definition step (input : Input) (s : state) : state :=
  match decide input s, s with
  | ends_badly, _ => s
  | loosens, _ => free
  | touches p c, free => stick p zero c
  | holds, slip p _ c | holds, stick p _ c => stick p zero c
  | slides p w c, slip _ _ _ | slides p w c, stick _ _ _ => slip p w c
  | _, _ => s
  end.

Fixpoint run (inputs : list Input) (s : state) : state :=
  match inputs with [] => s | i :: rest => run rest (step i s) end.

Fixpoint always_stuck (inputs : list Input) (s : state) : Prop :=
  (exists p w c, s = stick p w c) /\
  match inputs with [] => True | i :: rest => always_stuck rest (step i s) end.

Theorem stuck_pebble_never_moves : forall inputs p w c,
  always_stuck inputs (stick p w c) -> exists w', run inputs (stick p w c) = stick p w' c.
Proof.
  induction inputs as [| i rest IH]; simpl; intros p w c [_ stuck].
  - exists w; reflexivity.
  - destruct (step i (stick p w c)) as [| p' w' c' | p' w' c'] eqn:stepped.
    + exfalso; destruct rest; simpl in stuck; destruct stuck as [[? [? [? wrong]]] _]; discriminate.
    + exfalso; destruct rest; simpl in stuck; destruct stuck as [[? [? [? wrong]]] _]; discriminate.
    + assert (p' = p /\ c' = c) as [-> ->].
      { unfold step in stepped; destruct (decide i (stick p w c)); now inversion stepped. }
      now apply IH.
Qed.

End Sticking.

(* 2. Return mapping. Vectors of the wheel's x-y plane; signs as in SPEC section 5: k < 0, d <= 0, forces are
   those on the pebble, w is the frame's motion past a pebble at rest, p = e + h w. *)

Definition plane := (R * R)%type.
Definition plus (a b : plane) : plane := (fst a + fst b, snd a + snd b).
Definition times (s : R) (a : plane) : plane := (s * fst a, s * snd a).
Definition dot (a b : plane) := fst a * fst b + snd a * snd b.
Definition minus a b := plus a (times (-1) b).
Definition square a := dot a a.

Definition convex (K : plane -> Prop) :=
  forall a b t, K a -> K b -> 0 <= t <= 1 -> K (plus (times (1 - t) a) (times t b)).
Definition closest (K : plane -> Prop) (T F : plane) := K F /\ forall G, K G -> square (minus T F) <= square (minus T G).

Definition spring_force k d p w := plus (times k p) (times d w).
Definition return_mapping k d h clipped p w :=
  times (/ (k + d / h)) (plus (plus clipped (times (d / h) p)) (times (- d) w)).
Definition spring_relocation (k : R) clipped : plane := times (/ k) clipped.
Definition energy k e := / 2 * (- k) * square e.

(* What the frame gives to spring and ground: -F acts on it, and it moves by -h w past the pebble. *)
Definition work_by_frame h F w := - dot F (times h w).

Lemma closest_faces_away : forall K T F, convex K -> closest K T F ->
  forall G, K G -> dot (minus T F) (minus G F) <= 0.
Proof.
  intros K T F K_convex [F_in F_closest] G G_in.
  destruct (Rle_or_lt (dot (minus T F) (minus G F)) 0) as [fine | wrong]; [assumption | exfalso].
  set (D := dot (minus T F) (minus G F)) in *; set (S := square (minus G F)).
  assert (0 <= S) by (unfold S, square, dot; nra).
  set (t := Rmin 1 (D / (S + 1))).
  assert (0 < D / (S + 1)) by (apply Rdiv_lt_0_compat; lra).
  assert (0 < t <= 1) by (unfold t, Rmin; destruct (Rle_dec 1 (D / (S + 1))); lra).
  assert (t * (S + 1) <= D).
  { apply Rle_trans with (D / (S + 1) * (S + 1)); [apply Rmult_le_compat_r; [lra | apply Rmin_r] |].
    right; field; lra. }
  assert (nearer := F_closest _ (K_convex F G t F_in G_in ltac:(lra))).
  assert (square (minus T (plus (times (1 - t) F) (times t G))) = square (minus T F) - 2 * t * D + t * t * S)
    as expanded by (unfold D, S, square, dot, minus, plus, times; simpl; ring).
  rewrite expanded in nearer; nra.
Qed.

Section OneWheel.

Variables (K : plane -> Prop) (k d h : R) (e w F : plane).
Hypotheses (k_negative : k < 0) (d_not_positive : d <= 0) (h_positive : 0 < h).
Hypotheses (K_convex : convex K) (K_has_zero : K (0, 0)).

Let p := plus e (times h w).
Hypothesis F_clipped : closest K (spring_force k d p w) F.
Let e' := return_mapping k d h F p w.
Let slid := minus (times h w) (minus e' e).

Lemma d_over_h : d / h <= 0.
Proof. apply Rmult_le_reg_r with h; [lra |]; unfold Rdiv; rewrite Rmult_assoc, Rinv_l, Rmult_1_r, Rmult_0_l; lra. Qed.

Lemma divisors : h <> 0 /\ k * h + d <> 0.
Proof. split; apply not_eq_sym; [apply Rlt_not_eq | apply Rgt_not_eq]; nra. Qed.
Lemma h_is_not_zero : h <> 0.
Proof. apply divisors. Qed.

Ltac divide := repeat split; first [exact h_is_not_zero | apply divisors].

Lemma new_stretch_carries_F : F = plus (times k e') (times (d / h) (minus e' e)).
Proof.
  pose proof d_over_h as slope.
  rewrite (surjective_pairing F) at 1.
  unfold e', return_mapping, p, minus, plus, times; simpl; f_equal; field; divide.
Qed.

(* Spring, damper and ground share the frame's work. *)
Theorem return_mapping_balance :
  energy k e' - energy k e
    = work_by_frame h F w - / 2 * (- k) * square (minus e' e) - (- d / h) * square (minus e' e) - - dot F slid.
Proof.
  assert (dot F (minus e' e) = k * dot e' (minus e' e) + d / h * square (minus e' e)) as along.
  { rewrite new_stretch_carries_F at 1; unfold square, dot, plus, minus, times; simpl; ring. }
  assert (dot F slid = dot F (times h w) - dot F (minus e' e)) as split_work
    by (unfold slid, dot, plus, minus, times; simpl; ring).
  unfold work_by_frame; rewrite split_work, along.
  unfold energy, square, dot, plus, minus, times; simpl; field; divide.
Qed.

Lemma ground_only_loses : dot F slid <= 0.
Proof.
  pose proof d_over_h.
  pose proof (closest_faces_away K _ F K_convex F_clipped (0, 0) K_has_zero) as away.
  assert (minus (spring_force k d p w) F = times (k + d / h) slid) as excess.
  { transitivity (minus (spring_force k d p w) (plus (times k e') (times (d / h) (minus e' e))));
      [now rewrite <- new_stretch_carries_F |].
    unfold slid, p; generalize e'; intros stretch.
    unfold spring_force, plus, minus, times; simpl; apply injective_projections; simpl; field; divide. }
  rewrite excess in away.
  assert (dot (times (k + d / h) slid) (minus (0, 0) F) = - (k + d / h) * dot F slid) as scaled
    by (unfold dot, plus, minus, times; simpl; ring).
  rewrite scaled in away; nra.
Qed.

Theorem return_mapping_is_dissipative : energy k e' - energy k e <= work_by_frame h F w.
Proof.
  pose proof d_over_h; pose proof ground_only_loses; rewrite return_mapping_balance.
  assert (0 <= square (minus e' e)) by (unfold square, dot; nra).
  replace (- d / h) with (- (d / h)) by (field; divide); nra.
Qed.

(* Where nothing is clipped the pebble stays: continuous from stick to slip. *)
Theorem unclipped_pebble_stays : F = spring_force k d p w -> e' = p.
Proof.
  pose proof d_over_h; intros unclipped.
  unfold e'; rewrite unclipped; destruct e as [e1 e2], w as [w1 w2].
  unfold return_mapping, spring_force, p, plus, minus, times; simpl; f_equal; field; divide.
Qed.

End OneWheel.

(* 3. Refuted, with the band |F_x| <= 1 (brake 1, no friction limit). *)

Definition band (F : plane) := Rabs (fst F) <= 1.

Lemma within : forall x a, Rabs x <= a -> - a <= x <= a.
Proof. intros x a; unfold Rabs; destruct (Rcase_abs x); lra. Qed.

Lemma band_is_convex : convex band.
Proof.
  unfold convex, band; intros [a1 a2] [b1 b2] t; simpl; intros.
  apply Rabs_le; apply within in H; apply within in H0; nra.
Qed.

Lemma closest_in_band : forall x, 1 <= x -> closest band (- x, 0) (- 1, 0).
Proof.
  intros x Hx; split; [unfold band; simpl; rewrite Rabs_left; lra |].
  intros [G1 G2] G_in; unfold band in G_in; simpl in G_in.
  apply within in G_in; unfold square, dot, minus, plus, times; simpl; nra.
Qed.

(* k = -1, d = -3, h = 1, from rest, w = 3/8: the frame works 3/8 J, the spring holds 1/2 J. *)
Theorem spring_relocation_makes_energy :
  let k := -1 in let d := -3 in let h := 1 in let e := (0, 0) in let w := (3 / 8, 0) in let F := (-1, 0) in
  closest band (spring_force k d (plus e (times h w)) w) F /\
  energy k (spring_relocation k F) - energy k e > work_by_frame h F w.
Proof.
  intros k d h e w F; split.
  - replace (spring_force k d (plus e (times h w)) w) with (- (3 / 2), 0)
      by (unfold spring_force, plus, times, k, d, h, e, w; simpl; f_equal; lra).
    apply closest_in_band; lra.
  - unfold energy, spring_relocation, work_by_frame, square, dot, times, k, h, e, w, F; simpl; lra.
Qed.

(* k = -1, d = -1, h = 1, a pebble that slides along at the frame's 9 m/s: SPEC's w is then 0, though the frame moves
   9 m past where the pebble lies. The frame works 9 J, the spring holds 12.5 J. *)
Theorem own_velocity_makes_energy :
  let k := -1 in let d := -1 in let h := 1 in let e := (0, 0) in let past := (9, 0) in let w := (0, 0) in
  let F := (-1, 0) in let p := plus e (times h past) in
  closest band (spring_force k d p w) F /\
  energy k (return_mapping k d h F p w) - energy k e > work_by_frame h F past.
Proof.
  intros k d h e past w F p; split.
  - replace (spring_force k d p w) with (- 9, 0)
      by (unfold spring_force, plus, times, p, plus, times, k, d, h, e, past, w; simpl; f_equal; lra).
    apply (closest_in_band 9); lra.
  - unfold energy, return_mapping, work_by_frame, square, dot, plus, times, p, plus, times, k, d, h, e, past, w, F;
      simpl; replace (/ (-1 + -1 / 1)) with (- / 2) by field; lra.
Qed.

(* Where such a slide settles: the spring bears what the damper should, k e = F - d past. *)
Theorem own_velocity_settles_at : forall k d h e past F : R, k < 0 -> d <= 0 -> 0 < h ->
  e = (F + d / h * (e + h * past)) / (k + d / h) -> k * e = F + d * past.
Proof.
  intros k d h e past F Hk Hd Hh settled.
  assert (d / h <= 0) by (apply d_over_h; assumption).
  apply (f_equal (fun t => t * (k + d / h))) in settled.
  replace ((F + d / h * (e + h * past)) / (k + d / h) * (k + d / h)) with (F + d / h * e + d * past) in settled
    by (field; repeat split; first [apply Rlt_not_eq; nra | apply Rgt_not_eq; nra]).
  lra.
Qed.

Print Assumptions stuck_pebble_never_moves.
Print Assumptions return_mapping_balance.
Print Assumptions return_mapping_is_dissipative.
Print Assumptions unclipped_pebble_stays.
Print Assumptions spring_relocation_makes_energy.
Print Assumptions own_velocity_makes_energy.
Print Assumptions own_velocity_settles_at.
