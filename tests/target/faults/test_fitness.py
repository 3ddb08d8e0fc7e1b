#!/usr/bin/env python3
"""Runs the generic image for 512 KiB on chips with 1 MiB, 512 KiB and 256 KiB of flash, and
incomplete images. Each image must run and store, or report why it does not, with beam and motors
off.

    test_fitness.py PLUGIN kerfline_generic_512.elf [TEST...]

Also tries the images for 1 MiB in the same folder. Ends with 77 (skipped) if the emulator, the
plug-in or the image is missing.
"""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from chip import BEAM_PIN, BOOT_NS, CHIP_OPTIONS, FLASH, MS, STOPPED, Chip, main  # noqa: E402

CHIP = None
ENABLE_PIN = "PA15"  # Of all motors of the generic board, low where they have current.
STORE = {1024: 0x080C0000, 512: 0x08040000}  # Where the store's sectors begin.
JOB = "$32=1\nM3S600\nG1X5F1500\n"


class FitnessTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.binary = CHIP.image.with_suffix(".bin").read_bytes()

    def test_it_stores_in_the_last_sectors_of_each_chip(self):
        for kib, begin in STORE.items():
            with self.subTest(kib=kib):
                flash = self.folder / f"flash{kib}"
                options = (f"flash_kib={kib}", f"flash={flash}", *CHIP_OPTIONS)
                run = CHIP.run("$110=5432\n", BOOT_NS + 100 * MS, *options)
                self.assertEqual((STOPPED, 1), (run.status, run.said.count("ok\r\n")), run.said)
                places = {int(rest.split()[1], 16) for _, source, rest in run.trace
                          if source == "flash" and rest.startswith("program")}
                self.assertTrue(places)
                self.assertTrue(all(begin <= place < begin + 0x40000 for place in places), places)
                again = CHIP.run("$110\n", BOOT_NS + 60 * MS, *options)
                self.assertIn("$110=5432.000\r\n", again.said)
                self.assertEqual([], run.times("misuse") + again.times("misuse"), run.told + again.told)

    def assert_refused(self, run, reason: str, lines: int):
        """Asserts that the image reports the reason at the start and for every line, and that
        nothing moves or is lit."""
        self.assertEqual(STOPPED, run.status, run.told)
        self.assertTrue(run.said.startswith("\r\nGrbl 1.1h ['$' for help]\r\n[MSG:Nothing runs: "), run.said)
        self.assertIn(reason, run.said)
        self.assertEqual((lines, 0), (run.said.count("error:9\r\n"), run.said.count("ok\r\n")), run.said)
        self.assertEqual([], run.resets())
        self.assert_off(run)

    def assert_off(self, run):
        """Asserts that the beam's pin is driven low, the motors have no current, and no step was
        made."""
        self.assertEqual([], run.lit())
        self.assertEqual([], run.steps())
        beam = [rest for _, source, rest in run.trace if source == "pin" and rest.startswith(BEAM_PIN)]
        self.assertEqual(f"{BEAM_PIN} 0", beam[-1])

    def test_a_chip_that_is_too_small_is_told(self):
        run = CHIP.run(JOB + "?", BOOT_NS + 100 * MS, "flash_kib=256")
        self.assert_refused(run, "the chip has 256 KiB of flash, and the image with its store takes "
                                 "512 KiB. Use a board with a larger chip]\r\n", 3)
        self.assertIn("<Alarm|MPos:0.000,0.000,0.000|FS:0,0>\r\n", run.said)
        enables = [rest for _, source, rest in run.trace
                   if source == "pin" and rest.startswith(ENABLE_PIN + " ")]
        self.assertEqual([f"{ENABLE_PIN} 1"], enables[-1:])

    def test_images_for_1_mib_run_on_512_kib_only_where_they_fit(self):
        refused = 0
        for name in ("kerfline_generic", "kerfline_generic_can"):
            with self.subTest(name):
                chip = Chip(CHIP.plugin, CHIP.image.with_name(f"{name}.elf"))
                size = chip.image.with_suffix(".bin").stat().st_size
                run = chip.run("$110=5432\n", BOOT_NS + 100 * MS, "flash_kib=512", *CHIP_OPTIONS)
                if FLASH + size <= STORE[512]:
                    self.assertEqual(1, run.said.count("ok\r\n"), run.said)
                    continue
                refused += 1
                self.assert_refused(run, "the chip has 512 KiB of flash, and the image with its store "
                                         "takes 1024 KiB. Use an image for 512 KiB, or a board with a "
                                         "larger chip]\r\n", 1)
        self.assertGreater(refused, 0, "no image is large enough for this test")

    def test_the_way_into_the_boot_loader_stays_open(self):
        """The emulated chip has no boot loader: the jump to it is a fault, and the image reports
        again why it does not run."""
        run = CHIP.run("$DFU\n", BOOT_NS + 100 * MS, "flash_kib=256")
        self.assertIn("ok\r\n", run.said)
        self.assertEqual(2, len(run.resets()))
        self.assertEqual(2, run.said.count("Grbl 1.1h"), run.said)
        self.assertEqual([], run.lit())

    def run_binary(self, content: bytes, text: str = JOB):
        kernel = self.folder / "image.bin"
        kernel.write_bytes(content)
        return CHIP.run(text, BOOT_NS + 100 * MS, kernel=kernel)

    def test_the_binary_file_runs_as_the_image_does(self):
        run = self.run_binary(self.binary, "$I+\n")
        self.assertIn("[BOARD:Generic F405/F407]", run.said)

    def test_an_image_that_was_not_written_to_its_end_is_told(self):
        for size in (len(self.binary) // 8, len(self.binary) - 4):
            with self.subTest(size=size):
                self.assert_refused(self.run_binary(self.binary[:size]), "damaged or incomplete", 3)

    def test_one_wrong_bit_is_told(self):
        changed = bytearray(self.binary)
        changed[-len(changed) // 3] ^= 0x10
        self.assert_refused(self.run_binary(bytes(changed)), "damaged or incomplete", 3)

    def test_a_fragment_of_an_image_is_dark_and_does_not_run(self):
        """The fragment ends before the code that would detect this."""
        end = next(place for name, place in CHIP.symbols.items() if "Crc323addESt4span" in name)
        run = self.run_binary(self.binary[:end - FLASH])
        self.assertEqual(1, len(run.resets()), "it stands still after its first fault")
        self.assert_off(run)
        self.assertEqual("", run.said)


if __name__ == "__main__":
    main(globals(), "test_fitness")
