#!/usr/bin/env python3
"""kerfline order on generated problems: recomputed costs, precedence, and equal results of equal
calls.

    order_command_test.py KERFLINE
"""

import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
SEED = random.SystemRandom().randrange(1 << 32)


def run(*arguments, text=None):
    return subprocess.run([KERFLINE, "order", *map(str, arguments)], input=text, capture_output=True, text=True,
                          check=False, env={"PATH": "/usr/bin"})


class Sheet:
    """Parts with holes in rows as a PCGLNS file; some holes contain further parts with holes."""

    def __init__(self, seed, parts, points=6):
        choose = random.Random(seed)
        self.groups, self.pairs, places = [[1]], [], [(0, 0)]

        def contour(x, y, size, inside=None):
            self.groups.append([len(places) + i + 1 for i in range(points)])
            number = len(self.groups)
            turn = choose.random()
            for i in range(points):
                angle = 2 * math.pi * (i / points + turn)
                places.append((x + size * math.cos(angle), y + size * math.sin(angle)))
            if inside:
                self.pairs.append((number, inside))
            return number

        for _ in range(parts):
            x, y = choose.uniform(0, 500), choose.uniform(0, 500)
            outer = contour(x, y, 50)
            hole = contour(x + choose.uniform(-20, 20), y, 20, outer)
            if choose.random() < 0.5:
                contour(x, y, 8, hole)
        group_of = {vertex: i for i, group in enumerate(self.groups) for vertex in group}
        self.group_of = {vertex: group + 1 for vertex, group in group_of.items()}
        size = len(places)
        forbidden = {(then, first) for first, then in self.pairs}
        self.costs = [[-1 if (self.group_of[i + 1], self.group_of[k + 1]) in forbidden else
                       round(math.dist(places[i], places[k])) for k in range(size)] for i in range(size)]

    def text(self, more_pairs=()):
        rows = "\n".join(" ".join(map(str, row)) for row in self.costs)
        groups = "\n".join(f"{i} {' '.join(map(str, group))} -1" for i, group in enumerate(self.groups, 1))
        pairs = "\n".join(f"{first} {then} -1" for first, then in (*self.pairs, *more_pairs))
        return (f"NAME : sheet\nTYPE : PCGLNS\nCOMMENT : made\nDIMENSION : {len(self.costs)}\n"
                f"GTSP_SETS : {len(self.groups)}\nEDGE_WEIGHT_TYPE : EXPLICIT\nEDGE_WEIGHT_FORMAT : FULL_MATRIX\n"
                f"EDGE_WEIGHT_SECTION\n{rows}\nGTSP_SET_SECTION\n{groups}\nGTSP_SET_ORDERING\n{pairs}\n"
                "START_GROUP_SECTION\n1\nEOF\n")


class Order(unittest.TestCase):
    def solved(self, text, *options):
        done = run("-", "--json", *options, text=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def judge(self, sheet, result):
        groups = [sheet.group_of[vertex] for vertex in result["vertices"]]
        self.assertEqual(sorted(groups), list(range(1, len(sheet.groups) + 1)))
        self.assertEqual(groups, result["groups"])
        self.assertEqual(groups[0], 1)
        for first, then in sheet.pairs:
            self.assertLess(groups.index(first), groups.index(then))
        row = result["vertices"]
        legs = [sheet.costs[a - 1][b - 1] for a, b in zip(row, row[1:] + row[:1])]
        self.assertGreaterEqual(min(legs), 0)
        self.assertEqual(sum(legs), result["cost"])

    def test_every_order_is_a_tour_that_costs_what_it_says(self):
        for seed in range(SEED, SEED + 5):
            with self.subTest(seed=seed):
                sheet = Sheet(seed, 5)
                found = {}
                for order in ("ours", "anneal", "nearest", "file", "exact"):
                    steps = ("--steps", "3000") if order == "ours" else ()
                    result = self.solved(sheet.text(), "--order", order, *steps)
                    self.judge(sheet, result)
                    found[order] = result["cost"]
                    self.assertEqual(result["order"], order)
                self.assertEqual(found["ours"], found["exact"])
                self.assertTrue(self.solved(sheet.text(), "--order", "exact")["proven"])
                self.assertLessEqual(found["exact"], min(found.values()))

    def test_three_seeds_reach_the_optimum_in_a_second(self):
        sheet = Sheet(SEED, 9)
        least = self.solved(sheet.text(), "--order", "exact")["cost"]
        for seed in (1, 2, 3):
            result = self.solved(sheet.text(), "--seconds", "1", "--seed", seed)
            self.judge(sheet, result)
            self.assertEqual(result["cost"], least, f"sheet {SEED}, seed {seed}")

    def test_steps_give_the_same_tour_again_and_seeds_another_way(self):
        text = Sheet(SEED, 30).text()
        first, second = (self.solved(text, "--steps", "2000", "--seed", "5") for _ in range(2))
        first.pop("time_s"), second.pop("time_s")
        self.assertEqual(first, second)
        self.assertEqual(first["steps"], 2000)

    def test_annealing_has_its_course(self):
        course = self.solved(Sheet(SEED, 4).text(), "--order", "anneal")["course"]
        self.assertEqual(len(course), 70)
        self.assertAlmostEqual(course[0]["temperature"], 1.5)
        self.assertLess(course[-1]["cost"], course[0]["cost"])

    def test_what_has_no_order_is_told(self):
        sheet = Sheet(SEED, 3)
        first, then = sheet.pairs[0]
        done = run("-", text=sheet.text([(then, first)]))
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("standard input: the precedence is a cycle: ", done.stderr)
        self.assertIn(f"{first} before {then}", done.stderr)
        done = run("-", "--order", "exact", "--memory", "1", text=Sheet(SEED, 20, 3).text())
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("raise --memory", done.stderr)
        for row in sheet.costs[1:]:
            row[0] = -1  # Nothing leads home.
        done = run("-", "--steps", "100", text=sheet.text())
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn("no tour without a forbidden leg", done.stderr)

    def test_wrong_calls_and_files_are_told(self):
        for options in (("--order", "best"), ("--seconds", "-1"), ("--seed", "x"), ("--seconds", "1", "--steps", "1")):
            done = run("-", *options, text="TYPE: TSP\n")
            self.assertEqual((done.returncode, done.stdout), (2, ""), options)
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "bad.tsp"
            file.write_text("TYPE: TSP\nEDGE_WEIGHT_TYPE: ATT\n")
            done = run(file)
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn(f"{file}:2: EDGE_WEIGHT_TYPE `ATT` is not supported; it must be EUC_2D, CEIL_2D or EXPLICIT",
                      done.stderr)


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    print("seed", SEED)
    unittest.main()
