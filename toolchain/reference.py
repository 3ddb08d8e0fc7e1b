#!/usr/bin/env python3
"""Writes docs/reference: settings, alarms, errors, statements and the command line, as a simulated
controller and the program list them.

    toolchain/reference.py KERFLINE [--check]    --check: fails if a page is out of date
"""
import pathlib
import re
import socket
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGES = ROOT / "docs/reference"
WRITTEN_BY = "`toolchain/reference.py` writes this page from {}.\n"
# The types of a setting, by the numbers of `$ES`.
TYPES = {"0": "0 or 1", "1": "bits", "2": "bits, with the first as a switch", "3": "choice",
         "4": "axes, as bits", "5": "whole number", "6": "decimal", "7": "text"}
# Each statement with its effect; the names are compared with those in the code.
STATEMENTS = {
    "$": "lists the statements of Grbl",
    "$$": "lists all settings with their values",
    "$N": "lists the start-up lines",
    "$#": "lists work offsets, G28, G30, G92, tool radii, tool length and the last probe",
    "$G": "prints the modes of the parser, as a line that can be sent back",
    "$I": "prints version, options and the user's text",
    "$I+": "adds board, checksum, clock, reason of the start, stack, store and the chip's number",
    "$ES": "lists settings: number, group, name, unit, type, format, range",
    "$EG": "lists groups of settings",
    "$ESH": "lists descriptions of settings (not on the images for 512 KiB)",
    "$EA": "lists alarms",
    "$EE": "lists errors",
    "$PC": "lists the beam's power table, percent:watts",
    "$C": "begins or ends checking: lines are judged, and nothing moves",
    "$X": "unlocks an alarm",
    "$B": "switches block delete until `$890` is written",
    "$DFU": "restarts into the chip's boot loader, at rest only",
    "$K": "lists kerf tables",
    "$KS": "checks the parts of a kerf table that were sent, and keeps the table",
    "$RESUME": "prints the line at which an interrupted program can be taken up again",
    "$SLP": "puts motors and outputs to sleep",
    "$H": "homes all axes, `$HX` one, `$HXY` two",
    "$110": "prints one setting",
    "$J=": "jogs: `$J=G91 X10 F1000`",
    "$I=": "keeps a text of the user, which `$I` prints",
    "$RST=": "restores: `$` settings, `#` offsets and tool radii, `*` all",
    "$PC=": "sets the power table, `10:0,50:18.5,100:40`; empty: forgets it",
    "$KW=": "takes a part of a kerf table: number:hexadecimal bytes",
    "$KE=": "forgets a kerf table by name; `*`: all that were stored",
    "$KR=": "prints a stored kerf table as the lines that write it",
    "$KQ=": "asks for a kerf: table, thickness mm, power W, speed mm/min",
    "$RESUME=": "takes the program up again at that line; 0 ends it",
    "$N0=": "sets the start-up line that runs first",
    "$N1=": "sets the start-up line that runs second",
    "$110=": "changes one setting",
}
# The values of RealtimeByte with their effects; the names are compared with those in the code.
REALTIME = {
    "Reset": "soft reset", "Stop": "stop; the same as a reset", "CycleStart": "cycle start, resume",
    "FeedHold": "feed hold", "Status": "status report", "StatusRaw": "status report",
    "CycleStartRaw": "cycle start, resume", "FeedHoldRaw": "feed hold",
    "ParserState": "prints the modes of the parser", "SafetyDoor": "safety door",
    "JogCancel": "cancels a jog", "FullStatus": "status report with all fields",
    "OptionalStop": "optional stop (M1) on or off", "SingleBlock": "single block on or off",
    "AutoReport": "automatic status reports on or off (`$481`)",
    "FeedReset": "feed override 100 %", "FeedUp10": "feed override + 10 %",
    "FeedDown10": "feed override - 10 %", "FeedUp1": "feed override + 1 %",
    "FeedDown1": "feed override - 1 %", "RapidFull": "rapid override 100 %",
    "RapidHalf": "rapid override 50 %", "RapidQuarter": "rapid override 25 %",
    "PowerReset": "power override 100 %", "PowerUp10": "power override + 10 %",
    "PowerDown10": "power override - 10 %", "PowerUp1": "power override + 1 %",
    "PowerDown1": "power override - 1 %", "SpindleStop": "stops the spindle in a hold, or starts it again",
    "Flood": "flood coolant on or off", "Mist": "mist coolant on or off",
    "ToolAcknowledge": "the sender takes part in a tool change",
}


def ask(kerfline: str, statements: list) -> dict:
    """Returns the lines with which a fresh controller answers each statement."""
    command = [kerfline, "serve", "--tcp", "0"]
    answers = {}
    with subprocess.Popen(command, text=True, stdout=subprocess.PIPE) as machine:
        try:
            port = int(machine.stdout.readline().rsplit(":", 1)[1])
            with socket.create_connection(("127.0.0.1", port), timeout=30) as link:
                talk = link.makefile("rw", encoding="latin-1", newline="\n")
                while not talk.readline().startswith("Grbl"):
                    pass
                for statement in statements:
                    talk.write(statement + "\n")
                    talk.flush()
                    lines = []
                    while not re.match(r"ok$|error:", line := talk.readline().strip()):
                        lines.append(line)
                    answers[statement] = lines
        finally:
            machine.terminate()
    return answers


def rows(lines: list) -> list:
    """Returns the fields between the brackets of lines such as [ALARMCODE:1||text]."""
    return [line[line.index(":") + 1:-1].split("|") for line in lines if line.startswith("[")]


def table(head: list, body: list) -> str:
    def cell(text):
        return str(text).replace("|", "\\|")
    return "\n".join(["| " + " | ".join(head) + " |", "|" + "---|" * len(head)] +
                     ["| " + " | ".join(map(cell, row)) + " |" for row in body]) + "\n"


def meaning_of(kind: str, names: str) -> str:
    if kind in ("1", "2"):
        named = [f"{bit} {name}" for bit, name in enumerate(names.split(",")) if name != "N/A"]
        return "bits: " + ", ".join(named)
    if kind == "3":
        return "choice: " + ", ".join(f"{value} {name}" for value, name in enumerate(names.split(",")))
    return TYPES[kind]


def settings_page(answers: dict) -> str:
    groups = {number: name for number, _, name in rows(answers["$EG"])}
    helps = dict(rows(answers["$ESH"]))
    values = dict(line[1:].split("=", 1) for line in answers["$$"])
    by_group = {}
    for number, group, name, unit, kind, form, least, most, *_ in rows(answers["$ES"]):
        reach = f"{least} to {most}" if least else ""
        by_group.setdefault(group, []).append(
            [f"`${number}`", name, values[number], reach, unit, meaning_of(kind, form), helps[number]])
    parts = ["# Settings\n", WRITTEN_BY.format("the answers of a controller to `$ES`, `$EG`, `$ESH` and `$$`"),
             "`$N=value` changes one; [settings.md](../settings.md) explains them by subject.\n"]
    head = ["setting", "name", "delivered", "range", "unit", "type", "meaning"]
    for group, body in by_group.items():
        parts += [f"## {groups[group]}\n", table(head, body)]
    return "\n".join(parts)


def codes_page(title: str, statement: str, letter: str, answers: dict) -> str:
    body = [[f"{letter}{number}", text] for number, _, text in rows(answers[statement])]
    return "\n".join([f"# {title}\n", WRITTEN_BY.format(f"the answer of a controller to `{statement}`"),
                      table([title[:-1].lower(), "meaning"], body)])


def names_in_code() -> set:
    """Returns the names of the statements that firmware/protocol/statement.cpp reads."""
    code = (ROOT / "firmware/protocol/statement.cpp").read_text(encoding="utf-8")
    listings, rest = code.split("kListings{{", 1)[1].split("}};", 1)
    commands, assignments = rest.split("read_assignment", 1)
    found = {"$" + name for name in re.findall(r'\{"([^"]*)", ListingKind', listings)}
    found |= {"$" + name for name in re.findall(r'name == "(\w+)"', commands)}
    found |= {"$" + name for name in re.findall(r"name.front\(\) == '(\w)'", commands)}
    found |= {f"${name}=" for name in re.findall(r'name == "(\w+)"', assignments)}
    return found | {"$110", "$110="}


def statements_page() -> str:
    if differing := names_in_code() ^ set(STATEMENTS):
        sys.exit(f"reference.py: STATEMENTS and firmware/protocol/statement.cpp differ in {sorted(differing)}")
    code = (ROOT / "firmware/link/realtime_byte.hpp").read_text(encoding="utf-8")
    values = dict(re.findall(r"^  k(\w+) = (0x\w+|'.'),", code, re.MULTILINE))
    if differing := set(values) ^ set(REALTIME):
        sys.exit(f"reference.py: REALTIME and firmware/link/realtime_byte.hpp differ in {sorted(differing)}")
    return "\n".join([
        "# Statements and realtime bytes\n",
        WRITTEN_BY.format("`firmware/protocol/statement.cpp` and `firmware/link/realtime_byte.hpp`"),
        "[protocol.md](../protocol.md) says when each is taken, and what its answer holds.\n",
        "## Statements\n", table(["statement", "effect"], [[f"`{name}`", text] for name, text in STATEMENTS.items()]),
        "## Realtime bytes\n", "They act when they arrive, without a line.\n",
        table(["byte", "effect"], [[f"`{value.strip(chr(39))}`", REALTIME[name]] for name, value in values.items()])])


def helps_of(kerfline: str, words: list) -> list:
    """Returns the help of a command and of its subcommands, as pairs of words and text."""
    done = subprocess.run([kerfline, *words, "--help"], capture_output=True, text=True, check=True,
                          env={"PATH": "/usr/bin", "COLUMNS": "100"})
    found = [(words, done.stdout.rstrip())]
    listed = done.stdout.split("\nSubcommands:\n", 1)
    if len(listed) == 2:
        for name in re.findall(r"^  ([a-z][\w-]*) ", listed[1].split("\n\n", 1)[0], re.MULTILINE):
            found += helps_of(kerfline, words + [name])
    return found


def command_line_page(kerfline: str) -> str:
    parts = ["# Command line\n", WRITTEN_BY.format("`kerfline --help` and the help of each command")]
    for words, text in helps_of(kerfline, []):
        parts.append(f"## {' '.join(['kerfline', *words])}\n\n```text\n{text}\n```\n")
    return "\n".join(parts)


def pages(kerfline: str) -> dict:
    answers = ask(kerfline, ["$$", "$ES", "$EG", "$ESH", "$EA", "$EE"])
    return {"settings.md": settings_page(answers),
            "alarms.md": codes_page("Alarms", "$EA", "ALARM:", answers),
            "errors.md": codes_page("Errors", "$EE", "error:", answers),
            "statements.md": statements_page(),
            "command-line.md": command_line_page(kerfline)}


def main() -> int:
    complaints = []
    PAGES.mkdir(exist_ok=True)
    for name, text in pages(str(pathlib.Path(sys.argv[1]).resolve())).items():
        page = PAGES / name
        if "--check" not in sys.argv[2:]:
            page.write_text(text, encoding="utf-8")
        elif not page.exists() or page.read_text(encoding="utf-8") != text:
            complaints.append(f"docs/reference/{name} is not what the program lists; toolchain/reference.py writes it")
    print("\n".join(complaints) or "reference: the pages are what the program lists")
    return bool(complaints)


if __name__ == "__main__":
    sys.exit(main())
