"""The steps that prove a change, in order, each with its tiers.

`test` guards against a broken product in 25 minutes on two cores at most; `prove` is everything.
"""
import concurrent.futures
import dataclasses
import os
from typing import Callable

import ctest_run
import fuzzing
import seeds
from memory import ALL_ROOMS, head
from shell import ROOT, Outcome, run

TEST, PROVE = "test", "prove"
BOTH = (TEST, PROVE)


@dataclasses.dataclass(frozen=True)
class Step:
    """A stage of a run. `needs` names the steps that must pass before it, `without` the rooms of
    tests on which it does not depend."""
    name: str
    work: Callable[[str], Outcome]  # Takes the tier.
    tiers: tuple = BOTH
    needs: tuple = ()
    without: frozenset = frozenset()


def build(preset: str, *targets: str) -> Callable[[str], Outcome]:
    """Returns a step that configures a preset and builds the given targets, or all. It continues
    after an error."""
    def work(_tier: str) -> Outcome:
        configured = run("cmake", "--preset", preset, quiet=True)
        if not configured:
            return Outcome.of(f"configure {preset}", configured)
        chosen = ("--target", *targets) if targets else ()
        return Outcome.of(f"build {preset}", run("cmake", "--build", "--preset", preset, *chosen,
                                                 "--", "-k", "0"))
    return work


# Programs that read bytes from outside: the controller's firmware with the planner below it, and
# the fuzzers. The program and the other test programs would take three times as long to compile
# again: `prove` runs them.
SANITIZED_IN_TEST = ("firmware_tests", "same_bits_host", "fuzzers")


def build_sanitized(tier: str) -> Outcome:
    targets = ("all", "fuzzers", "cam_fuzzers") if tier == PROVE else SANITIZED_IN_TEST
    return build("sanitize", *targets)(tier)


def install_senders(_tier: str) -> Outcome:
    """Installs the sender programs that the lock file pins, outside of the source tree."""
    folder = ROOT / "build/senders"
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", "package-lock.json"):
        (folder / name).write_bytes((ROOT / "tests/senders" / name).read_bytes())
    return Outcome.of("npm ci of tests/senders", run(
        "npm", "ci", "--prefix", str(folder), "--no-audit", "--no-fund", "--loglevel=error"))


def side_by_side(*works: Callable[[str], Outcome]) -> Callable[[str], Outcome]:
    """Returns a step that runs works in parallel, one of which waits for the network or the disk."""
    def work(tier: str) -> Outcome:
        with concurrent.futures.ThreadPoolExecutor(len(works)) as pool:
            return sum(pool.map(lambda one: one(tier), works), Outcome())
    return work


def test(preset: str, **arguments) -> Callable[[str], Outcome]:
    return lambda tier: ctest_run.run_tests(preset, tier, **arguments)


def benchmarks(_tier: str) -> Outcome:
    """Prints figures of this machine. Judges only the instruction counts."""
    programs = ROOT / "build/release/tests"
    most = 600.0  # Seconds; each of them takes a few.
    stages = run(str(programs / "bench_stages"), "--benchmark_min_time=0.05", seconds=most)
    times = run(str(programs / "bench_job_times"), seconds=most)
    counts = run("tests/bench/count_instructions.py", "build/release/host-sim/kerfline")
    return (Outcome.of("bench_stages", stages) + Outcome.of("bench_job_times", times)
            + Outcome.of("instruction counts", counts))


STEPS = (
    Step("senders, build cortex-m4f", side_by_side(install_senders, build("cortex-m4f"))),
    Step("build release", build("release")),
    # Before any test: a failed build shows up within minutes, the tests of a proof take hours.
    Step("build sanitize", build_sanitized),
    Step("test release", test("release", most_trials={TEST: 20}), needs=("build release",)),
    Step("test sanitize", test("sanitize", most_trials={TEST: 3, PROVE: 20}),
         needs=("build sanitize",)),
    Step("fuzz", fuzzing.run_all, needs=("build sanitize",), without=ALL_ROOMS),
    Step("headers alone, controller", build("cortex-m4f", "headers_alone"), (PROVE,),
         without=ALL_ROOMS),
    Step("headers alone, host", build("release", "headers_alone"), (PROVE,), without=ALL_ROOMS),
    Step("build benchmarks", build("release", "benchmarks"), (PROVE,), ("build release",)),
    Step("benchmarks", benchmarks, (PROVE,), ("build benchmarks",), ALL_ROOMS),
    Step("new seeds", seeds.run_for_a_while, (PROVE,), ("test release",)),
)


def steps_of(tier: str) -> list:
    return [step for step in STEPS if tier in step.tiers]


def environment() -> None:
    """Sets up the environment of all steps: a compiler cache across clones, sanitizers that print
    locations, and the commit from which the seeds of random tests are derived."""
    os.environ.update({
        "PATH": f"/usr/lib/ccache:{os.environ['PATH']}",
        "CCACHE_DIR": os.environ.get("CCACHE_DIR", str(ROOT / "build/ccache")),
        "CCACHE_BASEDIR": "/", "CCACHE_NOHASHDIR": "1",
        "CCACHE_SLOPPINESS": "pch_defines,time_macros",  # Else nothing with a precompiled header.
        "UBSAN_OPTIONS": "print_stacktrace=1",
        "ASAN_OPTIONS": "detect_stack_use_after_return=1",
    })
    os.environ.setdefault("KERFLINE_SEED_BASE", head()[:10])
    print(f"random tests: KERFLINE_SEED_BASE={os.environ['KERFLINE_SEED_BASE']}")
