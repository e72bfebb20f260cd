(* Lemma sign-by-squares (proofs-notes/wheel.md, section 2): the sign of a + b sqrt A + c sqrt D from signs of
   sums and products of a, b, c, A, D alone. *)

From Coq Require Import Reals Psatz.
From Flocq Require Import Core.Raux.
Open Scope R_scope.

Definition sign (x : R) : comparison := Rcompare x 0.

(* The sign of p + q, from those of p, q and p^2 - q^2. *)
Definition sign_of_sum (p q squares : comparison) : comparison :=
  match p, q with
  | _, Eq => p
  | Eq, _ => q
  | Gt, Gt => Gt
  | Lt, Lt => Lt
  | Gt, Lt => squares
  | Lt, Gt => CompOpp squares
  end.

Definition sign_of_one_root a b A := sign_of_sum (sign a) (sign (b * A)) (sign (a * a - b * b * A)).

Definition sign_of_two_roots a b A c D :=
  sign_of_sum (sign_of_one_root a b A) (sign (c * D))
              (sign_of_one_root (a * a + b * b * A - c * c * D) (2 * a * b) A).

Lemma sign_cases : forall x, (x < 0 /\ sign x = Lt) \/ (x = 0 /\ sign x = Eq) \/ (0 < x /\ sign x = Gt).
Proof. intros x; unfold sign; destruct (Rcompare_spec x 0); auto. Qed.

Lemma sign_of_negative : forall x, x < 0 -> sign x = Lt.
Proof. intros; now apply Rcompare_Lt. Qed.
Lemma sign_of_positive : forall x, 0 < x -> sign x = Gt.
Proof. intros; now apply Rcompare_Gt. Qed.
Lemma sign_of_zero : forall x, x = 0 -> sign x = Eq.
Proof. intros; now apply Rcompare_Eq. Qed.

Lemma sum_by_squares : forall p q, sign (p + q) = sign_of_sum (sign p) (sign q) (sign (p * p - q * q)).
Proof.
  intros p q.
  destruct (sign_cases p) as [[Hp ->] | [[Hp ->] | [Hp ->]]];
    destruct (sign_cases q) as [[Hq ->] | [[Hq ->] | [Hq ->]]];
    destruct (sign_cases (p * p - q * q)) as [[Hs ->] | [[Hs ->] | [Hs ->]]]; simpl;
    (apply sign_of_negative; nra) || (apply sign_of_positive; nra) || (apply sign_of_zero; nra).
Qed.

Lemma sign_of_root_term : forall b A, 0 <= A -> sign (b * sqrt A) = sign (b * A).
Proof.
  intros b A HA.
  pose proof (sqrt_sqrt A HA) as square; pose proof (sqrt_pos A) as positive.
  destruct (Req_dec A 0) as [-> | nonzero].
  - rewrite sqrt_0; reflexivity.
  - assert (0 < sqrt A) by (apply sqrt_lt_R0; lra).
    destruct (sign_cases b) as [[Hb _] | [[Hb _] | [Hb _]]].
    + rewrite !sign_of_negative; auto; nra.
    + subst b; rewrite !Rmult_0_l; reflexivity.
    + rewrite !sign_of_positive; auto; nra.
Qed.

Theorem one_root_by_squares : forall a b A, 0 <= A -> sign (a + b * sqrt A) = sign_of_one_root a b A.
Proof.
  intros a b A HA; unfold sign_of_one_root.
  rewrite sum_by_squares, sign_of_root_term by assumption.
  replace (b * sqrt A * (b * sqrt A)) with (b * b * A); [reflexivity |].
  rewrite <- (sqrt_sqrt A HA) at 1; ring.
Qed.

Theorem two_roots_by_squares : forall a b A c D, 0 <= A -> 0 <= D ->
  sign (a + b * sqrt A + c * sqrt D) = sign_of_two_roots a b A c D.
Proof.
  intros a b A c D HA HD; unfold sign_of_two_roots.
  rewrite sum_by_squares, one_root_by_squares, sign_of_root_term by assumption.
  rewrite <- (one_root_by_squares (a * a + b * b * A - c * c * D) (2 * a * b) A HA).
  replace ((a + b * sqrt A) * (a + b * sqrt A) - c * sqrt D * (c * sqrt D))
    with (a * a + b * b * A - c * c * D + 2 * a * b * sqrt A); [reflexivity |].
  transitivity (a * a + b * b * (sqrt A * sqrt A) - c * c * (sqrt D * sqrt D) + 2 * a * b * sqrt A);
    [now rewrite (sqrt_sqrt A HA), (sqrt_sqrt D HD) | ring].
Qed.

Print Assumptions one_root_by_squares.
Print Assumptions two_roots_by_squares.
