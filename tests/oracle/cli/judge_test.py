"""`groundtruth judge` and `groundtruth vectors`: what was written is accepted; what is planted is found."""

import json
import pathlib
import tempfile
import unittest

import program


class Judge(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)
        self.assertEqual(program.run("vectors", "--out", str(self.path)).returncode, 0)
        self.answers = (self.path / "answers.jsonl").read_text().splitlines()

    def judged(self, lines, *arguments):
        (self.path / "mine.jsonl").write_text("".join(line + "\n" for line in lines))
        return program.run("judge", str(self.path / "asks.jsonl"), str(self.path / "mine.jsonl"), *arguments)

    def test_the_vectors_answers_are_accepted_in_every_profile(self):
        for profile in ("exact", "double", "float", "game"):
            done = self.judged(self.answers, "--profile", profile)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_a_wrong_lambda_is_told(self):
        wrong = [line.replace('"lambda":0.25,', '"lambda":0.5,') for line in self.answers]
        done = self.judged(wrong)
        self.assertEqual(done.returncode, 1)
        self.assertIn("lambda 0.5 (0x1p-1) -> 1/4 (0x1p-2)", done.stdout)

    def test_missing_unreadable_and_no_answers(self):
        self.assertEqual(self.judged(self.answers[:-1]).returncode, 1)
        self.assertEqual(self.judged([]).returncode, 5)
        self.assertEqual(self.judged(["garbage", *self.answers[1:]]).returncode, 3)
        self.assertEqual(program.run("judge", "/nowhere", "/nowhere").returncode, 3)
        self.assertEqual(self.judged(self.answers, "--profile", "none").returncode, 2)

    def test_strict_wants_the_canonical_face(self):
        other = [line.replace('"leaf":5,"normal":[0,0,1]', '"leaf":11,"normal":[0,0,1]') if "along-the-top" in line
                 else line for line in self.answers]
        self.assertNotEqual(other, self.answers)
        self.assertEqual(self.judged(other).returncode, 0)
        self.assertEqual(self.judged(other, "--strict").returncode, 1)

    def test_json_has_a_line_an_ask_and_a_summary(self):
        rows = [json.loads(line) for line in self.judged(self.answers, "--json").stdout.splitlines()]
        *rows, last = rows
        self.assertEqual(len(rows), len(self.answers))
        self.assertEqual({row["verdict"] for row in rows}, {"accepted"})
        counts = {"accepted": len(rows), "wrong": 0, "skipped": 0, "unreadable": 0, "left_over": 0}
        self.assertEqual(last, {"summary": counts})

    def test_json_rows_bear_the_exact_answer(self):
        wrong = [line.replace('"lambda":0.25,', '"lambda":0.5,') for line in self.answers]
        *rows, last = [json.loads(line) for line in self.judged([*wrong, '{"id":"?","error":"?"}'], "--json").stdout.splitlines()]
        for row, answer in zip(rows, self.answers, strict=True):
            self.assertEqual({"id": row["id"], **row["exact"]}, json.loads(answer))
        changed = sum(one != other for one, other in zip(wrong, self.answers, strict=True))
        self.assertGreater(changed, 0)
        self.assertEqual((last["summary"]["wrong"], last["summary"]["left_over"]), (changed, 1))


if __name__ == "__main__":
    program.main()
