"""Thirty malformed scenes and asks, each with the one line it gets. Run by hand with --table to print them."""

import json
import sys
import unittest

import program

ENTRY = '{"id": 1, "ask": "entry", "from": [0, 0, 1], "to": [0, 0, -1]%s}'
CLIP = '{"id": 1, "ask": "clip", "force": [1, 2, 3], "normal": [0, 0, -1], "friction": %s, "brake": %s}'


def scene(shape, rest=""):
    return '{"scene": {"groundtruth": "scene/1", %s"shape": %s}}' % (rest, shape)


CASES = [
    (scene('{"union": ["nothing", {"halfspace": [0, 0, "high", 1]}]}'),
     'scene.shape.union[1].halfspace[2]: high is not a hex float ("0x1.8p+0")'),
    (scene('{"halfspace": [0, 0, 1e400, 1]}'), "scene.shape.halfspace[2]: 1e400 lies outside the range of doubles"),
    (scene('{"halfspace": [0, 0, 9007199254740993, 1]}'),
     "scene.shape.halfspace[2]: 9007199254740993 is an integer that no double equals"),
    (scene('{"halfspace": [0, 0, null, 1]}'), "scene.shape.halfspace[2]: null is not a number"),
    (scene('{"halfspace": [0, 0, 1]}'), "scene.shape.halfspace: an array of 3 is not an array of 4"),
    (scene('{"halfspace": "flat"}'), 'scene.shape.halfspace: "flat" is not an array'),
    (scene('{"box": [[0, 0, 0], [1, 1]]}'), "scene.shape.box[1]: an array of 2 is not an array of 3"),
    (scene('{"sphere": [0, 0, 0, 1]}'), "scene.shape.sphere: unknown key"),
    (scene('{"union": [], "intersection": []}'),
     "scene.shape: a shape has one key: halfspace, box, union, intersection; or material, shape; or paint, where, "
     "shape"),
    (scene('{"union": [], "union": []}'), "scene.shape.union: the key stands here twice"),
    (scene('"all"'), 'scene.shape: "all" is no shape'),
    (scene('{"material": "mud", "shape": "nothing"}'), 'scene.shape.material: "mud" is not in materials'),
    (scene('{"paint": "mud", "shape": "nothing"}', '"materials": {"mud": {}}, '), "scene.shape: where is missing"),
    (scene('"nothing"', '"materials": {"mud": {"max_force": -1}}, '),
     "scene.materials.mud.max_force: -1 is not >= 0"),
    (scene('"nothing"', '"materials": {"mud": {"friction": {"rubber": {"static": 1}}}}, '),
     "scene.materials.mud.friction.rubber: dynamic is missing"),
    (scene('"nothing"', '"colour": "red", '), "scene.colour: unknown key"),
    ('{"scene": {"groundtruth": "scene/9", "shape": "nothing"}}', 'scene.groundtruth: "scene/9" is not "scene/1"'),
    ('{"scene": 7}', "scene: 7 is not an object"),
    ("{", "not JSON: Missing a name for object member."),
    (ENTRY % "" + " and more", "not JSON: The document root must not be followed by other values."),
    ("[]", "an array of 0 is not an object"),
    (ENTRY % ', "range": [1, 0]', "range: [1, 0]: the first is larger than the second"),
    (ENTRY % ', "range": [0, "0x1p+1024"]', "range[1]: 0x1p+1024 lies outside the range of doubles"),
    (ENTRY % ', "to": [0, 0, 0]', "to: the key stands here twice"),
    (ENTRY % ', "speed": 3', "speed: unknown key"),
    ('{"id": 1, "ask": "entry", "from": [0, 0, 1]}', "to is missing"),
    ('{"id": 1, "ask": "bounce"}', 'ask: "bounce" is no ask'),
    (CLIP % ("-0.5", "1"), "friction: -0.5 is not >= 0"),
    (CLIP % ("true", "1"), "friction: true is not a number"),
    (CLIP % ("0.5", "NaN"), "not JSON: Invalid value."),
]


class MalformedInput(unittest.TestCase):
    def test_each_gets_one_line_that_names_place_field_and_value(self):
        self.assertGreaterEqual(len(CASES), 30)
        got = program.answers("\n".join(text for text, _ in CASES))
        self.assertEqual(len(got), len(CASES))
        for number, (answer, (text, message)) in enumerate(zip(got, CASES), start=1):
            self.assertEqual(answer.get("error"), f"stdin:{number}: {message}", text)
            self.assertNotIn("answer", answer)


if __name__ == "__main__":
    if "--table" in sys.argv:
        for line, answer in zip((text for text, _ in CASES), program.answers("\n".join(text for text, _ in CASES))):
            print(line, "\n    ", json.dumps(answer))
    else:
        program.main()
