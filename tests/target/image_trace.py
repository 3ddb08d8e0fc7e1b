#!/usr/bin/env python3
"""Compares the image in the emulated chip with the host's simulator: given the same bytes in the
same cycles, each step with its direction, and each change of the beam, must belong to the same
tick.

If the image finished a cycle late, the simulator runs the job again, late at the same boundaries.
Of the cycles in motion, at most one in a hundred may be late. An example must not end in an alarm
on either side, however late the image is.

    image_trace.py PLUGIN kerfline_generic_1mbaud.elf image_trace_jobs EXAMPLES [TEST...]

KERFLINE_TRIALS=200 runs that many random jobs of 2000 edges or more (default 3; 100 in prove.sh),
from KERFLINE_SEED on. With less than 100 jobs the share of late cycles is not judged, because it
may reach a tenth in a single job. KERFLINE_TURNS=0 drives the examples to their end (default 2500
cycles of a millisecond). Ends with 77 (skipped) if a file is missing.
"""

import dataclasses
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "faults"))
from chip import (BOOT_NS, CHIP_OPTIONS, MS, STOPPED, failed_seeds_of, first_seed,  # noqa: E402
                  in_parallel, main, name_of, share_of, trials)

CHIP = None
JOBS, EXAMPLES = "", pathlib.Path()
EXAMPLE_TURNS = int(os.environ.get("KERFLINE_TURNS", "2500")) or 10**9
RANDOM_TURNS = 3000
EXAMPLES_IN_TEST = 2  # And programs beside their path, in test.sh.
LEAST_EDGES = 2000  # Of a random job; those with fewer are passed over.
SETTLED_NS = 300 * MS  # What is set is stored by then.
# The simulator's link accepts answers immediately. A row of refusals, 45 bytes each, exceeds the
# rate of 1 Mbaud within a cycle, and lines wait while answers do. Therefore this link carries 1000
# bytes per cycle.
ANSWERS = "usart1_answer_baud=10000000"
BURST_NS = 50_000  # After the boundary before; the bytes end 0.1 ms before their own.
TICK_NS = 250
AXES = (("PA0", "PA4"), ("PA1", "PA5"), ("PA2", "PA6"))
BEAM = "TIM1_CH1"
MOST_LATE = 0.01  # Of the turns from the first edge to the last.
JUDGED_JOBS = 100  # Random ones: from so many on that share is judged.
ALARM_TICKS = 20_000  # 5 ms: what a turn that is late takes.
LATEST_TICKS = 40  # 10 us: the way to an edge, behind a boundary or a pulse.
# Where pulses follow each other without a pause (two motors alternate, slightly more than a slot
# apart), each interrupt adds its duration to the lateness of the next one: 1 us at most.
MOST_ON_THE_WAY = 4
MACHINES = {"bracket": "laser", "circle_r20": "laser", "enclosure_lightburn": "laser",
            "relief_inkscape": "laser", "sheet_8877": "laser", "pocket_fusion": "mill"}


def fine_row() -> str:
    """Returns a row of 6,000 pixels of 0.02 mm at 400 mm/s, 48 per line, with an end of 20 mm on
    each side."""
    lines = ["G21 G90 M3 F24000", "G1 X20 S0"]
    for first in range(0, 6000, 48):
        powers = ":".join(str(10 + (37 * pixel) % 90) for pixel in range(first, first + 48))
        lines.append(f"X{20 + 0.02 * (first + 48):.2f}S{powers}")
    return "\n".join([*lines, "G1 X160 S0", ""])


def tick_address() -> int:
    """Returns the address of the tick that the image is driving."""
    place = CHIP.symbols["step_tick"]
    image = CHIP.image.with_suffix(".bin").read_bytes()
    at = place - 0x08000000
    return int.from_bytes(image[at:at + 4], "little")


def words() -> list:
    """Returns the options with which the emulated chip traces that tick and the late cycles."""
    return [f"word={address:x}" for address in (tick_address(), CHIP.symbols["turns_behind"],
                                                CHIP.symbols["late_turns"])]


def lively_seeds(first: int, count: int) -> list:
    """Returns the seeds of random jobs that are long enough, by the simulator."""
    found = []
    while len(found) < count:
        with tempfile.TemporaryDirectory() as text:
            subprocess.run([JOBS, "random", str(first), str(RANDOM_TURNS), text],
                           capture_output=True, check=True)
            edges = (pathlib.Path(text) / "edges").read_text().count("\n")
        if edges >= LEAST_EDGES:
            found.append(first)
        first += 1
    return found


class Image:
    """A flash whose store holds a machine's settings, and runs of the image on it."""

    def __init__(self, folder: pathlib.Path):
        self.folder, self.flash = folder, folder / "flash"
        settings = (folder / "settings").read_text()
        run = CHIP.run(settings, SETTLED_NS, f"flash={self.flash}", *words(),
                       *CHIP_OPTIONS, "usart1_window=1")
        self.trouble = "" if run.said.count("ok\r\n") == settings.count("\n") else run.said
        self.start_ns = run.times("counts", "TIM2")[0]

    def drive(self, turns: int):
        """Returns the image's edges in the simulator's form, and its output at the end."""
        times = []
        for line in (self.folder / "times").read_text().splitlines():
            turn, count = map(int, line.split())
            times.append(f"{self.start_ns + (turn - 1) * MS + BURST_NS} {count}\n")
        # The next request is answered whatever the image is doing by then.
        asked = "\x18$I+\n"
        times.append(f"{self.start_ns + (turns + 3) * MS} 1\n")
        times.append(f"{self.start_ns + (turns + 50) * MS} {len(asked) - 1}\n")
        (self.folder / "times_ns").write_text("".join(times))
        sent = (self.folder / "sent").read_bytes().decode("latin-1") + asked
        return CHIP.run(sent, self.start_ns + (turns + 80) * MS, f"flash={self.flash}",
                        *words(), f"usart1_times={self.folder / 'times_ns'}", ANSWERS,
                        *CHIP_OPTIONS, from_ns=BOOT_NS)


def edges_of(run, start_ns: int) -> tuple:
    """Returns lines `TICK X Y Z COUNTS`, and the lateness of the latest edge in ticks. Edges do not
    count if they are only as late as the edge before them plus the durations of the interrupts
    since."""
    tick_word = f"{tick_address():08x} "
    steps = {step: axis for axis, (step, _) in enumerate(AXES)}
    ways = {way: axis for axis, (_, way) in enumerate(AXES)}
    sign, row, last, tick, edges = [1, 1, 1], [0, 0, 0, 0], [0, 0, 0, 0], 0, []
    latest, excused = 0, 0
    for ns, source, rest in run.trace:
        if source == "word":
            if not rest.startswith(tick_word):
                continue
            if row != last:
                edges.append((tick, *row))
                last = list(row)
            tick = int(rest.split()[1])
            waits = (ns - start_ns) / TICK_NS < tick
            excused = 0 if waits else excused + MOST_ON_THE_WAY
            continue
        name, _, value = rest.partition(" ")
        if source == "compare" and name == BEAM:
            row[3] = int(value)
            excused += MOST_ON_THE_WAY
        elif source == "pin" and name in ways:
            sign[ways[name]] = -1 if value == "1" else 1
        elif source == "pin" and name in steps:
            row[steps[name]] += sign[steps[name]] if value == "1" else 0
            late = (ns - start_ns) / TICK_NS - tick
            if value == "1" and late > excused:
                latest = max(latest, late)
            excused = late
    if row != last:
        edges.append((tick, *row))
    return edges, latest


def late_boundaries(run, start_ns: int) -> dict:
    """Returns the number of cycles that were due and not finished, by the boundaries at which there
    were any."""
    behind_word = f"{CHIP.symbols['turns_behind']:08x} "
    late_word = f"{CHIP.symbols['late_turns']:08x} "
    found, behind = {}, 0
    for ns, source, rest in run.trace:
        if source == "word" and rest.startswith(behind_word):
            behind = int(rest.split()[1])
        elif source == "word" and rest.startswith(late_word) and int(rest.split()[1]) > 0:
            found[(ns - start_ns) // MS] = behind
    return found


def rows_of(folder: pathlib.Path) -> list:
    """Returns the simulator's edges."""
    return [tuple(map(int, line.split()))
            for line in (folder / "edges").read_text().splitlines()]


@dataclasses.dataclass
class Comparison:
    """Result of a comparison: the fault (or ""), the number of edges, the number of cycles in
    motion, and how many of these were late."""
    trouble: str = ""
    edges: int = 0
    turns: int = 0
    late: int = 0
    alarm: str = ""  # The turn in which one was raised.


class ImageTraceTest(unittest.TestCase):
    def compare(self, name: str, first: str, second: str, most_turns: int) -> Comparison:
        with tempfile.TemporaryDirectory() as text:
            folder = pathlib.Path(text)
            done = subprocess.run([JOBS, first, second, str(most_turns), text],
                                  capture_output=True, text=True, check=False)
            if done.returncode != 0 or done.stderr:
                return Comparison(f"{name}: {done.stderr}")
            turns = int(done.stdout.split()[0])
            image = Image(folder)
            if image.trouble:
                return Comparison(f"{name}: settings: {image.trouble[-400:]}")
            run = image.drive(turns)
            late = {turn: behind for turn, behind in
                    late_boundaries(run, image.start_ns).items() if turn < turns}
            if late:
                (folder / "late").write_text(
                    "".join(f"{turn} {behind}\n" for turn, behind in late.items()))
                subprocess.run([JOBS, "again", str(folder / "late"), str(turns), text],
                               capture_output=True, check=True)
            wanted = rows_of(folder)
            alarm = (folder / "alarm").read_text()
            if os.environ.get("KERFLINE_KEEP"):
                shutil.copytree(folder, pathlib.Path(os.environ["KERFLINE_KEEP"]) / name,
                                dirs_exist_ok=True)
        seen, latest = edges_of(run, image.start_ns)
        if run.status != STOPPED or "[LATE TURNS:" not in run.said or "Restarted" in run.said:
            return Comparison(f"{name}: ended with {run.status} {run.told} {run.said[-400:]}")
        if run.times("counts", "TIM2")[0] != image.start_ns or latest > LATEST_TICKS:
            return Comparison(f"{name}: an edge came {latest:.0f} ticks late")
        end, trouble = 4000 * turns, ""
        if alarm:
            end = 4000 * int(alarm)
            trouble = self.judge_alarm(name, end, seen, wanted)
        found = self.compare_edges(name, [row for row in seen if row[0] < end],
                                   [row for row in wanted if row[0] < end], late)
        found.trouble, found.alarm = found.trouble or trouble, alarm
        return found

    def judge_alarm(self, name: str, raised: int, seen: list, wanted: list) -> str:
        """An alarm ends motion and beam immediately, not at a certain tick: soon enough, and with
        the beam off."""
        after = [row for row in seen if row[0] > raised + ALARM_TICKS]
        if after:
            return f"{name}: the alarm of tick {raised} has not ended all: {after[0]}"
        if seen and wanted and seen[-1][4] != wanted[-1][4]:
            return f"{name}: after the alarm the output is {seen[-1][4]}, not {wanted[-1][4]}"
        return ""

    def compare_edges(self, name: str, seen: list, wanted: list, late: dict) -> Comparison:
        first, last = (wanted[0][0] // 4000, wanted[-1][0] // 4000) if wanted else (0, 0)
        found = Comparison("", len(wanted), last + 1 - first,
                           sum(first <= turn <= last for turn in late))
        if seen != wanted:
            at = next((i for i, (a, b) in enumerate(zip(seen, wanted)) if a != b),
                      min(len(seen), len(wanted)))
            found.trouble = (f"{name}: {len(wanted)} edges, the image's {len(seen)}; the first "
                             f"that differs is {at}: {wanted[at:at + 1]}, the image's "
                             f"{seen[at:at + 1]}; late turns: {late}")
        return found

    def judge(self, what: str, results: list, is_random: bool = False):
        edges, turns = sum(each.edges for each in results), sum(each.turns for each in results)
        late = sum(each.late for each in results)
        troubles = [each.trouble for each in results if each.trouble]
        print(f"{what}: {len(results) - len(troubles)} of {len(results)} jobs are the same, "
              f"{edges} edges; of {turns} turns in motion {late} were late, by jobs "
              f"{[each.late for each in results]}")
        print("\n".join(troubles))
        self.assertFalse(troubles)
        if not is_random:
            self.assertFalse([each.alarm for each in results if each.alarm])
        if not is_random or len(results) >= JUDGED_JOBS:
            self.assertLessEqual(late, MOST_LATE * turns)
        self.assertGreater(edges, 1000)

    def test_the_examples(self):
        def example(name: str):
            return self.compare(name, str(EXAMPLES / f"{MACHINES[name]}.settings"),
                                str(EXAMPLES / f"{name}.nc"), EXAMPLE_TURNS)

        here = sorted(path.stem for path in EXAMPLES.glob("*.nc"))
        self.assertEqual(sorted(MACHINES), here)
        self.judge("examples", in_parallel(example, share_of(here, EXAMPLES_IN_TEST, name_of(self))))

    def test_a_path_beside_the_programmed_one(self):
        def job(name: str):
            program = pathlib.Path(__file__).with_name("trace") / f"{name}.nc"
            return self.compare(name, str(EXAMPLES / "laser.settings"), str(program), 10**9)

        names = ["beside_the_path", "kerf_path", "kerf_power", "five_axes"]
        self.judge("beside the path",
                   in_parallel(job, share_of(names, 1, name_of(self))))

    def test_a_row_of_20000_pixels_a_second(self):
        with tempfile.TemporaryDirectory() as text:
            settings, program = pathlib.Path(text) / "settings", pathlib.Path(text) / "program"
            settings.write_text((EXAMPLES / "laser.settings").read_text() + "$110=30000\n$120=5000\n")
            program.write_text(fine_row())
            found = self.compare("fine row", str(settings), str(program), 10**9)
        self.judge("a row of fine pixels", [found])
        self.assertLess(found.turns, 500, "160 mm at 400 mm/s, and 80 ms of ramps")

    def test_random_jobs_with_holds_and_overrides(self):
        def job(number: int):
            return self.compare(f"seed {number}", "random", str(number), RANDOM_TURNS)

        seeds = lively_seeds(first_seed(self), trials(3, in_proof=JUDGED_JOBS))
        seeds = failed_seeds_of(self) + seeds
        self.judge(f"seeds {seeds[0]} to {seeds[-1]}", in_parallel(job, seeds), is_random=True)


if __name__ == "__main__":
    JOBS, EXAMPLES = sys.argv[3], pathlib.Path(sys.argv[4])
    del sys.argv[3:5]
    main(globals(), "image_trace")
