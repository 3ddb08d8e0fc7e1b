"""Runs every fuzz program for a while, from the seeds beside it and the examples."""
import os

from shell import ROOT, Outcome, run

SECONDS = {"test": 15, "prove": 360}  # Each; FUZZ_SECONDS says otherwise.


def run_all(tier: str) -> Outcome:
    folder = ROOT / "build/sanitize"
    names = sorted(f"fuzz_{path.stem}" for path in (ROOT / "tests/fuzz").glob("*.cpp"))
    total = Outcome()
    for name in names:
        corpus = folder / f"{name}.corpus"
        corpus.mkdir(parents=True, exist_ok=True)
        total += Outcome.of(name, run(
            str(folder / "tests" / name),
            f"-max_total_time={os.environ.get('FUZZ_SECONDS', SECONDS[tier])}", "-timeout=10",
            "-print_final_stats=1", f"-artifact_prefix={folder / name}.",
            str(corpus), "tests/fuzz/seeds", "host-sim/examples", log=folder / f"{name}.log"))
    return total
