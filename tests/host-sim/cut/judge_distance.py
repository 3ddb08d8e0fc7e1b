"""Distances and containment of many points at once, for judge_cuts.py. Points are arrays of complex numbers in mm."""
import numpy
from shapely import vectorized

SEGMENTS_OF_STROKE = 16
MIN_CELL_MM = 0.5
POINTS_AT_ONCE = 20000


def strokes_of(rows: list) -> tuple:
    """Returns short stretches of the rows, and the number of the row of each as an array."""
    strokes, owner = [], []
    for i, row in enumerate(rows):
        row = numpy.asarray(row, dtype=complex)
        for k in range(0, len(row) - 1, SEGMENTS_OF_STROKE):
            stroke = row[k:k + SEGMENTS_OF_STROKE + 1]
            if numpy.any(stroke != stroke[0]):
                strokes.append(stroke)
                owner.append(i)
    return strokes, numpy.array(owner, dtype=int)


def samples_of(strokes: list, every_mm: float) -> tuple:
    """Returns points along strokes, the number of the stroke of each, and the length that each stands for, mm."""
    places, numbers, each_mm = [numpy.empty(0, complex)], [numpy.empty(0, int)], [numpy.empty(0)]
    for i, stroke in enumerate(strokes):
        along = numpy.concatenate([[0], numpy.cumsum(numpy.abs(numpy.diff(stroke)))])
        count = max(1, int(along[-1] / every_mm))
        at = (numpy.arange(count) + 0.5) / count * along[-1]
        places.append(numpy.interp(at, along, stroke.real) + 1j * numpy.interp(at, along, stroke.imag))
        numbers.append(numpy.full(count, i))
        each_mm.append(numpy.full(count, along[-1] / count))
    return numpy.concatenate(places), numpy.concatenate(numbers), numpy.concatenate(each_mm)


class Nearest:
    """Distances from points to rows, exact up to a reach.

    Each square cell of a grid holds the segments that are within the reach of its points.
    """

    def __init__(self, rows: list, reach_mm: float) -> None:
        self.reach, self.cell = reach_mm, max(MIN_CELL_MM, reach_mm)
        rows = [numpy.asarray(row, dtype=complex) for row in rows]
        start = numpy.concatenate([numpy.empty(0, complex), *(row[:-1] for row in rows)])
        end = numpy.concatenate([numpy.empty(0, complex), *(row[1:] for row in rows)])
        owner = numpy.repeat(numpy.arange(len(rows)), [len(row) - 1 for row in rows])
        # Long segments are divided, so that each is in few cells.
        count = numpy.maximum(1, numpy.ceil(numpy.abs(end - start) / self.cell)).astype(int)
        part, of = positions_in(count), numpy.repeat(numpy.arange(len(start)), count)
        step = (end - start)[of] / count[of]
        self.start, self.step, self.owner = start[of] + part * step, step, owner[of]
        self.low = self.corner(start, end, numpy.minimum)
        self.enter(*self.cells_of(self.start, self.start + self.step))

    def corner(self, start: numpy.ndarray, end: numpy.ndarray, least) -> complex:
        if not len(start):
            return 0j
        return complex(least(start.real, end.real).min(), least(start.imag, end.imag).min()) - self.reach * (1 + 1j)

    def cells_of(self, start: numpy.ndarray, end: numpy.ndarray) -> tuple:
        """Returns the first and the last column and row of the cells near each segment."""
        bounds = []
        for a, b, low in ((start.real, end.real, self.low.real), (start.imag, end.imag, self.low.imag)):
            bounds += [numpy.floor((numpy.minimum(a, b) - self.reach - low) / self.cell).astype(int),
                       numpy.floor((numpy.maximum(a, b) + self.reach - low) / self.cell).astype(int)]
        return tuple(bounds)

    def enter(self, first_column, last_column, first_row, last_row) -> None:
        self.rows = int(last_row.max()) + 1 if len(last_row) else 1
        columns, rows = last_column - first_column + 1, last_row - first_row + 1
        segment = numpy.repeat(numpy.arange(len(columns)), columns * rows)
        k = positions_in(columns * rows)
        key = (first_column[segment] + k // rows[segment]) * self.rows + first_row[segment] + k % rows[segment]
        order = numpy.argsort(key, kind="stable")
        self.key, self.segment = key[order], segment[order]

    def of(self, places: numpy.ndarray, after: numpy.ndarray = None) -> numpy.ndarray:
        """Returns the distance of each point, at most the reach.

        With `after`, a number for each point, only rows with a larger number count.
        """
        found = [self.of_some(places[k:k + POINTS_AT_ONCE], None if after is None else after[k:k + POINTS_AT_ONCE])
                 for k in range(0, len(places), POINTS_AT_ONCE)]
        return numpy.concatenate(found) if found else numpy.empty(0)

    def of_some(self, places: numpy.ndarray, after: numpy.ndarray) -> numpy.ndarray:
        column = numpy.floor((places.real - self.low.real) / self.cell).astype(int)
        row = numpy.floor((places.imag - self.low.imag) / self.cell).astype(int)
        key = numpy.where((row >= 0) & (row < self.rows), column * self.rows + row, -1)
        first, last = numpy.searchsorted(self.key, key, "left"), numpy.searchsorted(self.key, key, "right")
        point = numpy.repeat(numpy.arange(len(places)), last - first)
        segment = self.segment[first[point] + positions_in(last - first)]
        if after is not None:
            counts = self.owner[segment] > after[point]
            point, segment = point[counts], segment[counts]
        from_start, step = places[point] - self.start[segment], self.step[segment]
        squared = step.real**2 + step.imag**2
        along = (from_start.real * step.real + from_start.imag * step.imag) / numpy.where(squared > 0, squared, 1)
        distance = numpy.full(len(places), self.reach + 1e-9)
        numpy.minimum.at(distance, point, numpy.abs(from_start - numpy.clip(along, 0, 1) * step))
        return distance


def positions_in(counts: numpy.ndarray) -> numpy.ndarray:
    """Returns 0, 1, … counts[0] - 1, 0, 1, … counts[1] - 1 and so on."""
    return numpy.arange(counts.sum()) - numpy.repeat(numpy.cumsum(counts) - counts, counts)


class Inside:
    """Whether points lie in any of the parts."""

    def __init__(self, parts: list) -> None:
        self.parts = parts

    def has(self, places: numpy.ndarray) -> numpy.ndarray:
        order = numpy.argsort(places.real)
        x, y = places.real[order], places.imag[order]
        found = numpy.zeros(len(places), dtype=bool)
        for part in self.parts:
            left, bottom, right, top = part.bounds
            first, last = numpy.searchsorted(x, [left, right])
            within = first + numpy.flatnonzero((y[first:last] > bottom) & (y[first:last] < top))
            if len(within):
                found[order[within]] |= vectorized.contains(part, x[within], y[within])
        return found
