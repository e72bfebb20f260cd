"""`groundtruth stability --quick`: maps for people, as CSV and as a picture, and the extremes."""

import csv
import pathlib
import tempfile
import unittest
import xml.etree.ElementTree

import program

FATES = {"settled", "swinging", "creeping", "chattering", "blown up", "gave a reason"}


class StabilityCommand(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            table, picture = pathlib.Path(folder) / "maps.csv", pathlib.Path(folder) / "maps.svg"
            cls.done = program.run("stability", "--quick", "--csv", str(table), "--svg", str(picture))
            cls.rows = list(csv.DictReader(table.read_text().splitlines()))
            cls.picture = xml.etree.ElementTree.parse(picture).getroot()

    def test_no_number_is_other_than_finite(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)

    def test_explicit_machines_stand_up_to_the_limit_only(self):
        explicit = [row for row in self.rows if row["integrator"] != "implicit"]
        self.assertEqual(len(explicit), 8 * 3 * 15)
        for row in explicit:
            is_below = float(row["h_omega"]) < float(row["limit"])
            self.assertEqual(row["fate"] in ("settled", "swinging"), is_below, row)

    def test_implicit_machines_stand_at_a_thousand_times_it(self):
        implicit = [row for row in self.rows if row["integrator"] == "implicit" and float(row["h_omega"]) < 2000]
        self.assertEqual({row["fate"] for row in implicit}, {"settled"})
        self.assertEqual({row["limit"] for row in implicit}, {""})

    def test_the_picture_has_a_legend_and_twelve_panels(self):
        texts = [text.text for text in self.picture.iter("{http://www.w3.org/2000/svg}text")]
        self.assertLessEqual(FATES, set(texts))
        self.assertEqual(sum(text.endswith((", spring", ", return-mapping")) for text in texts), 12)

    def test_every_extreme_is_listed(self):
        for words in ("mass 600 t", "k 1e12 N/m", "h 1 us", "h 1/15 s", "slope 9.99", "6.4e6 m", "friction 10",
                      "brake 1e300 N", "subnormal forces", "sink 20 m/s"):
            self.assertIn(words, self.done.stdout)


if __name__ == "__main__":
    program.main()
