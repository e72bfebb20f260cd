(* Lemma crossing-in-double-double (proofs-notes/rounding.md) as a whole: what rounded_crossing_of in
   fast/crossing_body.hpp computes, with the bound as the code rounds it, is lambda's nearest double wherever its two
   limits agree. Underflow is inside; that overflow shows (the limits are then no equal numbers) is on paper. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles pair_sum quotient delta_in_pairs crossing crossing_bound.
Open Scope R_scope.

Section Crossing.

(* Delta at both ends as delta_in_pairs.v leaves it (`delta_parts`), with the sizes as computed. *)
Variables va ra vb rb Ma Mb A B lambda : R.
Hypotheses (Dva : is_double va) (Dra : is_double ra) (Dvb : is_double vb) (Drb : is_double rb).
Hypotheses (DMa : is_double Ma) (DMb : is_double Mb) (Ma_pos : 0 <= Ma) (Mb_pos : 0 <= Mb).
Hypotheses (a_near : Rabs (va + ra - A) <= delta_error_unit * Ma + 64 * tiny) (b_near : Rabs (vb + rb - B) <= delta_error_unit * Mb + 64 * tiny).
Hypotheses (va_size : Rabs va <= (1 + 7 * u) * Ma) (vb_size : Rabs vb <= (1 + 7 * u) * Mb).
Hypotheses (ra_size : Rabs ra <= 7 / 2 * u * Ma + 32 * tiny) (rb_size : Rabs rb <= 7 / 2 * u * Mb + 32 * tiny).

Let difference := fl (va + - vb).
Let t := fl (rest va (- vb) + fl (ra + - rb)).
Let w_high := fl (difference + t).
Let w_low := rest difference t.
Let q := fl (va / w_high).
(* Dekker's or fused (quotient.v: `remainder_is_computed_anyway`, `fused_remainder`). *)
Variable remainder : R.
Hypotheses (Dremainder : is_double remainder)
  (remainder_near : Rabs (remainder - (va - q * w_high)) <= 32 * tiny + tiny * Rabs w_high).
Let inverse := fl (1 / w_high).
Let c := fl (fl (remainder + fl (ra + - fl (q * w_low))) * inverse).
Let high := fl (q + c).
Let low := rest q c.
Let size := fl (Ma + Mb).
Let e := error_bound size (Rabs inverse) (Rabs high).

Hypothesis crossing : A = lambda * (A - B).
Hypothesis w_some : w_high <> 0.
Hypotheses (size_is_usable : size <= greatest_size) (lambda_is_usable : least_lambda <= Rabs high).

Let pad := bpow radix2 (-1010).
Let Pa := (1 + 4 * u) * (Ma + pad).
Let Pb := (1 + 4 * u) * (Mb + pad).
Let S := Pa + Pb.
Let D := Rabs w_high.
Let L := 64 * tiny + tiny * D.
Let i := / D.
Let K := 1 + 2 * Rabs high.
Let part := (106 * u * u * S + 12 * L) * i * (1 + 2 * u).

Lemma D_pos : 0 < D. Proof. now apply Rabs_pos_lt. Qed.
Lemma pad_pos : 0 < pad. Proof. apply bpow_gt_0. Qed.
Lemma pad_covers : 64 * tiny <= u * pad.
Proof.
  unfold tiny, pad. replace u with (bpow radix2 (-53)) by reflexivity. rewrite <- bpow_plus.
  change (-53 + -1010)%Z with (12 + -1075)%Z. rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0 | simpl; lra].
Qed.

Lemma w_low_is_small : Rabs w_low <= u * D.
Proof.
  assert (is_double difference) as Dd by apply fl_is_double. assert (is_double t) as Dt by apply fl_is_double.
  pose proof (two_sum_is_exact difference t Dd Dt) as exact. fold w_high w_low in exact.
  pose proof (sum_error_of_rounded difference t Dd Dt) as near. fold w_high in near.
  replace w_low with (- (w_high - (difference + t))) by (rewrite <- exact; ring). now rewrite Rabs_Ropp.
Qed.

Lemma low_is_small : q + c = high + low /\ Rabs low <= u * Rabs high.
Proof.
  assert (is_double q) as Dq by apply fl_is_double. assert (is_double c) as Dc by apply fl_is_double.
  pose proof (two_sum_is_exact q c Dq Dc) as exact. fold high low in exact.
  pose proof (sum_error_of_rounded q c Dq Dc) as near. fold high in near.
  split; [now symmetry |]. replace low with (- (high - (q + c))) by (rewrite <- exact; ring). now rewrite Rabs_Ropp.
Qed.

Lemma w_high_size : D <= 3 * (Ma + Mb + pad).
Proof.
  assert (is_double (- vb)) as Dnb by now apply generic_format_opp. assert (is_double (- rb)) as Dnr by now apply generic_format_opp.
  assert (is_double difference) as Dd by apply fl_is_double. assert (is_double t) as Dt by apply fl_is_double.
  pose proof (two_sum_is_exact va (- vb) Dva Dnb) as exact; fold difference in exact.
  pose proof (sum_error va (- vb) Dva Dnb) as d_near; fold difference in d_near.
  set (d := rest va (- vb)) in *. assert (is_double d) as Ddl by apply fl_is_double.
  pose proof (sum_error ra (- rb) Dra Dnr) as r_near; set (r := fl (ra + - rb)) in *.
  pose proof (sum_error d r Ddl (fl_is_double _)) as t_near; fold t in t_near.
  pose proof (sum_error difference t Dd Dt) as w_near; fold w_high in w_near.
  pose proof pad_pos. pose proof pad_covers. pose proof tiny_positive. set (M := Ma + Mb + pad).
  apply within in va_size; apply within in vb_size; apply within in ra_size; apply within in rb_size.
  assert (Rabs (va + - vb) <= (1 + 7 * u) * M) by (unfold M, u in *; apply Rabs_le; lra).
  assert (u * Rabs (va + - vb) <= u * ((1 + 7 * u) * M)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (Rabs (ra + - rb) <= 4 * u * M) by (unfold M, u in *; apply Rabs_le; lra).
  assert (u * Rabs (ra + - rb) <= u * (4 * u * M)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (0 <= M) by (unfold M; lra).
  pose proof (within _ _ d_near). pose proof (within _ _ r_near).
  assert (Rabs (va + - vb) <= (1 + 7 * u) * M) as range by assumption. apply within in range.
  assert (Rabs (ra + - rb) <= 4 * u * M) as range' by assumption. apply within in range'.
  assert (Rabs (d + r) <= 6 * u * M) by (unfold u in *; apply Rabs_le; lra).
  assert (u * Rabs (d + r) <= u * (6 * u * M)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in t_near. assert (Rabs (d + r) <= 6 * u * M) as range'' by assumption. apply within in range''.
  assert (Rabs (difference + t) <= 2 * M) by (unfold u in *; apply Rabs_le; lra).
  assert (u * Rabs (difference + t) <= u * (2 * M)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in w_near. assert (Rabs (difference + t) <= 2 * M) as last by assumption. apply within in last.
  unfold D. unfold u in *; apply Rabs_le; lra.
Qed.

(* The quotient is near lambda. *)
Lemma computed_is_near : Rabs (q + c - lambda) <= (1 + 2 * Rabs lambda) * part.
Proof.
  pose proof D_pos. pose proof pad_pos. pose proof pad_covers. pose proof tiny_positive. pose proof w_low_is_small as w_tidy.
  pose proof w_high_size as w_size. assert (0 <= tiny * D) by (apply Rmult_le_pos; lra).
  assert (size_is : Ma + Mb <= 2 * greatest_size).
  { pose proof (sum_error Ma Mb DMa DMb) as near. fold size in near. rewrite (Rabs_pos_eq (Ma + Mb)) in near by lra.
    apply within in near. unfold u in *; lra. }
  assert (D <= bpow radix2 1000) as D_small.
  { apply Rle_trans with (1 := w_size). unfold greatest_size in *.
    assert (pad <= bpow radix2 900) by (apply bpow_le; lia).
    replace (bpow radix2 1000) with (bpow radix2 100 * bpow radix2 900) by (rewrite <- bpow_plus; reflexivity).
    assert (9 * bpow radix2 900 <= bpow radix2 100 * bpow radix2 900) by (apply Rmult_le_compat_r; [apply bpow_ge_0 | simpl; lra]). lra. }
  assert (Rabs (q + c - lambda) * ((1 - u) * D) <= (1 + 2 * Rabs lambda) * (106 * u * u * S + 12 * L)) as times_w.
  { apply Rle_trans with (Rabs ((q + c - lambda) * (w_high + w_low))).
    - rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos |].
      assert (D <= Rabs (w_high + w_low) + Rabs w_low).
      { unfold D. replace w_high with (w_high + w_low - w_low) at 1 by ring. apply difference_size. }
      lra.
    - apply quotient_error with (value := va) (rest := ra) (remainder := remainder) (A := A) (W := A - B); trivial.
      all: try (unfold L; lra).
      + unfold S, Pa, Pb, u in *; lra.
      + unfold S, Pa, Pb, u in *; lra.
      + unfold S, Pa, Pb, u in *; lra.
      + intros x at_x. apply Rle_trans with ((1 + 2 * Rabs x) * (52 * u * u * (Pa + Pb) + 64 * tiny)).
        * apply lambda_is_near with (A := A) (B := B); trivial.
          all: unfold Pa, Pb, delta_error_unit, u in *; lra.
        * apply Rmult_le_compat_l; [pose proof (Rabs_pos x); lra |]. unfold S, L; lra.
      + pose proof (fl_error (va / w_high)) as q_near. fold q in q_near.
        replace (va - q * w_high) with (- ((q - va / w_high) * w_high)) by (field; assumption). rewrite Rabs_Ropp, Rabs_mult. fold D.
        apply Rle_trans with ((u * Rabs (va / w_high) + tiny) * D); [apply Rmult_le_compat_r; lra |].
        assert (Rabs (va / w_high) * D = Rabs va) as whole by (unfold D; rewrite <- Rabs_mult; f_equal; field; assumption).
        replace ((u * Rabs (va / w_high) + tiny) * D) with (u * (Rabs (va / w_high) * D) + tiny * D) by ring. rewrite whole.
        assert (0 <= 2 * u * u * Rabs va) by (apply Rmult_le_pos; [unfold u; lra | apply Rabs_pos]). unfold L. lra.
      + apply Rle_trans with (32 * tiny + tiny * D); [| unfold L; lra].
        exact remainder_near.
      + now apply inverse_is_near.
      + change (tiny * D <= L). unfold L; lra.
      + assert (tiny <= u * pad) by lra.
        assert (tiny * D <= / 1000 * D) by (apply Rmult_le_compat_r; [lra |]; unfold tiny; simpl; lra).
        assert (Ma + pad <= Pa) by (unfold Pa, u; lra). assert (Mb + pad <= Pb) by (unfold Pb, u; lra).
        assert (u * pad <= / 1000 * pad) by (apply Rmult_le_compat_r; [| unfold u]; lra).
        unfold L, S. lra. }
  apply Rmult_le_reg_r with ((1 - u) * D); [apply Rmult_lt_0_compat; [unfold u |]; lra |].
  apply Rle_trans with (1 := times_w). unfold part.
  assert (i * D = 1) as whole by (unfold i; field; lra).
  set (E := 106 * u * u * S + 12 * L). assert (0 <= E).
  { unfold E, L, S, Pa, Pb. assert (0 <= u) by (unfold u; lra). assert (0 <= u * u) by nra.
    assert (0 <= u * u * (Ma + pad)) by (apply Rmult_le_pos; lra). assert (0 <= u * u * (Mb + pad)) by (apply Rmult_le_pos; lra).
    replace (106 * u * u * ((1 + 4 * u) * (Ma + pad) + (1 + 4 * u) * (Mb + pad)))
      with ((1 + 4 * u) * 106 * (u * u * (Ma + pad) + u * u * (Mb + pad))) by ring.
    assert (0 <= (1 + 4 * u) * 106 * (u * u * (Ma + pad) + u * u * (Mb + pad))) by (apply Rmult_le_pos; lra). lra. }
  replace ((1 + 2 * Rabs lambda) * (E * i * (1 + 2 * u)) * ((1 - u) * D)) with ((1 + 2 * Rabs lambda) * (E * ((1 + 2 * u) * (1 - u)) * (i * D))) by ring.
  rewrite whole, Rmult_1_r. apply Rmult_le_compat_l; [pose proof (Rabs_pos lambda); lra |].
  rewrite <- (Rmult_1_r E) at 1. apply Rmult_le_compat_l; [assumption | unfold u; lra].
Qed.

(* The code's bound is more than that, with room for its own rounding and the limits'. *)
Lemma bound_is_enough : (1 + 2 * Rabs (q + c)) * (64 / 63 * part) + 2 * u * (Rabs low + e) <= e /\ 0 <= part /\ K * part <= e.
Proof.
  pose proof D_pos as D_pos_. pose proof pad_pos. pose proof pad_covers. pose proof tiny_positive.
  destruct low_is_small as (parts & low_size). pose proof (Rabs_pos high). pose proof (Rabs_pos low).
  assert (0 <= size) as size_pos by (apply not_negative; lra).
  assert (is_double (Rabs high)) as Dm by (apply generic_format_abs, fl_is_double).
  pose proof (error_bound_is_at_least size (Rabs inverse) (Rabs high) Dm size_pos (Rabs_pos _) lambda_is_usable) as least.
  fold e K in least.
  assert (0 < i) by (unfold i; now apply Rinv_0_lt_compat).
  assert (i * D = 1) as whole by (unfold i; field; lra).
  (* the inverse as computed *)
  assert (size_is : Ma + Mb <= 2 * greatest_size).
  { pose proof (sum_error Ma Mb DMa DMb) as near. fold size in near. rewrite (Rabs_pos_eq (Ma + Mb)) in near by lra.
    apply within in near. unfold u in *; lra. }
  assert (D <= bpow radix2 1000) as D_small.
  { apply Rle_trans with (1 := w_high_size). unfold greatest_size in *.
    assert (pad <= bpow radix2 900) by (apply bpow_le; lia).
    replace (bpow radix2 1000) with (bpow radix2 100 * bpow radix2 900) by (rewrite <- bpow_plus; reflexivity).
    assert (9 * bpow radix2 900 <= bpow radix2 100 * bpow radix2 900) by (apply Rmult_le_compat_r; [apply bpow_ge_0 | simpl; lra]). lra. }
  set (I := Rabs inverse) in *.
  assert (i <= (1 + 3 * u) * I) as i_size.
  { pose proof (inverse_is_near w_high w_some D_small) as near. fold inverse in near.
    assert (1 - 2 * u <= I * D).
    { unfold I, D. rewrite <- Rabs_mult. apply within in near. apply Rle_trans with (2 := Rle_abs _). lra. }
    apply Rmult_le_reg_r with D; [assumption |]. rewrite whole.
    apply Rle_trans with ((1 + 3 * u) * (1 - 2 * u)); [unfold u; lra |].
    rewrite Rmult_assoc. apply Rmult_le_compat_l; [unfold u |]; lra. }
  assert (0 <= I) by apply Rabs_pos.
  assert (Ma + Mb <= (1 + 2 * u) * size) as sizes.
  { pose proof (sum_error Ma Mb DMa DMb) as near. fold size in near. rewrite (Rabs_pos_eq (Ma + Mb)) in near by lra.
    apply within in near. unfold u in *; lra. }
  assert (1 <= K) by (unfold K; lra).
  set (m := Rabs high) in *.
  (* everything in terms of X = size I K, Y = I K, N = u^2 m *)
  set (X := u * u * (size * I * K)). set (Y := I * K). set (N := u * u * m).
  assert (0 <= Y) by (apply Rmult_le_pos; lra).
  assert (0 <= X).
  { unfold X. apply Rmult_le_pos; [unfold u; lra |]. apply Rmult_le_pos; [now apply Rmult_le_pos | lra]. }
  assert (0 <= N) by (apply Rmult_le_pos; [unfold u |]; lra).
  assert (per_quotient = 128 * u * u) as pq by (unfold per_quotient, u; simpl; lra).
  assert (per_lambda = 32 * u * u) as pl by (unfold per_lambda, u; simpl; lra).
  rewrite pq, pl in least.
  replace (128 * u * u * (size * I * K)) with (128 * X) in least by (unfold X; ring).
  replace (32 * u * u * m) with (32 * N) in least by (unfold N; ring). fold Y in least.
  assert (0 < underflow) by (unfold underflow; apply bpow_gt_0).
  set (V := underflow * Y) in *. assert (0 <= V) by (apply Rmult_le_pos; lra).
  assert (pad <= / 1000 * underflow) as pad_small.
  { unfold pad, underflow. change (-1010)%Z with (-10 + -1000)%Z. rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0 | simpl; lra]. }
  assert (pad * Y <= / 1000 * V) as pad_Y.
  { unfold V. rewrite <- Rmult_assoc. now apply Rmult_le_compat_r. }
  assert (1000000 * tiny <= u * u * least_lambda) as tiny_small.
  { unfold least_lambda, tiny. replace u with (bpow radix2 (-53)) by reflexivity. rewrite <- !bpow_plus.
    change (-53 + -53 + -900)%Z with (69 + -1075)%Z. rewrite bpow_plus. apply Rmult_le_compat_r; [apply bpow_ge_0 | simpl; lra]. }
  assert (100000 * (tiny * K) <= N) as tiny_K.
  { assert (u * u * least_lambda <= N) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
    assert (1000000 * tiny <= u * u).
    { apply Rle_trans with (1 := tiny_small). replace (u * u) with (u * u * 1) at 2 by ring.
      apply Rmult_le_compat_l; [unfold u; lra |]. apply (bpow_le radix2 (-900) 0). lia. }
    assert (1000000 * tiny * m <= u * u * m) by (apply Rmult_le_compat_r; assumption). unfold K, N in *. lra. }
  (* part K is small *)
  assert (K * part <= 107 * X + / 100 * V + / 100 * N) as part_K.
  { unfold part, L, S, Pa, Pb.
    assert (K * i <= (1 + 3 * u) * Y) as Ki.
    { unfold Y. replace ((1 + 3 * u) * (I * K)) with (K * ((1 + 3 * u) * I)) by ring. apply Rmult_le_compat_l; lra. }
    assert (0 <= K * i) by (apply Rmult_le_pos; lra).
    replace (K * ((106 * u * u * ((1 + 4 * u) * (Ma + pad) + (1 + 4 * u) * (Mb + pad)) + 12 * (64 * tiny + tiny * D)) * i * (1 + 2 * u)))
      with ((1 + 2 * u) * (1 + 4 * u) * 106 * ((u * u) * ((Ma + Mb) * (K * i))) + (1 + 2 * u) * (1 + 4 * u) * 212 * (u * u) * (pad * (K * i))
            + (1 + 2 * u) * 768 * (tiny * (K * i)) + (1 + 2 * u) * 12 * (tiny * K) * (i * D)) by ring.
    rewrite whole, Rmult_1_r.
    assert ((Ma + Mb) * (K * i) <= (1 + 2 * u) * size * ((1 + 3 * u) * Y)) as one by (apply Rmult_le_compat; lra).
    assert (u * u * ((Ma + Mb) * (K * i)) <= (1 + 6 * u) * X) as one'.
    { apply Rle_trans with (u * u * ((1 + 2 * u) * size * ((1 + 3 * u) * Y))); [apply Rmult_le_compat_l; [unfold u; lra | assumption] |].
      replace (u * u * ((1 + 2 * u) * size * ((1 + 3 * u) * Y))) with ((1 + 2 * u) * (1 + 3 * u) * X) by (unfold X, Y; ring).
      apply Rmult_le_compat_r; [assumption | unfold u; lra]. }
    assert (pad * (K * i) <= (1 + 3 * u) * (/ 1000 * V)) as two.
    { apply Rle_trans with (pad * ((1 + 3 * u) * Y)); [apply Rmult_le_compat_l; lra |].
      replace (pad * ((1 + 3 * u) * Y)) with ((1 + 3 * u) * (pad * Y)) by ring. apply Rmult_le_compat_l; [unfold u; lra | assumption]. }
    assert (tiny * (K * i) <= u * (pad * (K * i))).
    { replace (u * (pad * (K * i))) with (u * pad * (K * i)) by ring. apply Rmult_le_compat_r; lra. }
    assert (0 <= tiny * K) by (apply Rmult_le_pos; lra).
    assert (0 <= pad * (K * i)) by (apply Rmult_le_pos; lra).
    unfold u in *; lra. }
  assert (0 <= part).
  { unfold part. apply Rmult_le_pos; [| unfold u; lra]. apply Rmult_le_pos; [| lra].
    assert (0 <= S) by (unfold S, Pa, Pb, u; lra). assert (0 <= L) by (unfold L; assert (0 <= tiny * D) by (apply Rmult_le_pos; lra); lra).
    assert (0 <= 106 * u * u * S) by (apply Rmult_le_pos; [unfold u |]; lra). lra. }
  assert (1 + 2 * Rabs (q + c) <= (1 + 2 * u) * K) as K_near.
  { rewrite parts. assert (Rabs (high + low) <= m + Rabs low) by apply Rabs_triang. unfold K. fold m. unfold u in *; lra. }
  assert ((1 + 2 * Rabs (q + c)) * (64 / 63 * part) <= (1 + 2 * u) * (64 / 63) * (K * part)).
  { replace ((1 + 2 * u) * (64 / 63) * (K * part)) with ((1 + 2 * u) * K * (64 / 63 * part)) by ring.
    apply Rmult_le_compat_r; [lra | assumption]. }
  assert (2 * u * Rabs low <= 2 * N) by (unfold N; replace (2 * (u * u * m)) with (2 * u * (u * m)) by ring; apply Rmult_le_compat_l; [unfold u |]; lra).
  split; [| split; [assumption |]]; unfold u in *; lra.
Qed.

(* Where the code says that its high part is certain, it is lambda rounded to nearest. *)
Theorem crossing_is_rounded : fl (high + fl (low + e)) = fl (high + fl (low + - e)) -> fl lambda = high.
Proof.
  intros same. destruct bound_is_enough as (enough & part_pos & part_K). destruct low_is_small as (parts & low_size).
  assert (is_double high) as Dh by apply fl_is_double. assert (is_double low) as Dl by apply fl_is_double.
  assert (is_double e) as De by apply fl_is_double. pose proof (Rabs_pos high). pose proof (Rabs_pos low).
  destruct (Rle_or_lt (128 * part) 1) as [small | large].
  - apply rounding_is_certain with (low := low) (e := e) (error := (1 + 2 * Rabs (q + c)) * (64 / 63 * part)); trivial.
    + rewrite <- parts. reflexivity.
    + rewrite <- parts, (Rabs_minus_sym lambda). apply error_by_computed; trivial. apply computed_is_near.
    + apply Rmult_le_pos; [pose proof (Rabs_pos (q + c)) |]; lra.
  - exfalso. assert (0 < least_lambda) by apply bpow_gt_0.
    assert (K * / 128 <= K * part) by (apply Rmult_le_compat_l; [unfold K |]; lra). unfold K in *.
    apply (far_limits_differ high low e); trivial; unfold u in *; lra.
Qed.
End Crossing.

Print Assumptions computed_is_near.
Print Assumptions bound_is_enough.
Print Assumptions crossing_is_rounded.
