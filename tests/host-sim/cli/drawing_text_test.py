"""Letters, style sheets and packed drawings on the command line of `drawing` and `cut`.

usage: drawing_text_test.py KERFLINE
"""
import gzip
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

KERFLINE = sys.argv.pop(1)
STEEL = ("--material", "CSP 1N", "--thickness", "2")
NOTES = """<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"
 width="80mm" height="60mm" viewBox="0 0 80 60" fill="none" stroke="#000">
<g inkscape:groupmode="layer" inkscape:label="cut"><rect x="5" y="10" width="60" height="40"/></g>
<g inkscape:groupmode="layer" inkscape:label="notes"><text x="10" y="30" font-size="6">3 mm ply</text></g></svg>"""


def run(*call):
    return subprocess.run([KERFLINE, *call], capture_output=True, text=True, timeout=120, check=False)


class DrawingText(unittest.TestCase):
    def setUp(self):
        kept = tempfile.TemporaryDirectory()
        self.addCleanup(kept.cleanup)
        self.folder = pathlib.Path(kept.name)
        self.notes = self.folder / "notes.svg"
        self.notes.write_text(NOTES)
        self.program = self.folder / "out.nc"

    def contours(self, *more):
        done = run("drawing", self.notes, "--json", *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["contours"]

    def test_letters_are_skipped_outlined_or_stroked(self):
        self.assertEqual(len(self.contours()), 1)
        outlines = self.contours("--text", "outline")
        self.assertEqual(len(outlines), 8)  # A rectangle, and a p of two.
        self.assertTrue(all(row["side"] != "open" for row in outlines))
        strokes = self.contours("--text", "stroke")
        self.assertIn("open", {row["side"] for row in strokes})
        self.assertEqual({row["colour"] for row in strokes}, {"#000", "text"})
        self.assertEqual(run("drawing", self.notes, "--text", "drawn").returncode, 2)

    def cut(self, *more):
        done = run("cut", self.notes, *STEEL, *more, "-o", self.program)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stderr, self.program.read_text()

    def test_letters_never_refuse_the_cut(self):
        told, plain = self.cut()
        self.assertIn('note: ' + str(self.notes) + ':4:54: text: letters are left out: "3 mm ply"; '
                      "--text outline or --text stroke draws them", told)
        told, skipped = self.cut("--layer", "notes: side=skip")
        self.assertNotIn("letters", told)
        told, engraved = self.cut("--text", "stroke")
        self.assertIn("letters are drawn in single strokes", told)
        self.assertGreater(engraved.count("\n"), plain.count("\n") + 20)
        _, skipped_too = self.cut("--text", "stroke", "--layer", "notes: side=skip")
        for program in (skipped, skipped_too):
            self.assertEqual([line for line in program.splitlines() if line.startswith("G")],
                             [line for line in plain.splitlines() if line.startswith("G")])
        told, marked = self.cut("--text", "outline", "--layer", "notes: side=mark")
        self.assertRegex(told, r'letters are drawn in .+: "3 mm ply"')
        self.assertGreater(marked.count("\n"), plain.count("\n") + 20)

    def test_packed_drawings_are_read(self):
        packed = self.folder / "notes.svgz"
        packed.write_bytes(gzip.compress(NOTES.encode()))
        done = run("drawing", packed, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(len(json.loads(done.stdout)["contours"]), 1)
        done = run("cut", packed, *STEEL, "-o", self.program)
        self.assertEqual(done.returncode, 0, done.stderr)
        packed.write_bytes(gzip.compress(NOTES.encode())[:-30])
        done = run("drawing", packed)
        self.assertEqual(done.returncode, 1)
        self.assertIn("its gzip data are damaged", done.stdout)


if __name__ == "__main__":
    unittest.main()
