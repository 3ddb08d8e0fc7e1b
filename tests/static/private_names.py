"""Fails if two sources of a program define a constant, a type or a function of the same name
(functions: with the same parameters) in anonymous namespaces.

The united builds combine several sources of a layer, or of a folder of tests, into one. Besides, a
constant that two files define should be defined in one place.

usage: private_names.py [root]
"""
import pathlib
import re
import sys
from typing import Iterator

from source_files import ROOT, source_files

PRIVATE = re.compile(r"^namespace \{$(.*?)^\}  // namespace$", re.MULTILINE | re.DOTALL)
NAMED = re.compile(r"^namespace ([\w:]+) \{$", re.MULTILINE)
DEFINED = re.compile(r"^(?:constexpr [^={(]*?\b(k\w+)(?:\{| =)|(?:struct|class|enum class) (\w+)\b[^;]*$)",
                     re.MULTILINE)
# First line of a function at the beginning of a line, whose parameters contain no parentheses.
FUNCTION = re.compile(r"^(?:[\w:<>,&*\[\]]+ )+&?(\w+)\(([^(){};]*)\)(?: noexcept)? \{$", re.MULTILINE)
OF_PARAMETER = re.compile(r"(?:\w+::)+|\bconst\b|\s*/\*\w+\*/|\s*\b\w+$|\s+")


def program_of(name: str) -> str:
    """Returns the layer, or the folder of tests, to which a file belongs."""
    parts = name.split("/")
    return "/".join(parts[:2]) if parts[0] == "tests" else parts[0]


def kinds_of(parameters: str) -> str:
    """Returns the types of parameters, without their names and namespaces."""
    return ",".join(OF_PARAMETER.sub("", parameter.strip().split(" = ")[0])
                    for parameter in re.split(r",(?![^<]*>)", parameters))


def private_names(text: str) -> set:
    """Returns namespace and name of each constant, type and function in an anonymous namespace."""
    outer = NAMED.search(text)
    return {(outer[1] if outer else "", name)
            for body in PRIVATE.findall(text)
            for name in [constant or kind for constant, kind in DEFINED.findall(body)] +
            [f"{function}({kinds_of(parameters)})" for function, parameters in FUNCTION.findall(body)]}


def complaints(root: pathlib.Path) -> Iterator:
    homes = {}
    for path in source_files(root, ".cpp"):
        name = path.relative_to(root).as_posix()
        if name.startswith(("tests/must_not_compile/", "tests/fuzz/", "tests/target/", "tests/bench/")):
            continue  # A program each.
        for private in sorted(private_names(path.read_text(encoding="utf-8"))):
            first = homes.setdefault((program_of(name), *private), name)
            if first != name:
                yield f"{name}: {private[1]} is in {first}, too"


if __name__ == "__main__":
    found = list(complaints(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT))
    print("\n".join(found) or "private names: clean")
    sys.exit(bool(found))
