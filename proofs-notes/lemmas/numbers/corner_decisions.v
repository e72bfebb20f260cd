(* Lemma decisions-in-doubles (proofs-notes/rounding-of-forces.md, section 8), for slips near a corner, and for uprightness.
   fast/surface_in_doubles.hpp: decide_slip, is_upright. *)

From Coq Require Import Reals Psatz.
From Groundtruth Require Import surface sizes decisions.
Open Scope R_scope.

Section Slip.

(* As in decisions.v; beta too. *)
Variables al al' be be' D D' gg' nn' k l f mu B : R.
Hypotheses (k_pos : 0 <= k) (l_pos : 0 <= l) (f_pos : 0 <= f).
Hypotheses (al_near : Rabs (al' - al) <= 70 * u * (k * f)) (be_near : Rabs (be' - be) <= 74 * u * (k * (l * f))).
Hypotheses (D_near : Rabs (D' - D) <= 6 * u * (l * f)) (al_size : Rabs al <= k * ((1 + 4 * u) * f)).
Hypotheses (gg_near : Rabs (gg' - k * k) <= 132 * u * (k * k)) (nn_near : Rabs (nn' - l * l) <= 4 * u * (l * l)).

Let limit := limit_of mu D'.
Let band := band_of B nn'.
Let floor := floor_of gg' f.
Let disc_floor := disc_floor_of mu nn' f.
Let corner := rd (limit - band).
Let both := rd (limit + band).
Let L := mu * mu * (D * D).
Let K := B * B * (l * l).
Let G := k * f * (k * f).
Let N := l * f * (l * f).
Let M := (1 + mu * mu) * N.

Lemma parts : 0 <= G /\ 0 <= N /\ mu * mu * N <= M /\ N <= M /\ 0 <= limit /\ 0 <= band /\ Rabs (band - K) <= 8 * u * band /\
  (1 - 140 * u) * G <= floor <= (1 + 140 * u) * G /\ (1 - 20 * u) * M <= disc_floor /\
  (1 - u) * (limit + band) <= both <= (1 + u) * (limit + band).
Proof.
  destruct (floors mu gg' nn' k l f gg_near nn_near) as (HG & HN & nF & _ & nD). fold G floor in HG, nF. fold N M disc_floor in HN, nD.
  destruct (limit_near mu D D' (l * f) ltac:(now apply Rmult_le_pos) D_near) as (L_pos & _).
  destruct (band_near B nn' l 4 ltac:(lra) nn_near) as (b_pos & nb). fold limit in L_pos. fold band K in b_pos, nb.
  assert (0 <= mu * mu * N) by (apply Rmult_le_pos; [apply Rle_0_sqr | assumption]).
  pose proof (rd_positive (limit + band) ltac:(lra)) as nS. fold both in nS.
  assert (M = N + mu * mu * N) as sum by (unfold M; ring). repeat split; lra.
Qed.

Lemma corner_near : Rabs (corner - (L - K)) <= 23 * u * (limit + band) + 23 / 10 * u * M /\ Rabs corner <= (1 + u) * (limit + band).
Proof.
  destruct parts as (_ & HN & HM & _ & L_pos & b_pos & nb & _).
  destruct (limit_near mu D D' (l * f) ltac:(now apply Rmult_le_pos) D_near) as (_ & nL). fold limit L N in nL.
  pose proof (rd_near (limit - band) (limit + band) ltac:(apply Rabs_le; lra)) as r. fold corner in r.
  apply within in nb. apply within in nL. apply within in r. split; apply Rabs_le; unfold u in *; lra.
Qed.

(* |F'_y| <= s: beta^2 against |g|^2 (L - K). *)
Theorem between_is_decided :
  let a := rd (be' * be') in let b := rd (gg' * corner) in let sizes := rd (rd (a + rd (gg' * both)) + rd (gg' * disc_floor)) in
  (rd (margin_part * sizes) < rd (b - a) -> be * be < k * k * (L - K)) /\ (rd (b - a) < - rd (margin_part * sizes) -> k * k * (L - K) < be * be).
Proof.
  intros a b sizes. destruct parts as (HG & HN & HM & HM' & L_pos & b_pos & _ & nF & nD & nS). destruct corner_near as (nc & c_size).
  set (S := limit + band) in *. assert (0 <= S) by (unfold S; lra). assert (0 <= M) by lra. pose proof (Rle_0_sqr k) as kk. unfold Rsqr in kk.
  assert (0 <= k * (l * f)) as klf by (repeat apply Rmult_le_pos; assumption).
  pose proof (square_near be be' 74 256 (k * (l * f)) be_near ltac:(lra) ltac:(lra) klf) as na. fold a in na.
  assert (k * (l * f) * (k * (l * f)) = k * k * N) as kN by (unfold N; ring). rewrite kN in na.
  assert (0 <= k * k * N <= k * k * M) by (split; [apply Rmult_le_pos | apply Rmult_le_compat_l]; lra).
  assert (0 <= k * k * S) as kS by (apply Rmult_le_pos; lra). pose proof (part_of _ _ _ gg_near) as ng.
  assert (Rabs (b - k * k * (L - K)) <= 160 * u * (k * k * S) + 24 / 10 * u * (k * k * M)) as nb.
  { assert (Rabs (gg' * corner) <= (1 + 140 * u) * (k * k * S)) as size.
    { rewrite Rabs_mult, (Rabs_pos_eq gg') by (unfold u in *; lra). apply Rle_trans with ((1 + 132 * u) * (k * k) * ((1 + u) * S)).
      - apply Rmult_le_compat; try apply Rabs_pos; unfold u in *; lra.
      - unfold u in *; lra. }
    pose proof (rd_near _ _ size) as r. fold b in r.
    assert (Rabs ((gg' - k * k) * corner) <= 133 * u * (k * k * S)) as moved.
    { rewrite Rabs_mult. apply Rle_trans with (132 * u * (k * k) * ((1 + u) * S)); [apply Rmult_le_compat; try apply Rabs_pos; assumption | unfold u in *; lra]. }
    assert (Rabs (k * k * (corner - (L - K))) <= k * k * (23 * u * S + 23 / 10 * u * M)) as moved'.
    { rewrite Rabs_mult, (Rabs_pos_eq (k * k)) by assumption. now apply Rmult_le_compat_l. }
    apply within in r. apply within in moved. apply within in moved'. apply Rabs_le. unfold u in *; lra. }
  assert (0 <= a) as a_pos by (pose proof (rd_positive _ (Rle_0_sqr be')); pose proof (Rle_0_sqr be'); unfold Rsqr, a, u in *; lra).
  assert ((1 - 140 * u) * (k * k * S) <= rd (gg' * both)) as t1.
  { assert ((1 - 132 * u) * (k * k) * ((1 - u) * S) <= gg' * both) by (apply Rmult_le_compat; unfold u in *; lra).
    pose proof (rd_positive (gg' * both) ltac:(apply Rmult_le_pos; unfold u in *; lra)). unfold u in *; lra. }
  assert ((1 - 160 * u) * (k * k * M) <= rd (gg' * disc_floor)) as t2.
  { assert ((1 - 132 * u) * (k * k) * ((1 - 20 * u) * M) <= gg' * disc_floor) by (apply Rmult_le_compat; unfold u in *; lra).
    pose proof (rd_positive (gg' * disc_floor) ltac:(apply Rmult_le_pos; unfold u in *; lra)). unfold u in *; lra. }
  set (t := rd (gg' * both)) in *. set (d := rd (gg' * disc_floor)) in *.
  pose proof (rd_positive (a + t) ltac:(unfold u in *; lra)) as s1. pose proof (rd_positive (rd (a + t) + d) ltac:(unfold u in *; lra)) as s2. fold sizes in s2.
  apply (comparison_is_right _ _ _ _ sizes _ _ na nb); unfold u in *; lra.
Qed.

(* B |F'_y| <= |F'_x| s: B^2 beta^2 against alpha^2 (L - K). *)
Theorem beside_is_decided :
  let al2 := rd (al' * al') in let a := rd (rd (B * B) * rd (be' * be')) in let b := rd (al2 * corner) in
  let sizes := rd (rd (a + rd (al2 * both)) + rd (floor * rd (4 * both + 4 * disc_floor))) in
  (rd (margin_part * sizes) < rd (b - a) -> B * B * (be * be) < al * al * (L - K)) /\
  (rd (b - a) < - rd (margin_part * sizes) -> al * al * (L - K) < B * B * (be * be)).
Proof.
  intros al2 a b sizes. destruct parts as (HG & HN & HM & HM' & L_pos & b_pos & nK & nF & nD & nS). destruct corner_near as (nc & c_size).
  set (S := limit + band) in *. assert (0 <= S) by (unfold S; lra). assert (0 <= M) by lra.
  pose proof (Rle_0_sqr B) as BB. pose proof (Rle_0_sqr k) as kk. unfold Rsqr in BB, kk. assert (0 <= k * f) as kf by now apply Rmult_le_pos.
  pose proof (square_near al al' 70 256 (k * f) al_near ltac:(lra) ltac:(lra) kf) as na. fold al2 G in na.
  assert (0 <= al2) as al2_pos by (pose proof (rd_positive _ (Rle_0_sqr al')); pose proof (Rle_0_sqr al'); unfold Rsqr, al2, u in *; lra).
  assert (0 <= k * (l * f)) as klf by (repeat apply Rmult_le_pos; assumption).
  pose proof (square_near be be' 74 256 (k * (l * f)) be_near ltac:(lra) ltac:(lra) klf) as nb. set (be2 := rd (be' * be')) in *.
  assert (0 <= be2) as be2_pos by (pose proof (rd_positive _ (Rle_0_sqr be')); pose proof (Rle_0_sqr be'); unfold Rsqr, be2, u in *; lra).
  assert (k * (l * f) * (k * (l * f)) = k * k * N) as kN by (unfold N; ring). rewrite kN in nb.
  (* over *)
  pose proof (product_part (B * B) (rd (B * B)) be2 be2 1 0 BB be2_pos ltac:(lra) ltac:(lra) ltac:(pose proof (rd_positive _ BB); lra) ltac:(lra)) as o.
  fold a in o. assert (0 <= B * B * be2) by now apply Rmult_le_pos.
  assert (Rabs (B * B * be2 - B * B * (be * be)) <= 258 * u * (B * B * be2) + 215 / 10 * u * (G * K)) as o'.
  { replace (B * B * be2 - B * B * (be * be)) with (B * B * (be2 - be * be)) by ring. rewrite Rabs_mult, (Rabs_pos_eq (B * B)) by assumption.
    replace (G * K) with (B * B * (k * k * N)) by (unfold G, K, N; ring).
    apply Rle_trans with (B * B * ((256 + 2) * u * be2 + (74 * 74 / 256 + / 100) * u * (k * k * N))); [now apply Rmult_le_compat_l |].
    assert (0 <= B * B * (k * k * N)) by (apply Rmult_le_pos; [assumption | now apply Rmult_le_pos]). unfold u in *; lra. }
  assert (0 <= G * K <= (1 + 9 * u) * (G * S)) as GK.
  { assert (0 <= K) by (unfold K; apply Rmult_le_pos; [assumption | apply Rle_0_sqr]). apply within in nK.
    split; [now apply Rmult_le_pos |]. replace ((1 + 9 * u) * (G * S)) with (G * ((1 + 9 * u) * S)) by ring. apply Rmult_le_compat_l; [assumption | unfold S, u in *; lra]. }
  assert (Rabs (a - B * B * (be * be)) <= 262 * u * a + 22 * u * (G * S)) as over.
  { apply within in o'. assert (0 <= G * S) by now apply Rmult_le_pos. apply Rabs_le. unfold u in *; lra. }
  (* the other side *)
  assert (0 <= al2 * S) as aS by now apply Rmult_le_pos. assert (0 <= G * S) as GS by now apply Rmult_le_pos. assert (0 <= G * M) as GM by now apply Rmult_le_pos.
  assert (0 <= al * al <= (1 + 10 * u) * G) as al_G.
  { split; [apply Rle_0_sqr |]. apply Rle_trans with (k * ((1 + 4 * u) * f) * (k * ((1 + 4 * u) * f))).
    - apply within in al_size. assert (0 <= k * ((1 + 4 * u) * f)) by (apply Rmult_le_pos; [assumption | unfold u; lra]). nra.
    - unfold G. assert (0 <= k * f * (k * f)) by now apply Rmult_le_pos. unfold u in *; lra. }
  assert (Rabs (b - al * al * (L - K)) <= 290 * u * (al2 * S) + 20 * u * (G * S) + 3 * u * (G * M)) as other.
  { assert (Rabs (al2 * corner) <= (1 + u) * (al2 * S)) as size.
    { rewrite Rabs_mult, (Rabs_pos_eq al2) by assumption. replace ((1 + u) * (al2 * S)) with (al2 * ((1 + u) * S)) by ring. now apply Rmult_le_compat_l. }
    pose proof (rd_near _ _ size) as r. fold b in r.
    assert (Rabs ((al2 - al * al) * corner) <= (258 * u * al2 + 192 / 10 * u * G) * ((1 + u) * S)) as moved.
    { rewrite Rabs_mult. apply Rmult_le_compat; try apply Rabs_pos; [| assumption]. apply Rle_trans with (1 := na). unfold u in *; lra. }
    assert (Rabs (al * al * (corner - (L - K))) <= al * al * (23 * u * S + 23 / 10 * u * M)) as moved'.
    { rewrite Rabs_mult, (Rabs_pos_eq (al * al)) by apply al_G. apply Rmult_le_compat_l; [apply al_G | assumption]. }
    assert (al * al * S <= (1 + 258 * u) * (al2 * S) + 20 * u * (G * S)) as a1.
    { replace ((1 + 258 * u) * (al2 * S) + 20 * u * (G * S)) with (((1 + 258 * u) * al2 + 20 * u * G) * S) by ring.
      apply Rmult_le_compat_r; [assumption |]. apply within in na. unfold u in *; lra. }
    assert (al * al * M <= (1 + 10 * u) * (G * M)) as a2 by (rewrite <- Rmult_assoc; apply Rmult_le_compat_r; [assumption | apply al_G]).
    apply within in r. apply within in moved. apply within in moved'. set (q := al * al) in *.
    replace (q * (23 * u * S + 23 / 10 * u * M)) with (23 * u * (q * S) + 23 / 10 * u * (q * M)) in moved' by ring.
    assert (b - q * (L - K) = (b - al2 * corner) + (al2 - q) * corner + q * (corner - (L - K))) as -> by ring.
    apply Rabs_le. unfold u in *; lra. }
  (* sizes *)
  assert (0 <= a) by (unfold u in *; lra).
  assert ((1 - 3 * u) * (al2 * S) <= rd (al2 * both)) as t1.
  { assert (al2 * ((1 - u) * S) <= al2 * both) by (apply Rmult_le_compat_l; lra).
    pose proof (rd_positive (al2 * both) ltac:(apply Rmult_le_pos; unfold u in *; lra)). unfold u in *; lra. }
  assert ((1 - 180 * u) * (4 * (G * S) + 4 * (G * M)) <= rd (floor * rd (4 * both + 4 * disc_floor))) as t2.
  { pose proof (rd_positive (4 * both + 4 * disc_floor) ltac:(unfold u in *; lra)) as r. set (y := rd (4 * both + 4 * disc_floor)) in *.
    assert ((1 - 140 * u) * G * ((1 - 22 * u) * (4 * S + 4 * M)) <= floor * y) by (apply Rmult_le_compat; unfold u in *; lra).
    pose proof (rd_positive (floor * y) ltac:(apply Rmult_le_pos; unfold u in *; lra)). unfold u in *; lra. }
  set (t := rd (al2 * both)) in *. set (d := rd (floor * rd (4 * both + 4 * disc_floor))) in *.
  pose proof (rd_positive (a + t) ltac:(unfold u in *; lra)) as s1. pose proof (rd_positive (rd (a + t) + d) ltac:(unfold u in *; lra)) as s2. fold sizes in s2.
  apply (comparison_is_right _ _ _ _ sizes _ _ over other); unfold u in *; lra.
Qed.

End Slip.

(* t^2 |n|^2 against (1 + t^2) n_z^2, n_z known within 2^-50 of |n|. *)
Theorem uprightness_is_decided : forall z z' l ll' t, 0 <= l -> Rabs (z' - z) <= 8 * u * l -> Rabs (ll' - l * l) <= 8 * u * (l * l) ->
  let least := band_of t ll' in let taller := rd (1 + rd (t * t)) in let got := rd (taller * rd (z' * z')) in
  let sizes := rd (rd (least + got) + rd (taller * ll')) in
  (rd (line_part * ll') < rd (z' * z') -> 0 < z' * z) /\
  (rd (margin_part * sizes) < rd (got - least) -> t * t * (l * l) < (1 + t * t) * (z * z)) /\
  (rd (got - least) < - rd (margin_part * sizes) -> (1 + t * t) * (z * z) < t * t * (l * l)).
Proof.
  intros z z' l ll' t l_pos z_near ll_near least taller got sizes. pose proof (Rle_0_sqr l) as ll. pose proof (Rle_0_sqr t) as tt. unfold Rsqr in ll, tt.
  pose proof (part_of _ _ _ ll_near) as nl. split.
  { apply (sign_by_square z z' 8 l); trivial; [lra | unfold u in *; lra]. }
  destruct (band_near t ll' l 8 ltac:(lra) ll_near) as (b_pos & nb). fold least in b_pos, nb.
  pose proof (square_near z z' 8 16 l z_near ltac:(lra) ltac:(lra) l_pos) as nz. set (q := rd (z' * z')) in *.
  assert (0 <= q) as q_pos by (pose proof (rd_positive _ (Rle_0_sqr z')); pose proof (Rle_0_sqr z'); unfold Rsqr, q, u in *; lra).
  pose proof (rd_positive _ tt) as nt. pose proof (rd_positive (1 + rd (t * t)) ltac:(unfold u in *; lra)) as n1. fold taller in n1.
  set (T := 1 + t * t) in *. assert ((1 - 3 * u) * T <= taller <= (1 + 3 * u) * T) as nT by (unfold T, u in *; lra). assert (1 <= T) by (unfold T; lra).
  pose proof (product_part T taller q q 3 0 ltac:(lra) q_pos ltac:(lra) ltac:(lra) nT ltac:(lra)) as g. fold got in g.
  pose proof (product_part T taller (l * l) ll' 3 8 ltac:(lra) ll ltac:(lra) ltac:(lra) nT nl) as w. set (last := rd (taller * ll')) in *.
  assert (0 <= T * q) by (apply Rmult_le_pos; lra). assert (0 <= T * (l * l)) by (apply Rmult_le_pos; lra).
  assert (Rabs (got - T * (z * z)) <= 26 * u * got + 5 * u * (T * (l * l))) as ng.
  { assert (Rabs (T * (q - z * z)) <= T * (18 * u * q + 41 / 10 * u * (l * l))) as moved.
    { rewrite Rabs_mult, (Rabs_pos_eq T) by lra. apply Rmult_le_compat_l; [lra |]. apply Rle_trans with (1 := nz). unfold u in *; lra. }
    apply within in moved. apply Rabs_le. unfold u in *; lra. }
  pose proof (rd_positive (least + got) ltac:(unfold u in *; lra)) as s1. pose proof (rd_positive (rd (least + got) + last) ltac:(unfold u in *; lra)) as s2. fold sizes in s2.
  apply (comparison_is_right _ _ _ _ sizes _ _ nb ng); unfold u in *; lra.
Qed.

Print Assumptions between_is_decided.
Print Assumptions beside_is_decided.
Print Assumptions uprightness_is_decided.
