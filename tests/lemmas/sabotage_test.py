"""What the proofs would not let pass: a constant of a filter lowered by 1 %, a rewriting rule without its side
condition, a wrong sign in Q. sabotage_test.py BUILD_FOLDER; skipped where coqc is missing.
"""

import pathlib
import re
import shutil
import sys
import tempfile
import unittest

import constants_test
import run_lemma

LEMMAS = run_lemma.LEMMAS
BUILD = pathlib.Path(sys.argv.pop())


def sources_pass():
    suite = unittest.defaultTestLoader.loadTestsFromTestCase(constants_test.Constants)
    return suite.run(unittest.TestResult()).wasSuccessful()


def is_proved(lemma, before, after):
    """Of a lemma file with a passage changed, under a name of its own so that others may be proved meanwhile."""
    file = LEMMAS / lemma
    text = file.read_text()
    assert text.count(before) == 1, f"{lemma}: {before} stands there {text.count(before)} times"
    with tempfile.TemporaryDirectory() as folder:
        changed = pathlib.Path(folder) / f"sabotaged_{file.name}"
        changed.write_text(text.replace(before, after))
        return run_lemma.main(changed, BUILD) == run_lemma.PROVED


class Sabotage(unittest.TestCase):
    def test_nothing_is_wrong_with_what_is_there(self):
        self.assertTrue(sources_pass())
        self.assertTrue(is_proved("numbers/surface.v", "Definition X := ", "Definition X :=  "))

    def test_a_constant_lowered_by_one_percent_is_seen(self):
        for source, around, _, name in constants_test.CONSTANTS:
            with self.subTest(source=source, name=name), tempfile.TemporaryDirectory() as folder:
                root = pathlib.Path(folder)
                shutil.copytree(constants_test.ROOT / "fast", root / "fast")
                text = constants_test.one_space((root / source).read_text())
                [start, end] = re.search(around, text).span(1)
                lowered = (0.99 * float.fromhex(text[start:end])).hex()
                (root / source).write_text(text[:start] + lowered + text[end:])
                there, constants_test.ROOT = constants_test.ROOT, root
                try:
                    self.assertFalse(sources_pass())
                finally:
                    constants_test.ROOT = there
                print(f"seen: {source}: {name} lowered from {text[start:end]} to {lowered}")

    def test_a_rewriting_rule_needs_its_side_condition(self):
        rules = [("a cell that is not empty", "(forall p, ~ member (cell hs) p) ->\n", "True ->\n"),
                 ("a cell that only touches its ground", "member (cell hs) p -> local_shape.delta g p < 0",
                  "member (cell hs) p -> local_shape.delta g p <= 0"),
                 ("a half-space that the others only touch",
                  "(forall p, member (cell (before ++ after)) p -> local_shape.delta h p < 0) ->\n  alike",
                  "(forall p, member (cell (before ++ after)) p -> local_shape.delta h p <= 0) ->\n  alike")]
        for what, condition, without in rules:
            with self.subTest(what):
                self.assertFalse(is_proved("simplifications.v", condition, without))
                print(f"refused: leaving out {what}")

    def test_each_sign_in_q_matters(self):
        for right, wrong in [("V (- z / r) 0 (x / r)", "V (z / r) 0 (x / r)"),
                             ("V (- z / r) 0 (x / r)", "V (- z / r) 0 (- x / r)"),
                             ("V (- x * y / (r * l))", "V (x * y / (r * l))"),
                             ("(- y * z / (r * l))", "(y * z / (r * l))"),
                             ("Z := V (- x / l) (- y / l) (- z / l)", "Z := V (- x / l) (y / l) (- z / l)")]:
            with self.subTest(wrong):
                self.assertFalse(is_proved("numbers/surface.v", right, wrong))
                print(f"refused: {wrong} for {right}")


if __name__ == "__main__":
    if not shutil.which("coqc"):
        print("coqc is not installed: .ci/install-dependencies --with-proofs")
        sys.exit(run_lemma.SKIPPED)
    unittest.main()
