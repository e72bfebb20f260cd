"""`groundtruth vectors`: its files follow its own schema, and the schema refuses what is wrong."""

import copy
import json
import pathlib
import tempfile
import unittest

import program

try:
    import jsonschema
except ImportError:
    jsonschema = None


@unittest.skipUnless(jsonschema, "needs python3-jsonschema")
class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            if program.run("vectors", "--out", folder).returncode != 0:
                raise AssertionError("vectors failed")
            cls.schema = json.loads((path / "schema.json").read_text())
            cls.asks = [json.loads(line) for line in (path / "asks.jsonl").read_text().splitlines()]
            cls.answers = [json.loads(line) for line in (path / "answers.jsonl").read_text().splitlines()]

    def validator(self, line):
        return jsonschema.Draft202012Validator({"$defs": self.schema["$defs"], "$ref": f"#/$defs/{line}"})

    def test_is_a_schema(self):
        jsonschema.Draft202012Validator.check_schema(self.schema)

    def test_every_line_follows_it(self):
        for kind, lines in (("ask_line", self.asks), ("answer_line", self.answers)):
            validator = self.validator(kind)
            for line in lines:
                self.assertTrue(validator.is_valid(line), f"{kind}: {json.dumps(line)[:300]}")

    def test_no_line_bears_a_key_too_many_or_lacks_one(self):
        for kind, lines in (("ask_line", self.asks), ("answer_line", self.answers)):
            validator = self.validator(kind)
            for line in lines:
                self.assertFalse(validator.is_valid({**line, "extra": 1}), kind)
                needed = [key for key in line if key not in ("id", "range", "min_uprightness")]
                if kind == "answer_line":
                    needed.append("id")
                for key in needed:
                    lacking = {name: value for name, value in line.items() if name != key}
                    self.assertFalse(validator.is_valid(lacking), f"{kind} without {key}")

    def test_answers_of_no_known_kind_are_refused(self):
        validator = self.validator("answer_line")
        for line in self.answers:
            if "answer" not in line:
                continue
            other = copy.deepcopy(line)
            other["answer"]["kind" if "kind" in other["answer"] else "outcome"] = "perhaps"
            self.assertFalse(validator.is_valid(other), json.dumps(line))


if __name__ == "__main__":
    program.main()
