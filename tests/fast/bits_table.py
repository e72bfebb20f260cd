"""bits_table.py FOLDER [COUNT]: builds fast with each compiler and level of optimisation in FOLDER, and compares
the bits of COUNT (default 1,000,000) answers of each kind. Exits with 1 if they differ."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
COMPILERS = ["g++", "clang++"]
FLAGS = ["-O0", "-O1", "-O3", "-O3 -mavx2 -mfma"]


def build(folder, compiler, flags):
    configure = ["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
                 "-DCMAKE_BUILD_TYPE=Bits", f"-DCMAKE_CXX_FLAGS={flags}"]
    subprocess.run(configure, check=True, stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, "--target", "fast_bits"], check=True, stdout=subprocess.DEVNULL)
    return next(folder.rglob("tests/fast_bits"))


def main():
    folder = pathlib.Path(sys.argv[1])
    count = sys.argv[2] if len(sys.argv) > 2 else "1000000"
    seen = set()
    for compiler in COMPILERS:
        for flags in FLAGS:
            program = build(folder / f"{compiler}{flags.replace(' ', '')}", compiler, flags)
            bits = subprocess.run([program, count], check=True, capture_output=True, text=True).stdout
            seen.add(bits)
            for line in bits.splitlines():
                print(f"{compiler:8} {flags:17} {line}", flush=True)
    print("all the same" if len(seen) == 1 else "THEY DIFFER")
    return 0 if len(seen) == 1 else 1


if __name__ == "__main__":
    sys.exit(main())
