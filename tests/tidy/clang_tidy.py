"""Runs clang-tidy over the layers' sources, and over headers that no source includes.

Most of its time goes into reading Eigen and the standard library. Therefore one source that
includes all sources of a layer is checked, if they compile together.

With --changed it checks the files that have changed since the last commit that is known to be clean:
the one in tests/tidy/clean or the one in tests/proven. These are all files in a clone that lacks both
commits. With --record it writes tests/tidy/clean if there are no findings on a clean tree.

usage: clang_tidy.py CLANG_TIDY CLANG BUILD_FOLDER [--jobs N] [--only REGEX] [--changed] [--record]
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve()
sys.path[:0] = [str(HERE.parents[1] / "static"), str(HERE.parents[2] / "toolchain/proof")]
from memory import commit_named_in, proven_commit  # noqa: E402
from source_files import ROOT  # noqa: E402

LAYERS = ("planner", "firmware", "hal", "host-sim")
LARGEST_GROUP = 80
GROUP_CHECKS = "-bugprone-suspicious-include"  # Of .cpp files, which is how a group is made.
# Checks without the analyser, which would spend most of its time on the code of fmt; on the host,
# sanitizers run instead.
HOST_CHECKS = GROUP_CHECKS + ",-clang-analyzer-*"
# This check raises a false alarm on each constexpr member of a template, which is never initialised
# at run time.
CHIP_CHECKS = GROUP_CHECKS + ",-bugprone-dynamic-static-initializers"
SPECIAL_CHECKS = {"host-sim/": HOST_CHECKS, "hal/stm32f405/": CHIP_CHECKS}


def included(name: str, seen: set) -> set:
    """Adds to `seen` the project's headers that a file includes, directly or not."""
    path = ROOT / name
    if name not in seen and path.is_file():
        seen.add(name)
        for target in re.findall(r'#include "([^"]+)"', path.read_text(encoding="utf-8")):
            included(target, seen)
    return seen


def unified(file: pathlib.Path) -> list:
    """Returns the sources that CMake combined into this one, otherwise the source itself."""
    if file.parent.name != "Unity":
        return [file]
    return [pathlib.Path(name) for name in
            re.findall(r'^#include "([^"]+)"', file.read_text(encoding="utf-8"), re.MULTILINE)]


def without_precompiled(arguments: list) -> list:
    """Returns the arguments without the compiler's precompiled header: clang-tidy cannot read
    GCC's, and each source must include what it uses."""
    kept = list(arguments)
    while "-include" in kept:
        at = kept.index("-include")
        del kept[at:at + 2]
    return [word for word in kept if word != "-Winvalid-pch"]


def commands(build: pathlib.Path) -> dict:
    """Returns {name from the root: arguments} of each source, and of each header that no source
    includes."""
    entries = json.loads((build / "compile_commands.json").read_text(encoding="utf-8"))
    alone = build / "headers_alone"
    sources, headers = {}, {}
    for entry in entries:
        words = shlex.split(entry["command"])
        arguments = [*without_precompiled(words[1:words.index("-o")]), "-Wno-unknown-warning-option"]
        for file in unified(pathlib.Path(entry["file"])):
            if alone in file.parents:
                headers[file.relative_to(alone).as_posix()[:-len(".cpp")]] = arguments
            elif ROOT in file.parents and file.relative_to(ROOT).parts[0] in LAYERS:
                sources[file.relative_to(ROOT).as_posix()] = arguments
    seen = set()
    for name in sources:
        included(name, seen)
    for name in sorted(headers, key=lambda name: -name.count("/")):
        if name not in seen:
            included(name, seen)
            sources[name] = headers[name]
    return sources


def git_lines(*command: str) -> list:
    return subprocess.run(["git", "-c", "safe.directory=*", *command], cwd=ROOT, check=True,
                          capture_output=True, text=True).stdout.splitlines()


def checked_text(text: str) -> str:
    """Returns a source without the comments that no check reads.

    Comments within functions and classes leave their lines behind, because long functions are
    found by their number of lines. Comments with NOLINT stay.
    """
    def shortened(found: re.Match) -> str:
        word = found[0]
        return word if word.startswith('"') or "NOLINT" in word else "//"
    outside = re.sub(r"^//(?!.*NOLINT).*\n", "", text, flags=re.MULTILINE)
    return re.sub(r'"(?:\\.|[^"\\\n])*"|//[^\n]*', shortened, outside)


def old_texts(commit: str, names: list) -> dict:
    """Returns the texts of those files that the commit has."""
    run = subprocess.run(["git", "-c", "safe.directory=*", "cat-file", "--batch"], cwd=ROOT, check=True,
                         capture_output=True, input="".join(f"{commit}:{name}\n" for name in names).encode())
    texts, rest = {}, run.stdout
    for name in names:
        head, _, rest = rest.partition(b"\n")
        if head.endswith(b" missing"):
            continue
        size = int(head.split()[-1])
        texts[name], rest = rest[:size].decode("utf-8"), rest[size + 1:]
    return texts


def different_from(commit: str) -> set:
    """Returns the names from the root of all files that differ from the commit, including new
    files."""
    return {*git_lines("diff", "--name-only", commit),
            *git_lines("ls-files", "--others", "--exclude-standard")}


def changed_since(commit: str) -> set:
    """Returns the names of all files that differ from the commit in more than comments that no check
    reads."""
    def reads_the_same(old: str, new: str) -> bool:
        # The simple rule for strings does not know raw ones.
        return 'R"' not in old + new and checked_text(old) == checked_text(new)

    changed = different_from(commit)
    sources = sorted(name for name in changed if name.endswith((".cpp", ".hpp")) and (ROOT / name).is_file())
    return changed - {name for name, old in old_texts(commit, sources).items()
                      if reads_the_same(old, (ROOT / name).read_text(encoding="utf-8"))}


def clean_file() -> pathlib.Path:
    """Returns the file that names the last commit on which all files were clean."""
    return ROOT / "tests/tidy/clean"


def last_clean_commit() -> str:
    """Returns the known clean commit since which the fewest files have changed; "" if there is none."""
    known = [commit for commit in (commit_named_in(clean_file()), proven_commit()) if commit]
    return min(known, key=lambda commit: len(different_from(commit)), default="")


def record() -> None:
    """Writes the commit that is checked out as a clean one, unless the tree is not clean."""
    if git_lines("status", "--porcelain"):
        print("tests/tidy/clean is not written: the tree is not that of a commit")
        return
    commit = git_lines("rev-parse", "HEAD")[0]
    clean_file().write_text("# clang_tidy.py --record wrote this: all files of the commit below are clean.\n"
                            f"{commit}\n", encoding="utf-8")
    print(f"tests/tidy/clean names {commit}: commit it")


def of_changed(found: dict, changed: set) -> dict:
    """Returns those commands that belong to changed sources, and one source for each changed
    header."""
    chosen = {name: arguments for name, arguments in found.items() if name in changed}
    missing = {name for name in changed if name.endswith(".hpp")}
    for name in chosen:
        missing -= included(name, set())
    for name in sorted(found, key=lambda name: name.count("/")):
        seen = included(name, set()) & missing
        if seen:
            chosen[name] = found[name]
            missing -= seen
    return chosen


class Checker:
    """Checks groups of files, each group as one source in a scratch folder."""

    def __init__(self, options: argparse.Namespace, scratch: str):
        self.options, self.scratch = options, pathlib.Path(scratch)
        self.commands = commands(options.build)
        commit = last_clean_commit() if options.changed else ""
        if commit:
            count = len(self.commands)
            self.commands = of_changed(self.commands, changed_since(commit))
            print(f"{len(self.commands)} of {count} files, for what has changed since {commit[:10]}")

    def groups(self) -> list:
        """Returns groups of files of one layer with the same flags."""
        layers = {}
        for name in sorted(self.commands):
            if re.search(self.options.only, name):
                key = (name.partition("/")[0], *self.commands[name])
                layers.setdefault(key, []).append(name)
        return [names[start:start + LARGEST_GROUP] for names in layers.values()
                for start in range(0, len(names), LARGEST_GROUP)]

    def source_of(self, group: list) -> pathlib.Path:
        # The analyser follows included sources only if the file has such a name.
        name = "UnifiedSource_" + re.sub(r"\W", "_", group[0]) + f"_{len(group)}.cpp"
        source = self.scratch / name
        source.write_text("".join(f'#include "{name}"\n' for name in group), encoding="utf-8")
        return source

    def compiles(self, group: list) -> bool:
        arguments = self.commands[group[0]]
        run = subprocess.run(
            [self.options.clang, *arguments, "-w", "-fsyntax-only", str(self.source_of(group))],
            capture_output=True, check=False)
        return run.returncode == 0

    def check(self, group: list) -> list:
        """Returns [(seconds, files, exit status, findings)]; divides a group that does not compile
        as one."""
        if len(group) > 1 and not self.compiles(group):
            half = len(group) // 2
            return self.check(group[:half]) + self.check(group[half:])
        checks = next((special for folder, special in SPECIAL_CHECKS.items()
                       if group[0].startswith(folder)), GROUP_CHECKS)
        start = time.monotonic()
        run = subprocess.run(
            [self.options.tidy, "--quiet", f"--config-file={ROOT / '.clang-tidy'}",
             f"--checks={checks}", str(self.source_of(group)),
             "--", *self.commands[group[0]]],
            capture_output=True, text=True, check=False)
        text = run.stdout or (run.stderr if run.returncode else "")
        return [(time.monotonic() - start, group, run.returncode, text)]


def findings(text: str) -> list:
    """Divides the output into one text for each finding, including its notes."""
    parts = re.split(r"^(?=\S+:\d+:\d+: (?:error|warning): )", text, flags=re.MULTILINE)
    return [part for part in parts if part.strip()]


def run(options: argparse.Namespace, scratch: str) -> int:
    checker = Checker(options, scratch)
    printed, failed, times = set(), False, []
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for results in pool.map(checker.check, checker.groups()):
            for seconds, group, status, text in results:
                times.append((seconds, group))
                failed = failed or status != 0
                new = [part for part in findings(text) if part not in printed] if status else []
                printed.update(new)  # A header's finding comes once for each user.
                print("".join(new).replace(f"{ROOT}/", ""), end="", flush=True)
    times.sort(reverse=True)
    for seconds, group in times[:3]:
        print(f"{seconds:6.1f} s  {len(group)} files from {group[0]}")
    count = sum(len(group) for _, group in times)
    print(f"clang-tidy: {count} files in {len(times)} groups, {len(printed)} findings")
    return failed


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tidy")
    parser.add_argument("clang")
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="", help="regex on file names")
    parser.add_argument("--changed", action="store_true")
    parser.add_argument("--record", action="store_true", help="write tests/tidy/clean")
    options = parser.parse_args()
    if options.record and options.only:
        parser.error("--record needs a check of all files: leave --only out")
    with tempfile.TemporaryDirectory() as scratch:
        failed = run(options, scratch)
    if options.record and not failed:
        record()
    return failed


if __name__ == "__main__":
    sys.exit(main())
