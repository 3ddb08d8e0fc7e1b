"""Runs the unchanged image of the controller in the emulated chip of tests/target/machine, and
records its output and its pins from power-on to a given virtual time."""

import bisect
import concurrent.futures
import dataclasses
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "support"))
from seeds import failed_seeds_of, first_seed, name_of, share_of, trials  # noqa: E402

EMULATOR = "qemu-system-arm"
SKIPPED = 77
POWER_CUT, STOPPED = 90, 91
MS = 1_000_000  # ns.
SLOWEST = 60  # Times as slow as the chip that the emulator is allowed to be.
BOOT_NS = 60 * MS  # Clocks, the image's checksum, the store; then the banner.
AT_ONCE = 2  # Emulators.
CHIP_OPTIONS = ("erase_us=1000",)  # A store that is new is erased at its first use.
RAM = 0x20000000
FLASH = 0x08000000

# Pins of the generic board.
BEAM_PIN, BEAM_TIMER = "PA8", "TIM1_CH1"
STEP_PINS = ("PA0", "PA1", "PA2", "PC0", "PC1", "PC2")  # Of all six axes.
FLOOD_PIN = "PB4"


def some_of(test: unittest.TestCase, cases: list, usual: int) -> list:
    """Returns as many of the cases as are to be tried, in their order."""
    count = min(trials(usual), len(cases))
    chosen = set(random.Random(first_seed(test)).sample(range(len(cases)), count))
    return [case for place, case in enumerate(cases) if place in chosen]


def in_parallel(work, inputs) -> list:
    """Returns the results in the order of the inputs."""
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        return list(pool.map(work, inputs))


@dataclasses.dataclass
class Run:
    """Result of a run: `trace` is a list of (ns, source, rest)."""
    status: int
    said: str
    told: str
    trace: list

    def times(self, source: str, beginning: str = "") -> list:
        return [ns for ns, who, rest in self.trace if who == source and rest.startswith(beginning)]

    def resets(self) -> list:
        """Returns the times of restarts, without power-on."""
        return self.times("reset")[1:]

    def steps(self) -> list:
        """Returns the times at which a step pulse of any axis rose."""
        rising = {f"{pin} 1" for pin in STEP_PINS}
        return [ns for ns, who, rest in self.trace if who == "pin" and rest in rising]

    def lit(self) -> list:
        """Returns the intervals during which the beam's pin was high or had pulses."""
        spans, since, driven, pulses = [], None, "z", "z"
        for ns, who, rest in self.trace:
            if who == "pin" and rest.startswith(BEAM_PIN + " "):
                driven = rest.split()[1]
            elif who == "pwm" and rest.startswith(BEAM_TIMER + " "):
                pulses = rest.split()[1]
            elif who != "end":
                continue
            high = driven == "1" or (driven == "f" and pulses not in ("0", "z"))
            if high and since is None:
                since = ns
            if since is not None and (not high or who == "end"):
                spans.append((since, ns))
                since = None
        return spans

    def gaps_lit(self):
        """Yields the spans between steps during which the beam was lit: (begin, end)."""
        steps = self.steps()
        for begin, end in self.lit():
            within = steps[bisect.bisect_left(steps, begin):bisect.bisect_right(steps, end)]
            edges = [begin, *within, end]
            yield from zip(edges, edges[1:])

    def lit_without_step(self) -> tuple:
        """Returns the longest time for which the beam was lit without a step, and its end; ns."""
        return max(((end - begin, end) for begin, end in self.gaps_lit()), default=(0, 0))

    def lit_without_motion(self) -> tuple:
        """Returns the same for spans between fast steps only: the steps before and after a span
        came at less than a quarter of its length."""
        steps = self.steps()

        def moves(begin: int, end: int) -> bool:
            before = steps[:bisect.bisect_right(steps, begin)][-2:]
            after = steps[bisect.bisect_left(steps, end):][:2]
            return any(len(pair) == 2 and end - begin <= 4 * (pair[1] - pair[0])
                       for pair in (before, after))
        return max(((end - begin, end) for begin, end in self.gaps_lit()
                    if end - begin > MS and not moves(begin, end)), default=(0, 0))


class Chip:
    """An image, and the machine in which it runs."""

    def __init__(self, plugin: str, image: str, shift: int = 3):
        self.plugin, self.image, self.shift = plugin, pathlib.Path(image), shift
        listing = subprocess.run(["arm-none-eabi-nm", image], capture_output=True, text=True,
                                 check=True).stdout
        self.symbols = {name: int(address, 16) for address, name
                        in re.findall(r"^(\w+) \w (\S+)$", listing, re.MULTILINE)}

    @property
    def instruction_ns(self) -> int:
        return 1 << self.shift

    def command(self, *options: str, kernel: pathlib.Path | None = None) -> list:
        return [EMULATOR, "-M", "netduinoplus2", "-display", "none", "-monitor", "none",
                "-serial", "none", "-icount", f"shift={self.shift},sleep=off",
                # On a board with a boot loader, the vectors have a higher address.
                "-global", f"armv7m.init-nsvtor={self.symbols['image_begin']:#x}",
                "-kernel", str(kernel or self.image), "-plugin", ",".join([self.plugin, *options])]

    def run(self, text: str, stop_ns: int, *options: str, from_ns: int = BOOT_NS,
            kernel: pathlib.Path | None = None) -> Run:
        """Sends `text` from `from_ns` on, and ends at `stop_ns`. `kernel` is a file that replaces
        the image."""
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            sent, heard, trace = folder / "sent", folder / "heard", folder / "trace"
            sent.write_bytes(text.encode("latin-1"))
            command = self.command(f"trace={trace}", f"usart1_in={sent}", f"usart1_out={heard}",
                                   f"usart1_from_ns={from_ns}", f"stop_ns={stop_ns}", *options,
                                   kernel=kernel)
            limit_s = 300 + SLOWEST * stop_ns // 10**9
            done = subprocess.run(command, capture_output=True, timeout=limit_s, check=False)
            lines = trace.read_text().splitlines() if trace.exists() else []
            said = heard.read_bytes().decode("latin-1") if heard.exists() else ""
        events = [(int(ns), source, rest)
                  for ns, source, rest in (line.split(" ", 2) for line in lines)]
        return Run(done.returncode, said, done.stderr.decode(), events)


def main(module, test: str):
    """PLUGIN IMAGE [TEST...]: runs a module's tests on Chip(PLUGIN, IMAGE), or skips them."""
    import sys
    import unittest
    plugin, image = sys.argv[1:3]
    missing = [path for path in (plugin, image) if not pathlib.Path(path).exists()]
    missing += [tool for tool in (EMULATOR, "arm-none-eabi-nm") if not shutil.which(tool)]
    if missing:
        print(f"skipped: {test} needs {' '.join(missing)} (presets release and cortex-m4f)")
        sys.exit(SKIPPED)
    module["CHIP"] = Chip(plugin, image)
    unittest.main(module="__main__", argv=[sys.argv[0], *sys.argv[3:]], verbosity=2)
