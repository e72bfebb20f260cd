"""The libraries as a user meets them: installed, found by CMake, linked; and fast without the reference.

usage: install_test.py CMAKE SOURCE_DIRECTORY BUILD_DIRECTORY CXX_COMPILER
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

CMAKE, SOURCE, BUILD, COMPILER = sys.argv[1:5]


def run(*command):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise AssertionError(f"{' '.join(command)}\n{done.stdout}\n{done.stderr}")
    return done.stdout


def build(source, folder, *settings):
    run(CMAKE, "-S", str(source), "-B", str(folder), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
        f"-DCMAKE_CXX_COMPILER={COMPILER}", *settings)
    run(CMAKE, "--build", str(folder), "-j", "2")


class Install(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.at = pathlib.Path(self.folder.name)
        self.here = pathlib.Path(__file__).parent

    def test_an_installed_reference_and_fast_can_be_linked(self):
        run(CMAKE, "--install", BUILD, "--prefix", str(self.at / "prefix"))
        build(self.here / "reference_consumer", self.at / "consumer", f"-DCMAKE_PREFIX_PATH={self.at / 'prefix'}")
        self.assertEqual(run(str(self.at / "consumer/consumer")), "exact 1/3, fast 0x1.5555555555555p-2\n")

    def test_fast_alone_needs_eigen_and_boost_headers_only(self):
        absent = [f"-DCMAKE_DISABLE_FIND_PACKAGE_{package}=ON"
                  for package in ("CGAL", "PkgConfig", "RapidJSON", "fmt", "CLI11", "GTest", "rapidcheck")]
        build(SOURCE, self.at / "fast", "-DGROUNDTRUTH_REFERENCE=OFF", *absent)
        run(CMAKE, "--install", str(self.at / "fast"), "--prefix", str(self.at / "prefix"))
        build(self.here / "fast_consumer", self.at / "consumer", f"-DCMAKE_PREFIX_PATH={self.at / 'prefix'}", *absent)
        consumer = str(self.at / "consumer/consumer")
        self.assertEqual(run(consumer), "fast 0x1p-2\n")
        libraries = run("ldd", consumer)
        for foreign in ("gmp", "mpfr", "CGAL", "boost"):
            self.assertNotIn(foreign, libraries)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
