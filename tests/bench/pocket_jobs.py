#!/usr/bin/env python3
"""Mills random pockets with each strategy, carves them with the simulator, and prints faults and
figures.

    pocket_jobs.py KERFLINE [JOBS [SEED [STRATEGY…]]]

A job is a star with islands, or a letter-like comb, with lines and arcs, random tool, levels,
entry and step-over. Its program is simulated with a stock, which is compared with the drawing.
Faults are:
  * a program that is refused, unless the tool fits nowhere, or only straight down;
  * an alarm;
  * stock that is certainly gouged by more than two steps of the machine, or that remains by
  more than two steps where the tool fits;
  * a rapid in stock, or a plunge where none was requested.
"""

import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile

STRATEGIES = ("contour", "spiral", "adaptive", "zigzag")
MACHINE = [word for setting in ("$22=0", "$32=0", "$30=24000", "$100=320", "$101=320", "$102=320", "$110=5000",
                                "$111=5000", "$112=2000", "$120=400", "$121=400", "$122=250", "$130=500", "$131=500",
                                "$132=200")
           for word in ("--set", setting)]
CENTRE = 60.0
STEP = 1 / 320  # mm, of the machine.


def star(rng, centre, least, most, clockwise):
    count = rng.randint(4, 11)
    step = 2 * math.pi / count
    corners = [(step * (i + rng.uniform(-0.3, 0.3)), rng.uniform(least, most)) for i in range(count)]
    places = [(centre[0] + r * math.cos(a), centre[1] + r * math.sin(a)) for a, r in corners]
    bulges = [rng.choice((0, 0, rng.uniform(-0.12, 0.12))) for _ in places]
    if clockwise:
        places = places[::-1]
        bulges = [-b for b in bulges[-2::-1] + bulges[-1:]]
    return list(zip(places, bulges))


def comb(rng, tool):
    """Returns areas that are joined by necks, some of which are narrower than the tool."""
    x, top = 20.0, []
    for _ in range(rng.randint(2, 4)):
        width, half = rng.uniform(1.2, 3) * tool, rng.uniform(0.8, 3) * tool
        top += [(x, half), (x + width, half)]
        x += width
        neck, length = rng.uniform(0.4, 1.2) * tool, rng.uniform(0.3, 2) * tool
        top += [(x, neck), (x + length, neck)]
        x += length
    top = top[:-2]
    walls = [(px, CENTRE - py) for px, py in top] + [(px, CENTRE + py) for px, py in reversed(top)]
    return [(place, 0.0) for place in walls]


def polygon(loop):
    """Returns points along a loop; its arcs are short and flat."""
    places = []
    for ((x, y), bulge), ((to_x, to_y), _) in zip(loop, loop[1:] + loop[:1]):
        for share in (0, 0.25, 0.5, 0.75):
            out = 2 * bulge * share * (1 - share)  # Of the chord, to its right.
            places.append((x + share * (to_x - x) + out * (to_y - y), y + share * (to_y - y) - out * (to_x - x)))
    return places


def lies_in(island, wall):
    """Returns whether all points of an island are within the wall."""
    corners = polygon(wall)
    edges = list(zip(corners, corners[1:] + corners[:1]))

    def is_within(x, y):
        return sum((y0 > y) != (y1 > y) and x < x0 + (y - y0) * (x1 - x0) / (y1 - y0)
                   for (x0, y0), (x1, y1) in edges) % 2 == 1

    return all(is_within(x, y) for x, y in polygon(island))


def drawing(rng, tool):
    if rng.random() < 0.3:
        return [comb(rng, tool)]
    least = rng.uniform(1.0, 5.0) * tool
    loops = [star(rng, (CENTRE, CENTRE), least, min(least * rng.uniform(1, 1.6), 55.0), False)]
    for dx in (-0.25, 0.25):
        for dy in (-0.25, 0.25):
            if rng.random() < 0.3:
                middle = (CENTRE + dx * least, CENTRE + dy * least)
                island = star(rng, middle, 0.05 * least, 0.15 * least, True)
                if lies_in(island, loops[0]):
                    loops.append(island)
    return loops


def as_text(loops):
    return "".join("".join(f"{x:.9f} {y:.9f} {b:.9f}\n" for (x, y), b in loop) + "closed\n" for loop in loops)


class Jobs:
    def __init__(self, kerfline, scratch):
        self.kerfline, self.scratch = kerfline, scratch
        self.done = {}

    def call(self, *arguments):
        return subprocess.run([self.kerfline, *map(str, arguments)], capture_output=True, text=True, check=False,
                              env={"PATH": "/usr/bin"})

    def mill(self, wall, strategy, tool, words):
        program, report = self.scratch / "job.nc", self.scratch / "pocket.json"
        done = self.call("pocket", wall, "--tool", tool, "--feed", 1500, "--plunge-feed", 400, "--strategy", strategy,
                         "--anyway", "-o", program, "--report", report, *words)
        if done.returncode == 2 or not program.exists():
            return None, done.stderr.strip()
        return json.loads(report.read_text()), ""

    def carve(self, wall, tool, depth):
        report = self.scratch / "sim.json"
        done = self.call("sim", self.scratch / "job.nc", *MACHINE, "--stock", f"0,0,130,130,0,{-depth - 3}", "--tool",
                         tool, "--stock-cell", 0.1, "--stock-target", wall, "--stock-depth", depth, "--report", report)
        return (json.loads(report.read_text()) if done.returncode == 0 else None), done.stderr.strip()

    def run(self, number, seed, strategy):
        rng = random.Random(seed)
        tool = rng.choice((3, 4, 6, 8))
        wall = self.scratch / "wall.txt"
        wall.write_text(as_text(drawing(rng, tool)))
        depth, levels = rng.uniform(1, 6), rng.randint(1, 3)
        words = ["--depth", f"{depth:.3f}", "--depth-step", f"{depth / levels + 1e-3:.3f}"]
        entry = rng.choice(("helix", "ramp", "plunge"))
        words += ["--entry", entry]
        if strategy != "adaptive":
            if rng.random() < 0.5:
                most = 0.45 if strategy == "spiral" else 0.9
                words += ["--stepover", f"{rng.uniform(most / 3, most) * tool:.3f}"]
        else:
            words += ["--engagement", f"{rng.uniform(40, 120):.0f}"]
        if rng.random() < 0.3:
            words += ["--finish", f"{rng.uniform(0.02, 0.4) * tool:.3f}"]
        for old in self.scratch.glob("*.nc"):
            old.unlink()
        made, refusal = self.mill(wall, strategy, tool, words)
        if made is None:
            plunges = any(words in refusal for words in ("fits nowhere", "--entry plunge"))
            return self.count(strategy, "fits not" if plunges else "refused", number, seed, refusal)
        driven, refusal = self.carve(wall, tool, round(depth, 3))
        if driven is None:
            return self.count(strategy, "not driven", number, seed, refusal)
        stock = driven["stock"]
        target = stock["pocket"]
        for name, wrong in (("gouge", target["deepest_gouge"]["least_mm"] > 2 * STEP),
                            ("rest", target["tallest_rest"]["least_mm"] > 2 * STEP),
                            ("rapid in stock", stock["rapids_in_stock"]["count"] > 0),
                            ("plunge", entry != "plunge" and stock["plunges_in_stock"]["count"] > 0)):
            if wrong:
                self.count(strategy, name, number, seed, f"{tool} mm, {' '.join(words)}")
        return self.count(strategy, "driven", number, seed, "")

    def count(self, strategy, name, number, seed, text):
        self.done[strategy, name] = self.done.get((strategy, name), 0) + 1
        if name not in ("driven", "fits not"):
            print(f"  job {number}, seed {seed}, {strategy}: {name}: {text}", flush=True)


def main():
    kerfline = sys.argv[1]
    jobs = int(sys.argv[2]) if len(sys.argv) > 2 else 100
    base = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    strategies = sys.argv[4:] or STRATEGIES
    with tempfile.TemporaryDirectory() as folder:
        bench = Jobs(kerfline, pathlib.Path(folder))
        for number in range(jobs):
            for strategy in strategies:
                bench.run(number, base + number, strategy)
        for (strategy, name), count in sorted(bench.done.items()):
            print(f"{strategy:10} {name:16} {count}")


if __name__ == "__main__":
    main()
