"""Runs the program under test: its path is the first argument of the test."""

import json
import pathlib
import subprocess
import sys
import unittest

PROGRAM = sys.argv[1] if len(sys.argv) > 1 else "groundtruth"
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"


def run(*arguments, text="", cwd=None):
    return subprocess.run([PROGRAM, *arguments], input=text, capture_output=True, text=True, cwd=cwd, timeout=600)


def answers(text, *arguments, cwd=None):
    """The answers to asks, as read from JSON. Fails if the program does."""
    done = run("answer", *arguments, text=text, cwd=cwd)
    if done.returncode != 0:
        raise AssertionError(f"exit {done.returncode}: {done.stderr}")
    return [json.loads(line) for line in done.stdout.splitlines()]


def main():
    unittest.main(argv=sys.argv[:1])
