"""SVG drawings of paths for `kerfline cut`. Lines and arcs are kept, in mm, with one colour for each operation."""
import math


def svg(size, operations):
    """Returns the drawing. `size` is the size of the sheet, complex, mm. `operations` are (name, colour, paths), with Y
    upwards.
    """
    width, height = number(size.real), number(size.imag)
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}mm" height="{height}mm" '
             f'viewBox="0 0 {width} {height}" fill="none" stroke-width="0.2">']
    for name, colour, paths in operations:
        lines.append(f'<g id="{name}" stroke="{colour}">')
        lines += [f'<path d="{commands(path, size.imag)}"/>' for path in paths]
        lines.append("</g>")
    return "\n".join(lines + ["</svg>", ""])


def commands(path, height):
    text = "M" + point(path[0].start, height)
    for segment in path:
        text += "L" + point(segment.end, height) if segment.centre is None else arc(segment, height)
    closed = abs(path[-1].end - path[0].start) < 1e-6
    return text + ("Z" if closed else "")


def arc(segment, height):
    # SVG has no arc of a full turn. Therefore a full turn is written as two halves.
    whole = abs(segment.sweep) > math.radians(359)
    parts = [segment.part(0, 0.5), segment.part(0.5, 1)] if whole else [segment]
    text = ""
    for part in parts:
        large, left = int(abs(part.sweep) > math.pi), int(part.sweep < 0)  # Y is turned over.
        radius = number(part.radius)
        text += f"A{radius} {radius} 0 {large} {left} {point(part.end, height)}"
    return text


def point(z, height):
    return f"{number(z.real)} {number(height - z.imag)}"


def number(value):
    """Returns a number with at most six decimals. Thus an arc is as exact as its ends."""
    return f"{value + 0.0:.6f}".rstrip("0").rstrip(".")
