#!/usr/bin/env python3
"""Makes the small JSON files in this folder from their sources; see README.md in this folder.

    extract.py glyphs DejaVuSans-Bold.ttf > dejavu_sans_bold.json
    extract.py sheet  8877_01.DBS.JSON    > sheet_8877.json
    extract.py height volcano.json        > volcano.json
"""
import json
import string
import struct
import sys

WANTED = string.ascii_uppercase + string.digits + " -.°"


class TrueType:
    """Reader for the parts of a TrueType font that outlines require: cmap format 4 and simple glyphs."""

    def __init__(self, path):
        with open(path, "rb") as file:
            self.data = file.read()
        count = struct.unpack_from(">H", self.data, 4)[0]
        self.tables = {}
        for i in range(count):
            tag, _, offset, _ = struct.unpack_from(">4sLLL", self.data, 12 + 16 * i)
            self.tables[tag.decode()] = offset
        self.units_per_em = self.read("head", 18, "H")[0]
        self.long_loca = self.read("head", 50, "h")[0] == 1
        self.metrics = self.read("hhea", 34, "H")[0]

    def read(self, table, offset, form):
        return struct.unpack_from(">" + form, self.data, self.tables[table] + offset)

    def glyph_index(self, character):
        code = ord(character)
        for i in range(self.read("cmap", 2, "H")[0]):
            base = self.read("cmap", 4 + 8 * i + 4, "L")[0]
            if self.read("cmap", base, "H")[0] == 4:
                return self.look_up_format_4(base, code)
        raise ValueError("no cmap of format 4")

    def look_up_format_4(self, base, code):
        count = self.read("cmap", base + 6, "H")[0] // 2
        for i in range(count):
            end = self.read("cmap", base + 14 + 2 * i, "H")[0]
            if code > end:
                continue
            start, delta, at = (self.read("cmap", base + 16 + 2 * (count * k + i), "H")[0] for k in (1, 2, 3))
            if code < start:
                break
            if at == 0:
                return (code + delta) & 0xFFFF
            place = base + 16 + 6 * count + 2 * i + at + 2 * (code - start)
            return (self.read("cmap", place, "H")[0] + delta) & 0xFFFF
        raise ValueError(f"no glyph for {chr(code)!r}")

    def advance(self, index):
        return self.read("hmtx", 4 * min(index, self.metrics - 1), "H")[0]

    def contours(self, index):
        """Returns the closed contours of a glyph as lists of [x, y, on_curve], in font units."""
        if self.long_loca:
            begin, end = self.read("loca", 4 * index, "LL")
        else:
            begin, end = (2 * half for half in self.read("loca", 2 * index, "HH"))
        if begin == end:
            return []
        count = self.read("glyf", begin, "h")[0]
        if count < 0:
            raise ValueError("composite glyph")
        ends = self.read("glyf", begin + 10, f"{count}H")
        return split_contours(self.points(begin + 10 + 2 * count, ends[-1] + 1), ends)

    def points(self, at, count):
        at += 2 + self.read("glyf", at, "H")[0]
        flags = []
        while len(flags) < count:
            flag = self.read("glyf", at, "B")[0]
            at += 1
            repeat = 0
            if flag & 8:
                repeat = self.read("glyf", at, "B")[0]
                at += 1
            flags += [flag] * (1 + repeat)
        xs, at = self.coordinates(at, flags, 2, 16)
        ys, at = self.coordinates(at, flags, 4, 32)
        return [[x, y, flag & 1] for x, y, flag in zip(xs, ys, flags)]

    def coordinates(self, at, flags, short, same):
        values, value = [], 0
        for flag in flags:
            if flag & short:
                step = self.read("glyf", at, "B")[0]
                value += step if flag & same else -step
                at += 1
            elif not flag & same:
                value += self.read("glyf", at, "h")[0]
                at += 2
            values.append(value)
        return values, at


def split_contours(points, ends):
    starts = [0] + [end + 1 for end in ends[:-1]]
    return [points[start:end + 1] for start, end in zip(starts, ends)]


def extract_glyphs(path):
    font = TrueType(path)
    glyphs = {}
    for character in WANTED:
        index = font.glyph_index(character)
        glyphs[character] = {"advance": font.advance(index), "contours": font.contours(index)}
    cap_height = max(y for x, y, _ in glyphs["K"]["contours"][0])
    return {
        "note": "Outlines of DejaVu Sans Bold (quadratic splines, [x, y, on_curve], font units). Licence: README.md",
        "units_per_em": font.units_per_em, "cap_height": cap_height, "glyphs": glyphs}


def extract_sheet(path):
    """Returns the parts of a sheet, without the outline of the sheet. Coordinates are rounded to 0.1 um; vertices are
    [x, y, bulge]."""
    with open(path, encoding="utf-8") as file:
        parts = json.load(file)[1:]
    return {
        "note": "Nested parts of sheet 8877_01, mm, [x, y, bulge of the edge that follows]. Licence: README.md",
        "parts": [[[[round(x, 4), round(y, 4), round(bulge, 9)] for x, y, bulge in contour]
                   for contour in part["paths"]] for part in parts]}


def extract_height(path):
    with open(path, encoding="utf-8") as file:
        grid = json.load(file)
    return {"note": "Height map of a volcano in m, row by row from the top, 10 m grid. Licence: README.md",
            "width": grid["width"], "height": grid["height"], "values": grid["values"]}


EXTRACTORS = {"glyphs": extract_glyphs, "sheet": extract_sheet, "height": extract_height}

if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in EXTRACTORS:
        sys.exit(__doc__)
    print(json.dumps(EXTRACTORS[sys.argv[1]](sys.argv[2]), separators=(",", ":"), ensure_ascii=False))
