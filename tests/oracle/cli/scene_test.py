"""`groundtruth scene`: what compiling a scene left out and chose, for people and as JSON."""

import json
import pathlib
import tempfile
import unittest

import program

# A house twice, the ground, a cell under it, an empty cell, and a constant.
SCENE = {"groundtruth": "scene/1", "shape": {"union": [
    {"box": [[0, 0, 0], [1, 1, 1]]}, {"halfspace": [0, 0, 1, 0]}, {"box": [[0, 0, 0], [1, 1, 1]]},
    {"box": [[0, 0, -2], [1, 1, -1]]}, {"box": [[0, 0, 1], [1, 1, 0.5]]}, "nothing"]}}


def left_out(scene):
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / "scene.json"
        file.write_text(json.dumps(scene))
        done = program.run("scene", str(file), "--json")
    assert done.returncode == 0, done.stderr
    [line] = done.stdout.splitlines()
    return json.loads(line)


class SceneCommand(unittest.TestCase):
    def test_counts_what_is_dropped(self):
        compiled = left_out(SCENE)
        counts = {one["what"]: one["count"] for one in compiled["left_out"]}
        self.assertEqual(compiled["half_spaces"], 25)
        self.assertEqual(compiled["convex_parts"], 2)
        for what in ("duplicates", "empty-cells", "buried-parts", "constants"):
            self.assertEqual(counts[what], 1, what)

    def test_builds_no_index_for_one_convex_cell(self):
        compiled = left_out({"groundtruth": "scene/1", "shape": {"box": [[0, 0, 0], [1, 1, 1]]}})
        counts = {one["what"]: one["count"] for one in compiled["left_out"]}
        self.assertEqual(counts, {"known-materials": 1, "hierarchy": 0, "written-solid": 6})

    def test_says_why_for_every_built_in_scene(self):
        done = program.run("scene")
        self.assertEqual(done.returncode, 0, done.stderr)
        for scene in ("house", "runway", "town", "hills", "ramp", "degenerate:0", "nested:0", "far-town"):
            self.assertRegex(done.stdout, rf"(?m)^{scene}: \d+ half-spaces; .*\n  \S+ +\d+  \S")
        self.assertRegex(done.stdout, r"(?m)^  hierarchy +1000  parts in a hierarchy of boxes")

    def test_a_bad_scene_is_named(self):
        done = program.run("scene", "/nowhere.json")
        self.assertEqual(done.returncode, 3)
        self.assertIn("/nowhere.json", done.stderr)


if __name__ == "__main__":
    program.main()
