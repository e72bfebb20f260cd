"""What run_lemma.py lets pass, refuses and skips. Itself skipped where coqc, gappa or z3 is missing."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

RUN_LEMMA = pathlib.Path(__file__).with_name("run_lemma.py")
PROVED, NOT_PROVED, SKIPPED = 0, 1, 77

TRUE_COQ = "Theorem one : 1 = 1. Proof. reflexivity. Qed.\nPrint Assumptions one.\n"


class RunLemma(unittest.TestCase):
    def verdict(self, name, text, environment=None):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / name
            file.write_text(text)
            run = subprocess.run([sys.executable, str(RUN_LEMMA), str(file), folder + "/build"], env=environment,
                                 stdout=subprocess.PIPE, text=True)
            return run.returncode

    def test_a_closed_theorem_is_proved(self):
        self.assertEqual(self.verdict("one.v", TRUE_COQ), PROVED)

    def test_a_false_theorem_is_not(self):
        self.assertEqual(self.verdict("one.v", TRUE_COQ.replace("1 = 1", "1 = 2")), NOT_PROVED)

    def test_words_that_give_up_are_refused_but_not_in_comments(self):
        given_up = "Theorem two : 1 = 2. Admitted.\n"
        self.assertEqual(self.verdict("one.v", TRUE_COQ + given_up), NOT_PROVED)
        self.assertEqual(self.verdict("one.v", TRUE_COQ + f"(* {given_up} *)"), PROVED)

    def test_an_assumption_is_refused(self):
        assumed = "Axiom magic : 1 = 2.\nTheorem two : 1 = 2. exact magic. Qed.\nPrint Assumptions two.\n"
        for word in ("Axiom", "Parameter", "Hypothesis", "Variable", "Context"):
            self.assertEqual(self.verdict("one.v", assumed.replace("Axiom", word)), NOT_PROVED, word)

    def test_the_axioms_of_the_real_numbers_are_let_pass(self):
        text = ("Require Import Reals Lra.\nTheorem t : forall x : R, (x < x + 1)%R. intros; lra. Qed.\n"
                "Print Assumptions t.\n")
        self.assertEqual(self.verdict("reals.v", text), PROVED)

    def test_a_file_that_shows_no_assumptions_is_refused(self):
        self.assertEqual(self.verdict("one.v", "Theorem one : 1 = 1. reflexivity. Qed.\n"), NOT_PROVED)

    def test_gappa_must_reach_its_goal(self):
        self.assertEqual(self.verdict("sum.g", "{ x in [0,1] -> x + 1 in [1,2] }\n"), PROVED)
        self.assertEqual(self.verdict("sum.g", "{ x in [0,1] -> x + 1 in [1,1.5] }\n"), NOT_PROVED)

    def test_solvers_must_answer_the_status_that_stands_before(self):
        text = "(declare-const x Real)\n(assert (< x x))\n(check-sat)\n"
        self.assertEqual(self.verdict("less.smt2", text), PROVED)
        self.assertEqual(self.verdict("less.smt2", text.replace("< x x", "<= x x")), NOT_PROVED)
        self.assertEqual(self.verdict("less.smt2", "(set-info :status sat)\n" + text), NOT_PROVED)
        self.assertEqual(self.verdict("less.smt2", text.replace("(check-sat)", "")), NOT_PROVED)

    def test_without_the_tool_a_lemma_is_skipped(self):
        without_tools = {**os.environ, "PATH": "/nonexistent"}
        for name, text in (("one.v", TRUE_COQ), ("sum.g", ""), ("less.smt2", "")):
            self.assertEqual(self.verdict(name, text, without_tools), SKIPPED)


if __name__ == "__main__":
    if not all(map(shutil.which, ("coqc", "gappa", "z3"))):
        sys.exit(SKIPPED)
    unittest.main()
