"""`groundtruth explain`: a page of text, a page of HTML, and one line for what cannot be explained."""

import json
import pathlib
import tempfile
import unittest

import program

SEAM = "seam/across-it-from-the-rim"
CHAIN = pathlib.Path(__file__).resolve().parents[1] / "page" / "lift-off.jsonl"


class Explain(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def explained(self, *arguments):
        done = program.run("explain", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_text_names_faces_engines_and_the_way_back(self):
        text = self.explained(SEAM)
        for words in ("Faces that meet there", "How near another decision is", "definition", "as-written:normal-by-order",
                      f"groundtruth explain {SEAM}"):
            self.assertIn(words, text)
        self.assertNotIn("\x1b", text)

    def test_every_engine_but_those_with_errors_agrees(self):
        text = self.explained(SEAM)
        for engine in ("exact", "definition", "fast"):
            self.assertRegex(text, rf"(?m)^  {engine} +the same$")

    def test_the_exact_answer_of_a_miss_bears_no_lambda(self):
        text = self.explained("grazing/one-ulp-above")
        self.assertIn("misses the solid", text)
        self.assertNotIn("nearest double", text)
        self.assertIn("with its offset raised by", text)

    def test_a_scene_given_apart_is_the_asks_scene(self):
        (self.path / "asks.jsonl").write_text(json.dumps({"id": 1, "ask": "entry", "from": [0, 0, 3], "to": [0, 0, -1]}) + "\n")
        (self.path / "ground.json").write_text('{"groundtruth": "scene/1", "shape": {"halfspace": [0, 0, 1, 0]}}')
        asks = str(self.path / "asks.jsonl")
        self.assertIn("misses the solid", self.explained(asks))
        self.assertIn("lambda = 3/4, on leaf 0", self.explained(asks, "--scene", str(self.path / "ground.json")))

    def test_a_page_needs_no_other_file(self):
        page = self.path / "page.html"
        self.assertEqual(self.explained(str(CHAIN), "--html", str(page)), "")
        text = page.read_text()
        self.assertLess(len(text), 1_000_000)
        self.assertEqual(text.count('<section class="case"'), 5)
        self.assertNotRegex(text, r'(src|href)="(?!#)')
        self.assertNotIn("url(", text)

    def test_an_implementations_answer_stands_beside_the_exact_one(self):
        theirs = [program.PROGRAM, "answer", "--engine", "as-written"]
        text = self.explained("seam/inside-it", "--implementation", "--", *theirs)
        self.assertRegex(text, r"(?m)^  yours.* differs in ")
        same = self.explained("seam/inside-it", "--implementation", "--", program.PROGRAM, "answer")
        self.assertRegex(same, r"(?m)^  yours.* the same$")

    def test_what_cannot_be_explained_is_told_in_one_line(self):
        for arguments, code in (
            (("/nowhere",), 3),
            ((SEAM, "--scene", "/nowhere"), 3),
            ((SEAM, "--html", "/nowhere/page.html"), 3),
            ((SEAM, "--implementation"), 2),
            ((SEAM, "--implementation", "--", "/nowhere"), 3),
            ((), 2),
        ):
            done = program.run("explain", *arguments)
            self.assertEqual(done.returncode, code, arguments)
            if code == 3:
                self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)


if __name__ == "__main__":
    program.main()
