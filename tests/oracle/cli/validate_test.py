"""`groundtruth validate` and `groundtruth merge`: our own engines through the pipe, every exit code, every file."""

import json
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

import program

CASES = ["--cases", "2500"]
PYTHON = sys.executable


def answering(engine):
    return ["--", program.PROGRAM, "answer", "--engine", engine]


def validate(*arguments):
    return program.run("validate", *arguments)


def records(file):
    lines = [json.loads(line) for line in pathlib.Path(file).read_text().splitlines()]
    return [line for line in lines if "case" in line]


def ids(file):
    return [record["case"] for record in records(file)]


class Validate(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name):
        return str(self.folder / name)

    def test_exact_and_fast_agree_in_every_profile(self):
        for profile in ("exact", "double", "float", "game"):
            for engine in ("exact", "fast"):
                done = validate(*CASES, "--profile", profile, *answering(engine))
                self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
                self.assertIn("AGREES: 0 of 2500 cases failed; seed 1", done.stdout.splitlines()[-1])
                self.assertIn("profile " + profile, done.stdout)

    def test_double_and_as_written_disagree(self):
        for engine in ("double", "as-written"):
            done = validate(*CASES, *answering(engine))
            self.assertEqual(done.returncode, 1, engine)
            self.assertIn("DISAGREES", done.stdout.splitlines()[-1])
            self.assertIn("replay groundtruth validate --replay ", done.stdout)

    def test_an_engine_is_judged_the_same_through_the_pipe(self):
        validate(*CASES, "--json", self.file("pipe"), *answering("double"))
        validate(*CASES, "--json", self.file("within"), "--engine", "double")
        self.assertGreater(len(ids(self.file("pipe"))), 10)
        self.assertEqual(ids(self.file("pipe")), ids(self.file("within")))

    def test_failures_do_not_depend_on_jobs(self):
        validate(*CASES, "--json", self.file("one"), "--engine", "double")
        validate(*CASES, "--jobs", "3", "--json", self.file("three"), "--engine", "double")
        self.assertEqual(sorted(ids(self.file("one"))), sorted(ids(self.file("three"))))

    def test_seeds_differ_and_are_printed(self):
        for seed in ("1", "2"):
            done = validate(*CASES, "--seed", seed, "--json", self.file(seed), "--engine", "double")
            self.assertIn(f"seed {seed}", done.stdout)
        self.assertFalse(set(ids(self.file("1"))) & {i for i in ids(self.file("2")) if i[0].isdigit()})

    def test_a_replayed_case_fails_as_it_did(self):
        validate(*CASES, "--json", self.file("all"), "--engine", "double")
        found = records(self.file("all"))
        bred = [record for record in found if "+" in record["case"]]
        self.assertTrue(bred, "failures breed")
        for record in [found[0], bred[-1]]:
            done = validate("--replay", record["case"], "--json", self.file("again"), "--engine", "double")
            self.assertEqual(done.returncode, 1, done.stderr)
            [again] = records(self.file("again"))
            for key in ("case", "verdict", "difference", "scene", "ask", "exact", "explanation"):
                self.assertEqual(again[key], record[key])
        done = validate("--replay", self.file("all"), "--json", self.file("again"), "--engine", "double")
        self.assertEqual(ids(self.file("again")), ids(self.file("all")))
        done = validate("--replay", self.file("all"), "--engine", "exact")
        self.assertEqual(done.returncode, 0)
        self.assertIn(f"0 of {len(found)} cases failed", done.stdout)

    def test_ask_files_and_corpus_cases_can_be_replayed(self):
        done = validate("--replay", str(program.EXAMPLES / "asks.jsonl"), "--engine", "exact")
        self.assertEqual(done.returncode, 3, "the examples hold bad asks")
        self.assertIn("asks.jsonl:", done.stderr)
        asks = self.folder / "asks.jsonl"
        asks.write_text('{"scene": {"groundtruth": "scene/1", "shape": {"halfspace": [0, 0, 1, 0]}}}\n'
                        '{"id": "x", "ask": "entry", "from": [0, 0, 1], "to": [0, 0, -2]}\n')
        done = validate("--replay", str(asks), "--engine", "exact")
        self.assertIn("0 of 1 cases failed", done.stdout)
        done = validate("--replay", "seam/along-the-top", "--engine", "exact")
        self.assertIn("0 of 1 cases failed", done.stdout)
        self.assertEqual(validate("--replay", "no/such-case", "--engine", "exact").returncode, 3)

    def test_json_on_stdout_is_nothing_but_json(self):
        done = validate(*CASES, "--json", "-", "--engine", "double")
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(lines[0]["groundtruth"], "validation/1")
        self.assertIn("summary", lines[-1])
        self.assertIn("DISAGREES", done.stderr)

    def test_junit_counts_what_it_lists(self):
        validate(*CASES, "--junit", self.file("x.xml"), "--json", self.file("x"), "--engine", "double")
        suites = xml.etree.ElementTree.parse(self.file("x.xml")).getroot()
        failed = 0
        for suite in suites:
            self.assertEqual(int(suite.get("tests")), len(suite))
            self.assertEqual(int(suite.get("failures")), len(suite.findall("testcase/failure")))
            failed += int(suite.get("failures"))
        self.assertEqual(failed, len(ids(self.file("x"))))

    def test_a_page_explains_each_group_and_is_linked(self):
        page = self.file("x.html")
        for more in ((), ("--shrink", "0")):
            done = validate("--cases", "300", "--html", page, *more, "--engine", "as-written")
            text = pathlib.Path(page).read_text()
            sections = text.count('<section class="case"')
            self.assertGreater(sections, 1)
            self.assertEqual(sum(line.startswith(f"  {page}#case=") for line in done.stdout.splitlines()), sections)
            self.assertEqual(text.count("<td>yours</td>"), sections)

    def test_no_failure_no_page(self):
        validate("--cases", "50", "--html", self.file("x.html"), "--engine", "exact")
        self.assertFalse(pathlib.Path(self.file("x.html")).exists())

    def test_only_asks_what_it_is_told_to(self):
        done = validate(*CASES, "--only", "clip,step", "--json", self.file("x"), "--engine", "double")
        self.assertEqual({record["kind"] for record in records(self.file("x"))}, {"clip", "step"})
        self.assertRegex(done.stdout, r"\nentry +0 ")

    def test_known_failures_pass_and_cannot_go_stale(self):
        known = ["--known", self.file("known"), *CASES]
        self.assertEqual(validate(*known, "--update-known", "--engine", "double").returncode, 0)
        done = validate(*known, "--json", self.file("x"), "--engine", "double")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual({record["expectation"] for record in records(self.file("x"))}, {"known"})
        cured = validate(*known, "--engine", "exact")
        self.assertEqual(cured.returncode, 1, "known failures that pass")
        self.assertIn("known to fail", cured.stdout)
        other = validate(*known, "--json", self.file("y"), "--engine", "as-written")
        self.assertEqual(other.returncode, 1)
        self.assertIn("unexpected", {record["expectation"] for record in records(self.file("y"))})
        self.assertEqual(validate(*known, "--update-known", "--engine", "exact").returncode, 0)
        self.assertEqual(validate(*known, "--engine", "exact").returncode, 0)
        pathlib.Path(self.file("known")).write_text("{}\n")
        self.assertEqual(validate(*known, "--engine", "exact").returncode, 3)

    def test_a_known_failure_that_fails_otherwise_is_new(self):
        validate("--known", self.file("known"), "--update-known", *CASES, "--engine", "double")
        lines = pathlib.Path(self.file("known")).read_text()
        pathlib.Path(self.file("known")).write_text(lines.replace('"difference":"lambda"', '"difference":"hit/miss"'))
        done = validate("--known", self.file("known"), "--json", self.file("x"), *CASES, "--engine", "double")
        self.assertEqual(done.returncode, 1)
        self.assertEqual({record["expectation"] for record in records(self.file("x"))}, {"known", "changed"})

    def test_shards_are_disjoint_and_make_the_whole(self):
        validate(*CASES, "--json", self.file("whole"), "--engine", "double")
        shards = [self.file(f"shard{i}") for i in (1, 2, 3)]
        for i, shard in enumerate(shards, 1):
            validate(*CASES, "--shard", f"{i}/3", "--json", shard, "--engine", "double")
        parts = [ids(shard) for shard in shards]
        self.assertEqual(sorted(sum(parts, [])), sorted(ids(self.file("whole"))))
        merged = program.run("merge", *shards)
        self.assertEqual(merged.returncode, 1)
        self.assertIn(f"{len(ids(self.file('whole')))} of ", merged.stdout.splitlines()[-1])
        self.assertEqual(program.run("merge", shards[0], shards[1]).returncode, 1, "wrong is wrong")

    def test_merge_tells_what_is_missing(self):
        shards = [self.file(f"shard{i}") for i in (1, 2)]
        for i, shard in enumerate(shards, 1):
            validate(*CASES, "--shard", f"{i}/2", "--json", shard, "--engine", "exact")
        whole = program.run("merge", *shards)
        self.assertEqual((whole.returncode, whole.stderr), (0, ""))
        self.assertIn("0 of 2500 cases failed", whole.stdout)
        self.assertEqual(program.run("merge", shards[0]).returncode, 3)
        self.assertEqual(program.run("merge", shards[0], shards[0]).returncode, 3)
        text = pathlib.Path(shards[1]).read_text()
        pathlib.Path(shards[1]).write_text(text[:-30])
        cut = program.run("merge", *shards)
        self.assertEqual(cut.returncode, 3)
        self.assertIn("was cut off", cut.stderr)
        pathlib.Path(shards[1]).write_text(text.replace('"seed":1', '"seed":2'))
        self.assertEqual(program.run("merge", *shards).returncode, 3)

    @unittest.skipUnless(shutil.which("parallel"), "GNU parallel is not installed")
    def test_shards_run_under_gnu_parallel(self):
        done = subprocess.run(
            ["parallel", "--will-cite", "-j2", f"{program.PROGRAM} validate --cases 2000 --shard {{}}/4 "
             f"--json {self.folder}/shard{{}} --engine fast", ":::", "1", "2", "3", "4"],
            capture_output=True, text=True, timeout=600)
        self.assertEqual(done.returncode, 0, done.stderr)
        merged = program.run("merge", *[self.file(f"shard{i}") for i in (1, 2, 3, 4)])
        self.assertEqual(merged.returncode, 0, merged.stderr)
        self.assertIn("0 of 2000 cases failed", merged.stdout)

    def test_usage_is_2(self):
        for arguments in ([], ["--engine", "exact", "--", "true"], ["--engine", "exact", "--shard", "0/2"],
                          ["--engine", "exact", "--shard", "3/2"], ["--engine", "exact", "--profile", "lax"],
                          ["--engine", "exact", "--only", "fly"], ["--engine", "exact", "--update-known"],
                          ["--engine", "exact", "--jobs", "0"]):
            done = validate(*arguments)
            self.assertEqual((done.returncode, done.stdout), (2, ""), arguments)
            self.assertNotEqual(done.stderr, "", arguments)

    def test_what_cannot_run_is_3(self):
        done = validate("--", "/no/such/program")
        self.assertEqual(done.returncode, 3)
        self.assertIn("nothing to judge", done.stderr)
        self.assertEqual(validate("--engine", "none").returncode, 3)
        self.assertEqual(validate("--engine", "exact", "--json", "/no/such/folder/x").returncode, 3)

    def small_program(self, text):
        file = self.folder / "implementation.py"
        file.write_text(text)
        return ["--", PYTHON, str(file)]

    def test_garbage_is_3(self):
        done = validate("--cases", "40", *self.small_program(
            "import sys\nfor line in sys.stdin: print('what?', flush=True)\n"))
        self.assertEqual(done.returncode, 3, done.stdout + done.stderr)

    def test_a_crash_is_4_and_keeps_the_ask(self):
        done = validate("--cases", "400", "--json", self.file("x"), *self.small_program(
            "import json, os, sys\n"
            "for line in sys.stdin:\n"
            "    if 'hello' in line: print(json.dumps({'hello': 'answers/1', 'name': 'x', 'asks': ['clip']}), flush=True)\n"
            "    elif 'scene' not in json.loads(line): os._exit(9)\n"))
        self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
        self.assertTrue(all(record["ask"]["ask"] == "clip" for record in records(self.file("x"))))

    def test_who_answers_nothing_cannot_be_judged(self):
        done = validate("--cases", "20", *self.small_program(
            "import json, sys\n"
            "for line in sys.stdin:\n"
            "    print(json.dumps({'hello': 'answers/1', 'name': 'x', 'asks': []}), flush=True)\n"))
        self.assertEqual(done.returncode, 5, done.stdout + done.stderr)

    def test_an_interrupt_finishes_the_summary(self):
        process = subprocess.Popen(
            [program.PROGRAM, "validate", "--time", "600", "--json", self.file("x"), *answering("exact")],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(2)
        process.send_signal(signal.SIGINT)
        out, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 130)
        self.assertIn("interrupted", out.splitlines()[-1])
        self.assertIn('"ending":"interrupted"', pathlib.Path(self.file("x")).read_text())

    def test_time_ends_a_run(self):
        done = validate("--time", "0.5", "--engine", "exact")
        self.assertEqual(done.returncode, 0)
        self.assertIn("out of time", done.stdout.splitlines()[-1])


if __name__ == "__main__":
    program.main()
