"""Who includes whom, as the tree promises it (README, "The house")."""

import pathlib
import re
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Folder -> the folders of ours that it may include besides itself.
ENGINES = {"exact", "definition", "fast", "as_written"}
ALLOWED = {
    "reference/problem": set(),
    "reference/text": {"problem"},
    "reference/exact": {"problem"},
    "reference/as_written": {"problem"},
    "fast": {"problem"},
    "oracle/definition": {"problem"},
    "oracle/cases": {"problem"},
    "oracle/judge": {"problem", "text", "implementations"},
    "oracle/implementations": {"problem", "text"},
    "oracle/proved": set(),  # OCaml
    "oracle/tiers": {"problem", "implementations"},
    "oracle/precision": {"problem", "text", "cases", "judge", "implementations", "tiers", "rig"},
    "oracle/campaign": {"problem", "judge", "cases", "implementations"},
    "oracle/validation": {"diagnosis", "problem", "text", "judge", "cases", "implementations"},
    "oracle/report": {"precision", "tiers", "rig", "stability", "validation", "campaign", "cases", "diagnosis", "implementations", "judge",
                      "problem", "text"},
    "oracle/rig": {"problem", "implementations", "text"},
    "oracle/stability": {"problem", "rig"},
    "oracle/diagnosis": {"problem", "cases", "judge", "implementations"},
    "oracle/explanation": {"problem", "text", "cases", "judge", "implementations", "tiers"},
    "oracle/page": {"problem", "text", "cases", "explanation", "report"},
    "oracle/cli": {"precision", "problem", "text", "cases", "judge", "implementations", "campaign", "validation", "report", "rig",
                   "stability", "explanation", "page"},
}
TOP_LEVEL = {
    "CMakeLists.txt", "reference", "fast", "oracle", "tests", "proofs-notes", "README.md",
    "CMakePresets.json", "LICENSE", ".clang-format", ".clang-tidy", ".gitignore", ".gitattributes", ".ci",
}
# Libraries by the start of the include, and the folders that may use them.
LIBRARIES = {
    "CGAL/": {"reference/exact", "oracle/tiers"},
    "Eigen/": {"fast", "oracle/rig", "oracle/stability"},
    "boost/": {"reference/exact", "oracle/definition", "oracle/cases", "oracle/judge", "oracle/explanation", "oracle/tiers",
               "oracle/precision", "fast"},
    # In oracle/implementations for its template only.
    "rapidjson/": {"reference/text", "oracle/report", "oracle/validation", "oracle/implementations"},
    "CLI/": {"oracle/cli"},
    "fmt/": {"oracle/cli", "oracle/judge", "oracle/report", "oracle/validation",
             "oracle/explanation", "oracle/page"},
}


def sources(folder):
    return [p for p in sorted((ROOT / folder).rglob("*")) if p.suffix in {".hpp", ".cpp", ".h"}]


def includes(path):
    return re.findall(r'^\s*#\s*include\s+[<"]([^>"]+)[>"]', path.read_text(), re.MULTILINE)


class House(unittest.TestCase):
    def test_every_folder_has_a_rule(self):
        for part in ("reference", "oracle"):
            for folder in (ROOT / part).iterdir():
                if folder.is_dir():
                    self.assertIn(f"{part}/{folder.name}", ALLOWED)

    def test_folders_include_only_what_they_may(self):
        seen = 0
        for folder, allowed in ALLOWED.items():
            own = folder.split("/")[-1]
            for path in sources(folder):
                for include in includes(path):
                    if not include.startswith("groundtruth/"):
                        continue
                    seen += 1
                    target = include.split("/")[1]
                    adapter = folder == "oracle/implementations" and path.name == f"{target}_engine.cpp"
                    self.assertTrue(
                        target == own or target in allowed or (target in ENGINES and adapter),
                        f"{path.relative_to(ROOT)} includes {include}",
                    )
        self.assertGreater(seen, 100)

    def test_libraries_stay_where_they_belong(self):
        for folder in ALLOWED:
            for path in sources(folder):
                for include in includes(path):
                    for start, homes in LIBRARIES.items():
                        if include.startswith(start):
                            self.assertIn(folder, homes, f"{path.relative_to(ROOT)} includes {include}")

    def test_public_headers_of_the_problem_need_the_standard_library_only(self):
        for path in sources("reference/problem"):
            for include in includes(path):
                self.assertTrue("/" not in include or include.startswith("groundtruth/problem/"), f"{path}: {include}")

    def test_top_level_is_the_agreed_one(self):
        found = {p.name for p in ROOT.iterdir() if p.name not in {".git", "build", ".cache"}}
        self.assertLessEqual(found, TOP_LEVEL)

    def test_files_are_short(self):
        for folder in [*ALLOWED, "tests"]:
            for path in sources(folder):
                self.assertLessEqual(len(path.read_text().splitlines()), 300, path)


if __name__ == "__main__":
    sys.exit(unittest.main())
