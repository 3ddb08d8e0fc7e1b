"""Converts lines and arcs to G-code text in the dialect of a CAM program."""
from dataclasses import dataclass


@dataclass(frozen=True)
class Dialect:
    decimals: int = 3
    separator: str = " "            # text between words
    g_separator: str = " "          # text after the G word
    lower_case: bool = False
    leading_zero: bool = True       # whether 0.5 is written, not .5
    modal_motion: bool = False      # whether a repeated G1, G2 or G3 is omitted
    zero_offsets: bool = True       # whether I0 and J0 are written
    comment: str = "({})"
    two_digits: bool = False        # whether G01 is written, not G1
    line_numbers: int = 0           # step of the N words; 0: no N words
    line_end: str = "\n"


PLAIN = Dialect(decimals=4)


class Writer:
    """Collects the lines of one program. Tracks the position as the machine reads it: rounded."""

    def __init__(self, dialect=PLAIN):
        self.dialect = dialect
        self.lines = []
        self.position = [None, None, None]
        self.motion = None
        self.modal = {}
        self.prefix = ""            # text before the next block; used once

    # -- text ------------------------------------------------------------------------------------------------------

    def raw(self, *lines):
        self.lines += lines

    def comment(self, *lines):
        self.lines += [self.dialect.comment.format(line) for line in lines]

    def text(self):
        step = self.dialect.line_numbers
        lines = self.lines
        if step:
            lines = [f"N{step * (i + 1)}{self.dialect.separator}{line}" for i, line in enumerate(lines)]
        return self.dialect.line_end.join(lines) + self.dialect.line_end

    def number(self, value):
        text = f"{value:.{self.dialect.decimals}f}"
        if "." in text:
            text = text.rstrip("0").rstrip(".")
        if text in ("-0", ""):
            text = "0"
        if not self.dialect.leading_zero:
            text = text.replace("0.", ".", 1) if text.startswith(("0.", "-0.")) else text
        return text

    def block(self, motion, words):
        """Writes one line. `words` are the (letter, value) pairs of the line."""
        parts = [letter + self.number(value) for letter, value in words]
        line = self.dialect.separator.join(parts)
        if not (self.dialect.modal_motion and motion == self.motion):
            word = "G0" + motion[1:] if self.dialect.two_digits else motion
            line = word + self.dialect.g_separator + line
        self.motion = motion
        self.lines.append(self.prefix + (line.lower() if self.dialect.lower_case else line))
        self.prefix = ""

    # -- motion ----------------------------------------------------------------------------------------------------

    def rounded(self, value):
        return round(value, self.dialect.decimals) + 0.0

    def axis_words(self, x=None, y=None, z=None):
        """Returns words for the axes that change, and updates the position."""
        words = []
        for i, (letter, value) in enumerate(zip("XYZ", (x, y, z))):
            if value is None:
                continue
            value = self.rounded(value)
            if value != self.position[i]:
                words.append((letter, value))
            self.position[i] = value
        return words

    def other_words(self, **values):
        """Returns the words S and F if their values change."""
        words = []
        for letter in ("S", "F"):
            value = values.get(letter)
            if value is not None and self.modal.get(letter) != value:
                self.modal[letter] = value
                words.append((letter, value))
        return words

    def rapid(self, point=None, z=None):
        x, y = (None, None) if point is None else (point.real, point.imag)
        words = self.axis_words(x, y, z)
        if words:
            self.block("G0", words)

    def line(self, point=None, z=None, **words):
        x, y = (None, None) if point is None else (point.real, point.imag)
        axes = self.axis_words(x, y, z)
        if axes:
            self.block("G1", axes + self.other_words(**words))

    def arc(self, segment, z=None, **words):
        """Writes an arc or, with `z`, a helix. The centre is relative to the rounded start, so that both radii agree.

        Grbl requires at least one axis of the plane in the line. Therefore a full turn repeats its start.
        """
        start = complex(self.position[0], self.position[1])
        centre = segment.centre - start
        axes = self.axis_words(segment.end.real, segment.end.imag, z)
        if not any(letter in "XY" for letter, _ in axes):
            axes = [("X", self.position[0]), ("Y", self.position[1])] + axes
        offsets = [("I", centre.real), ("J", centre.imag)]
        if not self.dialect.zero_offsets:
            offsets = [(letter, value) for letter, value in offsets if self.rounded(value) != 0]
        self.block("G3" if segment.sweep > 0 else "G2", axes + offsets + self.other_words(**words))

    def follow(self, path, **words):
        for segment in path:
            if segment.centre is None:
                self.line(segment.end, **words)
            else:
                self.arc(segment, **words)
