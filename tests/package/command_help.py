"""Reads the commands and options of `kerfline` from `--help`; tests compare generated files with
them."""
import re
import subprocess


def help_of(kerfline, path) -> str:
    return subprocess.run([kerfline, *path, "--help"], capture_output=True, text=True, check=True).stdout


def options_in(text) -> set:
    found = set()
    for line in text.splitlines():
        if match := re.match(r" {2,4}(-\w)?,?(--[\w-]+)?(?= |$)", line):
            found.update(name for name in match.groups() if name)
    return found


def subcommands_in(text) -> list:
    _, _, below = text.partition("\nSubcommands:\n")
    return re.findall(r"^  ([\w-]+) ", below.split("\n\n")[0], re.MULTILINE)


def all_commands(kerfline) -> dict:
    """Returns {path: (subcommands, options)}, where a path is a tuple of names, and that of the
    program itself is empty."""
    commands, open_paths = {}, [()]
    while open_paths:
        path = open_paths.pop()
        text = help_of(kerfline, path)
        commands[path] = (subcommands_in(text), options_in(text))
        open_paths += [(*path, name) for name in commands[path][0]]
    return commands
