"""Compiles one case with the project's flags. Passes if the compiler refuses it with the message
that the case expects.

A case without an EXPECT line is the reference case: it must compile.
"""
import argparse
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys


def command_for(case: pathlib.Path, database: pathlib.Path, model: pathlib.Path) -> tuple:
    """Returns the compile command of `model` for `case`, without output, and the folder of the
    command."""
    for entry in json.loads(database.read_text()):
        if pathlib.Path(entry["file"]) != model:
            continue
        words = shlex.split(entry["command"])
        output = words.index("-o")
        words = words[:output] + words[output + 2:]
        words[words.index(str(model))] = str(case)
        return [*words, "-fsyntax-only"], entry["directory"]
    sys.exit(f"{database} has no command for {model}")


def verdict(case: pathlib.Path, exit_code: int, messages: str) -> str:
    """Returns an empty text if the compiler behaved as the case expects, otherwise the complaint."""
    expected = re.search(r"^// EXPECT: (.+)$", case.read_text(), re.MULTILINE)
    if not expected:
        return f"must compile, but does not:\n{messages}" if exit_code else ""
    if exit_code == 0:
        return f"compiles, but must fail with: {expected[1]}"
    if not re.search(expected[1], messages):
        return f"fails, but not with: {expected[1]}\n{messages}"
    return ""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--compile-commands", type=pathlib.Path, required=True)
    parser.add_argument("--flags-of", type=pathlib.Path, required=True)
    parser.add_argument("case", type=pathlib.Path)
    options = parser.parse_args()
    command, folder = command_for(options.case, options.compile_commands, options.flags_of)
    run = subprocess.run(command, cwd=folder, capture_output=True, text=True,
                         env={**os.environ, "LC_ALL": "C"}, check=False)
    complaint = verdict(options.case, run.returncode, run.stderr)
    print(f"{options.case.name}: {complaint or 'as expected'}")
    return bool(complaint)


if __name__ == "__main__":
    sys.exit(main())
