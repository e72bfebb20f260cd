"""`groundtruth answer` as a program in a pipe: protocol, streams, files, exit codes."""

import json
import pathlib
import select
import subprocess
import tempfile
import unittest

import program

SCENE = '{"scene": {"groundtruth": "scene/1", "shape": {"halfspace": [0, 0, 1, 0]}}}\n'
DOWN = '{"id": "down", "ask": "entry", "from": [0, 0, 1], "to": [0, 0, -2]}\n'
CLIP = '{"id": "c", "ask": "clip", "force": [30, 0, -50], "normal": [0, 0, -1], "friction": 0.5, "brake": 10}\n'
WHEEL = ('"wheel": {"k_xy": -1024, "k_z": -1024, "d_xy": -16, "d_z": 0, "z_min": 0.125, "z_zero": 0.75, "z_max": 1, '
         '"tyre": "rubber"}, "frame": {"position": [-0.25, 0, 0.59375], "orientation": [0, 1, 0, 0], '
         '"velocity": [0, 0, 0]}, "h": 0.0078125')


def stick_step(brake):
    return ('{"id": "s", "ask": "step", ' + WHEEL + f', "brake": {brake}, "state": '
            '{"kind": "stick", "pebble": [-0.1875, -0.046875, 0], "velocity": [0, 0, 0], "normal": [0, 0, 2], '
            '"static": 0.5, "dynamic": 0.5, "max_force": null}}\n')


class Answer(unittest.TestCase):
    def test_a_third(self):
        [answer] = program.answers(SCENE + DOWN)
        self.assertEqual(answer["answer"]["lambda_exact"], "1/3")
        self.assertEqual(answer["answer"]["lambda"], 1 / 3)
        self.assertEqual(answer["answer"]["admissible"], [0])
        self.assertIsNone(answer["answer"]["material"])

    def test_hello_comes_first_or_not_at_all(self):
        hello, answer = program.answers('{"hello": "answers/1"}\n' + SCENE + DOWN)
        self.assertEqual(hello["hello"], "answers/1")
        self.assertEqual(hello["asks"], ["entry", "clip", "step"])
        self.assertIn("answer", answer)
        _, late = program.answers(CLIP + '{"hello": "answers/1"}\n')
        self.assertIsNone(late["id"])
        self.assertIn("error", late)

    def test_each_answer_arrives_while_the_next_ask_is_awaited(self):
        process = subprocess.Popen([program.PROGRAM, "answer"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        try:
            for text in (SCENE + DOWN, CLIP, DOWN):
                process.stdin.write(text.encode())
                process.stdin.flush()
                ready, _, _ = select.select([process.stdout], [], [], 30)
                self.assertTrue(ready, "no answer within 30 s")
                self.assertIn("answer", json.loads(process.stdout.readline()))
            process.stdin.close()
            self.assertEqual(process.wait(30), 0)
        finally:
            process.kill()
            process.stdout.close()

    def test_a_bad_line_does_not_end_the_stream(self):
        got = program.answers(SCENE + "{\n" + DOWN + "\n" + DOWN)
        self.assertEqual([a["id"] for a in got], [None, "down", None, "down"])
        self.assertEqual(["error" in a for a in got], [True, False, True, False])

    def test_the_last_line_needs_no_line_end(self):
        self.assertEqual(len(program.answers(SCENE + DOWN.rstrip("\n"))), 1)

    def test_a_bad_scene_is_answered_and_takes_the_scene_away(self):
        bad_scene = '{"scene": {"groundtruth": "scene/1"}}\n'
        got = program.answers(SCENE + bad_scene + DOWN + CLIP + SCENE + DOWN)
        self.assertEqual([a["id"] for a in got], [None, "down", "c", "down"])
        self.assertEqual(["error" in a for a in got], [True, True, False, False])
        self.assertIn("scene", got[1]["error"])

    def test_a_step_needs_no_scene_until_it_slips(self):
        sticks, slips = program.answers(stick_step(80) + stick_step(0))
        self.assertEqual(sticks["answer"]["state"]["kind"], "stick")
        self.assertIn("scene", slips["error"])

    def test_scene_files_are_relative_to_the_ask_file(self):
        with tempfile.TemporaryDirectory() as folder:
            scene = json.loads(SCENE)["scene"]
            (pathlib.Path(folder) / "ground.json").write_text(json.dumps(scene))
            asks = pathlib.Path(folder) / "asks.jsonl"
            asks.write_text('{"scene": "ground.json"}\n' + DOWN)
            done = program.run("answer", str(asks), cwd="/")
            self.assertIn("1/3", done.stdout)
            self.assertIn("1/3", program.run("answer", text=asks.read_text(), cwd=folder).stdout)
            [bad, _] = program.answers('{"scene": "nowhere.json"}\n' + DOWN, cwd=folder)
            self.assertIn("nowhere.json", bad["error"])

    def test_digits_enclose_the_exact_value(self):
        [answer] = program.answers(SCENE + DOWN, "--digits", "50")
        lower, upper = answer["answer"]["enclosures"]["lambda"]
        self.assertEqual(lower, "3" * 50 + "e-50")
        self.assertEqual(upper, "3" * 49 + "4e-50")
        irrational = ('{"id": "c", "ask": "clip", "force": [3, 3, -1], "normal": [0, 0, -1], "friction": 1, '
                      '"brake": 9}\n')
        [answer] = program.answers(irrational, "--digits", "20")  # sqrt(1/2)
        self.assertEqual(answer["answer"]["enclosures"]["force[0]"],
                         ["70710678118654752440e-20", "70710678118654752441e-20"])
        self.assertEqual(answer["answer"]["enclosures"]["force[2]"][0], answer["answer"]["enclosures"]["force[2]"][1])

    def test_every_engine_answers(self):
        for engine in ("exact", "definition", "fast", "double", "as-written", "as-written:no-liftoff,normal-by-order"):
            [entry, clip] = program.answers(SCENE + DOWN + CLIP, "--engine", engine)
            self.assertEqual((entry["answer"]["kind"], clip["answer"]["kind"]), ("border", "slip"), engine)

    def test_usage_is_2_and_unreadable_files_are_3(self):
        for arguments in ([], ["fly"], ["answer", "--engine", "slow"], ["answer", "--engine", "as-written:typo"],
                          ["answer", "--digits", "0"], ["check", "--cases", "many"]):
            done = program.run(*arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
            self.assertNotEqual(done.stderr, "", arguments)
        done = program.run("answer", str(program.EXAMPLES / "asks.jsonl"), "/nowhere/asks.jsonl")
        self.assertEqual((done.returncode, done.stdout), (3, ""), "nothing half-written")
        self.assertIn("/nowhere/asks.jsonl", done.stderr)

    def test_a_full_disk_is_no_success(self):
        with open("/dev/full", "w") as full:
            done = subprocess.run([program.PROGRAM, "answer"], input=CLIP, text=True, stdout=full,
                                  stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, 3)
        self.assertIn("cannot be written", done.stderr)


if __name__ == "__main__":
    program.main()
