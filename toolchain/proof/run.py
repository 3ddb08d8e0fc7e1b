#!/usr/bin/env python3
"""Runs the steps of a tier and sums up their results. Called by toolchain/test.sh and
toolchain/prove.sh.

    run.py test|prove [--only STEP]... [--again] [--list]

`prove` records passed steps in build/proof, by the content of the tree: started again, it continues
where it was interrupted. After a change in one room of tests, the tests of other rooms remain
passed. When everything has passed on a clean tree, it writes tests/proven.
The last line is `N passed, N failed`; the exit status is 0 only without a failure.
"""
import argparse
import csv
import sys
import time

import steps
from memory import Memory
from shell import ROOT, Outcome

SLOWEST = 10


def clock(seconds: float) -> str:
    return f"{int(seconds) // 60:3d} min {int(seconds) % 60:02d} s"


def run_steps(tier: str, chosen: list, memory: Memory) -> tuple:
    """Returns the total outcome, and rows (step, seconds, remark)."""
    total, rows, broken = Outcome(), [], set()
    for step in chosen:
        if before := memory.passed(step.name, step.without):
            total += Outcome(passed=before["passed"])
            rows.append((step.name, before["seconds"], "passed before"))
            continue
        missing = [need for need in step.needs if need in broken]
        if missing:
            total += Outcome(failed=[f"{step.name}: did not run, needs {', '.join(missing)}"])
            rows.append((step.name, 0.0, "did not run"))
            broken.add(step.name)
            continue
        print(f"\n==== {step.name}", flush=True)
        begin = time.monotonic()
        outcome = step.work(tier)
        seconds = time.monotonic() - begin
        total += outcome
        rows.append((step.name, seconds, f"{len(outcome.failed)} failed" if outcome.failed else ""))
        print(f"==== {step.name}: {clock(seconds)}", flush=True)
        if outcome.failed:
            broken.add(step.name)
        else:
            memory.note(step.name, step.without, seconds, outcome.passed)
    return total, rows


def sum_up(total: Outcome, rows: list) -> None:
    print("\n==== stages")
    for name, seconds, remark in rows:
        print(f"{clock(seconds)}  {name}  {remark}".rstrip())
    print(f"{clock(sum(seconds for _, seconds, _ in rows))}  all")
    slowest = sorted(total.seconds.items(), key=lambda item: -item[1])[:SLOWEST]
    if slowest:
        print(f"\n==== slowest {len(slowest)} tests")
    for name, seconds in slowest:
        print(f"{seconds:7.1f} s  {name}")
    print()
    for name in total.failed:
        print(f"failed: {name}")


def write_stages(tier: str, rows: list) -> None:
    """Writes the stages for toolchain/figures.py."""
    file = ROOT / "build/proof" / f"{tier}_stages.csv"
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("w", encoding="utf-8", newline="") as out:
        csv.writer(out).writerows((name, seconds) for name, seconds, _ in rows)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tier", choices=steps.BOTH)
    parser.add_argument("--only", action="append", default=[], metavar="STEP",
                        help="only this step; may be given several times")
    parser.add_argument("--again", action="store_true", help="forget what has passed before")
    parser.add_argument("--list", action="store_true", help="print the steps of the tier")
    options = parser.parse_args()
    chosen = steps.steps_of(options.tier)
    names = [step.name for step in chosen]
    if options.list:
        print("\n".join(names))
        return 0
    for name in options.only:
        if name not in names:
            parser.error(f"no step {name!r} in {options.tier}; --list names them")
    if options.only:
        chosen = [step for step in chosen if step.name in options.only]
    steps.environment()
    memory = Memory(options.tier, keeps=options.tier == steps.PROVE, forget=options.again)
    total, rows = run_steps(options.tier, chosen, memory)
    sum_up(total, rows)
    if not options.only:
        write_stages(options.tier, rows)
    if options.tier == steps.PROVE and not options.only and not total.failed:
        memory.write_proven(rows)
    print(f"{total.passed} passed, {len(total.failed)} failed")
    return int(bool(total.failed) or not total.passed)


if __name__ == "__main__":
    sys.exit(main())
