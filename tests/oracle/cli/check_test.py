"""`groundtruth check`: small runs of the main job, its table, its JSON, and its replay."""

import json
import pathlib
import tempfile
import unittest

import program


class Check(unittest.TestCase):
    def test_the_witnesses_agree_on_every_built_in_scene(self):
        done = program.run("check", "--cases", "1600", "--jobs", "2")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("exact, definition and fast agree", done.stdout)
        for scene in ("house", "runway", "town", "hills", "ramp", "degenerate"):
            self.assertIn(f"\n{scene} (", done.stdout)
        self.assertEqual(done.stderr, "", "a progress bar is for terminals")

    def test_json_counts_what_was_asked(self):
        done = program.run("check", "--cases", "301", "--scene", "house", "--scene", "ramp", "--json")
        rows = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(sum(row["asks"] for row in rows if row["engine"] == "exact"), 301)
        self.assertEqual({row["engine"] for row in rows}, {"exact", "definition", "fast", "double", "as-written"})
        for row in rows:
            if row["engine"] in ("exact", "definition", "fast"):
                self.assertEqual(sum(row["disagreements"].values()), 0)
            if row["engine"] == "as-written":
                self.assertGreater(sum(row["disagreements"].values()), 0, "the check sees nothing")

    def test_the_same_seed_gives_the_same_counts(self):
        def counts(seed):
            done = program.run("check", "--cases", "300", "--scene", "house", "--seed", seed, "--json")
            return [(json.loads(line)["disagreements"], json.loads(line)["worst_force"]) for line in
                    done.stdout.splitlines()]
        self.assertEqual(counts("5"), counts("5"))
        self.assertNotEqual(counts("5"), counts("6"))

    def test_show_prints_lines_that_answer_understands(self):
        shown = program.run("check", "--seed", "3", "--show", "degenerate:4:17")
        [answer] = program.answers(shown.stdout)
        self.assertEqual(answer["id"], "degenerate:4:17")
        for wrong, exit_code in (("degenerate", 2), ("degenerate:400:1", 2), ("degenerate:a:b", 2), ("nowhere:0:0", 3)):
            self.assertEqual(program.run("check", "--show", wrong).returncode, exit_code, wrong)

    def test_a_scene_of_the_users(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = pathlib.Path(folder) / "mine.json"
            scene.write_text('{"groundtruth": "scene/1", "shape": {"box": [[0, 0, 0], [1, 1, 1]]}}')
            done = program.run("check", "--cases", "200", "--scene", str(scene))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("(6 leaves)", done.stdout)
            shown = program.run("check", "--show", f"{scene}:0:5")
            self.assertEqual(len(program.answers(shown.stdout)), 1)
        self.assertEqual(program.run("check", "--scene", "/nowhere.json").returncode, 3)


if __name__ == "__main__":
    program.main()
