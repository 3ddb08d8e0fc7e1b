#!/usr/bin/env python3
"""Counts instructions per line, block, segment and step interrupt with callgrind.

    tests/bench/count_instructions.py build/release/host-sim/kerfline

Runs `kerfline check` on two files, 20,000 lines of 0.1 mm and 400 arcs, and
prints the instructions that each stage took on this machine, its callees
included, on average per call. Counts do not depend on how busy the machine is.
"""

import collections
import math
import pathlib
import re
import subprocess
import sys
import tempfile

# (printed name, unit, function that performs the stage)
STAGES = [
    ("read and parse", "line", "cnc::gcode::Interpreter::interpret("),
    ("take it into the path", "element", "cnc::path::PathStage::put("),
    ("round and weld", "call", "cnc::path::PathStage::next("),
    ("judge a corner", "corner", "cnc::path::examine("),
    ("build a block", "block", "cnc::motion::build_block("),
    ("take it into the queue", "block", "cnc::motion::BlockQueue::push("),
    ("look ahead", "main loop turn", "cnc::motion::BlockQueue::plan("),
    ("cut a segment", "segment", "cnc::motion::Segmenter::next("),
    ("step interrupt", "interrupt", "::on_interrupt()"),
]


def freeform(lines: int) -> str:
    text, x, y, step = ["G21 G90 G1 F6000"], 100.0, 100.0, 0.1
    for i in range(lines):
        s = step * i
        angle = 1.5 * math.sin(s / 9) + 0.8 * math.sin(s / 31) + s / 40
        x += step * math.cos(angle)
        y += step * math.sin(angle)
        text.append(f"X{x:.3f} Y{y:.3f}")
    return "\n".join(text) + "\n"


def arcs(count: int) -> str:
    text, x, y = ["G21 G90 G1 F6000"], 0.0, 0.0
    for i in range(count):
        r = 2 + 0.1 * (i // 4 % 31)
        clockwise, upright = i % 4 < 2, i % 2 == 0
        rise = r if clockwise == upright else -r
        centre = (r, 0.0) if upright else (0.0, rise)
        x, y = x + r, y + rise
        code = "G2" if clockwise else "G3"
        text.append(f"{code} X{x:.3f} Y{y:.3f} I{centre[0]:.3f} J{centre[1]:.3f}")
    return "\n".join(text) + "\n"


def read_profile(path: pathlib.Path) -> dict[str, tuple[int, int]]:
    """Returns the number of calls and of instructions, callees included, by the callee's name."""
    names: dict[str, str] = {}
    totals: dict[str, list[int]] = collections.defaultdict(lambda: [0, 0])
    callee, calls = "", 0
    for line in path.read_text().splitlines():
        if match := re.match(r"c?fn=\((\d+)\)(?: (.*))?", line):
            if match[2]:
                names[match[1]] = match[2]
            if line.startswith("cfn"):
                callee = names[match[1]]
        elif match := re.match(r"calls=(\d+)", line):
            calls = int(match[1])
        elif calls:
            totals[callee][0] += calls
            totals[callee][1] += int(line.split()[1])
            calls = 0
    return {name: (count, cost) for name, (count, cost) in totals.items()}


def profile(kerfline: str, program: str, folder: pathlib.Path) -> dict[str, tuple[int, int]]:
    job, out = folder / "job.nc", folder / "callgrind.out"
    job.write_text(program)
    command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", kerfline, "check"]
    travel = [f"--set=${number}=0" for number in (130, 131)]
    subprocess.run([*command, str(job), *travel], check=True, capture_output=True)
    return read_profile(out)


def report(title: str, counts: dict[str, tuple[int, int]]) -> bool:
    print(title)
    complete = True
    for words, unit, function in STAGES:
        found = [value for name, value in counts.items() if function in name]
        calls, cost = sum(c for c, _ in found), sum(i for _, i in found)
        complete &= calls > 0
        print(f"  {words:<24}{cost / max(1, calls):9.0f} per {unit:<15}{calls:9d} times")
    return complete


def main() -> int:
    if len(sys.argv) != 2:
        print(__doc__)
        return 2
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        complete = report("20,000 lines of 0.1 mm", profile(sys.argv[1], freeform(20_000), place))
        complete &= report("400 tangent arcs", profile(sys.argv[1], arcs(400), place))
    return 0 if complete else 1


if __name__ == "__main__":
    sys.exit(main())
