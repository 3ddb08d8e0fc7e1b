"""Runs the random tests at new seeds for a while: for KERFLINE_MINUTES, by default 10."""
import os
import re
import subprocess
import time
import xml.etree.ElementTree as ElementTree

from ctest_run import MARK
from memory import TestMemory
from shell import ROOT, Outcome

KNOWN = "a known fault violates some new seeds"  # Printed by tests that then may fail here.


def random_tests() -> list:
    """Returns the names of the release tests that printed their first seeds, in the last run or
    before."""
    report = ElementTree.parse(ROOT / "build/release/ctest.xml").getroot()
    names = {case.get("name") for case in report.iter("testcase")
             if MARK in (case.findtext("system-out") or "")}
    names |= {name for name, note in TestMemory("release").notes.notes.items() if note["random"]}
    return sorted(names)


def run_once(names: list, base: str) -> list:
    """Returns the names of the tests that failed at this base, except known faults, which it
    prints."""
    report = ROOT / "build/release/seeds.xml"
    pattern = "^(" + "|".join(re.escape(name) for name in names) + ")$"
    subprocess.run(["ctest", "--preset", "release", f"-j{os.cpu_count()}", "-R", pattern, "--quiet",
                    "--output-junit", str(report), "--test-output-size-failed", "65536"], cwd=ROOT,
                   check=False,
                   env=os.environ | {"KERFLINE_TIER": "seeds", "KERFLINE_SEED_BASE": base})
    failed = []
    for case in ElementTree.parse(report).getroot().iter("testcase"):
        text = case.findtext("system-out") or ""
        if case.get("status") == "run":
            continue
        if KNOWN in text:
            print(f"known fault: {case.get('name')} at KERFLINE_SEED_BASE={base}", flush=True)
        else:
            failed.append(f"{case.get('name')} at KERFLINE_SEED_BASE={base}")
            print(text[-3000:], flush=True)
    return failed


def run_for_a_while(_tier: str) -> Outcome:
    end = time.monotonic() + 60.0 * float(os.environ.get("KERFLINE_MINUTES", "10"))
    names = random_tests()
    if not names:
        return Outcome(failed=["no test of the release run says where its seeds begin"])
    base = os.environ["KERFLINE_SEED_BASE"]
    rounds, failed = 0, []
    while time.monotonic() < end:
        rounds += 1
        failed += run_once(names, f"{base}/{rounds}")
        print(f"{len(names)} random tests, {rounds} rounds, {len(failed)} failed", flush=True)
    return Outcome(passed=rounds * len(names) - len(failed), failed=failed)
