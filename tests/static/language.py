"""Fails if a comment of the product begins without a subject or uses a word that has no clear
referent.

usage: language.py [root]

It checks only what a program can: the first words of each comment and of each printed text, words
that the rules of language exclude, and names of bounds. It ignores NOLINT lines and names in
backticks.
"""
import pathlib
import re
import sys
from typing import Iterator

from source_files import ROOT, source_files

PRODUCT = ("planner/", "firmware/", "hal/", "host-sim/")
COMMENT = re.compile(r"^\s*///?<?\s?|\s///?<?\s")
FIRST = re.compile(r"(?:Of|Who|Whoever|Whatever|What (?:is|was|has)|All that|That which|As asked|With it)\b"
                   r"(?! course)")
EXCLUDED = (
    (re.compile(r"\b(?:some|no)body\b", re.I), "names nothing: write which part or person it is"),
    (re.compile(r"\bwho(?:ever|m|se)?\b", re.I), "is for persons: name the code, the tool, the caller"),
    (re.compile(r"\bso (?:much|many) (?:mm|steps|ticks|bytes|lines|of it)\b", re.I), "name the parameter"),
    (re.compile(r"\banew\b", re.I), "write `again`, `restart` or `recompute`"),
    (re.compile(r"\bmind changer\b", re.I), "write `revisit if`"),
)
NAMES = re.compile(r"\bk(Most|Least)(?=[A-Z0-9]|\b)")
BOUNDS = {"Most": "Max", "Least": "Min"}
PRINTED = re.compile(r'"((?:Of|Who|Whoever|What (?:is|the|a|has)) [^"]*)"')
PERSONS = re.compile(r"\b(?:operator|user|caller|owner|sender|people|person|engineer|host|listener|client|"
                     r"those)\b", re.I)


def comments_of(text: str) -> Iterator:
    """Yields (number of its first line, text) of each comment, which may have several lines."""
    number, words = 0, []
    for line_number, line in enumerate(text.splitlines(), 1):
        bare = re.sub(r'"(?:[^"\\]|\\.)*"', '""', line)
        found = re.search(r"(?:^|\s)//[/!]?<?(.*)$", bare)
        is_whole_line = bool(re.match(r"\s*//", bare))
        if words and not (found and is_whole_line):
            yield number, " ".join(words)
            words = []
        if not found or "NOLINT" in line or "clang-format" in line:
            continue
        said = found[1].strip()
        if not is_whole_line:
            yield line_number, said
        elif said:
            number = number if words else line_number
            words.append(said)
        elif words:
            yield number, " ".join(words)
            words = []
    if words:
        yield number, " ".join(words)


def faults_of(comment: str) -> Iterator:
    plain = re.sub(r"`[^`]*`", "", comment)
    if first := FIRST.match(plain):
        yield f"begins with `{first[0]}`: give the comment a subject"
    for pattern, reason in EXCLUDED:
        for found in pattern.finditer(plain):
            before = plain[max(0, found.start() - 60):found.start()]
            if found[0].lower().startswith("who") and (found[0].lower() == "whose" or PERSONS.search(before)):
                continue
            yield f"`{found[0]}` {reason}"


def complaints(root: pathlib.Path) -> Iterator:
    for path in source_files(root, ".hpp", ".cpp"):
        name = path.relative_to(root).as_posix()
        if not name.startswith(PRODUCT):
            continue
        for number, comment in comments_of(path.read_text(encoding="utf-8")):
            for fault in faults_of(comment):
                yield f"{name}:{number}: {fault}"
    for path in source_files(root, ".hpp", ".cpp"):
        name = path.relative_to(root).as_posix()
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if found := NAMES.search(line):
                yield f"{name}:{number}: `{found[0]}` is named `k{BOUNDS[found[1]]}…` here"
            if name.startswith(PRODUCT) and "NOLINT" not in line and (found := PRINTED.search(line)):
                yield f"{name}:{number}: a text begins with `{found[1][:20]}`: give it a subject"


if __name__ == "__main__":
    found = list(complaints(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT))
    print("\n".join(found) or "language: comments have subjects")
    sys.exit(bool(found))
