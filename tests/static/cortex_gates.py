"""Reads the build for the controller and fails if it contains anything that must not be in it:
heap, exceptions, RTTI, double arithmetic, printf, library functions that differ between machines,
state outside of Application, recursion, too large frames.

Prints sizes, the largest stack frames and the deepest calls.

usage: cortex_gates.py BUILD_FOLDER [--largest-frame BYTES]
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
from typing import Iterator

from source_files import ROOT

sys.path.insert(0, str(ROOT / "toolchain"))
from banned_symbols import banned  # noqa: E402  pylint: disable=wrong-import-position

TOOLS = "arm-none-eabi-"
LARGEST_FRAME_BYTES = 1024
INDIRECT = "__indirect_call"
# The objects that own all state: one Application and its port each.
OWNERS = ("bare_controller", "stm32f405_main", "stm32f405_ends")


def tool(name: str, *arguments) -> list:
    run = subprocess.run([TOOLS + name, *map(str, arguments)], capture_output=True, text=True,
                         check=True)
    return run.stdout.splitlines()


def built_objects(build: pathlib.Path) -> dict:
    """Returns {object file: whether it has its final code} of the build, by its compile commands.
    Leaves out the test program in tests/target, which never runs on a controller, and single
    headers, which only toolchain/prove.sh compiles. Objects that are optimized again at link time
    have their frames in the images, where image_stack.py reads them."""
    entries = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    entries = [entry for entry in entries if "/tests/target/" not in entry["command"]
               and "/headers_alone/" not in entry["command"]]
    return {pathlib.Path(entry["directory"], re.search(r" -o (\S+) ", entry["command"])[1]):
            " -flto" not in entry["command"] for entry in entries}


def call_file(compiled: pathlib.Path) -> pathlib.Path:
    """Returns the file with the call graph that the compiler writes next to an object."""
    return compiled.with_suffix(".ci")


class CallGraph:
    """Frames and calls of every function, from the .ci files that GCC writes next to each object."""

    def __init__(self, files: list):
        self.names, self.frames, self.dynamic, self.calls = {}, {}, set(), {}
        for file in files:
            for line in file.read_text(encoding="utf-8").splitlines():
                self._read(line)
        self._name_clones()

    def _read(self, line: str):
        if node := re.match(r'node: { title: "([^"]+)" label: "(.+?)\\n', line):
            frame = re.search(r"(\d+) bytes \(([a-z,]+)\)", line)
            if frame:
                self.names[node[1]] = node[2]
                self.frames[node[1]] = int(frame[1])
                if frame[2] == "dynamic" or re.search(r"[1-9]\d* dynamic objects", line):
                    self.dynamic.add(node[1])
        elif edge := re.match(r'edge: { sourcename: "([^"]+)" targetname: "([^"]+)"', line):
            self.calls.setdefault(edge[1], set()).add(edge[2])

    def _name_clones(self):
        """Names the clones: GCC gives the parts that it splits off a function only a number."""
        for function, name in self.names.items():
            if name[0].isdigit():
                self.names[function] = tool("c++filt", function.rpartition(":")[2])[0]

    def name(self, function: str) -> str:
        return self.names.get(function, function)

    def deepest(self) -> tuple:
        """Returns ({function: (stack bytes of it and the functions below, next function)},
        [cycles])."""
        depths, cycles, path = {}, [], []

        def visit(function):
            if function in path:
                cycles.append([*path[path.index(function):], function])
                return 0
            if function not in depths:
                path.append(function)
                below = [(visit(callee), callee) for callee in sorted(self.calls.get(function, ()))]
                path.pop()
                bytes_below, callee = max(below, default=(0, ""))
                depths[function] = (self.frames.get(function, 0) + bytes_below, callee)
            return depths[function][0]

        for function in sorted(self.frames):
            visit(function)
        return depths, cycles


def symbol_complaints(objects: list) -> Iterator:
    found, kinds = {}, {}
    # nm reads the machine code: its plugin would read the data for link-time optimization instead.
    for line in tool("nm", "--plugin", "/dev/null", "-A", "-P", *objects) if objects else []:
        file, _, rest = line.partition(": ")
        symbol, kind, *place = rest.split()
        kinds.setdefault(symbol, set()).add(kind)
        if kind in "dDbB" and not any(owner in file for owner in OWNERS):
            key = ("state outside Application", f"{symbol}, {int(place[1], 16)} bytes of RAM")
            found.setdefault(key, set()).add(pathlib.Path(file))
        for what in banned(symbol):
            found.setdefault((what, symbol), set()).add(pathlib.Path(file))
    for (what, symbol), files in sorted(found.items()):
        if is_dropped(symbol, objects, kinds):
            continue
        names = ", ".join(sorted({path.name for path in files}))
        callers = "; ".join(callers_of(symbol, files))
        yield f"{what}: {symbol} in {names}" + (callers and f", from {callers}")


def sections_with(symbol: str, objects) -> set:
    """Returns the sections that refer to the symbol."""
    found, section = set(), ""
    for line in tool("objdump", "-r", *objects):
        if begin := re.match(r"RELOCATION RECORDS FOR \[(\S+)\]", line):
            section = begin[1]
        elif line.split()[-1:] == [symbol]:
            found.add(section)
    return found


def is_dropped(symbol: str, objects: list, kinds: dict) -> bool:
    """Returns whether the linker drops a function everywhere: a weak function to which nothing
    refers, because the compiler inlined all its calls, or to which only such functions refer."""
    sections = sections_with(symbol, objects)
    if not sections:
        return kinds.get(symbol) == {"W"}
    functions = [re.sub(r"^\.text\.(unlikely\.)?", "", section) for section in sections]
    return all(kinds.get(function) == {"W"} and not sections_with(function, objects)
               for function in functions)


def callers_of(symbol: str, objects) -> list:
    """Returns the functions that refer to the symbol; each function has its own section."""
    functions = [section.removeprefix(".text.") for section in sections_with(symbol, objects)
                 if section.startswith(".text.")]
    return tool("c++filt", *sorted(functions)) if functions else []


def stack_complaints(graph: CallGraph, largest_frame: int) -> Iterator:
    for function, size in sorted(graph.frames.items()):
        if size > largest_frame:
            yield f"stack: {size} bytes, limit {largest_frame}: {graph.name(function)}"
    for function in sorted(graph.dynamic):
        yield f"stack: size known only at run time: {graph.name(function)}"
    for cycle in graph.deepest()[1]:
        yield "recursion: " + " > ".join(map(graph.name, cycle))


def sizes(objects: list) -> dict:
    """Returns the bytes of text, data and bss of each target of the build."""
    total = {}
    for line in tool("size", *objects)[1:] if objects else []:
        fields = line.split(None, 5)
        target = re.search(r"CMakeFiles/(?:kerfline_)?(\w+)\.dir/", fields[5])[1]
        old = total.get(target, (0, 0, 0))
        total[target] = tuple(a + int(b) for a, b in zip(old, fields))
    return total


def print_report(total: dict, graph: CallGraph):
    print(f"{'':16}{'text':>9}{'data':>9}{'bss':>9}")
    for target, numbers in sorted(total.items()):
        if any(numbers):
            print(f"{target:16}" + "".join(f"{number:9}" for number in numbers))
    print("largest stack frames, bytes:")
    for function, size in sorted(graph.frames.items(), key=lambda item: -item[1])[:8]:
        print(f"{size:9}  {graph.name(function)}")
    print("deepest calls, bytes (* calls through a pointer or virtually, which are not followed):")
    depths = graph.deepest()[0]
    inner = {callee for callees in graph.calls.values() for callee in callees}
    roots = [function for function in depths if function not in inner]
    for root in sorted(roots, key=lambda function: -depths[function][0])[:5]:
        print(f"{depths[root][0]:9}  {' > '.join(chain(graph, depths, root))}")


def chain(graph: CallGraph, depths: dict, function: str) -> Iterator:
    while function in graph.frames:
        mark = "*" if INDIRECT in graph.calls.get(function, ()) else ""
        yield graph.name(function).split("(")[0].split(" ")[-1] + mark
        function = depths[function][1]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--largest-frame", type=int, default=LARGEST_FRAME_BYTES)
    options = parser.parse_args()
    if not (options.build / "compile_commands.json").is_file():
        print("skipped: not built; cmake --preset cortex-m4f && cmake --build --preset cortex-m4f")
        return 77
    named = built_objects(options.build)
    objects = [path for path in named if path.is_file()]
    final = [path for path in objects if named[path]]
    described = [path for path in final if call_file(path).is_file()]
    graph = CallGraph([call_file(path) for path in described])
    print_report(sizes(objects), graph)
    found = [*(f"not built: {path.name}" for path in named if path not in objects),
             *(f"no call graph: {path.name}; compile it with -fcallgraph-info, not from a cache"
               for path in final if path not in described),
             *symbol_complaints(objects), *stack_complaints(graph, options.largest_frame)]
    print("\n".join(found) or "controller: clean")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
