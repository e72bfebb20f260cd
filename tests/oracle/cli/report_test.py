"""`groundtruth report`: its page, the files behind it, and what --compare exits with."""

import csv
import html.parser
import json
import pathlib
import re
import tempfile
import unittest
import xml.etree.ElementTree

import program

SVG = "{http://www.w3.org/2000/svg}"


class Page(html.parser.HTMLParser):
    """What the page would fetch, and what it links to within itself."""

    def __init__(self):
        super().__init__()
        self.sources, self.ids, self.links, self.scripts = [], set(), [], 0

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("src", "href", "data", "poster", "srcset"):
                (self.links if tag == "a" else self.sources).append(value)
            if name == "id":
                self.ids.add(value)
        self.scripts += tag == "script"


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = pathlib.Path(cls.folder.name, "report")
        cls.done = program.run("report", "--quick", "--out", str(cls.out), "--json")
        assert cls.done.returncode == 0, cls.done.stderr
        cls.page = (cls.out / "report.html").read_text()
        cls.json = json.loads((cls.out / "report.json").read_text())

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def study(self, name):
        [study] = [study for study in self.json["studies"] if study["study"] == name]
        return {tier["tier"]: tier for tier in study["tiers"]}

    def test_page_is_small_well_formed_and_alone(self):
        self.assertLess(len(self.page.encode()), 1_000_000)
        xml.etree.ElementTree.fromstring(self.page.replace("<!DOCTYPE html>", ""))
        page = Page()
        page.feed(self.page)
        self.assertEqual(page.sources, [])
        self.assertEqual(page.scripts, 0)
        for link in page.links:
            self.assertIn(link.removeprefix("#"), page.ids)
        self.assertNotRegex(self.page, r"@import|url\(")

    def test_figures_can_be_read_aloud_and_say_where_they_come_from(self):
        root = xml.etree.ElementTree.fromstring(self.page.replace("<!DOCTYPE html>", ""))
        charts = list(root.iter(SVG + "svg"))
        self.assertGreaterEqual(len(charts), 16)
        for chart in charts:
            self.assertEqual(chart.get("role"), "img")
            self.assertTrue(chart.get("aria-label"))
        captions = [text for text in re.findall(r"<figcaption>(.*?)</figcaption>", self.page, re.DOTALL)]
        self.assertEqual(len(captions), len(charts))
        for caption in captions:
            self.assertIn("Seed 1; ", caption)
            self.assertIn("-ffp-contract=off", caption)

    def test_every_tier_is_there_or_says_why_not(self):
        for study in self.json["studies"]:
            self.assertEqual(len(study["tiers"]), 13, study["study"])
            for tier in study["tiers"]:
                self.assertTrue("omitted" in tier or tier["asks"] > 0, (study["study"], tier))
        omissions = [omission["what"] for omission in self.json["omissions"]]
        self.assertIn("cgal-lazy on clip asks", omissions)

    def test_fast_is_exact_and_on_the_front_of_all_that_is_hostile(self):
        for study in self.json["studies"]:
            [fast] = [tier for tier in study["tiers"] if tier["tier"] == "fast"]
            self.assertEqual((fast["wrong"], fast["undecided"]), (0, 0), study["study"])
            self.assertLessEqual(fast["worst_ulps"], 0.5, study["study"])
            if study["study"].endswith("hostile"):
                self.assertEqual(fast["on_front"], "yes", study["study"])

    def test_floats_are_wrong_where_asks_are_hostile(self):
        self.assertGreater(self.study("far-town/entry/hostile")["float"]["wrong"], 0)

    def test_worst_asks_can_be_asked_again(self):
        worst = self.study("town/entry/hostile")["double"]["worst"]
        shown = program.run("check", "--seed", "1", "--show", f"town:{worst['part']}:{worst['index']}").stdout
        ask = json.loads(shown.splitlines()[1])
        self.assertEqual((ask["from"], ask["to"]), (worst["ask"]["from"], worst["ask"]["to"]))

    def test_leaving_out_changes_no_answer(self):
        self.assertEqual({worth["same_answers"] for worth in self.json["left_out"]}, {"yes"})
        self.assertGreater(len(self.json["left_out"]), 8)

    def test_stable_integrators_gain_where_steps_are_shorter(self):
        runs = [run for run in self.json["trajectories"] if run["motion"] == "smooth sliding" and run["stiffness"] == 1
                and run["integrator"] == "half-kick" and run["relocation"] == "return-mapping"]
        runs.sort(key=lambda run: run["h"])
        self.assertLess(runs[0]["error_m"], runs[-1]["error_m"])

    def test_files_stand_beside_the_page(self):
        for name in ("tiers.csv", "left-out.csv", "trajectories.csv"):
            with open(self.out / name, newline="") as file:
                self.assertGreater(len(list(csv.DictReader(file))), 8, name)
        for picture in self.out.glob("*.svg"):
            xml.etree.ElementTree.parse(picture)
        self.assertGreaterEqual(len(list(self.out.glob("*.svg"))), 16)
        self.assertEqual(json.loads(self.done.stdout), self.json)

    def test_compare_exits_with_1_past_the_threshold(self):
        older = pathlib.Path(self.folder.name, "older.json")
        better = json.loads(json.dumps(self.json))
        [fast] = [tier for study in better["studies"] if study["study"] == "house/entry/ordinary"
                  for tier in study["tiers"] if tier["tier"] == "fast"]
        fast["ns"] = [number / 1000 for number in fast["ns"]]
        older.write_text(json.dumps(better))
        other = str(pathlib.Path(self.folder.name, "other"))
        done = program.run("report", "--quick", "--out", other, "--compare", str(older))
        self.assertEqual(done.returncode, 1)
        self.assertIn("house/entry/ordinary fast: time relative to double", done.stdout)

    def test_compare_says_what_is_wrong_with_a_file(self):
        broken = pathlib.Path(self.folder.name, "broken.json")
        broken.write_text('{"groundtruth": "report/2"}')
        done = program.run("report", "--out", str(self.out), "--compare", str(broken))
        self.assertEqual(done.returncode, 3)
        self.assertIn("broken.json:1: groundtruth: is not \"report/1\"", done.stderr)
        self.assertEqual(program.run("report", "--out", str(self.out), "--compare", "nowhere.json").returncode, 3)

    def test_usage(self):
        self.assertEqual(program.run("report").returncode, 2)
        self.assertEqual(program.run("report", "--out", "x", "--threshold", "-1").returncode, 2)


if __name__ == "__main__":
    program.main()
