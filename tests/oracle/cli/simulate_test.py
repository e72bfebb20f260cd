"""`groundtruth simulate`: scenarios by name and from files, their summary, CSV and SVG."""

import csv
import json
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree

import program

SCENARIO = {
    "groundtruth": "scenario/1",
    "machine": {"mass": 1200, "inertia": None, "wheels": [{"place": [0, 0, 0.3], "wheel": {
        "k_xy": -7e5, "k_z": -7e5, "d_xy": -2e4, "d_z": -2e4, "z_min": 0.2, "z_zero": 0.8, "z_max": 0.8,
        "tyre": "rubber"}}]},
    "start": {"position": [0, 0, 1.2], "orientation": [0, 1, 0, 0]},
    "scene": "ground.json",
    "inputs": {"brake": 1000},
    "h": 0.005, "duration": 2,
}
GROUND = {"groundtruth": "scene/1", "materials": {"dry": {"friction": {"rubber": {"static": 0.5, "dynamic": 0.4}}}},
          "shape": {"material": "dry", "shape": {"halfspace": [0, 0, 1, 0]}}}


def summary(*arguments):
    done = program.run("simulate", *arguments, "--json")
    assert done.returncode == 0, done.stderr
    [line] = done.stdout.splitlines()
    return json.loads(line)


class Simulate(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def file(self, name, content=None):
        path = pathlib.Path(self.folder.name) / name
        if content is not None:
            path.write_text(content if isinstance(content, str) else json.dumps(content))
        return str(path)

    def scenario(self, **changes):
        self.file("ground.json", GROUND)
        return self.file("run.json", {**SCENARIO, **changes})

    def test_a_built_in_scenario_stands_still(self):
        result = summary("parked-5", "--duration", "60")
        self.assertEqual(result["outcome"], "ok")
        self.assertEqual(result["pebble_drift_m"], 0)
        self.assertEqual(result["steps"], 14400)
        self.assertEqual(sum(result["wheel_steps"].values()), 3 * 14400)

    def test_a_file_with_a_scene_beside_it(self):
        result = summary(self.scenario())
        self.assertEqual((result["scenario"], result["outcome"], result["steps"]), ("run", "ok", 400))
        self.assertGreater(result["wheel_steps"]["free"], 10)
        self.assertGreater(result["wheel_steps"]["stick"], 200)

    def test_options_override_the_scenario(self):
        result = summary("stop-one", "--h", "0.01", "--duration", "1", "--integrator", "implicit")
        self.assertEqual((result["steps"], result["h"], result["integrator"]), (100, 0.01, "implicit"))
        self.assertGreater(result["most_convex_passes"], 0)
        self.assertNotEqual(summary("stop-dry", "--duration", "1", "--relocation", "return-mapping"),
                            summary("stop-dry", "--duration", "1", "--relocation", "spring"))

    def test_engines_agree(self):
        fast, exact = (summary("land-3", "--duration", "0.5", "--engine", engine) for engine in ("fast", "exact"))
        self.assertEqual(fast, exact)

    def test_a_halt_is_an_outcome(self):
        result = summary("overload")
        self.assertEqual((result["outcome"], result["halting_wheel"]), ("wheel_broken", 0))
        done = program.run("simulate", "soft")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"outcome +the ground gave way under wheel \d")

    def test_repetitions_are_skipped_unless_asked_for(self):
        skipped = summary("parked-one-5", "--duration", "100")
        played = summary("parked-one-5", "--duration", "100", "--every-step")
        self.assertEqual(skipped.pop("recurrence")["period"], 1)
        self.assertEqual(skipped, played)

    def test_csv_has_a_row_every_so_many_steps(self):
        table = self.file("run.csv")
        summary("land-3", "--duration", "1", "--csv", table, "--every", "10")
        with open(table, newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 24)
        self.assertAlmostEqual(float(rows[0]["time"]), 10 / 240)
        self.assertEqual(rows[0]["wheel0_state"], "free")
        self.assertEqual(rows[0]["wheel0_pebble_x"], "")
        self.assertIn("slip", {row["wheel2_state"] for row in rows})
        self.assertGreater(max(float(row["wheel1_force_z"]) for row in rows), 10000)

    def test_plot_is_an_svg_of_a_panel_a_quantity_and_a_wheel(self):
        picture = self.file("run.svg")
        summary("land-3", "--plot", picture)
        root = xml.etree.ElementTree.parse(picture).getroot()
        titles = [text.text for text in root.iter("{http://www.w3.org/2000/svg}text")]
        for title in ("height of the centre of mass, m", "speed, m/s", "energy, kJ", "wheel 2, kN", "time, s"):
            self.assertIn(title, titles)

    def test_without_a_name_it_lists_the_built_in_ones(self):
        done = program.run("simulate")
        self.assertEqual(done.returncode, 0)
        for name in ("parked-5", "slide", "tilt", "stop-dry", "land-6", "edge", "soft"):
            self.assertRegex(done.stdout, rf"(?m)^{name} +\S")

    def test_mistakes_are_named(self):
        for arguments, code, words in (
                (("/nowhere.json",), 3, "/nowhere.json"),
                ((self.scenario(h=-1),), 3, "run.json:1: h: -1 is not > 0"),
                ((self.file("bad.json", "{"),), 3, "bad.json:1"),
                (("parked-5", "--engine", "abacus"), 2, "abacus"),
                (("parked-5", "--h", "0"), 2, "--h"),
                (("parked-5", "--h", "nan"), 2, "--h"),
                (("parked-5", "--h", "1e-300"), 2, "2^53"),
                (("parked-5", "--duration", "-1"), 2, "--duration"),
                (("parked-5", "--integrator", "euler"), 2, "--integrator"),
                (("parked-5", "--csv", "/nowhere/run.csv"), 3, "/nowhere/run.csv")):
            done = program.run("simulate", *arguments)
            self.assertEqual(done.returncode, code, (arguments, done.stderr))
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    program.main()
