#!/usr/bin/env python3
"""The command line as its users call it: exit status, files, messages.

    command_line_test.py KERFLINE EXAMPLES
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

KERFLINE = ""
# Leaks of the libraries behind --png; only a sanitized build reads this file.
SUPPRESSIONS = pathlib.Path(__file__).with_name("leaks.supp")
EXAMPLES = pathlib.Path()


def run(*arguments, text=None, **environment):
    return subprocess.run(
        [KERFLINE, *map(str, arguments)], input=text, capture_output=True, text=True, check=False,
        env={"PATH": "/usr/bin", "LSAN_OPTIONS": f"suppressions={SUPPRESSIONS}", **environment})


class CommandLine(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.laser = ("--settings", EXAMPLES / "laser.settings")

    def test_sim_writes_every_file_it_is_asked_for(self):
        names = {key: self.folder / f"out.{key}" for key in ("trace", "vcd", "report", "svg", "png")}
        options = [word for key, name in names.items() for word in (f"--{key}", name)]
        done = run("sim", EXAMPLES / "circle_r20.nc", *self.laser, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        trace = names["trace"].read_text().splitlines()
        comments = [line for line in trace if line.startswith("#")]
        self.assertIn("# steps_per_mm X=160 Y=160 Z=400 A=100 B=100 C=100", comments)
        self.assertEqual(trace[len(comments)], "time_ns,x,y,z,a,b,c,s")
        report = json.loads(names["report"].read_text())
        self.assertLess(report["max_path_deviation_mm"], 0.0045)
        self.assertEqual(report["faults"], [])
        self.assertEqual(list(report["energy_per_mm_ratio"]), ["least", "mean", "greatest"])
        self.assertTrue(names["svg"].read_text().startswith("<"))
        self.assertEqual(names["png"].read_bytes()[:4], b"\x89PNG")
        self.assertIn("$var", names["vcd"].read_text())

    def test_same_call_writes_the_same_trace(self):
        traces = []
        for name in ("first", "second"):
            run("sim", EXAMPLES / "bracket.nc", *self.laser, "--trace", self.folder / name)
            traces.append((self.folder / name).read_bytes())
        self.assertEqual(traces[0], traces[1])

    def test_reads_standard_input(self):
        done = run("check", "-", text="G0 X1\n")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_wrong_calls_end_with_status_2(self):
        for call in ([], ["sim"], ["nonsense"], ["sim", self.folder / "missing.nc"],
                     ["sim", EXAMPLES / "circle_r20.nc", "--set", "$110"],
                     ["sim", EXAMPLES / "circle_r20.nc", "--set", "$110=-1"],
                     ["sim", EXAMPLES / "circle_r20.nc", "--set", "$9999=1"],
                     ["sim", EXAMPLES / "circle_r20.nc", "--trace", self.folder / "no" / "such"],
                     ["sim", EXAMPLES / "circle_r20.nc", EXAMPLES / "bracket.nc", "--svg", "x"]):
            with self.subTest(call=call):
                done = run(*call)
                self.assertEqual(done.returncode, 2, done.stdout)
                self.assertNotEqual(done.stderr, "")

    def test_several_programs_fill_the_placeholder(self):
        done = run("sim", EXAMPLES / "circle_r20.nc", EXAMPLES / "bracket.nc", *self.laser,
                   "--report", self.folder / "{}.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "bracket.json").exists())
        self.assertTrue((self.folder / "circle_r20.json").exists())

    def test_offset_writes_contours_and_a_picture(self):
        part, cut, svg = (self.folder / name for name in ("part.txt", "cut.txt", "cut.svg"))
        part.write_text("# clockwise, with a hole\n0 0\n0 10\n10 10\n10 0\n\n4 5 1\n6 5 1\n")
        done = run("offset", part, "--distance", "-1", "0.5", "-o", cut, "--svg", svg)
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = cut.read_text().splitlines()
        heads = [line for line in lines if line.startswith("#")]
        self.assertEqual(heads, ["# distance -1 mm: 6 vertices, loops: 2",
                                 "# distance 0.5 mm: 10 vertices, loops: 2"])
        self.assertEqual(sorted(lines[1:5]), ["1 1 0", "1 9 0", "9 1 0", "9 9 0"])
        self.assertEqual(svg.read_text().count('fill-rule="evenodd"'), 3)
        again = run("offset", cut, "--distance", "0")
        self.assertEqual(again.returncode, 0, again.stderr)

    def test_offset_names_file_line_and_reason(self):
        part = self.folder / "part.txt"
        part.write_text("0 0\n1 nothing\n")
        done = run("offset", part, "--distance", "1")
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, f"{part}:2: `nothing` is no number for y\n")
        part.write_text("0 0\n5 0\n5 1e30\n")
        self.assertEqual(run("offset", part, "--distance", "1").stderr,
                         f"{part}: vertex 3 at 5 1e+30: is farther than 10 km from the origin; "
                         "check that its unit is mm\n")
        for distance in ("nan", "inf", "1e300", "x"):
            done = run("offset", part, "--distance", distance)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("--distance", done.stderr)
        self.assertEqual(run("offset", self.folder / "none", "--distance", "1").returncode, 2)
        self.assertEqual(run("offset", part).returncode, 2)
        self.assertEqual(run("offset", "-", "--distance", "1", text="0 0\n1 0\n0 1\n").returncode, 0)

    def test_offset_reads_drawings_and_writes_dxf(self):
        part, dxf = self.folder / "part.svg", self.folder / "cut.dxf"
        part.write_text("<svg width='40mm' height='40mm' viewBox='0 0 40 40'>\n"
                        "<ellipse cx='20' cy='20' rx='15' ry='10'/></svg>")
        counts = {}
        for fit in ("fewest", "paper"):
            done = run("offset", part, "--distance", "0.28", "--tolerance", "0.1", "--fit", fit, "--dxf", dxf)
            self.assertEqual(done.returncode, 0, done.stderr)
            counts[fit] = len(done.stdout.splitlines()) - 2
            again = run("offset", dxf, "--distance", "0")
            self.assertEqual(len(again.stdout.splitlines()) - 2, counts[fit], again.stderr)
        self.assertLess(counts["fewest"], counts["paper"])
        part.write_text("<svg width='9mm' height='9mm' viewBox='0 0 9 9'><path id='p' d='M1 1L8 1'/></svg>")
        done = run("offset", part, "--distance", "1")
        self.assertEqual((done.returncode, done.stdout), (1, ""))
        self.assertIn('path "p" at 1.000 8.000: the contour is open', done.stderr)
        self.assertEqual(run("offset", dxf, "--distance", "1", "--tolerance", "0").returncode, 2)
        self.assertEqual(run("offset", dxf, "--distance", "1", "--fit", "best").returncode, 2)

    def test_offset_takes_parts_of_a_file_one_by_one(self):
        """All parts of a nesting job are drawn at their own origin."""
        square = [[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]]
        cross = [[x - 3, y + 4] for x, y in square]
        items = [{"id": i, "demand": 1, "allowed_orientations": [0.0],
                  "shape": {"type": "simple_polygon", "data": data}}
                 for i, data in enumerate((square, cross, square))]
        nest = self.folder / "nest.json"
        nest.write_text(json.dumps({"name": "nest", "items": items, "strip_height": 20}))
        done = run("offset", nest, "--distance", "1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("# distance 1 mm: 24 vertices, loops: 3\n", done.stdout)

    def test_drawing_lists_contours_and_names_faults(self):
        part = self.folder / "part.svg"
        part.write_text("<svg width='40mm' height='40mm' viewBox='0 0 40 40'>\n<circle cx='20' cy='20' r='10'/>"
                        "<circle cx='20' cy='20' r='5'/>\n<path id='p' d='M1 1L9 1'/></svg>")
        picture = self.folder / "out.svg"
        done = run("drawing", part, "--svg", picture)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("hole  in 1", done.stdout)
        self.assertIn(f'{part}:3:1: path "p" at 1.000 39.000: the contour is open', done.stdout)
        self.assertEqual(picture.read_text().count("<circle"), 1)
        read = json.loads(run("drawing", part, "--json").stdout)
        self.assertEqual([row["side"] for row in read["contours"]], ["outer", "hole", "open"])
        self.assertEqual(read["contours"][0]["kinds"], {"arc": 1})
        self.assertEqual(run("drawing", part, "--gap", "-1").returncode, 2)
        self.assertEqual(run("drawing", self.folder / "none.svg").returncode, 2)

    def test_version_is_in_reports_and_answers(self):
        version = run("--version").stdout.strip()
        self.assertRegex(version, r"^\d+\.\d+\.\d+(\+[0-9a-f]{7}(-dirty)?)?$")
        self.assertEqual(json.loads(run("check", "-", "--json", text="G0 X1\n").stdout)[0]["version"], version)

    def test_prints_completions_and_manual(self):
        for shell in ("bash", "zsh", "fish"):
            self.assertIn("--probe-plate" if shell != "fish" else "-l probe-plate",
                          run("completion", shell).stdout)
        done = run("completion", "tcsh")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("tcsh", done.stderr)
        self.assertIn(".SH NAME\nkerfline ", run("manual").stdout)

    def commands(self, words=()):
        text = run(*words, "--help").stdout
        yield words, text
        _, _, below = text.partition("\nSubcommands:\n")
        for name in re.findall(r"^  (\w+) ", below.split("\n\n")[0], re.MULTILINE):
            yield from self.commands((*words, name))

    def test_help_begins_with_examples_of_the_command(self):
        for words, text in self.commands():
            with self.subTest(words=words):
                before, found, after = text.partition("\nExample")
                self.assertTrue(found, text)
                self.assertNotIn("Options:", before)
                self.assertIn("Options:", after)
                examples = after.split("\n\n")[0]
                self.assertIn(" ".join(["kerfline", *words]), examples)
                self.assertEqual(text.count("\nExample"), 1)

    def test_a_wrong_word_names_its_nearest_neighbour(self):
        job = EXAMPLES / "circle_r20.nc"
        for call, told in ((["chek", job], "chek: no such command; there are sim check"),
                           (["chek", job], "did you mean check?"),
                           (["kerf", "advice"], "did you mean advise?"),
                           (["cal"], "no such command"),
                           (["sim", job, "--sgv", "x"], "--sgv: `kerfline sim` has no such option; did you"),
                           (["sim", job, "--sgv", "x"], "did you mean --svg?"),
                           (["sim", job, "--trac=x"], "did you mean --trace?"),
                           (["send", job, "--prot", "x"], "did you mean --port?"),
                           (["--versoin"], "--versoin: `kerfline` has no such option; did you mean --version?"),
                           (["kerf", "--hepl"], "`kerfline kerf` has no such option; did you mean --help?"),
                           (["kerf", "advise", "--matrial", "x"], "`kerfline kerf advise` has no such option; did you"
                            " mean --material?"),
                           (["kerf", "calibrate", "--form", "x", "--oud", "y"], "did you mean --out?"),
                           (["sim", job, "-svg", "x"], "-svg: `kerfline sim` has no such option; did you mean --svg?"),
                           (["cut", EXAMPLES / "plate.svg", "--material", "CSP 1N", "--thickness", "2", "--layer",
                             "black: tabz=2"], "did you mean tabs?"),
                           (["cut", EXAMPLES / "plate.svg", "--material", "CSP 1n", "--thickness", "2"],
                            "did you mean CSP 1N?"),
                           (["check", job, "--xyzzy"], "--xyzzy: `kerfline check` has no such option\n")):
            with self.subTest(call=call):
                done = run(*call)
                self.assertEqual((done.returncode, done.stdout), (2, ""))
                self.assertIn(told, done.stderr)

    def test_wrong_values_name_range_and_unit(self):
        job, part = EXAMPLES / "circle_r20.nc", EXAMPLES / "plate.svg"
        for call, option, told in (
                (["sim", job], "--kerf", "0 to 100 mm"), (["sim", job], "--probe-plate", "-10000 to 10000 mm"),
                (["sim", job], "--stock-cell", "0.001 to 10 mm"),
                (["drawing", part], "--gap", "0 to 10 mm"), (["offset", part], "--distance", "mm"),
                (["serve", "--tcp", "0"], "--speed", "0.01 to 1000"),
                (["serve", "--tcp", "0"], "--node", "1 to 126"),
                (["send", job, "--tcp", "localhost:1"], "--window", "16 to 65536 bytes"),
                (["cut", part, "--material", "CSP 1N", "--thickness", "2"], "--full-power", "W"),
                (["cut", part, "--material", "CSP 1N", "--thickness", "2"], "--decimals", "3 to 5"),
                (["kerf", "advise", "--material", "CSP 1N"], "--thickness", "0 to 100 mm"),
                (["kerf", "advise", "--material", "CSP 1N", "--thickness", "2"], "--speed", "mm/min"),
                (["kerf", "plot", "--material", "CSP 1N"], "--thickness", "0 to 100 mm"),
                (["kerf", "calibrate", "--material", "CSP 1N"], "--thickness", "0 to 100 mm"),
                (["kerf", "calibrate", "--material", "CSP 1N", "--thickness", "2"], "--powers", "W"),
                (["kerf", "calibrate", "--material", "CSP 1N", "--thickness", "2"], "--speeds", "mm/min"),
                (["serve"], "--tcp", "0 to 65535"), (["serve"], "--ws", "0 to 65535"),
                (["send", job], "--tcp", "0 to 65535"),
                *((["cut", part, "--material", "CSP 1N", "--thickness", "2"], f"--{key}", unit)
                  for key, unit in (("tabs", "0 to 1000 tabs"), ("overcut", "0 to 1000 mm"), ("pierce", "0 to 60 s"),
                                    ("tab-width", "0.01 to 1000 mm"), ("corner-angle", "1 to 180 degrees"),
                                    ("common-line", "0 to 1 mm"), ("narrow", "0 to 1 mm"),
                                    ("power", "W"), ("feed", "mm/min"))),
                (["kerf", "advise", "--material", "CSP 1N", "--thickness", "2"], "--power", "W"),
                (["kerf", "calibrate", "--material", "CSP 1N", "--thickness", "2"], "--length", "10 to 1000 mm")):
            for value in ("nan", "1e30", "-1e30", "word"):
                with self.subTest(option=option, value=value):
                    done = run(*call, option, value)
                    self.assertEqual((done.returncode, done.stdout), (2, ""))
                    self.assertIn(option, done.stderr)
                    self.assertIn(told, done.stderr)

    def test_settings_name_range_and_unit(self):
        job = EXAMPLES / "circle_r20.nc"
        for value, told in (("$110=1e30", "0.1 to 1000000 mm/min"), ("$110=-1", "mm/min"), ("$130=-5", "mm"),
                            ("$11=1e9", "mm")):
            done = run("check", job, "--set", value)
            self.assertEqual(done.returncode, 2)
            self.assertRegex(done.stderr, r"--set: \$\d+=\S+: value is (above|below) the range of this setting, \S+ to "
                                          rf"\S+ {told.split()[-1]}\n")

    def test_a_recording_from_standard_input_is_not_rewritten(self):
        done = subprocess.run([KERFLINE, "replay", "-", "--update"], input="kerfline conversation 1\nend 1000\n",
                              capture_output=True, text=True, check=False, cwd=self.folder)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("--update rewrites its files, and `-` is standard input", done.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_no_program_says_what_stays(self):
        old, part = self.folder / "part.nc", self.folder / "part.svg"
        old.write_text("old")
        part.write_text("<svg width='9mm' height='9mm' viewBox='0 0 9 9'><path d='M1 1L8 1V7 M8 7.25H1V1.25'/></svg>")
        for call in (("cut", part, "--material", "CSP 1N", "--thickness", "2"), ("offset", part, "-d", "1")):
            done = run(*call, "-o", old)
            self.assertEqual(done.returncode, 1)
            self.assertIn(f"{old} is still the earlier file", done.stderr)
            self.assertNotIn("is still", run(*call, "-o", self.folder / "new").stderr)
        self.assertEqual(old.read_text(), "old")

    def test_figures_read_from_steps_state_their_error(self):
        done = run("sim", "-", *self.laser, "--json", text="G21 G91\nG1 X100 F12000\n")
        report = json.loads(done.stdout)
        speed, error = (report["max_speed_mm_s"]["X"], report["measuring_error"]["max_speed"]["X"])
        self.assertGreater(speed, 199.0)
        self.assertLess(speed, 200.0 + error)
        self.assertGreater(error, 0.0)
        self.assertIn("read from steps: up to ", run("sim", "-", *self.laser, text="G21 G91\nG1 X9 F9000\n").stdout)

    def test_one_cut_length_everywhere(self):
        job, svg = EXAMPLES / "circle_r20.nc", self.folder / "out.svg"
        simulated = json.loads(run("sim", job, *self.laser, "--json", "--svg", svg).stdout)["cut_length_mm"]
        checked, = json.loads(run("check", job, *self.laser, "--json").stdout)
        self.assertEqual(checked["cut_length_mm"], simulated)
        self.assertIn(f"{simulated:.1f} mm of it cut", run("check", job, *self.laser).stdout)
        self.assertIn(f"{simulated:.1f} mm of it cut", run("sim", job, *self.laser).stdout)
        self.assertIn(f"{simulated:.1f} mm cut", svg.read_text())

    def test_a_picture_shows_what_matters_of_the_job(self):
        """The picture shows the depth of a mill, the power of a relief, the speed of a cut; only a
        laser has a kerf.
        """
        rows = "".join(f"G1 X{x} S{37 * x % 1000} F6000\n" for x in range(1, 40))
        for text, options, heading, kerf in (
                ("G21 G90\nM3 S500\nG1 Z-1 F600\nG1 X20\nZ-3\nX0\nM5\n", ("--set", "$32=0"), "Depth, mm", False),
                ("G21 G90\nM3 S500\nG1 X20 F600\nM5\n", ("--set", "$32=0"), "Speed, mm/min", False),
                (f"G21 G90\nM4 S0\n{rows}M5\n", self.laser, "Power, %", True),
                ("G21 G90\nM4 S500\nG1 X20 F600\nM5\n", self.laser, "Speed, mm/min", True)):
            svg = self.folder / "out.svg"
            done = run("sim", "-", *options, "--svg", svg, text=text)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn(heading, svg.read_text())
            self.assertEqual("kerf" in svg.read_text(), kerf, heading)

    def test_depth_counts_from_zero_or_from_the_highest_cut(self):
        for levels, deepest in (((-1, -4), "4"), ((10, 6), "4"), ((2, -3), "3")):
            svg = self.folder / "out.svg"
            text = f"G21 G90\nG0 Z20\nM3 S500\nG1 Z{levels[0]} F600\nX20\nZ{levels[1]}\nX0\nM5\nG0 Z20\n"
            self.assertEqual(run("sim", "-", "--set", "$32=0", "--svg", svg, text=text).returncode, 0)
            legend = svg.read_text().partition("Depth, mm")[2].partition(">cut<")[0]
            self.assertEqual(re.findall(r">([\d.]+)</text>", legend)[-1], deepest, levels)

    def test_an_offset_that_vanishes_is_told(self):
        part = self.folder / "part.txt"
        part.write_text("0 0\n40 0\n40 30\n0 30\n\n10 10 1\n14 10 1\n")
        for distance, told in (("-100", ["the loop that begins at"]), ("3", ["the hole that begins at"])):
            done = run("offset", part, "-d", distance)
            self.assertEqual(done.returncode, 1, done.stdout)
            for words in told:
                self.assertIn(words, done.stderr)
            self.assertIn(f"vanishes at distance {distance} mm", done.stderr)
        for distance in ("-2", "1.9", "0"):
            self.assertEqual(run("offset", part, "-d", distance).returncode, 0)

    def test_an_offset_that_vanishes_in_parts_is_told(self):
        """Frames, lobes, slots and gaps are reported; corners, however sharp, and fillets are not."""
        part = self.folder / "part.txt"
        frame = "0 0\n40 0\n40 40\n0 40\n\n5 5\n35 5\n35 35\n5 35\n"
        lobe = "0 0\n40 0\n40 40\n21 40\n21 50\n19 50\n19 40\n0 40\n"
        slot = "0 0\n40 0\n40 40\n21 40\n21 20\n19 20\n19 40\n0 40\n"
        for text, distance, told in (
                (frame, "-3", ["the loop that begins at 0.000 0.000 vanishes at distance -3 mm"]),
                (frame + "\n100 0\n140 0\n140 40\n100 40\n", "-3", ["the loop that begins at 0.000 0.000 vanishes"]),
                (frame, "-2", []), (frame, "20", ["the hole that begins at 5.000 5.000 vanishes"]),
                (lobe, "-2", ["22.0 mm of the loop that begins at 0.000 0.000, from about 21.000 45.000 on"]),
                (lobe, "-0.5", []), (lobe, "2", []),
                (slot, "2", ["42.0 mm of the loop that begins at 0.000 0.000, from about 21.000 30.000 on"]),
                (slot, "0.5", []), (slot, "-2", []),
                ("0 0\n60 4\n0 8\n", "-1", []), ("0 0\n40 0 0.4142135624\n43 3\n43 40\n0 40\n", "-5", []),
                ("0 0\n20 0\n20 20\n0 20\n\n22 0\n42 0\n42 20\n22 20\n", "3", ["20.0 mm of the loop that begins at"])):
            with self.subTest(text=text, distance=distance):
                part.write_text(text)
                done = run("offset", part, "-d", distance)
                for words in told:
                    self.assertIn(words, done.stderr)
                if not told:
                    self.assertEqual(done.stderr, "")
                self.assertEqual(done.returncode, 1 if told else 0, done.stderr)

    def test_contours_are_numbered_in_their_picture(self):
        svg = self.folder / "out.svg"
        run("drawing", EXAMPLES / "plate.svg", "--svg", svg)
        numbers = re.findall(r">(\d+)</text>", svg.read_text())
        self.assertEqual(numbers, [str(i + 1) for i in range(len(numbers))])
        self.assertGreater(len(numbers), 1)

    def test_flat_arcs_are_drawn_where_they_are(self):
        """An arc of 100 mm with a rise of 0.2 mm is part of a circle of 6 m, whose centre
        renderers compute wrongly.
        """
        part, svg = self.folder / "part.txt", self.folder / "out.svg"
        part.write_text("0 0 0.004\n100 0\n100 50\n0 50\n")
        self.assertEqual(run("offset", part, "-d", "0", "--svg", svg).returncode, 0)
        self.assertNotRegex(svg.read_text(), r"A\d{5}")
        self.assertIn("C", svg.read_text())

    def test_pictures_fit_a_browser(self):
        svg = self.folder / "out.svg"
        for call in (("sim", EXAMPLES / "circle_r20.nc"), ("drawing", EXAMPLES / "plate.svg"),
                     ("offset", EXAMPLES / "plate.svg", "-d", "1"),
                     ("kerf", "plot", "--material", "CSP 1N")):
            run(*call, "--svg", svg)
            head = svg.read_text()[:400]
            self.assertIn("viewBox=", head)
            self.assertIn("max-width:100%;max-height:100vh", head)


if __name__ == "__main__":
    KERFLINE, EXAMPLES = sys.argv[1], pathlib.Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])
