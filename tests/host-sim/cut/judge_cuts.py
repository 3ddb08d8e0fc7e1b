"""Judges the programs that `kerfline cut` makes of a folder of drawings, by geometry of its own.

usage: judge_cuts.py KERFLINE FOLDER [--only PATTERN] OPTION_OF_CUT …
       judge_cuts.py --self-test

Not part of the test suite, because it needs shapely and drawings of others. judge_drawing.py reads each drawing a
second time and fills its closed contours by even-odd, or by the fill rule of a filled shape. judge_path.py then checks
the program, with judge_distance.py:

* No path of the beam runs across a part, or is nearer to a part than half the kerf less 5 um. The option --narrow
  lowers this distance by its value.
* Each edge of a part has a path beside it, unless the program's warnings list the edge as uncut, at its position.
* No two cuts go along the same line.
* With the option --common-line, each line along which two parts lie against each other is cut once along itself. At
  its ends, and where parts touch at a corner, a path may be nearer than half the kerf over a length of two kerfs, but
  not within a part.

Not judged are:

* parts and holes of less than 0.02 mm2, or of less than 0.01 mm mean width;
* loops of the waste of less than 0.02 mm2 that hang on a contour, at a point or by a neck that is narrower than the
  kerf and at most half as wide as the loop;
* needles and slits that are narrower than 5 um;
* open lines that are cut along themselves.

Prints a line for each drawing, then the sums of drawings and of closed shapes. Closed shapes are the edges of parts and
holes. A shape is cut as drawn if no path is too near to it and 95 % of it has a path beside it. With the option
--anyway of `cut`, the shapes of refused drawings count, too. The exit status is 1 if a drawing is judged wrong.
"""
import fnmatch
import pathlib
import subprocess
import sys
import tempfile

import shapely

from judge_drawing import parts_of, rows_of
from judge_path import Shapes, judged

MAX_SECONDS = 300
DEFAULT_KERF_MM = 0.1  # Counts the shapes of a drawing that has no program.


def count_uncut(rows: list, shapes: Shapes) -> None:
    """Counts the shapes of a drawing that has no program."""
    shapes.count += sum(1 + len(part.interiors) for part in parts_of(rows, DEFAULT_KERF_MM))


def verdict_on(kerfline: str, file: pathlib.Path, options: list, shapes: Shapes) -> tuple:
    """Returns `right`, `wrong`, `refused` or `not judged`, and the reason."""
    with tempfile.TemporaryDirectory() as scratch:
        target = pathlib.Path(scratch) / "job.nc"
        try:
            run = subprocess.run([kerfline, "cut", str(file), *options, "-o", str(target)],
                                 capture_output=True, text=True, check=False, timeout=MAX_SECONDS)
        except subprocess.TimeoutExpired:
            return "refused", f"longer than {MAX_SECONDS} s"
        complaint = None
        try:
            rows = rows_of(file)
            if target.exists():
                complaint = judged(rows, target.read_text(), run.stderr, shapes, options)
            else:
                count_uncut(rows, shapes)
        except Exception as error:  # pylint: disable=broad-except
            return "not judged", f"{type(error).__name__}: {error}"
        if run.returncode != 0:
            errors = [text for text in run.stderr.splitlines()
                      if not text.startswith(("note", "warning", "kerfline"))]
            return "refused", errors[0] if errors else run.stderr.strip()[-200:]
        return ("wrong", complaint) if complaint else ("right", "")


def main() -> int:
    if sys.argv[1:] == ["--self-test"]:
        import judge_self_test  # pylint: disable=import-outside-toplevel
        return judge_self_test.main()
    kerfline, folder, options = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    pattern = "*"
    if options[:1] == ["--only"]:
        pattern, options = options[1], options[2:]
    sums, shapes = {}, Shapes()
    for file in sorted(folder.rglob("*")):
        if file.suffix.lower() not in (".svg", ".dxf") or not fnmatch.fnmatch(file.name, pattern):
            continue
        own = Shapes()
        verdict, why = verdict_on(kerfline, file, options, own)
        shapes.add(own)
        sums[verdict] = sums.get(verdict, 0) + 1
        print(f"{file.relative_to(folder)}: {verdict}, {own.right} of {own.count} shapes as drawn"
              f"{': ' + why[:200] if why else ''}", flush=True)
    print(", ".join(f"{count} {verdict}" for verdict, count in sorted(sums.items())) +
          f"; {shapes.right} of {shapes.count} closed shapes as drawn; shapely {shapely.__version__}")
    return 1 if sums.get("wrong") else 0


if __name__ == "__main__":
    sys.exit(main())
