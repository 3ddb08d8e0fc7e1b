"""Checks that the same program gives the same trace, byte for byte, from two builds and from two
runs of one build.

usage: same_trace.py KERFLINE OTHER_KERFLINE EXAMPLES_FOLDER
"""
import filecmp
import pathlib
import subprocess
import sys
import tempfile


def trace(binary: pathlib.Path, program: pathlib.Path, into: pathlib.Path) -> pathlib.Path:
    settings = program.parent / "laser.settings"
    arguments = ["--settings", settings] if settings.is_file() else []
    subprocess.run([binary, "sim", program, *arguments, "--trace", into],
                   stdout=subprocess.DEVNULL, check=True)
    return into


def main() -> int:
    binaries = [pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])]
    programs = sorted(pathlib.Path(sys.argv[3]).glob("*.nc"))
    if not programs or not all(binary.is_file() for binary in binaries):
        print("skipped: needs examples and both builds,", *binaries)
        return 77
    different = 0
    with tempfile.TemporaryDirectory() as folder:
        for program in programs:
            runs = {"first": binaries[0], "again": binaries[0], "other build": binaries[1]}
            traces = [trace(binary, program, pathlib.Path(folder) / name)
                      for name, binary in runs.items()]
            for name, other in list(zip(runs, traces))[1:]:
                if not filecmp.cmp(traces[0], other, shallow=False):
                    different += 1
                    print(f"{program.name}: another trace when run by: {name}")
            print(f"{program.name}: {traces[0].stat().st_size} bytes")
    return bool(different)


if __name__ == "__main__":
    sys.exit(main())
