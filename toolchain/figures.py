#!/usr/bin/env python3
"""Writes docs/figures.md from the results of builds and measurements: the images, the instructions
on the emulated chip, and the stages of the last test.sh and prove.sh.

    toolchain/figures.py [BUILD_FOLDER]      build, or that of another clone
"""
import csv
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
NEVER = "not measured here"


def table(head: list, rows: list) -> list:
    return ["| " + " | ".join(head) + " |", "|" + "---|" * len(head),
            *("| " + " | ".join(map(str, row)) + " |" for row in rows), ""]


def images(build: pathlib.Path) -> list:
    """Returns the bytes of flash, static RAM and stack of each image."""
    rows = []
    for elf in sorted((build / "cortex-m4f/images").glob("*.elf")):
        symbols = {name: int(value, 16) for value, _, name in
                   (line.split() for line in subprocess.run(
                       ["arm-none-eabi-nm", elf], capture_output=True, text=True,
                       check=True).stdout.splitlines() if len(line.split()) == 3)}
        flash = elf.with_suffix(".bin").stat().st_size
        ram = symbols["bss_end"] - symbols["data_begin"]
        stack = subprocess.run(
            [sys.executable, "-B", ROOT / "tests/static/image_stack.py", elf],
            capture_output=True, text=True, check=False).stdout
        need = {name.rstrip(":"): bytes_ for bytes_, name in
                re.findall(r"^ *(\d+)  (\S+)", stack, re.MULTILINE)}
        interrupt = max(int(value) for name, value in need.items() if name.endswith("_interrupt"))
        rows.append([elf.stem, f"{flash:,}", f"{symbols['application_end'] - symbols['image_begin']:,}",
                     f"{ram:,}", f"{need['main']} / {interrupt} / {need['all']}"])
    return rows


COUNTS = {"instructions": "", "cycles": "_cycles", "loads": "_loads", "branches taken": "_taken",
          "divisions": "_divisions", "misses": "_misses"}
LINE, INTERRUPT = "the main loop in all at 60 m/min per line", "step interrupt per interrupt"
PIXEL, PIXELS_A_SECOND = "fine raster: the main loop in all, worst: a turn per pixel", 20_000
CORE_HZ, STEPS_A_LINE = 168_000_000, 25  # 0.1 mm at 250 steps/mm.


def figures_on_the_chip() -> dict:
    with (ROOT / "tests/target/instructions.csv").open(encoding="utf-8") as file:
        return {row["stage"]: row for row in csv.DictReader(file)}


def on_the_chip() -> list:
    """Returns for each stage the average of all counts, and the worst case of the first two."""
    return [[stage, *(f"{row['average' + count]} / {row['worst' + count]}" if "worst" + count in row
                      else row["average" + count] for count in COUNTS.values())]
            for stage, row in figures_on_the_chip().items()]


def lines_a_second() -> int:
    """Returns the number of lines of 0.1 mm that the chip can read, plan and drive in a second."""
    cycles = {stage: int(row["average_cycles"]) for stage, row in figures_on_the_chip().items()}
    return 100 * round(CORE_HZ / (cycles[LINE] + STEPS_A_LINE * cycles[INTERRUPT]) / 100)


def share_of_pixels() -> int:
    """Returns the percentage of processor time that the main loop takes for 20,000 fine pixels in a
    second."""
    return round(100 * PIXELS_A_SECOND * int(figures_on_the_chip()[PIXEL]["average_cycles"]) / CORE_HZ)


def stages(build: pathlib.Path, tier: str) -> list:
    file = build / "proof" / f"{tier}_stages.csv"
    if not file.is_file():
        return [[NEVER, ""]]
    with file.open(encoding="utf-8") as rows:
        return [[name, f"{float(seconds):.0f}"] for name, seconds in csv.reader(rows)]


def main() -> int:
    build = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else ROOT / "build"
    lines = [
        "# Figures", "", "`toolchain/figures.py` writes this page.", "",
        "## Images", "",
        "Bytes, by `cmake --preset cortex-m4f && cmake --build --preset cortex-m4f`. Static RAM is",
        "without the stack, which has 8,192 bytes of CCM; the main loop may use 4,096 of it and each",
        "interrupt 512 (`tests/static/image_stack.py`).", "",
        *table(["image", "flash", "may be", "static RAM", "stack: main loop / interrupt / at once"],
               images(build)),
        "Images that may be 786,432 bytes run on chips with 512 KiB, too, where they have 262,144 at most.", "",
        "## On the controller's processor", "",
        "By `tests/target/instructions.py`: averages, and where there are two the worst. Cycles are those of",
        "a model of the core and its flash at 168 MHz (`tests/target/machine/README.md`).", "",
        *table(["stage", *COUNTS], on_the_chip()),
        f"So the chip reads, plans and drives {lines_a_second():,} lines of 0.1 mm a second at most, with a step",
        "interrupt for each of the 25 steps that 250 steps/mm make of a line. Of 20,000 fine pixels a second, many",
        f"to a line, the main loop takes {share_of_pixels()} % of its time.", "",
        "## Time of a proof", "",
        "Seconds on two cores of an x86-64 machine, from a clean clone with cold caches.", "",
        *table(["`toolchain/test.sh`", "s"], stages(build, "test")),
        *table(["`toolchain/prove.sh`", "s"], stages(build, "prove")),
    ]
    (ROOT / "docs").mkdir(exist_ok=True)
    (ROOT / "docs/figures.md").write_text("\n".join(lines).rstrip("\n") + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
