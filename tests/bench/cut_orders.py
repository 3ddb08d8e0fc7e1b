#!/usr/bin/env python3
"""Measures the ordering of published problems and of nested sheets; prints figures, judges nothing.

    cut_orders.py KERFLINE DATA [LINE…]

DATA has the folders order, nest and laser: r1000.tsp, r35.tsp and precedence problems (*.pcglns),
nested sheets (*.svg) and layouts (*.json). LINE is any of: tours, sheets_of_many, precedence,
annealing, nests, prediction; the default is all. Each command is printed, then run while no other
command runs, so that the measured processor time and memory belong to it alone.
"""

import json
import math
import pathlib
import random
import re
import resource
import subprocess
import sys
import tempfile
import time

STEEL = ("--material", "CSP 1N", "--thickness", "2")
SEEDS = (1, 2, 3)
R1000_BEST = 23297628
# Proven optima of the problems with precedence and choice of start.
OPTIMA = {"e1x_6": 1513}


class Bench:
    def __init__(self, kerfline, data, scratch):
        self.kerfline, self.data, self.scratch = kerfline, data, scratch

    def run(self, *arguments):
        """Returns output, status, wall and processor seconds, and the MB of the largest child so far."""
        print("  $ kerfline", *arguments, flush=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        start = time.monotonic()
        done = subprocess.run([self.kerfline, *map(str, arguments)], capture_output=True, text=True,
                              check=False)
        wall = time.monotonic() - start
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        cpu = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        print(f"    status {done.returncode}, {wall:.2f} s, {cpu:.2f} s of processor, "
              f"at most {after.ru_maxrss / 1024:.0f} MB", flush=True)
        return done, wall

    def order(self, file, *options):
        done, wall = self.run("order", file, "--json", *options)
        return (json.loads(done.stdout) if done.returncode == 0 else None), wall

    def cut(self, file, *options):
        report = self.scratch / "report.json"
        report.unlink(missing_ok=True)
        done, _ = self.run("cut", file, *STEEL, "-o", self.scratch / "out.nc", "--report", report,
                           *options)
        if not report.exists():
            print("   ", done.stderr.strip().splitlines()[-1:])
            return None
        return json.loads(report.read_text())

    # The values of LINE: a method for each.

    def tours(self):
        for seed in SEEDS:
            result, _ = self.order(self.data / "order/r1000.tsp", "--seconds", 1, "--seed", seed)
            if result:
                print(f"    {100 * (result['cost'] / R1000_BEST - 1):.3f} % above the best known")
        side, count = 1.0e6, 10_000
        places = random.Random(20261127)
        lines = [f"{i + 1} {places.uniform(0, side):.3f} {places.uniform(0, side):.3f}"
                 for i in range(count)]
        file = self.scratch / "uniform.tsp"
        file.write_text("NAME: uniform\nTYPE: TSP\nDIMENSION: %d\nEDGE_WEIGHT_TYPE: EUC_2D\n"
                        "NODE_COORD_SECTION\n%s\nEOF\n" % (count, "\n".join(lines)))
        expected = 0.7124 * math.sqrt(count * side * side) * (1 + 0.33 / count)
        result, _ = self.order(file, "--seconds", 20)
        if result:
            print(f"    {100 * (result['cost'] / expected - 1):.3f} % above 0.7124 sqrt(n A)(1 + 0.33 / n)")

    def sheets_of_many(self):
        """Orders 100,000 squares and discs in rows, and made_1000 with free and with fixed starts."""
        side = 317
        shapes = []
        for i in range(100_000):
            x, y = 12 * (i % side), 12 * (i // side)
            shapes.append(f'<rect x="{x + 1}" y="{y + 1}" width="9" height="{5 + i % 4}"/>' if i % 3 else
                          f'<circle cx="{x + 5}" cy="{y + 5}" r="{3 + i % 2}"/>')
        file = self.scratch / "many.svg"
        size = 12 * side + 12
        file.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" width="{size}mm" height="{size}mm" '
                        f'viewBox="0 0 {size} {size}">\n' + "\n".join(shapes) + "\n</svg>\n")
        for sheet in (file, self.data / "nest/made_1000.svg"):
            for start in ("any", "usual"):
                self.print_order(self.cut(sheet, "--start", start))

    @staticmethod
    def print_order(report):
        if report is None:
            return
        order = report["order"]
        nearest = order["nearest_with_usual_starts"]
        of_file = order["file_with_usual_starts"]
        for name, key in (("rapids, mm", "rapid_length_mm"), ("rapids, s", "rapid_time_s"),
                          ("job, s", "predicted_job_time_s")):
            ours = order[key]
            print(f"    {name}: {ours:.1f}; nearest {nearest[key]:.1f} ({100 * (1 - ours / nearest[key]):.1f} % less), "
                  f"file {of_file[key]:.1f} ({100 * (1 - ours / of_file[key]):.1f} % less), "
                  f"listed starts only {order['with_listed_starts'][key]:.1f}")

    def precedence(self):
        for file in sorted((self.data / "order").glob("*.pcglns")):
            optimum = OPTIMA.get(file.stem)
            for seed in SEEDS:
                result, _ = self.order(file, "--seconds", 1, "--seed", seed)
                if result:
                    print(f"    {file.stem}: {result['cost']}, optimum {optimum or 'not known here'}")
            result, wall = self.order(file, "--order", "exact")
            if result:
                print(f"    {file.stem}: {result['cost']}, proven: {result['proven']}, "
                      f"solved in {result['time_s']:.3f} s of {wall:.3f}")

    def annealing(self):
        for name in ("r35.tsp", "r1000.tsp"):
            costs = {}
            for order in ("anneal", "ours"):
                for seed in SEEDS:
                    options = ("--seconds", 1) if order == "ours" else ()
                    result, _ = self.order(self.data / "order" / name, "--order", order, "--seed", seed, *options)
                    if result:
                        costs.setdefault(order, []).append(result["cost"])
            least = min(min(row) for row in costs.values())
            for order, row in costs.items():
                print(f"    {name}, {order}: " +
                      ", ".join(f"{100 * (cost / least - 1):.3f} %" for cost in row) + " above the least")

    def sheets(self):
        yield from (self.data / "nest" / f"{name}_sheet.svg" for name in ("albano", "shirts", "swim"))
        yield self.data / "laser/8877_01.DBS.JSON"

    def nests(self):
        for sheet in self.sheets():
            for cost in ("length", "time"):
                for group in ("none", "part"):
                    self.print_order(self.cut(sheet, "--anyway", "--cost", cost, "--group", group))

    def prediction(self):
        """Prints the predicted and the simulated time, without and with a limit of jerk."""
        examples = pathlib.Path(__file__).parents[2] / "host-sim/examples"
        drawings = [*sorted(examples.glob("*.svg")), *sorted(examples.glob("*.dxf")), *self.sheets()]
        for drawing in drawings:
            for jerk in (0, 5_000, 20_000, 200_000):
                report = self.cut(drawing, "--anyway", "--set", f"$800={jerk}", "--set", f"$801={jerk}")
                if report is None or report.get("job_time_is") != "simulated":
                    continue
                predicted = report["time"]["predicted_s"]
                driven = report["job_time_s"]
                print(f"    {drawing.name}, jerk {jerk}: {predicted:.2f} s predicted, {driven:.2f} s simulated, "
                      f"{100 * (predicted / driven - 1):+.2f} %")


def main():
    if len(sys.argv) < 3:
        print(__doc__)
        return 2
    kerfline, data = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2])
    wanted = sys.argv[3:] or ["tours", "sheets_of_many", "precedence", "annealing", "nests", "prediction"]
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(kerfline, data, pathlib.Path(folder))
        for line in wanted:
            if not re.fullmatch("tours|sheets_of_many|precedence|annealing|nests|prediction", line):
                print(f"no line {line}")
                return 2
            print(line, flush=True)
            getattr(bench, line)()
    return 0


if __name__ == "__main__":
    sys.exit(main())
