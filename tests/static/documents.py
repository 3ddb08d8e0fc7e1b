"""Fails if a document is too long, if a link has no target, if no page links to a page, or if the
decisions are not numbered consecutively.

usage: documents.py [root]
"""
import pathlib
import re
import sys
from typing import Iterator

from source_files import ROOT, project_files

MOST_LINES = {"README.md": 120, "ARCHITECTURE.md": 150}
MOST_DECISION_LINES = 30
MOST_COLUMNS = 100
DECISIONS = "docs/decisions/"
# Pages that a program writes.
WRITTEN = ("docs/reference/", "docs/boards.md", "docs/figures.md")


def without_code(text: str) -> list:
    """Returns the lines of a page, with empty lines for those of code blocks, so that line numbers
    stay right."""
    lines, is_code = [], False
    for line in text.splitlines():
        is_fence = line.lstrip().startswith("```")
        lines.append("" if is_code or is_fence else line)
        is_code ^= is_fence
    return lines


def anchors_of(text: str) -> set:
    """Returns the anchors of a page's headings, as GitHub makes them."""
    anchors = set()
    for line in without_code(text):
        if heading := re.match(r"#{1,6} (.*)", line):
            plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading[1]).strip().lower()
            anchors.add(re.sub(r"[^\w\- ]", "", plain).replace(" ", "-"))
    return anchors


def links_of(text: str) -> Iterator:
    """Yields (line number, target) of each link of a page that stays in the repository."""
    for number, line in enumerate(without_code(text), 1):
        for target in re.findall(r"\]\(([^)\s]+)\)", re.sub(r"`[^`]*`", "", line)):
            if not re.match(r"[a-z]+:", target):
                yield number, target


def length_complaints(name: str, text: str) -> Iterator:
    lines = text.splitlines()
    most = MOST_LINES.get(name, MOST_DECISION_LINES if re.match(DECISIONS + r"\d", name) else len(lines))
    if len(lines) > most:
        yield f"{name}: {len(lines)} lines, {most} at most; move details to a page of their own"
    if name.startswith(WRITTEN):
        return
    for number, line in enumerate(without_code(text), 1):
        # A row of a table and the text of a link or address cannot be broken into lines.
        if len(line) > MOST_COLUMNS and not re.match(r"\s*\||.*\]\(", line):
            yield f"{name}:{number}: {len(line)} columns, {MOST_COLUMNS} at most"


def link_complaints(root: pathlib.Path, texts: dict) -> Iterator:
    linked = {"README.md"}
    for name, text in texts.items():
        for number, target in links_of(text):
            file, _, anchor = target.partition("#")
            path = (root / name).parent / file if file else root / name
            path = path.resolve()
            if not path.exists():
                yield f"{name}:{number}: {target} leads to no file"
                continue
            page = path.relative_to(root.resolve()).as_posix()
            page = page + "/README.md" if path.is_dir() else page
            if page != name:
                linked.add(page)
            if anchor and page in texts and anchor not in anchors_of(texts[page]):
                yield f"{name}:{number}: {target} has no such heading"
    for name in sorted(set(texts) - linked):
        if name.startswith("docs/"):
            yield f"{name}: no page has a link to it"


def decision_complaints(texts: dict) -> Iterator:
    numbers = {}
    for name, text in texts.items():
        if not (found := re.match(DECISIONS + r"(\d{4})-[a-z0-9-]+\.md$", name)):
            continue
        number = int(found[1])
        if number in numbers:
            yield f"{name}: has the number of {numbers[number]}"
        numbers[number] = name
        if not text.startswith(f"# {number}. "):
            yield f"{name}: its heading does not begin with `# {number}. `"


def complaints(root: pathlib.Path) -> Iterator:
    texts = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
             for path in project_files(root) if path.suffix == ".md"}
    for name, text in texts.items():
        yield from length_complaints(name, text)
    yield from link_complaints(root, texts)
    yield from decision_complaints(texts)


if __name__ == "__main__":
    found = list(complaints(pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT))
    print("\n".join(found) or "documents: links lead somewhere, and lengths are within their limits")
    sys.exit(bool(found))
