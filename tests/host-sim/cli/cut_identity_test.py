#!/usr/bin/env python3
"""Rules of the shop, frames and the identity of programs of `kerfline cut`, as their users call them.

    cut_identity_test.py KERFLINE
"""

import http.client
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
PLATE = """<svg xmlns="http://www.w3.org/2000/svg" width="120mm" height="80mm" viewBox="0 0 120 80">
<path id="plate" d="M10 10H80A15 15 0 0 1 95 25V60H60V50A8 8 0 0 0 44 50V60H10Z"/>
<circle id="bore" cx="28" cy="30" r="9"/><circle id="screw" cx="80" cy="25" r="0.9"/>
<circle id="dot" cx="80" cy="35" r="0.4"/>
</svg>
"""
STEEL = ("--material", "CSP 1N", "--thickness", "2")
FINE_STEPS = ("--set", "$100=400", "--set", "$101=400")


def run(*arguments, text=None, folder=None):
    return subprocess.run([KERFLINE, *map(str, arguments)], input=text, capture_output=True,
                          text=True, check=False, env={"PATH": "/usr/bin"}, cwd=folder)


def hull_of(places):
    """Returns the convex hull, counter-clockwise, by Andrew's monotone chain."""
    def half(row):
        chain = []
        for place in row:
            while len(chain) > 1 and ((chain[-1][0] - chain[-2][0]) * (place[1] - chain[-2][1]) -
                                      (chain[-1][1] - chain[-2][1]) * (place[0] - chain[-2][0])) <= 0:
                chain.pop()
            chain.append(place)
        return chain[:-1]
    row = sorted(set(places))
    return half(row) + half(row[::-1])


def distance_to_ring(ring, place):
    def to_side(a, b):
        way = (b[0] - a[0], b[1] - a[1])
        square = way[0] ** 2 + way[1] ** 2
        share = ((place[0] - a[0]) * way[0] + (place[1] - a[1]) * way[1]) / square if square else 0.0
        share = min(1.0, max(0.0, share))
        return math.dist(place, (a[0] + share * way[0], a[1] + share * way[1]))
    return min(to_side(a, b) for a, b in zip(ring, ring[1:] + ring[:1]))


class Cut(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.plate = self.folder / "plate.svg"
        self.plate.write_text(PLATE)
        self.program = self.folder / "out.nc"

    def cut(self, *more, drawing=None, status=0):
        done = run("cut", drawing or self.plate, *STEEL, *more, "-o", self.program)
        self.assertEqual(done.returncode, status, done.stderr)
        return done

    def test_rules_of_a_file_and_of_the_call_are_reported_where_they_applied(self):
        rules = self.folder / "rules"
        rules.write_text("# the shop's\nhole diameter < thickness: feed=4000, lead-in=line:0.2\n")
        report = self.folder / "report.json"
        done = self.cut("--rules", rules, "--rule", "hole diameter < 1 mm: mark", "--report", report)
        self.assertIn('rule "hole diameter < thickness: feed=4000, lead-in=line:0.2": 2', done.stdout)
        rows = json.loads(report.read_text())["rules"]
        self.assertEqual([row["place"] for row in rows], [f"{rules}:2", "--rule"])
        self.assertEqual(sorted(rows[0]["contours"]), ['circle "dot"', 'circle "screw"'])
        self.assertEqual(rows[1]["contours"], ['circle "dot"'])
        program = self.program.read_text()
        self.assertIn('engraved, circle "dot"', program)
        self.assertIn("F4000", program)

    def test_bad_rules_are_refused_with_place_and_column(self):
        rules = self.folder / "rules"
        rules.write_text("hole: skip\nhole diameter 3: skip\n")
        for call, told in ((("--rules", rules), f"{rules}:2: column 15: requires `<`"),
                           (("--rule", "hole: fed=3"), "--rule: column 7: fed: there is no such setting"),
                           (("--rule", "hole: feed=1%"), '--rule: "hole: feed=1%": '),
                           (("--rule", "hole: mark", "--mark-power", "0"), "--mark-power")):
            done = self.cut(*call, status=2)
            self.assertIn(told, done.stderr)
            self.assertFalse(self.program.exists())

    def places(self, program, *, lit):
        """Returns the positions of the simulated machine along a program, mm; if `lit`, only those
        with the beam on.
        """
        trace = self.folder / "trace"
        done = run("sim", program, "--trace", trace, *FINE_STEPS, "--set", "$32=1")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = (line.split(",") for line in trace.read_text().splitlines() if line[0].isdigit())
        return [(int(row[1]) / 400, int(row[2]) / 400) for row in rows if not lit or float(row[-1]) > 0]

    def test_the_frame_is_driven_within_a_tenth_of_the_hull_of_the_job(self):
        frame = self.folder / "frame.nc"
        self.cut("--frame", frame, "--frame-power", "1", "--lead-in", "line:6")
        job = hull_of(self.places(self.program, lit=True))
        driven = self.places(frame, lit=True)
        self.assertGreater(len(driven), 1000)
        self.assertLess(max(distance_to_ring(job, place) for place in driven[::25]), 0.1)
        ring = hull_of(driven)
        self.assertLess(max(distance_to_ring(ring, place) for place in job), 0.1)
        self.assertLessEqual({float(s) for s in re.findall(r"S([\d.]+)", frame.read_text())}, {0.0, 10.0})

    def test_the_frame_is_dark_by_default_and_a_box_if_wanted(self):
        frame = self.folder / "frame.nc"
        self.cut("--frame", frame, "--frame-shape", "box", "--frame-feed", "1200")
        text = frame.read_text()
        self.assertIn("the box of all cuts, at 1200 mm/min, beam off", text)
        self.assertNotRegex(text, r"M3|M4|S[1-9]")
        self.assertEqual(self.places(frame, lit=True), [])
        job, box = self.places(self.program, lit=True), self.places(frame, lit=False)
        for axis in (0, 1):
            self.assertAlmostEqual(max(place[axis] for place in job), max(place[axis] for place in box), 1)

    def test_check_tells_what_has_changed_since_the_program_was_made(self):
        rules = self.folder / "rules"
        rules.write_text("hole diameter < 1: skip\n")
        self.cut("--rules", rules, "--set", "$110=9000")
        heading = re.findall(r"\(kerfline digest (\w+)=[0-9a-f]{16} (.*)\)", self.program.read_text())
        self.assertEqual(heading, [("drawing", "plate.svg"), ("rules", "rules"), ("kerf", "CSP 1N"),
                                   ("settings", "given")])

        def warnings(*more):
            done = run("check", self.program, "--json", *more)
            self.assertEqual(done.returncode, 0, done.stderr)
            return json.loads(done.stdout)[0]["warnings"]
        fine = ("--set", "$32=1", "--set", "$110=9000")
        self.assertEqual(warnings(*fine), [])
        self.assertIn("the settings ($30, $110", "\n".join(warnings("--set", "$32=1", "--set", "$110=8000")))
        self.plate.write_text(PLATE.replace("0.9", "0.8"))
        self.assertEqual(warnings(*fine), [f"{self.program}: the drawing plate.svg has changed since this "
                                           "program was made; cut it again"])
        rules.unlink()
        self.plate.unlink()
        self.assertEqual(warnings(*fine), [])

    def test_send_and_the_page_tell_it_too(self):
        self.cut("--set", "$110=9000")
        with subprocess.Popen([KERFLINE, "serve", "--tcp", "0", "--ws", "0", "--speed", "50", "--set", "$32=1",
                               "--set", "$110=8000"], cwd=self.folder, text=True, stdout=subprocess.PIPE,
                              stderr=subprocess.DEVNULL) as server:
            try:
                ways = "".join(iter(server.stdout.readline, "ready\n"))
                tcp, web = (re.search(fr"^{way} \S+:(\d+)$", ways, re.MULTILINE)[1] for way in ("tcp", "ws"))
                self.plate.write_text(PLATE.replace("0.9", "0.8"))
                for folder in (self.folder, self.folder.parent):
                    done = run("send", self.program, "--tcp", f"127.0.0.1:{tcp}", folder=folder)
                    self.assertIn("warning: the drawing plate.svg has changed", done.stderr)
                    self.assertIn("warning: the settings ($30, $110", done.stderr)
                page = http.client.HTTPConnection("127.0.0.1", int(web), timeout=20)
                page.request("POST", "/outline", self.program.read_bytes(),
                             {"Origin": f"http://127.0.0.1:{web}"})
                notes = json.loads(page.getresponse().read())["notes"]
                self.assertIn("the drawing plate.svg has changed since this program was made", notes[0])
                self.assertIn("the settings ($30, $110", notes[1])
            finally:
                server.terminate()

    def test_a_sheet_names_its_drawings_too(self):
        sheet = self.folder / "sheet.json"
        sheet.write_text(json.dumps({"kerfline_sheet": 1, "stock": {"width_mm": 300, "height_mm": 200},
                                     "parts": [{"drawing": "plate.svg", "x_mm": 5, "y_mm": 5}]}))
        self.cut("--rule", "hole diameter < 2: skip", drawing=sheet)
        names = re.findall(r"\(kerfline digest (\w+)=[0-9a-f]{16} (.*)\)", self.program.read_text())
        self.assertEqual(names[:2], [("sheet", "sheet.json"), ("drawing", "plate.svg")])
        sheet.write_text(sheet.read_text() + "\n")
        told = run("check", "out.nc", "--set", "$32=1", folder=self.folder)
        self.assertIn("the sheet sheet.json has changed", told.stdout)


if __name__ == "__main__":
    KERFLINE = sys.argv[1]
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
