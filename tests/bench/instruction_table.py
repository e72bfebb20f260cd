"""instruction_table.py COUNTED_ASKS [SCENE...]: instructions and branches that a simple predictor does not foretell,
per entry ask, as callgrind counts them: the same on every run. COUNTED_ASKS is the program of that name."""

import pathlib
import re
import subprocess
import sys
import tempfile

SCENES = ["house", "runway", "town-1k", "hills-20k"]
ASKS = ["strut", "taxi", "long"]
PEERS = ["fast", "fast warm", "without certainty", "one-pass clip"]


def counted(program, *arguments):
    """Instructions and mispredicted branches an ask, or nothing where there is no such peer."""
    with tempfile.TemporaryDirectory() as folder:
        command = ["valgrind", "--tool=callgrind", "--branch-sim=yes", "--toggle-collect=*answer_counted*",
                   f"--callgrind-out-file={pathlib.Path(folder) / 'counts'}", program, *arguments]
        run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        return None
    asks = int(re.match(r"(\d+) asks", run.stdout).group(1))
    instructions = int(re.search(r"Collected : (\d+)", run.stderr).group(1))
    mispredicted = int(re.search(r"Mispredicts:\s+([\d,]+)", run.stderr).group(1).replace(",", ""))
    return instructions / asks, mispredicted / asks


def main():
    program, scenes = sys.argv[1], sys.argv[2:] or SCENES
    print(f"{'scene, asks':18} {'peer':18} {'instructions':>12} {'mispredicted':>12}")
    for scene in scenes:
        for asks in ASKS:
            for peer in PEERS:
                counts = counted(program, scene, asks, peer)
                if counts:
                    print(f"{scene + ', ' + asks:18} {peer:18} {counts[0]:12.0f} {counts[1]:12.2f}", flush=True)


if __name__ == "__main__":
    main()
