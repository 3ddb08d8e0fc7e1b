"""Seeds of the random tests in Python; tests/support/trials.hpp does the same for the tests in C++."""
import inspect
import os
import pathlib
import re
import unittest


def first_seed_of(base: str, test: str) -> int:
    """Returns the seed at which the range of a test begins: 1 without a base, else 1 to 4e9 by a
    hash of base and test, the same as in trials.cpp."""
    if not base:
        return 1
    mask = (1 << 64) - 1
    value = 0xCBF29CE484222325
    for byte in f"{base} {test}".encode():
        value = (value ^ byte) * 0x100000001B3 & mask
    value = (value ^ value >> 30) * 0xBF58476D1CE4E5B9 & mask
    value = (value ^ value >> 27) * 0x94D049BB133111EB & mask
    return 1 + (value ^ value >> 31) % 4_000_000_000


def trials(usual: int, in_proof: int = 0) -> int:
    """Returns the number of trials: KERFLINE_TRIALS if set, else `in_proof` in prove.sh if it is
    given, else `usual`."""
    proves = in_proof > 0 and os.environ.get("KERFLINE_TIER") == "prove"
    return int(os.environ.get("KERFLINE_TRIALS", in_proof if proves else usual))


def name_of(test: unittest.TestCase) -> str:
    """Returns class and method of a test, which are its section in a seed file."""
    return ".".join(test.id().split(".")[-2:])


def first_seed(test: unittest.TestCase, known_fault: bool = False) -> int:
    """Returns the first seed of a running test; prints it with the base. If a known fault violates
    some new seeds, the first seed is 1, except in the last step of prove.sh."""
    base = os.environ.get("KERFLINE_SEED_BASE", "")
    if known_fault:
        print("a known fault violates some new seeds")
        base = base if os.environ.get("KERFLINE_TIER") == "seeds" else ""
    chosen = os.environ.get("KERFLINE_SEED")
    seed = int(chosen) if chosen else first_seed_of(base, name_of(test))
    print(f"{name_of(test)}: base '{base}', to repeat: KERFLINE_SEED={seed}", flush=True)
    return seed


def share_of(cases: list, in_test: int, name: str) -> list:
    """Returns the cases of a test that run. In toolchain/test.sh these are every n-th case,
    `in_test` or a few more, and the base of seeds chooses where they begin. Elsewhere all cases
    run."""
    stride = len(cases) // in_test if os.environ.get("KERFLINE_TIER") == "test" else 1
    if stride < 2:
        return cases
    base = os.environ.get("KERFLINE_SEED_BASE", "")
    begin = first_seed_of(base, name) % stride
    print(f"{name}: base '{base}', every {stride} of {len(cases)} cases from number {begin}", flush=True)
    return cases[begin::stride]


def read_seeds(text: str) -> dict:
    """Returns the seeds of a seed file by test (seed_file.hpp describes the format). Raises
    ValueError."""
    seeds, section = {}, None
    for number, line in enumerate(text.splitlines(), 1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        if head := re.fullmatch(r"\[(\w+\.\w+)\]\s*", line):
            section = seeds.setdefault(head[1], [])
        elif (seed := re.fullmatch(r"(\d+)\s*#\s*\S.*", line)) and section is not None:
            section.append(int(seed[1]))
        else:
            raise ValueError(f"line {number}: {line}")
    return seeds


def failed_seeds_of(test: unittest.TestCase) -> list:
    """Returns the seeds of the test in the .seeds file of its folder; none if KERFLINE_SEED chooses
    a seed."""
    file = pathlib.Path(inspect.getfile(type(test))).with_suffix(".seeds")
    if "KERFLINE_SEED" in os.environ or not file.exists():
        return []
    seeds = read_seeds(file.read_text("utf-8"))
    for section in seeds:
        suite, method = section.split(".")
        if suite == type(test).__name__ and not hasattr(test, method):
            raise ValueError(f"{file}: {suite} has no test {method}")
    return seeds.get(name_of(test), [])


def seeds_of(test: unittest.TestCase, usual: int, known_fault: bool = False) -> list:
    """Returns the seeds of a test: those that once failed, then the random range."""
    first = first_seed(test, known_fault)
    count = trials(1 if "KERFLINE_SEED" in os.environ else usual)
    return failed_seeds_of(test) + list(range(first, first + count))
