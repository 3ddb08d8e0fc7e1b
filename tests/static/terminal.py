"""Fails if a source of host-sim writes to a stream of the process without
`host-sim/report/terminal.hpp`, which escapes the control characters that a terminal would obey.

usage: terminal.py [root]
"""
import pathlib
import re
import sys
from typing import Iterator

from source_files import ROOT, source_files

OTHER_WAYS = re.compile(r"\bfmt::v?print\(|\bf?printf\(|\bf?put[sc]\(|\bputchar\(|\bfwrite\(|\bperror\(|"
                        r"\bstd::c(?:out|err|log)\b|\bwrite\(STD(?:OUT|ERR)_FILENO")
# The writer itself, and the constant message that standard output has failed.
ALLOWED = {"host-sim/report/terminal.cpp", "host-sim/cli/standard_streams.cpp"}


def complaints(root: pathlib.Path) -> Iterator:
    for suffix in (".cpp", ".hpp"):
        for path in source_files(root, suffix):
            name = path.relative_to(root).as_posix()
            if not name.startswith("host-sim/") or name in ALLOWED:
                continue
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if found := OTHER_WAYS.search(line.split("//")[0]):
                    yield f"{name}:{number}: {found[0]}: print by sim::terminal, which escapes names"


if __name__ == "__main__":
    found = list(complaints(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT))
    print("\n".join(found) or "terminal: clean")
    sys.exit(bool(found))
