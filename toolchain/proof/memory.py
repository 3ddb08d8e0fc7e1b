"""Remembers which steps and tests have passed on which content, and the commit on which all have
passed."""
import functools
import hashlib
import json
import pathlib
import re
import subprocess

from shell import ROOT, output_of

PROVEN = ROOT / "tests/proven"
# Folders of tests with the programs that are built from them; no other program depends on their
# files.
TEST_ROOMS = {"planner": ("planner_tests", "firmware_tests"), "firmware": ("firmware_tests",),
              "hal": ("hal_tests",), "simulation": ("simulation_tests",)}
ALL_ROOMS = frozenset(TEST_ROOMS)


def head() -> str:
    """Returns the commit that is checked out; "" without git."""
    try:
        return output_of("git", "rev-parse", "HEAD")
    except (OSError, subprocess.CalledProcessError):
        return ""


@functools.cache
def tree_key(without: frozenset = frozenset()) -> str:
    """Returns a key of the committed tree, its changes, and new files; "" without git.

    `without` names rooms of tests whose committed files do not count.
    """
    left_out = re.compile(rf"\ttests/({'|'.join(sorted(without))})/") if without else None
    try:
        files = output_of("git", "ls-tree", "-r", "HEAD").splitlines()
        digest = hashlib.sha256()
        for file in files:
            if not (left_out and left_out.search(file)):
                digest.update(file.encode() + b"\n")
        digest.update(output_of("git", "diff", "HEAD", "--binary").encode(errors="replace"))
        for name in output_of("git", "ls-files", "--others", "--exclude-standard").splitlines():
            digest.update(name.encode() + (ROOT / name).read_bytes())
    except (OSError, subprocess.CalledProcessError):
        return ""
    return digest.hexdigest()[:16]


class Notes:
    """Remarks by name in a file of build/proof, each with the key of the content to which it
    applies."""

    def __init__(self, file: str):
        self.file = ROOT / "build/proof" / file
        known = self.file.is_file()
        self.notes = json.loads(self.file.read_text(encoding="utf-8")) if known else {}

    def find(self, name: str, key: str) -> dict | None:
        note = self.notes.get(name)
        return note if key and note and note["key"] == key else None

    def add(self, name: str, key: str, **remark) -> None:
        if key:
            self.notes[name] = {"key": key, **remark}

    def write(self) -> None:
        self.file.parent.mkdir(parents=True, exist_ok=True)
        self.file.write_text(json.dumps(self.notes, indent=1), encoding="utf-8")


class TestMemory:
    """Tests of a preset that have passed in `prove`. Tests named static.* and tidy.* read all
    sources. Any other test depends on a room of tests only if its program or script belongs to that
    room."""

    def __init__(self, preset: str):
        self.notes = Notes(f"tests_{preset}.json")

    @staticmethod
    def key_of(name: str, command: list) -> str:
        names = {pathlib.Path(word).name for word in command}
        rooms = {room for room, programs in TEST_ROOMS.items()
                 if names & set(programs) or any(f"/tests/{room}/" in word for word in command)}
        reads_all = name.startswith(("static.", "tidy."))
        return tree_key() if reads_all else tree_key(ALL_ROOMS - rooms)


class Memory:
    def __init__(self, tier: str, keeps: bool, forget: bool):
        self.key = tree_key() if keeps else ""
        if forget:
            for file in (ROOT / "build/proof").glob("*.json"):
                file.unlink()
        self.notes = Notes(f"{tier}.json")

    def key_of(self, without: frozenset) -> str:
        return tree_key(without) if self.key else ""

    def passed(self, name: str, without: frozenset) -> dict | None:
        """Returns seconds and passed tests of a step that passed before on its present content,
        otherwise nothing."""
        return self.notes.find(name, self.key_of(without))

    def note(self, name: str, without: frozenset, seconds: float, passed: int) -> None:
        self.notes.add(name, self.key_of(without), seconds=seconds, passed=passed)
        if self.key:
            self.notes.write()

    def write_proven(self, rows: list) -> None:
        """Records HEAD as proven, unless the tree has changed since the start or is not clean."""
        tree_key.cache_clear()
        if not self.key or output_of("git", "status", "--porcelain") or tree_key() != self.key:
            print("tests/proven is not written: the tree is not that of a commit")
            return
        lines = ["# toolchain/prove.sh wrote this when all had passed on the commit below.",
                 output_of("git", "rev-parse", "HEAD"),
                 *(f"# {seconds:6.0f} s  {name}" for name, seconds, _ in rows)]
        PROVEN.write_text("\n".join(lines) + "\n", encoding="utf-8")
        print(f"{PROVEN.relative_to(ROOT)} names {lines[1]}: commit it")


def proven_commit() -> str:
    """Returns the commit on which prove.sh passed last; "" if this clone lacks it."""
    return commit_named_in(PROVEN)


def commit_named_in(file: pathlib.Path) -> str:
    """Returns the commit that a file of the clone names; "" if there is no such file, or if the clone
    lacks the commit."""
    if not file.is_file():
        return ""
    names = [line for line in file.read_text(encoding="utf-8").splitlines()
             if line and not line.startswith("#")]
    known = subprocess.run(["git", "-c", "safe.directory=*", "cat-file", "-e", f"{names[0]}^{{commit}}"],
                           cwd=file.parent, capture_output=True, check=False)
    return names[0] if known.returncode == 0 else ""
