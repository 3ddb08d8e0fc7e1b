"""Seeds of the random tests in Python, as tests/support/trials.hpp has them for those in C++."""
import inspect
import os
import pathlib
import re
import unittest


def first_seed_of(base: str, test: str) -> int:
    """1 without a base, else 1 to 4e9 by a hash of base and test, the same as in trials.cpp."""
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
    """KERFLINE_TRIALS, else `in_proof` in prove.sh where it is given, else `usual`."""
    proves = in_proof > 0 and os.environ.get("KERFLINE_TIER") == "prove"
    return int(os.environ.get("KERFLINE_TRIALS", in_proof if proves else usual))


def name_of(test: unittest.TestCase) -> str:
    """Class and method, as a section of a seed file names them."""
    return ".".join(test.id().split(".")[-2:])


def first_seed(test: unittest.TestCase, known_fault: bool = False) -> int:
    """The first seed of a running test; prints it and the base once for each call. Where a known
    fault violates some new seeds it is 1, but in the last step of prove.sh."""
    base = os.environ.get("KERFLINE_SEED_BASE", "")
    if known_fault:
        print("a known fault violates some new seeds")
        base = base if os.environ.get("KERFLINE_TIER") == "seeds" else ""
    chosen = os.environ.get("KERFLINE_SEED")
    seed = int(chosen) if chosen else first_seed_of(base, name_of(test))
    print(f"{name_of(test)}: base '{base}', to repeat: KERFLINE_SEED={seed}", flush=True)
    return seed


def share_of(cases: list, in_test: int, name: str) -> list:
    """All cases of the test of that name; in toolchain/test.sh `in_test` of them or a few more: every
    so many, beginning at another one with another base of seeds."""
    stride = len(cases) // in_test if os.environ.get("KERFLINE_TIER") == "test" else 1
    if stride < 2:
        return cases
    base = os.environ.get("KERFLINE_SEED_BASE", "")
    begin = first_seed_of(base, name) % stride
    print(f"{name}: base '{base}', every {stride} of {len(cases)} cases from number {begin}", flush=True)
    return cases[begin::stride]


def read_seeds(text: str) -> dict:
    """The seeds by test of a seed file (seed_file.hpp says its form). Raises ValueError."""
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
    """The test's seeds in the .seeds file beside it; none where KERFLINE_SEED chooses one."""
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
    """The seeds that once failed, then the random range."""
    first = first_seed(test, known_fault)
    count = trials(1 if "KERFLINE_SEED" in os.environ else usual)
    return failed_seeds_of(test) + list(range(first, first + count))
