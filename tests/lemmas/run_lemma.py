"""Checks one lemma file of proofs-notes/lemmas: run_lemma.py FILE BUILD_FOLDER.

Exit: 0 proved, 1 not proved, 77 the tool that reads such a file is not installed (a skip, never a pass).
  .v     Coq: compiled into the build folder, after the lemmas it requires. Nothing may be assumed but what the
         standard library assumes of the real numbers; `Print Assumptions` of its theorems shows it.
  .g     Gappa: proves every goal, without a warning.
  .smt2  z3, or cvc5 if a line says `; solver: cvc5`: each (check-sat) answers what the last
         (set-info :status ...) before it says.
"""

import fcntl
import pathlib
import re
import shutil
import subprocess
import sys

LEMMAS = pathlib.Path(__file__).resolve().parents[2] / "proofs-notes" / "lemmas"
PROVED, NOT_PROVED, SKIPPED = 0, 1, 77

GIVEN_UP = re.compile(r"\b(Admitted|admit|Abort|give_up|Axioms?|Parameters?|Conjecture|bypass_check|Unset Guard Checking)\b")
# What the standard library assumes of the real numbers.
OF_REAL_NUMBERS = {
    "ClassicalDedekindReals.sig_forall_dec",
    "ClassicalDedekindReals.sig_not_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
}
CLOSED = "Closed under the global context"


class NotProved(Exception):
    pass


class ToolMissing(Exception):
    pass


def tool(name):
    found = shutil.which(name)
    if not found:
        raise ToolMissing(f"{name} is not installed: .ci/install-dependencies --with-proofs")
    return found


def output_of(command, folder=None):
    run = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if run.returncode != 0:
        raise NotProved(run.stdout)
    return run.stdout


def without_comments(text):
    depth, kept = 0, []
    for token in re.split(r"(\(\*|\*\))", text):
        if token == "(*":
            depth += 1
        elif token == "*)":
            depth -= 1
        elif depth == 0:
            kept.append(token)
    return " ".join(kept)


def required_lemmas(file):
    """Files of ours that this one requires, by name: a lemma's name is that of its file."""
    sentences = re.findall(r"From\s+Groundtruth\s+Require\s+(?:Import\s+|Export\s+)?([^.]*)\.", file.read_text())
    names = [name for sentence in sentences for name in sentence.split()]
    beside = [file.parent, LEMMAS]
    found = []
    for name in names:
        places = [folder / f"{name}.v" for folder in beside if (folder / f"{name}.v").exists()]
        if not places:
            raise NotProved(f"{file}: no lemma {name}.v beside it")
        found.append(places[0])
    return found


def compile_coq(file, build):
    """What coqc printed, now or when it last compiled this very text on the same grounds."""
    grounds = [compile_coq(required, build)[1] for required in required_lemmas(file)]
    with open(build / f"{file.stem}.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # tests run side by side, and share what they require
        return compile_on(grounds, file, build)


def compile_on(grounds, file, build):
    copy = build / file.name
    printed = copy.with_suffix(".printed")
    text = file.read_text()
    fresh = (printed.exists() and copy.with_suffix(".vo").exists() and copy.exists() and copy.read_text() == text
             and all(ground <= printed.stat().st_mtime for ground in grounds))
    if not fresh:
        printed.unlink(missing_ok=True)
        copy.write_text(text)
        result = output_of([tool("coqc"), "-q", "-Q", ".", "Groundtruth", copy.name], build)  # it leaves caches there
        printed.write_text(result)
    return printed.read_text(), printed.stat().st_mtime


def check_assumptions(file, printed):
    theorems = re.findall(r"Print\s+Assumptions\s+([\w.']+)\s*\.", without_comments(file.read_text()))
    if not theorems:
        raise NotProved(f"{file}: no theorem prints its assumptions")
    verdicts = printed.count(CLOSED) + len(re.findall(r"^Axioms:$", printed, re.MULTILINE))
    if verdicts != len(theorems):
        raise NotProved(f"{file}: {len(theorems)} theorems, but assumptions of {verdicts} are printed:\n{printed}")
    for block in printed.split("Axioms:\n")[1:]:
        assumed = re.findall(r"^([\w.']+)\s*(?::|$)", block.split(CLOSED)[0], re.MULTILINE)
        for name in assumed:
            if not any(name == known or known.endswith("." + name) for known in OF_REAL_NUMBERS):
                raise NotProved(f"{file}: assumes {name}")
    print("theorems:", ", ".join(theorems))


def check_coq(file, build):
    tool("coqc")
    given_up = GIVEN_UP.search(without_comments(file.read_text()))
    if given_up:
        raise NotProved(f"{file}: {given_up.group()}")
    build.mkdir(parents=True, exist_ok=True)
    printed, _ = compile_coq(file, build)
    print(printed)
    check_assumptions(file, printed)


def check_gappa(file, _):
    printed = output_of([tool("gappa"), str(file)])
    print(printed)
    if re.search(r"^(Warning|Error)|no path|some enclosures were not satisfied", printed, re.MULTILINE | re.IGNORECASE):
        raise NotProved(printed)


def check_smt(file, _):
    text = file.read_text()
    named = re.search(r"^;\s*solver:\s*(\w+)", text, re.MULTILINE)
    solver = named.group(1) if named else "z3"
    commands = re.findall(r"^\s*\((?:set-info\s+:status\s+(\w+)|(check-sat)\b)", text, re.MULTILINE)
    expected, status = [], "unsat"
    for new_status, asks in commands:
        if asks:
            expected.append(status)
        else:
            status = new_status
    options = {"z3": ["-T:120"], "cvc5": ["--incremental", "--tlimit=120000"]}[solver]
    printed = output_of([tool(solver), *options, str(file)])
    print(printed)
    answers = [line for line in printed.split() if line in {"sat", "unsat", "unknown", "timeout"}]
    if not expected or answers != expected:
        raise NotProved(f"{file}: expected {expected}, got {answers}")


CHECKS = {".v": check_coq, ".g": check_gappa, ".smt2": check_smt}


def main(file, build):
    try:
        CHECKS[file.suffix](file.resolve(), build)
    except ToolMissing as missing:
        print(missing)
        return SKIPPED
    except NotProved as why:
        print(f"NOT PROVED: {why}")
        return NOT_PROVED
    return PROVED


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
