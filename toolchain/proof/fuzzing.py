"""Runs the fuzz programs for a while, from their seeds and the examples. The programs of
tests/fuzz/cam run only in `prove`."""
import concurrent.futures
import os

from shell import ROOT, Outcome, run

SECONDS = {"test": 10, "prove": 360}  # Each; FUZZ_SECONDS says otherwise.


def fuzz(name: str, tier: str) -> Outcome:
    folder = ROOT / "build/sanitize"
    corpus = folder / f"{name}.corpus"
    corpus.mkdir(parents=True, exist_ok=True)
    return Outcome.of(name, run(
        str(folder / "tests" / name),
        f"-max_total_time={os.environ.get('FUZZ_SECONDS', SECONDS[tier])}", "-timeout=10",
        "-print_final_stats=1", f"-artifact_prefix={folder / name}.",
        str(corpus), "tests/fuzz/seeds", "host-sim/examples", log=folder / f"{name}.log"))


def run_all(tier: str) -> Outcome:
    pattern = "**/*.cpp" if tier == "prove" else "*.cpp"
    names = sorted(f"fuzz_{path.stem}" for path in (ROOT / "tests/fuzz").glob(pattern))
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return sum(pool.map(lambda name: fuzz(name, tier), names), Outcome())
