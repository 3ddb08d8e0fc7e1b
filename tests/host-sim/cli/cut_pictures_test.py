#!/usr/bin/env python3
"""`kerfline cut` with pictures: position, darkness and settings of the burnt picture, and
refusals.

    cut_pictures_test.py KERFLINE
"""

import base64
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

from engrave_command_test import LASER, burnt, png_of

KERFLINE = ""
CUT = ("--kerf", "0.15", "--power", "60%", "--feed", "600")
PIXEL, FEED = 0.5, 3000.0
BURN = f"image: kind=image, power=80%, feed={FEED:.0f}, interval={PIXEL}"
GREYS = [[0, 60, 120, 180], [255, 200, 30, 90], [10, 20, 250, 128]]
PLATE = '<rect id="plate" x="1" y="1" width="38" height="28"/>'


def run(*arguments):
    return subprocess.run([KERFLINE, *map(str, arguments)], capture_output=True, text=True, check=False,
                          env={"PATH": "/usr/bin"})


def page(*elements):
    return ('<svg xmlns="http://www.w3.org/2000/svg" width="40mm" height="30mm" viewBox="0 0 40 30" fill="none" '
            'stroke="#000">' + "".join(elements) + "</svg>")


def image(attributes, greys=None, link=None):
    data = base64.b64encode(png_of(greys or GREYS)).decode()
    return f'<image id="photo" {attributes} href="{link or "data:image/png;base64," + data}"/>'


def statements(program):
    return [line for line in program.splitlines() if not line.startswith("(")]


class Pictures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.program = self.folder / "job.nc"
        self.report = self.folder / "job.json"

    def cut(self, drawing, *options, status=0, name="drawing.svg"):
        path = self.folder / name
        path.write_text(drawing)
        done = run("cut", path, *options, "-o", self.program, "--report", self.report)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def energy(self):
        """Returns the seconds of full power before the first cut, by cells of the size of a pixel."""
        rows = self.program.read_text().split(": outer")[0]
        pictures = self.folder / "pictures.nc"
        pictures.write_text(rows[:rows.rindex("\n") + 1] + "M5\nM2\n")
        trace = self.folder / "trace.csv"
        done = run("sim", pictures, *LASER, "--trace", trace)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return burnt(trace, PIXEL, PIXEL)

    def expect_burnt(self, place, greys=None, power=lambda darkness: 0.8 * darkness):
        """Compares the burnt energy; `place` maps the middle of a pixel, in pixels from the upper
        left corner, to mm on the machine.
        """
        energy = self.energy()
        whole = PIXEL * 60.0 / FEED
        for row, line in enumerate(greys or GREYS):
            for column, grey in enumerate(line):
                x, y = place(column + 0.5, row + 0.5)
                cell = (math.floor(x / PIXEL), math.floor(y / PIXEL))
                wanted = power(1.0 - grey / 255.0)
                # A step is 0.004 mm, and the power of the neighbour pixel may last one step longer.
                self.assertAlmostEqual(energy.pop(cell, 0.0) / whole, wanted, delta=0.03 * wanted + 0.009,
                                       msg=f"{column} {row}")
        self.assertLess(sum(energy.values()), 0.02 * whole)

    def test_a_picture_is_burnt_as_it_lies_and_before_the_cut(self):
        size = f'width="{4 * PIXEL}" height="{3 * PIXEL}"'
        h = PIXEL
        cases = {
            f'x="10" y="5" {size}': lambda u, v: (10 + h * u, 25 - h * v),
            f'{size} transform="translate(10 5) rotate(90)"': lambda u, v: (10 - h * v, 25 - h * u),
            f'{size} transform="translate(10 5) rotate(180)"': lambda u, v: (10 - h * u, 25 + h * v),
            f'{size} transform="translate(10 5) rotate(-90)"': lambda u, v: (10 + h * v, 25 + h * u),
            f'{size} transform="translate(10 5) scale(-1 1)"': lambda u, v: (10 - h * u, 25 - h * v),
            f'{size} transform="translate(10 5) scale(1 -1)"': lambda u, v: (10 + h * u, 25 + h * v),
            f'{size} transform="matrix(0 1 1 0 10 5)"': lambda u, v: (10 + h * v, 25 - h * u),
            f'{size} transform="matrix(0 -1 -1 0 10 5)"': lambda u, v: (10 - h * v, 25 + h * u),
        }
        for attributes, place in cases.items():
            with self.subTest(attributes):
                done = self.cut(page(PLATE, image(attributes)), *CUT, "--layer", BURN)
                self.assertRegex(done.stdout, r'picture image "photo": [34] x [34] pixels')
                self.expect_burnt(place)
        text = self.program.read_text()
        self.assertLess(text.index("(1: picture, image _photo_)".replace("_", '"')), text.index("(2: outer"))
        report = json.loads(self.report.read_text())
        self.assertEqual((report["cuts"], len(report["pictures"]), report["pictures"][0]["burnt_rows"]), (1, 1, 4))
        self.assertGreater(report["job_time_s"], 12.0)

    def test_any_other_turn_samples_the_picture(self):
        attributes = 'width="6" height="6" transform="translate(20 8) rotate(30)"'
        self.cut(page(PLATE, image(attributes, [[0, 0], [0, 0]])), *CUT, "--layer", BURN)
        energy = self.energy()
        whole = PIXEL * 60.0 / FEED
        self.assertAlmostEqual(sum(energy.values()) / whole * PIXEL ** 2, 0.8 * 36.0, delta=0.8)
        turn = math.radians(30)
        for (column, row), seconds in energy.items():
            x, y = (column + 0.5) * PIXEL - 20, 22 - (row + 0.5) * PIXEL
            along, across = x * math.cos(turn) + y * math.sin(turn), y * math.cos(turn) - x * math.sin(turn)
            beyond = max(-along, along - 6, -across, across - 6)
            if beyond > 1.3 * PIXEL:
                self.assertLess(seconds, 0.01 * whole, f"{x} {y}")
            elif beyond < -1.3 * PIXEL:
                self.assertAlmostEqual(seconds / whole, 0.8, delta=0.05)

    def test_a_clip_and_the_box_of_slice_crop(self):
        clip = '<clipPath id="c"><rect x="11" y="0" width="30" height="30"/></clipPath>'
        place = 'x="10" y="5" width="2" height="1.5"'
        for attributes in (place + ' clip-path="url(#c)"',
                           'x="11" y="5" width="1" height="1.5" preserveAspectRatio="xMaxYMid slice"'):
            self.cut(page(clip, PLATE, image(attributes)), *CUT, "--layer", BURN + ", invert=on")
            self.expect_burnt(lambda u, v: (10 + PIXEL * u, 25 - PIXEL * v),
                              [[255, 255, *line[2:]] for line in GREYS],
                              lambda darkness: 0.8 * (1.0 - darkness) if darkness > 0.0 else 0.0)

    def test_settings_are_those_of_engrave(self):
        drawing = page(PLATE, image('x="10" y="5" width="2" height="1.5"'))
        place = (lambda u, v: (10 + PIXEL * u, 25 - PIXEL * v))

        def curve(darkness):
            return 0.1 + 0.7 * darkness ** 1.5 if darkness > 0.0 else 0.0
        for more in ("", ", plain=on", ", one-way=on", ", overscan=1", ", pixel=0.25"):
            self.cut(drawing, *CUT, "--layer", BURN + ", gamma=1.5, min-power=10%" + more)
            self.expect_burnt(place, power=curve)
        self.cut(drawing, *CUT, "--layer", BURN + ", passes=2")
        self.expect_burnt(place, power=lambda darkness: 1.6 * darkness)
        self.cut(drawing, *CUT, "--layer", BURN + ", shading=threshold")
        self.expect_burnt(place, power=lambda darkness: 0.8 * (darkness > 0.5))
        self.cut(drawing, *CUT, "--layer", BURN + ", reverse-shift=0.1, overscan=0")
        self.assertIn("G0X12.1Y24.25\n", self.program.read_text())

    def test_pictures_are_notes_until_a_rule_burns_them(self):
        plain = page(PLATE)
        with_picture = page(PLATE, image('x="10" y="5" width="2" height="1.5"'))
        self.cut(plain, *CUT)
        wanted = statements(self.program.read_text())
        for rule in ((), ("--layer", "*: kind=cut"), ("--layer", "image: kind=skip")):
            done = self.cut(with_picture, *CUT, *rule)
            self.assertEqual(statements(self.program.read_text()), wanted)
            told = 'image "photo": pictures are left out; `cut --layer \'image: kind=image, power=20%, feed=3000\'`'
            self.assertEqual(told in done.stderr, "image: kind=skip" not in rule, done.stderr)
        alone = page(image('x="10" y="5" width="2" height="1.5"'))
        self.assertIn("nothing is left to cut", self.cut(alone, *CUT, status=1).stderr)
        self.cut(alone, "--layer", BURN)
        self.assertNotIn("kerf 0", self.program.read_text())

    def test_pictures_are_placed_with_the_drawing(self):
        drawing = page('<rect id="p" x="10" y="5" width="2" height="1.5"/>',
                       image('x="10" y="5" width="2" height="1.5"'))
        self.cut(drawing, *CUT, "--layer", BURN, "--place", "5,6")
        self.expect_burnt(lambda u, v: (5 + PIXEL * u, 7.5 - PIXEL * v))
        done = self.cut(drawing, *CUT, "--layer", BURN, "--copies", "2x1", "--copy-gap", "2", "--mirror", "x")
        self.assertIn('picture #2: image "photo"', done.stdout)
        left = [line for line in done.stdout.splitlines() if "at X" in line]
        self.assertRegex(" ".join(left), r"at X10\.000 .*at X14\.000 ")
        alone = page(image('x="10" y="5" width="2" height="1.5"'))
        self.cut(alone, "--layer", BURN, "--place", "corner", "--machine", "k40")
        told = self.cut(alone, "--layer", BURN, "--place", "0,-20", "--machine", "k40", status=1).stderr
        self.assertRegex(told, r'image "photo" at .*leaves the bed of K40.*at its left')

    def test_a_linked_file_is_an_input(self):
        (self.folder / "my photo.png").write_bytes(png_of(GREYS))
        drawing = page(PLATE, image('x="10" y="5" width="2" height="1.5"', link="my%20photo.png"))
        self.cut(drawing, *CUT, "--layer", BURN)
        self.expect_burnt(lambda u, v: (10 + PIXEL * u, 25 - PIXEL * v))
        self.assertRegex(self.program.read_text(), r"digest picture=[0-9a-f]{16} my photo.png")
        for link, told in (("gone.png", "gone.png"), ("http://a.b/c.png", "is a web address, which is not downloaded"),
                           ("/etc/passwd", "is a path on another computer"), ("../photo.png", "is not below")):
            drawing = page(PLATE, image('x="10" y="5" width="2" height="1.5"', link=link))
            note = self.cut(drawing, *CUT).stderr
            self.assertRegex(note, f'note: .*drawing.svg:1:[0-9]+: image "photo": .*{told}.*; embed it')
            self.assertIn("no program is written", self.cut(drawing, *CUT, "--layer", BURN, status=1).stderr)
            self.cut(drawing, *CUT, "--layer", BURN, "--anyway", status=1)

    def test_recipe_post_and_picture(self):
        drawing = page(PLATE, image('x="10" y="5" width="2" height="1.5"'))
        recipe, svg = self.folder / "recipe.json", self.folder / "job.svg"
        self.cut(drawing, *CUT, "--layer", BURN + ", shading=jarvis, one-way=on", "--save-recipe", recipe, "--svg", svg)
        first = statements(self.program.read_text())
        self.assertIn("<image ", svg.read_text())
        self.cut(drawing, "--recipe", recipe)
        self.assertEqual(statements(self.program.read_text()), first)
        self.cut(drawing, *CUT, "--layer", BURN)
        self.assertTrue([line for line in statements(self.program.read_text()) if ":" in line])
        post = self.folder / "own.post"
        post.write_text("[header]\nG21\n")
        self.cut(drawing, *CUT, "--layer", BURN, "--post", post)
        self.assertFalse([line for line in statements(self.program.read_text()) if ":" in line])

    def test_a_project_of_lightburn_brings_its_settings(self):
        data = base64.b64encode(png_of(GREYS)).decode()
        project = ('<LightBurnProject><CutSetting type="Cut"><index Value="0"/><maxPower Value="60"/>'
                   '<speed Value="10"/></CutSetting><CutSetting_Img type="Image"><index Value="1"/>'
                   '<name Value="photo"/><maxPower Value="80"/><minPower Value="10"/><speed Value="50"/>'
                   f'<interval Value="{PIXEL}"/><ditherMode Value="grayscale"/></CutSetting_Img>'
                   '<Shape Type="Rect" CutIndex="0" W="38" H="28"><XForm>1 0 0 1 20 15</XForm></Shape>'
                   f'<Shape Type="Bitmap" CutIndex="1" W="2" H="1.5" Data="{data}"><XForm>1 0 0 1 11 24.25</XForm>'
                   '</Shape></LightBurnProject>')
        done = self.cut(project, "--kerf", "0.15", name="project.lbrn2")
        self.assertRegex(" ".join(done.stdout.split()), r'layer "photo" .*: kind=image, power=80 percent, feed=3000')
        self.expect_burnt(lambda u, v: (10 + PIXEL * u, 25 - PIXEL * v),
                          power=lambda darkness: 0.1 + 0.7 * darkness if darkness > 0.0 else 0.0)

    def test_what_is_wrong_is_named(self):
        drawing = page(PLATE, image('x="10" y="5" width="2" height="1.5"'))
        for rule, told in (("image: kind=image, power=80%", "a picture requires its own power and feed"),
                           (BURN + ", min-power=90%", 'layer "" image: min-power exceeds power'),
                           (BURN + ", angle=3", "angle=3: is not for pictures"),
                           (BURN + ", lead-in=arc:2", "is not for pictures"),
                           (BURN + ", shading=dots", "shading=dots: must be grey, threshold"),
                           (BURN + ", invert=yes", "must be `on` or `off`"),
                           (BURN + ", interval=0.005, pixel=0.005", ""),
                           ("#000: gamma=2", "gamma=2: is for a layer with kind=image"),
                           ("image: kind=photo", "must be `cut`, `score`, `engrave`, `fill`, `image` or `skip`")):
            status = 2 if told else 0
            self.assertIn(told, self.cut(drawing, *CUT, "--layer", rule, status=status).stderr)
        told = self.cut(drawing, *CUT, "--layer", BURN, "--layer", "#000: kind=image, power=1%, feed=100",
                        status=1).stderr
        self.assertRegex(told, r'rect "plate" at 1.000 \S+: its layer has kind=image')
        white = page(PLATE, image('x="10" y="5" width="2" height="1.5"', [[255, 255]]))
        self.assertIn("warning: ", self.cut(white, *CUT, "--layer", BURN).stderr)
        self.assertEqual(re.findall("picture", "".join(statements(self.program.read_text()))), [])
        huge = page(PLATE, image('x="0" y="0" width="4000" height="3000"'))
        told = self.cut(huge, *CUT, "--layer", BURN + ", interval=0.05", status=2).stderr
        self.assertRegex(told, 'layer "" image: [0-9]+ x [0-9]+ pixels would be burnt')


if __name__ == "__main__":
    KERFLINE = sys.argv.pop(1)
    unittest.main()
