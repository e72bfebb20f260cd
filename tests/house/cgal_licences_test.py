"""No header of CGAL that we include, directly or not, is under the GPL.

usage: cgal_licences_test.py COMPILER INCLUDE_DIRECTORY SOURCE...
"""

import pathlib
import re
import subprocess
import sys


def included_headers(compiler, include_directory, source):
    command = [compiler, "-std=c++20", "-M", "-I", include_directory, source]
    rule = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return {word for word in rule.replace("\\\n", " ").split() if "/CGAL/" in word}


def main():
    compiler, include_directory, *sources = sys.argv[1:]
    headers = set()
    for source in sources:
        headers |= included_headers(compiler, include_directory, source)
    licences = {}
    for header in sorted(headers):
        text = pathlib.Path(header).read_text(errors="replace")
        for licence in re.findall(r"SPDX-License-Identifier:\s*(.+)", text) or ["none stated"]:
            licences.setdefault(licence.strip(), []).append(header)
    for licence, of in sorted(licences.items()):
        print(f"{len(of):5} headers: {licence}")
    if len(headers) < 50:
        print(f"FAILED: only {len(headers)} headers of CGAL were found; the test looks in the wrong place")
        return 1
    gpl = [header for licence, of in licences.items() if re.search(r"(?<!L)GPL", licence) for header in of]
    for header in gpl:
        print(f"FAILED: {header} is under the GPL")
    return 1 if gpl else 0


if __name__ == "__main__":
    sys.exit(main())
