"""Reads all drawings of a folder and prints a table: read, reported or refused, and the sum.

usage: collection.py KERFLINE FOLDER [--compare] [OPTION of `kerfline drawing` …]

Not part of the test suite: it accepts any folder of drawings. `read` are drawings without a
message, `reported` those with notes, `refused` those with faults, whose kinds are counted. With
`--compare`, svgelements also reads SVG drawings, and the sums of all lengths are compared. A
drawing is `silent` if its sum differs by more than one in a thousand and it has no note or
fault.
"""
import collections
import json
import pathlib
import subprocess
import sys

SUFFIXES = {".svg", ".svgz", ".dxf", ".json"}
MM_PER_PX = 25.4 / 96
SECONDS = 120
CHORDS = 64  # Within 0.05 % of a circle.


def read(kerfline: str, file: pathlib.Path, options: list) -> tuple:
    """Returns the status, and the drawing as `kerfline drawing --json` prints it."""
    try:
        done = subprocess.run([kerfline, "drawing", file, "--json", *options],
                              capture_output=True, text=True, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return "refused", {"contours": [], "faults": [{"kind": f"longer than {SECONDS} s"}]}
    if done.returncode not in (0, 1):
        return "refused", {"contours": [], "faults": [{"kind": done.stderr.strip()[:60]}]}
    drawn = json.loads(done.stdout)
    if done.returncode == 1:
        return "refused", drawn
    return ("reported" if drawn["faults"] else "read"), drawn


def is_seen(shape) -> bool:
    """Returns whether a shape of svgelements has a stroke or a fill."""
    values = shape.values
    if values.get("visibility") in ("hidden", "collapse") or values.get("display") == "none":
        return False
    return any(paint is not None and paint.value is not None for paint in (shape.stroke, shape.fill))


def length_of(segment) -> float:
    """Returns the length of a segment along CHORDS chords, px."""
    if segment.start is None or segment.end is None:
        return 0.0
    count = 1 if type(segment).__name__ in ("Line", "Close") else CHORDS
    places = [segment.point(i / count) for i in range(count + 1)]
    return sum(abs(b - a) for a, b in zip(places, places[1:]))


def length_by_svgelements(file: pathlib.Path) -> float:
    """Returns the length of all drawn shapes, mm."""
    import svgelements  # pylint: disable=import-outside-toplevel
    total = 0.0
    document = svgelements.SVG.parse(str(file), reify=True, ppi=96)
    for shape in document.elements():
        if isinstance(shape, svgelements.Shape) and is_seen(shape):
            total += sum(length_of(segment) for segment in svgelements.Path(shape)
                         if not isinstance(segment, svgelements.Move))
    return total * MM_PER_PX


def difference(file: pathlib.Path, drawn: dict) -> str:
    """Returns the difference between our length and that of the other reader, as text."""
    try:
        theirs = length_by_svgelements(file)
    except Exception as error:  # pylint: disable=broad-except
        return f"svgelements: {type(error).__name__}"
    ours = sum(contour["length_mm"] for contour in drawn["contours"])
    if abs(ours - theirs) <= 1e-3 * max(ours, theirs, 1.0):
        return "same"
    return f"{ours:.1f} mm, svgelements {theirs:.1f} mm"


def main() -> None:
    arguments = sys.argv[1:]
    compares = "--compare" in arguments
    kerfline, folder, *options = [word for word in arguments if word != "--compare"]
    sums = collections.Counter()
    files = sorted(path for path in pathlib.Path(folder).rglob("*") if path.suffix.lower() in SUFFIXES)
    for file in files:
        status, drawn = read(kerfline, file, options)
        kinds = collections.Counter(fault["kind"] for fault in drawn["faults"])
        told = ", ".join(f"{count} {kind}" for kind, count in kinds.most_common())
        if compares and file.suffix.lower() == ".svg":
            apart = difference(file, drawn)
            if apart.startswith(tuple("0123456789")) and status == "read":
                status = "silent"
            told += f" | {apart}"
        sums[status] += 1
        print(f"{status:8} {len(drawn['contours']):6} contours  {file.relative_to(folder)}  {told}")
    print(f"{len(files)} files: " + ", ".join(f"{count} {status}" for status, count in sorted(sums.items())))


if __name__ == "__main__":
    main()
