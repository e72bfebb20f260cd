"""Which planted mistakes does `groundtruth validate` find, how soon, and does it accuse the right ones?

    measure.py GROUNDTRUTH PLANTED [--seeds 1,2,3,4,5] [--cases 20000] [--seconds 10] [--names a,b] [--jobs 2]

Exit: 0 if every mistake is found with every seed in time and no right one is accused, else 1.
"""

import argparse
import concurrent.futures
import json
import re
import subprocess
import sys
import time


def names_of(planted):
    """Name -> kind of ask, or "right"."""
    listed = subprocess.run([planted, "--list"], capture_output=True, text=True, check=True).stdout
    return dict(re.match(r"(\S+)\s+(\S+)", line).groups() for line in listed.splitlines())


def validate(options, name, seed):
    """One run: its exit code, and the ask number and seconds of the first wrong verdict, if there is one."""
    command = [options.groundtruth, "validate", "--failures", "1", "--shrink", "0", "--seed", str(seed),
               "--cases", str(options.cases), "--json", "-", "--", options.planted, name]
    started = time.monotonic()
    first = None
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as run:
        for line in run.stdout:
            verdict = json.loads(line) if line.startswith("{") else {}
            if first is None and verdict.get("verdict") == "wrong":
                first = (verdict.get("ask_number"), verdict.get("seconds", time.monotonic() - started))
    return run.returncode, first


def outcome(options, kind, code, first):
    """ "" if the run says what it should, else what is amiss."""
    if kind == "right":
        return "" if code == 0 and first is None else f"accused (exit {code})"
    if first is None:
        return f"missed (exit {code})"
    if code != 1:
        return f"found, but exit {code}"
    return "" if first[1] <= options.seconds else "late"


def row(name, kind, runs, problems):
    firsts = [first for _, first in runs if first]
    asks = max((first[0] for first in firsts), default="-")
    seconds = f"{max(first[1] for first in firsts):.2f}" if firsts else "-"
    verdict = ", ".join(problem for problem in problems if problem) or ("accepted" if kind == "right" else "found")
    return f"{name:32} {kind:6} {len(firsts)}/{len(runs):<5} {asks:>10} {seconds:>10}  {verdict}"


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("groundtruth")
    parser.add_argument("planted")
    parser.add_argument("--seeds", default="1,2,3,4,5")
    parser.add_argument("--cases", type=int, default=20000)
    parser.add_argument("--seconds", type=float, default=10)
    parser.add_argument("--names", default="")
    parser.add_argument("--jobs", type=int, default=2)
    return parser.parse_args()


def main():
    options = arguments()
    kinds = names_of(options.planted)
    seeds = [int(seed) for seed in options.seeds.split(",")]
    names = options.names.split(",") if options.names else list(kinds)
    amiss = 0
    print(f"{'name':32} {'kind':6} {'found':7} {'worst ask':>10} {'worst s':>10}  verdict")
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        started = {name: [pool.submit(validate, options, name, seed) for seed in seeds] for name in names}
        for name, futures in started.items():
            runs = [future.result() for future in futures]
            problems = [outcome(options, kinds[name], *run) for run in runs]
            amiss += any(problems)
            print(row(name, kinds[name], runs, problems), flush=True)
    print(f"{len(names)} implementations, {len(seeds)} seeds: {amiss} amiss")
    return 1 if amiss else 0


if __name__ == "__main__":
    sys.exit(main())
