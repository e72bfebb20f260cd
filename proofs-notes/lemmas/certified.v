(* Lemma 7, first half: a procedure that takes only decisions whose certificate holds, and the exact ones
   otherwise, returns what the exact procedure returns (proofs-notes/scene-rewriting.md, 1).

   A procedure is all that it may ask, and what it does with each reply; its data are in the questions. *)

From Coq Require Import List Bool.
Import ListNotations.
Set Implicit Arguments.

Section Certified.
Variables Question Result : Type.

Inductive procedure : Type :=
| Answer (result : Result)
| Decide (question : Question) (next : bool -> procedure).

Variable exact : Question -> bool.

(* A stage decides, or says that it cannot; it is certified if what it decides is so. *)
Definition stage := Question -> option bool.
Definition certified (s : stage) : Prop := forall question reply, s question = Some reply -> exact question = reply.

Fixpoint run (decide : Question -> bool) (p : procedure) : Result :=
  match p with
  | Answer result => result
  | Decide question next => run decide (next (decide question))
  end.

(* Gives up at the first decision that the stage cannot take. *)
Fixpoint attempt (s : stage) (p : procedure) : option Result :=
  match p with
  | Answer result => Some result
  | Decide question next => match s question with Some reply => attempt s (next reply) | None => None end
  end.

(* The first stage that can decides; exact arithmetic if none can. *)
Fixpoint staged (stages : list stage) (question : Question) : bool :=
  match stages with
  | [] => exact question
  | s :: rest => match s question with Some reply => reply | None => staged rest question end
  end.

Theorem attempt_is_exact s p result : certified s -> attempt s p = Some result -> run exact p = result.
Proof.
  intros sound. induction p as [given | question next IH]; simpl; [congruence |].
  destruct (s question) as [reply |] eqn:decided; [| easy].
  intros finished. rewrite (sound question reply decided). now apply IH.
Qed.

Theorem staged_decisions_are_exact stages : Forall certified stages -> forall p, run (staged stages) p = run exact p.
Proof.
  intros sound. assert (same : forall question, staged stages question = exact question).
  { intros question. induction sound as [| s rest certified_s _ IH]; simpl; trivial.
    destruct (s question) as [reply |] eqn:decided; trivial. symmetry. now apply certified_s. }
  induction p as [given | question next IH]; simpl; trivial. rewrite same. apply IH.
Qed.

(* The procedure may be any other than that of the definition, if only its exact decisions lead to Phi. *)
Corollary certified_procedure_returns_phi (phi : Result) s p : certified s -> run exact p = phi ->
  match attempt s p with Some result => result | None => phi end = phi.
Proof.
  intros sound right. destruct (attempt s p) as [result |] eqn:finished; trivial.
  now rewrite <- right, (attempt_is_exact p sound finished).
Qed.
End Certified.

Print Assumptions attempt_is_exact.
Print Assumptions staged_decisions_are_exact.
Print Assumptions certified_procedure_returns_phi.
