(* Lemma crossing-in-double-double (proofs-notes/rounding.md), the bound: what `error` of fast/crossing_body.hpp is at
   least when all its operations are rounded, and that limits which are far apart do not round alike. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core Mult_error.
From Groundtruth Require Import doubles.
Open Scope R_scope.

(* 128 unit unit, 32 unit unit, 0x1p-1000 of the code, and the range of lambda that it asks for. *)
Definition per_quotient := bpow radix2 (-99).
Definition per_lambda := bpow radix2 (-101).
Definition underflow := bpow radix2 (-1000).
Definition least_lambda := bpow radix2 (-900).
Definition greatest_size := bpow radix2 900.

Lemma not_negative : forall x, 0 <= x -> 0 <= fl x.
Proof. intros x positive. rewrite <- (fl_of_double 0) by apply generic_format_0. now apply fl_monotone. Qed.

(* Limits that are far apart do not round alike. *)
Lemma far_limits_differ : forall high low e, is_double high -> is_double low -> is_double e ->
  Rabs low <= 2 * u * Rabs high -> Rabs high <= 100 * e -> 0 < e ->
  fl (high + fl (low + e)) <> fl (high + fl (low + - e)).
Proof.
  intros high low e Dh Dl De tidy large positive same.
  assert (is_double (- e)) as Dm by now apply generic_format_opp.
  pose proof (sum_error low e Dl De) as up. pose proof (sum_error low (- e) Dl Dm) as down.
  pose proof (sum_error high _ Dh (fl_is_double (low + e))) as up'.
  pose proof (sum_error high _ Dh (fl_is_double (low + - e))) as down'.
  rewrite <- same in down'.
  assert (Rabs low <= 200 * u * e) as small by (unfold u in *; lra).
  apply within in small. pose proof (within _ _ large) as range.
  assert (Rabs (low + e) <= 2 * e) by (apply Rabs_le; unfold u in *; lra).
  assert (Rabs (low + - e) <= 2 * e) by (apply Rabs_le; unfold u in *; lra).
  assert (u * Rabs (low + e) <= u * (2 * e)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (u * Rabs (low + - e) <= u * (2 * e)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in up; apply within in down.
  assert (Rabs (high + fl (low + e)) <= 103 * e) by (apply Rabs_le; unfold u in *; lra).
  assert (Rabs (high + fl (low + - e)) <= 103 * e) by (apply Rabs_le; unfold u in *; lra).
  assert (u * Rabs (high + fl (low + e)) <= u * (103 * e)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (u * Rabs (high + fl (low + - e)) <= u * (103 * e)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  apply within in up'; apply within in down'. unfold u in *; lra.
Qed.

Section Bound.

(* The sizes' sum, |1 / w| and |lambda| as they were computed; `error` of the code, and what it is at least. *)
Variables size inverse m : R.
Hypotheses (Dm : is_double m) (size_pos : 0 <= size) (inverse_pos : 0 <= inverse) (lambda_some : least_lambda <= m).

Let k := fl (1 + 2 * m).
Definition error_bound :=
  fl (fl (fl (fl (per_quotient * fl (size * inverse)) * k) + fl (per_lambda * m)) + fl (fl (underflow * k) * inverse)).

Lemma error_bound_is_at_least :
  (1 - 10 * u) * (per_quotient * (size * inverse * (1 + 2 * m)) + per_lambda * m + underflow * (inverse * (1 + 2 * m))) <= error_bound.
Proof.
  pose proof tiny_positive. assert (0 < m) as some by (apply Rlt_le_trans with (2 := lambda_some); apply bpow_gt_0).
  assert (is_double (2 * m)) as D2.
  { replace (2 * m) with (m * bpow radix2 1) by (change (bpow radix2 1) with 2; ring). apply mult_bpow_pos_exact_FLT; [assumption | lia]. }
  assert (is_double 1) as D1 by (apply (power_is_double 0); lia).
  set (K := 1 + 2 * m).
  pose proof (sum_error 1 (2 * m) D1 D2) as k_near. fold k K in k_near. rewrite (Rabs_pos_eq K) in k_near by (unfold K; lra).
  apply within in k_near. assert (1 <= K) by (unfold K; lra).
  assert (0 <= k) by (unfold u in *; lra).
  set (X := size * inverse). assert (0 <= X) by now apply Rmult_le_pos.
  pose proof (fl_error X) as p_near. rewrite (Rabs_pos_eq X) in p_near by assumption. apply within in p_near.
  assert (0 <= fl X) as p_pos by now apply not_negative. unfold error_bound. fold X. set (p := fl X) in *.
  assert (0 < per_quotient <= / 1000) as pq by (unfold per_quotient; simpl; lra).
  assert (0 < per_lambda) as pl by (unfold per_lambda; apply bpow_gt_0).
  assert (0 < underflow) as uf by (unfold underflow; apply bpow_gt_0).
  assert (0 <= per_quotient * p) by (apply Rmult_le_pos; lra).
  pose proof (fl_error (per_quotient * p)) as t_near. rewrite (Rabs_pos_eq (per_quotient * p)) in t_near by assumption. apply within in t_near.
  assert (0 <= fl (per_quotient * p)) as t_pos by now apply not_negative. set (t := fl (per_quotient * p)) in *.
  assert (per_quotient * (X * (1 - u) - tiny) <= per_quotient * p) by (apply Rmult_le_compat_l; lra).
  set (Y := per_quotient * X) in *. assert (0 <= Y) by (apply Rmult_le_pos; lra).
  assert (per_quotient * tiny <= tiny) by (replace tiny with (1 * tiny) at 2 by ring; apply Rmult_le_compat_r; lra).
  assert (0 <= per_quotient * tiny) by (apply Rmult_le_pos; lra).
  replace (per_quotient * (X * (1 - u) - tiny)) with (Y * (1 - u) - per_quotient * tiny) in * by (unfold Y; ring).
  assert (Y * (1 - 2 * u) - 3 * tiny <= t) as t_least by (unfold u in *; lra).
  (* e1 *)
  assert (0 <= t * k) by now apply Rmult_le_pos.
  pose proof (fl_error (t * k)) as e1_near. rewrite (Rabs_pos_eq (t * k)) in e1_near by assumption. apply within in e1_near.
  set (e1 := fl (t * k)) in *. assert (is_double e1) as De1 by apply fl_is_double.
  assert ((Y * (1 - 2 * u) - 3 * tiny) * k <= t * k) by now apply Rmult_le_compat_r.
  assert (0 <= Y * (1 - 2 * u)) by (apply Rmult_le_pos; [assumption | unfold u; lra]).
  assert (Y * (1 - 2 * u) * (K * (1 - u)) <= Y * (1 - 2 * u) * k) by (apply Rmult_le_compat_l; [assumption | lra]).
  assert (tiny * k <= tiny * (K * (1 + u))) by (apply Rmult_le_compat_l; lra).
  set (YK := Y * K). assert (0 <= YK) by (apply Rmult_le_pos; lra).
  set (TK := tiny * K) in *. assert (tiny <= TK) by (unfold TK; replace tiny with (tiny * 1) at 1 by ring; apply Rmult_le_compat_l; lra).
  assert (YK * (1 - 3 * u) - 3 * TK * (1 + u) <= t * k).
  { replace ((Y * (1 - 2 * u) - 3 * tiny) * k) with (Y * (1 - 2 * u) * k - 3 * (tiny * k)) in * by ring.
    replace (Y * (1 - 2 * u) * (K * (1 - u))) with (YK * (1 - 3 * u + 2 * u * u)) in * by (unfold YK; ring).
    replace (tiny * (K * (1 + u))) with (TK * (1 + u)) in * by (unfold TK; ring).
    unfold u in *; lra. }
  assert (YK * (1 - 5 * u) - 5 * TK <= e1) as e1_least by (unfold u in *; lra).
  (* e2 *)
  assert (0 <= per_lambda * m) by (apply Rmult_le_pos; lra).
  pose proof (fl_error (per_lambda * m)) as e2_near. rewrite (Rabs_pos_eq (per_lambda * m)) in e2_near by assumption. apply within in e2_near.
  set (e2 := fl (per_lambda * m)) in *. assert (is_double e2) as De2 by apply fl_is_double. set (N := per_lambda * m) in *.
  (* e3 *)
  assert (0 <= underflow * k) by (apply Rmult_le_pos; lra).
  pose proof (fl_error (underflow * k)) as y_near. rewrite (Rabs_pos_eq (underflow * k)) in y_near by assumption. apply within in y_near.
  assert (0 <= fl (underflow * k)) as y_pos by now apply not_negative. set (y := fl (underflow * k)) in *.
  assert (underflow * (K * (1 - u)) <= underflow * k) by (apply Rmult_le_compat_l; lra).
  assert (tiny <= u * underflow) as tiny_underflow.
  { unfold tiny, underflow. replace u with (bpow radix2 (-53)) by reflexivity. rewrite <- bpow_plus. apply bpow_le. lia. }
  set (V := underflow * K). assert (underflow <= V) by (unfold V; replace underflow with (underflow * 1) at 1 by ring; apply Rmult_le_compat_l; lra).
  replace (underflow * (K * (1 - u))) with (V * (1 - u)) in * by (unfold V; ring).
  assert (V * (1 - 3 * u) <= y) as y_least by (unfold u in *; lra).
  assert (0 <= y * inverse) by now apply Rmult_le_pos.
  pose proof (fl_error (y * inverse)) as e3_near. rewrite (Rabs_pos_eq (y * inverse)) in e3_near by assumption. apply within in e3_near.
  set (e3 := fl (y * inverse)) in *. assert (is_double e3) as De3 by apply fl_is_double.
  assert (V * (1 - 3 * u) * inverse <= y * inverse) by now apply Rmult_le_compat_r.
  set (VI := V * inverse). assert (0 <= VI) by (apply Rmult_le_pos; [unfold V; apply Rmult_le_pos; lra | assumption]).
  replace (V * (1 - 3 * u) * inverse) with (VI * (1 - 3 * u)) in * by (unfold VI; ring).
  assert (VI * (1 - 5 * u) - tiny <= e3) as e3_least by (unfold u in *; lra).
  (* what underflows is nothing beside per_lambda m *)
  assert (100 * TK <= u * N) as nothing.
  { assert (1000000 * tiny <= u * per_lambda * least_lambda) as small.
    { unfold per_lambda, least_lambda, tiny. replace u with (bpow radix2 (-53)) by reflexivity. rewrite <- !bpow_plus.
      change (-53 + -101 + -900)%Z with (21 + -1075)%Z. rewrite bpow_plus.
      apply Rmult_le_compat_r; [apply bpow_ge_0 | simpl; lra]. }
    assert (u * per_lambda * least_lambda <= u * per_lambda * m) by (apply Rmult_le_compat_l; [apply Rmult_le_pos; [unfold u |]; lra | assumption]).
    assert (1000000 * tiny <= u * per_lambda).
    { apply Rle_trans with (1 := small). replace (u * per_lambda) with (u * per_lambda * 1) at 2 by ring.
      apply Rmult_le_compat_l; [apply Rmult_le_pos; [unfold u |]; lra |]. apply (bpow_le radix2 (-900) 0). lia. }
    assert (1000000 * tiny * m <= u * per_lambda * m) by (apply Rmult_le_compat_r; lra).
    replace (u * N) with (u * per_lambda * m) by (unfold N; ring). unfold TK, K. lra. }
  assert (0 <= e1) by now apply not_negative. assert (0 <= e2) by now apply not_negative. assert (0 <= e3) by now apply not_negative.
  pose proof (sum_error e1 e2 De1 De2) as f_near. rewrite (Rabs_pos_eq (e1 + e2)) in f_near by lra. apply within in f_near.
  set (f := fl (e1 + e2)) in *. assert (is_double f) as Df by apply fl_is_double.
  assert (0 <= f) by (apply not_negative; lra).
  pose proof (sum_error f e3 Df De3) as e_near. rewrite (Rabs_pos_eq (f + e3)) in e_near by lra. apply within in e_near.
  replace (per_quotient * (X * K)) with YK by (unfold YK, Y; ring).
  replace (underflow * (inverse * K)) with VI by (unfold VI, V; ring). fold N.
  unfold u in *; lra.
Qed.
End Bound.

Print Assumptions far_limits_differ.
Print Assumptions error_bound_is_at_least.
