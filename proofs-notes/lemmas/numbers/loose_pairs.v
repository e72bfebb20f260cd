(* Lemma loose-pairs (proofs-notes/rounding-of-forces.md, section 2): dot and cross products of pairs that are made tidy once, at
   the end, are off by no more than the three, or two, roundings that one by one would be counted. fast/surface.hpp, dot and
   determinant; fast/pairs.hpp, dot and determinant. Terms may be products of pairs, of a double and a pair, or of doubles. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.
From Groundtruth Require Import doubles pair_sum pair_product.
Open Scope R_scope.

(* (h, l) stands for a product x of size P = |a_h b_h|. *)
Definition is_term h l x P := is_double h /\ is_double l /\ 0 <= P /\ Rabs (h + l - x) <= 9 * u * u * P + 32 * tiny
  /\ Rabs h <= (1 + u) * P + tiny /\ Rabs l <= 301 / 100 * u * P + 12 * tiny.

Lemma rounded_within : forall x y s, Rabs (x - y) <= s -> Rabs x <= Rabs y + s.
Proof. intros x y s near. replace x with (y + (x - y)) by ring. apply Rle_trans with (1 := Rabs_triang _ _). lra. Qed.

Section Terms.

Variables ah al bh bl r : R.
Hypotheses (a_tidy : Rabs al <= u * Rabs ah) (b_tidy : Rabs bl <= u * Rabs bh).
Hypotheses (r_is_double : is_double r) (r_near : Rabs (r - (ah * bh - fl (ah * bh))) <= 7 * tiny).
Let P := Rabs ah * Rabs bh.

Lemma parts : 0 <= P /\ Rabs (fl (ah * bh)) <= (1 + u) * P + tiny /\ Rabs r <= u * P + 8 * tiny /\ Rabs (ah * bl) <= u * P /\ Rabs (al * bh) <= u * P.
Proof.
  assert (0 <= P) by (apply Rmult_le_pos; apply Rabs_pos). pose proof (fl_error (ah * bh)) as near. rewrite Rabs_mult in near. fold P in near.
  pose proof (rounded_within _ _ _ near) as h. rewrite Rabs_mult in h. fold P in h. pose proof (rounded_within _ _ _ r_near) as s. rewrite (Rabs_minus_sym (ah * bh)) in s.
  repeat split; try lra; rewrite Rabs_mult; unfold P.
  - replace (u * (Rabs ah * Rabs bh)) with (Rabs ah * (u * Rabs bh)) by ring. apply Rmult_le_compat_l; [apply Rabs_pos | assumption].
  - replace (u * (Rabs ah * Rabs bh)) with (u * Rabs ah * Rabs bh) by ring. apply Rmult_le_compat_r; [apply Rabs_pos | assumption].
Qed.

Theorem product_of_pairs : is_term (fl (ah * bh)) (fl (r + fl (fl (ah * bl) + fl (al * bh)))) ((ah + al) * (bh + bl)) P.
Proof.
  destruct parts as (P_pos & h_size & r_size & p_size & q_size). pose proof tiny_positive. pose proof (fl_error (ah * bl)) as p. pose proof (fl_error (al * bh)) as q.
  assert (u * Rabs (ah * bl) <= u * (u * P)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  assert (u * Rabs (al * bh) <= u * (u * P)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  pose proof (rounded_within _ _ _ p) as p'. pose proof (rounded_within _ _ _ q) as q'.
  pose proof (sum_error _ _ (fl_is_double (ah * bl)) (fl_is_double (al * bh))) as c.
  assert (Rabs (fl (ah * bl) + fl (al * bh)) <= 2 * u * P + 2 * u * (u * P) + 2 * tiny) as c' by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  assert (u * Rabs (fl (ah * bl) + fl (al * bh)) <= u * (2 * u * P + 2 * u * (u * P) + 2 * tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  pose proof (rounded_within _ _ _ c) as c''. pose proof (sum_error _ _ r_is_double (fl_is_double (fl (ah * bl) + fl (al * bh)))) as l.
  assert (Rabs (r + fl (fl (ah * bl) + fl (al * bh))) <= 3 * u * P + 5 * u * (u * P) + 11 * tiny) as l' by (apply Rle_trans with (1 := Rabs_triang _ _); unfold u in *; lra).
  assert (u * Rabs (r + fl (fl (ah * bl) + fl (al * bh))) <= u * (3 * u * P + 5 * u * (u * P) + 11 * tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  pose proof (rounded_within _ _ _ l). pose proof (loose_product_error ah al bh bl r a_tidy b_tidy r_is_double r_near) as near. fold P in near.
  split; [apply fl_is_double |]. split; [apply fl_is_double |]. repeat split; trivial. unfold u in *; lra.
Qed.

Theorem product_of_double_and_pair : al = 0 -> is_term (fl (ah * bh)) (fl (r + fl (ah * bl))) (ah * (bh + bl)) P.
Proof.
  intros none. destruct parts as (P_pos & h_size & r_size & p_size & _). pose proof tiny_positive. pose proof (fl_error (ah * bl)) as p.
  assert (u * Rabs (ah * bl) <= u * (u * P)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  pose proof (rounded_within _ _ _ p) as p'. pose proof (sum_error _ _ r_is_double (fl_is_double (ah * bl))) as l.
  assert (Rabs (r + fl (ah * bl)) <= 2 * u * P + u * (u * P) + 9 * tiny) as l' by (apply Rle_trans with (1 := Rabs_triang _ _); lra).
  assert (u * Rabs (r + fl (ah * bl)) <= u * (2 * u * P + u * (u * P) + 9 * tiny)) by (apply Rmult_le_compat_l; [unfold u; lra | assumption]).
  pose proof (rounded_within _ _ _ l). split; [apply fl_is_double |]. split; [apply fl_is_double |]. repeat split; trivial; [| unfold u in *; lra].
  apply within in p. apply within in l. apply within in r_near. apply Rabs_le. unfold u in *; lra.
Qed.

Theorem product_of_doubles : al = 0 -> bl = 0 -> is_term (fl (ah * bh)) r (ah * bh) P.
Proof.
  intros _ _. destruct parts as (P_pos & h_size & r_size & _). pose proof tiny_positive. split; [apply fl_is_double |]. split; [assumption |].
  assert (0 <= u * P) by (apply Rmult_le_pos; [unfold u; lra | assumption]). assert (0 <= u * u * P) by (rewrite Rmult_assoc; apply Rmult_le_pos; [unfold u; lra | assumption]).
  repeat split; trivial; [| lra]. replace (fl (ah * bh) + r - ah * bh) with (r - (ah * bh - fl (ah * bh))) by ring. lra.
Qed.
End Terms.

(* loose_sum, whatever the low parts are. *)
Lemma loose_sum_of_loose : forall ah al bh bl S Q, is_double ah -> is_double al -> is_double bh -> is_double bl ->
  Rabs ah + Rabs bh <= S -> Rabs al + Rabs bl <= Q ->
  let s := fl (ah + bh) in let l := fl (rest ah bh + fl (al + bl)) in
  Rabs (s + l - (ah + al + (bh + bl))) <= 201 / 100 * u * Q + 101 / 100 * u * u * S /\ Rabs s <= (1 + u) * S /\ Rabs l <= 101 / 100 * (u * S + Q).
Proof.
  intros ah al bh bl S Q Dah Dal Dbh Dbl HS HQ s l. pose proof (two_sum_is_exact ah bh Dah Dbh) as exact. fold s in exact.
  pose proof (sum_error ah bh Dah Dbh) as s_near. fold s in s_near. pose proof (Rabs_triang ah bh). pose proof (Rabs_triang al bl).
  pose proof (Rabs_pos ah). pose proof (Rabs_pos bh). pose proof (Rabs_pos al). pose proof (Rabs_pos bl).
  assert (u * Rabs (ah + bh) <= u * S) by (apply Rmult_le_compat_l; [unfold u |]; lra). assert (u * Rabs (al + bl) <= u * Q) by (apply Rmult_le_compat_l; [unfold u |]; lra).
  pose proof (rounded_within _ _ _ s_near). pose proof (sum_error al bl Dal Dbl) as t_near. pose proof (rounded_within _ _ _ t_near).
  assert (Rabs (rest ah bh) <= u * S) as r_size by (replace (rest ah bh) with (- (s - (ah + bh))) by lra; rewrite Rabs_Ropp; lra).
  assert (is_double (rest ah bh)) as Dr by apply fl_is_double. pose proof (sum_error (rest ah bh) (fl (al + bl)) Dr (fl_is_double _)) as l_near. fold l in l_near.
  pose proof (Rabs_triang (rest ah bh) (fl (al + bl))).
  assert (u * Rabs (rest ah bh + fl (al + bl)) <= u * (u * S + (1 + u) * Q)) by (apply Rmult_le_compat_l; [unfold u |]; lra).
  pose proof (rounded_within _ _ _ l_near). split; [| split; [lra | unfold u in *; lra]].
  replace (s + l - (ah + al + (bh + bl))) with ((l - (rest ah bh + fl (al + bl))) + (fl (al + bl) - (al + bl))) by lra.
  apply Rle_trans with (1 := Rabs_triang _ _). unfold u in *; lra.
Qed.

Section Chains.

Variables h1 l1 x1 P1 h2 l2 x2 P2 h3 l3 x3 P3 : R.
Hypotheses (one : is_term h1 l1 x1 P1) (two : is_term h2 l2 x2 P2) (three : is_term h3 l3 x3 P3).
Let s := fl (h1 + h2).
Let l := fl (rest h1 h2 + fl (l1 + l2)).

(* Of two terms, and as tidy gives it. *)
Theorem determinant_error : Rabs (s + l - (x1 + x2)) <= 17 * u * u * (P1 + P2) + 100 * tiny /\ Rabs s <= (1 + 3 * u) * (P1 + P2) + 3 * tiny
  /\ Rabs l <= 42 / 10 * u * (P1 + P2) + 30 * tiny.
Proof.
  destruct one as (Dh1 & Dl1 & pos1 & e1 & s1 & z1). destruct two as (Dh2 & Dl2 & pos2 & e2 & s2 & z2). pose proof tiny_positive.
  destruct (loose_sum_of_loose h1 l1 h2 l2 ((1 + u) * (P1 + P2) + 2 * tiny) (301 / 100 * u * (P1 + P2) + 24 * tiny) Dh1 Dl1 Dh2 Dl2 ltac:(lra) ltac:(lra)) as (e & sz & lz).
  fold s l in e, sz, lz. split; [| split; unfold u in *; lra].
  replace (s + l - (x1 + x2)) with ((s + l - (h1 + l1 + (h2 + l2))) + (h1 + l1 - x1) + (h2 + l2 - x2)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). pose proof (Rabs_triang (s + l - (h1 + l1 + (h2 + l2))) (h1 + l1 - x1)). unfold u in *; lra.
Qed.

Corollary tidy_determinant_error : let high := fl (s + l) in let low := fl (l - fl (high - s)) in
  Rabs (high + low - (x1 + x2)) <= 2 * pair_unit * (P1 + P2) + 101 * tiny.
Proof.
  intros high low. destruct determinant_error as (e & _ & z). pose proof (tidy_error s l (fl_is_double _) (fl_is_double _)) as t. fold high low in t.
  assert (pair_unit = 16 * u * u) as -> by (unfold pair_unit, u; simpl; lra). destruct one as (_ & _ & pos1 & _). destruct two as (_ & _ & pos2 & _). pose proof tiny_positive.
  replace (high + low - (x1 + x2)) with ((high + low - (s + l)) + (s + l - (x1 + x2))) by ring. apply Rle_trans with (1 := Rabs_triang _ _). unfold u in *; lra.
Qed.

Let s' := fl (s + h3).
Let l' := fl (rest s h3 + fl (l + l3)).

Theorem dot_error : let high := fl (s' + l') in let low := fl (l' - fl (high - s')) in
  Rabs (high + low - (x1 + x2 + x3)) <= 3 * pair_unit * (P1 + P2 + P3) + 300 * tiny.
Proof.
  intros high low. destruct determinant_error as (e & sz & lz). destruct one as (_ & _ & pos1 & _). destruct two as (_ & _ & pos2 & _).
  destruct three as (Dh3 & Dl3 & pos3 & e3 & s3 & z3). pose proof tiny_positive.
  destruct (loose_sum_of_loose s l h3 l3 ((1 + 3 * u) * (P1 + P2 + P3) + 4 * tiny) (42 / 10 * u * (P1 + P2 + P3) + 42 * tiny)
    (fl_is_double _) (fl_is_double _) Dh3 Dl3 ltac:(unfold u in *; lra) ltac:(unfold u in *; lra)) as (e' & _ & lz'). fold s' l' in e', lz'.
  pose proof (tidy_error s' l' (fl_is_double _) (fl_is_double _)) as t. fold high low in t.
  assert (pair_unit = 16 * u * u) as -> by (unfold pair_unit, u; simpl; lra).
  replace (high + low - (x1 + x2 + x3)) with ((high + low - (s' + l')) + (s' + l' - (s + l + (h3 + l3))) + (s + l - (x1 + x2)) + (h3 + l3 - x3)) by ring.
  apply Rle_trans with (1 := Rabs_triang _ _). pose proof (Rabs_triang (high + low - (s' + l') + (s' + l' - (s + l + (h3 + l3)))) (s + l - (x1 + x2))).
  pose proof (Rabs_triang (high + low - (s' + l')) (s' + l' - (s + l + (h3 + l3)))). unfold u in *; lra.
Qed.
End Chains.

Print Assumptions product_of_pairs.
Print Assumptions tidy_determinant_error.
Print Assumptions dot_error.
