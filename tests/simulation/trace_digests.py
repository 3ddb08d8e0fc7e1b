#!/usr/bin/env python3
"""Checks the step traces of every example, and of random jobs with feed holds and overrides,
against recorded ones.

    trace_digests.py KERFLINE IMAGE_TRACE_JOBS EXAMPLES_FOLDER [--record]

The SHA-256 of each trace is recorded in trace_digests.txt in this folder. A change that
intentionally changes the motion records them again with --record and says so in its commit.
"""
import concurrent.futures
import hashlib
import os
import pathlib
import subprocess
import sys
import tempfile

RECORD = pathlib.Path(__file__).with_suffix(".txt")
RANDOM_JOBS = 200
RANDOM_TURNS = 10_000  # Of a millisecond; nearly all random jobs have ended by then.
MILL_PROGRAMS = {"pocket_fusion"}


def digest_of(file: pathlib.Path) -> str:
    with file.open("rb") as stream:
        return hashlib.file_digest(stream, "sha256").hexdigest()


def example_digest(kerfline: str, program: pathlib.Path) -> str:
    machine = "mill" if program.stem in MILL_PROGRAMS else "laser"
    with tempfile.TemporaryDirectory() as folder:
        trace = pathlib.Path(folder) / "trace"
        subprocess.run([kerfline, "sim", program, "--settings", program.parent / f"{machine}.settings",
                        "--trace", trace], stdout=subprocess.DEVNULL, check=True)
        return digest_of(trace)


def random_digest(jobs: str, seed: int) -> str:
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([jobs, "random", str(seed), str(RANDOM_TURNS), folder],
                       stdout=subprocess.DEVNULL, check=True)
        return digest_of(pathlib.Path(folder) / "edges")


def digests(kerfline: str, jobs: str, examples: pathlib.Path) -> dict:
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        found = {f"example {program.stem}": pool.submit(example_digest, kerfline, program)
                 for program in sorted(examples.glob("*.nc"))}
        found |= {f"random {seed}": pool.submit(random_digest, jobs, seed)
                  for seed in range(1, RANDOM_JOBS + 1)}
        return {name: future.result() for name, future in found.items()}


def main() -> int:
    kerfline, jobs, examples = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    found = digests(kerfline, jobs, examples)
    if "--record" in sys.argv[4:]:
        RECORD.write_text("".join(f"{digest}  {name}\n" for name, digest in found.items()))
        return 0
    recorded = {name: digest for digest, name in
                (line.split("  ", 1) for line in RECORD.read_text().splitlines())}
    different = [name for name in recorded | found if recorded.get(name) != found.get(name)]
    for name in different:
        print(f"{name}: recorded {recorded.get(name)}, now {found.get(name)}")
    print(f"{len(found) - len(different)} of {len(found)} traces are the recorded ones")
    return bool(different)


if __name__ == "__main__":
    sys.exit(main())
