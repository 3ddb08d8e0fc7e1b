"""Checks includes and CMake links against the layer map of ARCHITECTURE.md, and the shape of files.

usage: layers.py [root] (prints one complaint per line; exit status 1 if there are any)
"""
import pathlib
import re
import sys
from typing import Iterator

from source_files import ROOT, source_files

# Each layer with the layers that it may include and link
MAP = {
    "planner": {"planner"},
    "hal/interface": {"hal/interface"},
    "hal/host": {"hal/host", "hal/interface"},
    "hal/stm32f405": {"hal/stm32f405", "hal/interface"},
    "firmware": {"firmware", "planner", "hal/interface"},
    "host-sim": {"host-sim", "firmware", "planner", "hal/host", "hal/interface"},
}
TARGETS = {
    "kerfline_planner": "planner",
    "kerfline::planner": "planner",
    "kerfline_contract_handler": "planner",
    "embed": "planner",
    "kerfline_hal_interface": "hal/interface",
    "kerfline_hal_host": "hal/host",
    "kerfline_hal_stm32f405": "hal/stm32f405",
    "kerfline_firmware": "firmware",
    "kerfline_sim": "host-sim",
    "kerfline_cam": "host-sim",
    "kerfline": "host-sim",
}
# The files that combine a port with the firmware.
COMPOSITION_ROOTS = re.compile(r"firmware/target/stm32f405_\w+\.[ch]pp")
# Programs and parts of a program, which may print.
ON_A_HOST = re.compile(r"planner/(examples/.*|base/default_contract_handler\.cpp)")

# Rooms in the order of the data flow: each may include itself and the rooms before it.
PIPELINES = {
    "planner/motion": ("block", "lookahead", "plan", "jerk", "segment", "motors"),
}

FREESTANDING = set("""array atomic bit cfloat climits compare concepts cstdarg cstddef cstdint
    initializer_list limits new numbers optional ratio source_location span tuple type_traits
    utility version""".split())
# Layers that may call the operating system, whose headers end in .h.
ON_AN_OS = {"host-sim", "hal/host"}
# No header of these uses heap, clock, stream, exception or thread.
BOUNDED = FREESTANDING | set("""algorithm charconv cmath cstring iterator numeric string_view
    variant""".split())
STANDARD_HEADERS = {
    "planner": BOUNDED - {"atomic"},
    "hal/interface": FREESTANDING,
    "hal/stm32f405": FREESTANDING,
    "firmware": BOUNDED,
}
# Each layer with the foreign headers and CMake targets that it may use, as prefixes
FOREIGN = {
    "planner": ("Eigen",),
    "host-sim": ("Eigen", "fmt", "nlohmann", "CLI", "PkgConfig::", "librsvg", "cairo",
                 "sys/", "netinet/", "arpa/", "Threads::", "sqlite3", "SQLite::",
                 "pugixml", "png.h", "PNG::", "zlib.h", "ZLIB::",
                 "freetype/", "harfbuzz/", "fontconfig/", "$<LINK_ONLY:PkgConfig::", "tiffio.h", "TIFF::",
                 "boost/", "Boost::"),
}
# Targets that carry flags only
FLAGS = re.compile(r"(\$<BUILD_INTERFACE:)?kerfline_((controller_)?flags|same_bits)>?")
# glibc and newlib differ in the last bit of these.
TRANSCENDENTAL = re.compile(
    r"std::(a?(sin|cos|tan)h?|atan2|exp2?|expm1|log(2|10|1p)?|pow|hypot|cbrt|[el]?gamma|erfc?)f?\(")

FILE_LINES, GOOD_FILE_LINES = 500, 300
LINE_COLUMNS, PYTHON_COLUMNS = 100, 120


def layer_of(name: str) -> str:
    """Returns the layer to which a path from the root belongs, or an empty string."""
    return next((layer for layer in MAP if name.startswith(layer + "/")), "")


def room_number(name: str, folder: str) -> int:
    """Returns the number of the room of a pipeline to which a path belongs, from 0; -1 if it
    belongs to none."""
    found = re.match(rf"{folder}/(\w+)/", name)
    rooms = PIPELINES[folder]
    return rooms.index(found[1]) if found and found[1] in rooms else -1


def goes_back(name: str, target: str) -> bool:
    """Returns whether an include leads from a room of a pipeline to a later room."""
    return any(0 <= room_number(name, folder) < room_number(target, folder) for folder in PIPELINES)


def include_complaint(name: str, target: str, quoted: bool, root: pathlib.Path) -> str:
    """Returns the complaint about one #include, or an empty string."""
    layer = layer_of(name)
    if COMPOSITION_ROOTS.fullmatch(name):
        return ""
    if target.endswith(".cpp"):
        return f"{target} is a source; include headers"
    if quoted:
        if not (root / target).is_file():
            return f'"{target}" is not a path from the root'
        if layer_of(target) not in MAP[layer]:
            return f"{layer} must not include {target}"
        if goes_back(name, target):
            return f"{target} is in a later room"
        return ""
    if target.endswith(".h") and "/" not in target:
        return f"<{target}> is C; use its C++ form" if layer not in ON_AN_OS else ""
    if "/" not in target and re.fullmatch("[a-z_0-9]+", target):
        if target not in STANDARD_HEADERS.get(layer, {target}) and not ON_A_HOST.fullmatch(name):
            return f"<{target}> is not for {layer}"
        return ""
    if layer != "hal/host" and not target.startswith(FOREIGN.get(layer, ())):
        return f"{layer} does not use the library of <{target}>"
    return ""


def line_complaints(name: str, lines: list, root: pathlib.Path) -> Iterator:
    layer = layer_of(name)
    for number, line in enumerate(lines, 1):
        if found := re.match(r'\s*#\s*include\s*(["<])([^">]+)', line):
            complaint = include_complaint(name, found[2], found[1] == '"', root)
            if complaint:
                yield f"{name}:{number}: {complaint}"
        if re.match(r"\s*#\s*(if|ifdef|ifndef|elif)\b", line) and not layer.startswith("hal/"):
            yield f"{name}:{number}: conditional compilation is for hal/ and toolchain/"
        if layer in ("planner", "firmware") and (found := TRANSCENDENTAL.search(line)):
            yield (f"{name}:{number}: {found[0]}) differs between machines; "
                   "use planner/base/scalar_math")


def source_complaints(root: pathlib.Path) -> Iterator:
    """Yields complaints about includes, calls and preprocessor lines of the layers."""
    for path in source_files(root, ".hpp", ".cpp"):
        name = path.relative_to(root).as_posix()
        if not layer_of(name):
            continue
        for folder, rooms in PIPELINES.items():
            if name.startswith(folder + "/") and room_number(name, folder) < 0:
                yield f"{name}: lies in none of {', '.join(rooms)}"
        lines = path.read_text(encoding="utf-8").splitlines()
        yield from line_complaints(name, lines, root)
        if path.suffix == ".hpp" and "#pragma once" not in lines:
            yield f"{name}: no #pragma once"


def shape_complaints(root: pathlib.Path) -> Iterator:
    """Yields complaints about the length of files and lines and the names of files."""
    for path in source_files(root):
        name = path.relative_to(root).as_posix()
        lines = path.read_text(encoding="utf-8").splitlines()
        if len(lines) > FILE_LINES:
            yield f"{name}: {len(lines)} lines, limit {FILE_LINES}; split it"
        elif len(lines) > GOOD_FILE_LINES:
            print(f"note: {name}: {len(lines)} lines, aim below {GOOD_FILE_LINES}")
        columns = PYTHON_COLUMNS if path.suffix == ".py" else LINE_COLUMNS
        for number, line in enumerate(lines, 1):
            if len(line) > columns:
                yield f"{name}:{number}: {len(line)} columns, limit {columns}"
        if path.suffix in (".hpp", ".cpp", ".py") and not re.fullmatch("[a-z0-9_]+", path.stem):
            yield f"{name}: file names are snake_case"


def calls_of(text: str, command: str) -> Iterator:
    """Yields the argument lists of a CMake command."""
    text = re.sub(r"#.*", "", text)
    for found in re.finditer(rf"\b{command}\s*\(([^)]*)\)", text):
        yield found[1].split()


def links(root: pathlib.Path) -> Iterator:
    """Yields (file, target, linked libraries) of every link of a layer's target."""
    for path in source_files(root, "CMakeLists.txt"):
        name = path.relative_to(root).as_posix()
        text = path.read_text(encoding="utf-8")
        calls = [*calls_of(text, "target_link_libraries"), *calls_of(text, "kerfline_layer")]
        for target, *libraries in calls:
            for library in libraries:
                if library not in ("PRIVATE", "PUBLIC", "INTERFACE"):
                    yield name, target, library


def link_complaints(root: pathlib.Path) -> Iterator:
    """Yields the links of layers that the map forbids."""
    for name, target, library in links(root):
        layer = TARGETS.get(target)
        if layer is None or FLAGS.fullmatch(library):
            if layer is None and layer_of(name):
                yield f"{name}: {target} belongs to no layer that this check knows"
        elif library in TARGETS:
            if TARGETS[library] not in MAP[layer]:
                yield f"{name}: {layer} must not link {library}"
        elif not library.startswith(FOREIGN.get(layer, ())):
            yield f"{name}: {layer} does not use the library {library}"


def unlinked_complaints(root: pathlib.Path) -> Iterator:
    """Yields the includes between layers for which CMake has no link."""
    linked = {layer: {layer} for layer in MAP}
    for _, target, library in links(root):
        if target in TARGETS and library in TARGETS:
            linked[TARGETS[target]].add(TARGETS[library])
    for _ in MAP:  # Links are passed on: close over them.
        for layer, reached in linked.items():
            linked[layer] = reached.union(*(linked[other] for other in reached))
    for path in source_files(root, ".hpp", ".cpp"):
        name = path.relative_to(root).as_posix()
        if not layer_of(name) or COMPOSITION_ROOTS.fullmatch(name):
            continue
        for target in re.findall(r'#include "([^"]+)"', path.read_text(encoding="utf-8")):
            other = layer_of(target)
            if other in MAP[layer_of(name)] and other not in linked[layer_of(name)]:
                yield f"{name}: includes {target}, but {layer_of(name)} does not link {other}"


def complaints(root: pathlib.Path) -> list:
    return [*source_complaints(root), *shape_complaints(root),
            *link_complaints(root), *unlinked_complaints(root)]


if __name__ == "__main__":
    found = complaints(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT)
    print("\n".join(found) or "layers: clean")
    sys.exit(bool(found))
