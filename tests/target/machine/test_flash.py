"""Tests the flash: locks, sizes, programming, erasing, and power cuts."""

import struct
import unittest

from emulator import POWER_CUT, Emulator, Files

ERASED, PATTERN = 0xFFFF_FFFF, 0x0F0F_0F0F
SEQUENCE_ERROR, SIZE_ERROR = 1 << 7, 1 << 6
FIRST, SIZE = 0x8000, 0x4000  # Sector 2.
WORDS = [0x1234_5678 + i for i in range(8)]


class FlashTest(unittest.TestCase):
    def test_what_a_driver_may_do_and_what_not(self):
        said = Emulator.run("flash").said
        self.assertEqual([[SEQUENCE_ERROR, ERASED], [SEQUENCE_ERROR, ERASED]], said["locked"])
        self.assertEqual([[0]], said["unlocked"])
        self.assertEqual([[SEQUENCE_ERROR, ERASED]], said["no_program"])
        self.assertEqual([[SIZE_ERROR, ERASED]], said["wrong_size"])
        self.assertEqual([[0, PATTERN]] * 4, said["programmed"])
        self.assertEqual([[PATTERN & 0xFFFF_0000]], said["again"])
        self.assertEqual([[SEQUENCE_ERROR, ERASED]], said["while_busy"])
        self.assertEqual([[PATTERN], [ERASED], [ERASED], [PATTERN]], said["erased"])

    def test_times_of_the_data_sheet(self):
        said = Emulator.run("flash").said
        self.assertAlmostEqual(16, said["program_us"][0][0], delta=1)
        self.assertEqual([[1]], said["erasing"])
        self.assertAlmostEqual(250_000, said["erase_us"][0][0], delta=1)
        self.assertAlmostEqual(700, Emulator.run("flash", "erase_us=700").said["erase_us"][0][0],
                               delta=1)

    def test_a_small_chip_saves_as_much_as_it_has(self):
        flash = Files(self)("flash")
        Emulator.run("flash_cut", f"flash={flash}", "erase_us=100", "flash_kib=256")
        self.assertEqual(256 << 10, len(flash.read_bytes()))

    def test_a_wrong_key_locks_until_reset(self):
        self.assertEqual([[1]], Emulator.run("flash_keys").said["locked"])

    def cut(self, flash, operation: int, kind: str, seed: int = 1) -> tuple:
        """Returns the words of the sector after a cut during the n-th operation, and the completed
        operations."""
        flash.unlink(missing_ok=True)
        outcome = Emulator.run("flash_cut", f"flash={flash}", "erase_us=100", f"cut={operation}",
                               f"cut_kind={kind}", f"seed={seed}")
        self.assertEqual(POWER_CUT, outcome.status)
        self.assertEqual([[i + 1] for i in range(operation - 1)], outcome.said["done"])
        content = flash.read_bytes()
        self.assertEqual(1 << 20, len(content))
        words = struct.unpack(f"<{SIZE // 4}I", content[FIRST:FIRST + SIZE])
        self.assertEqual({ERASED}, set(words[8:]))
        return list(words[:8])

    def test_power_cut_before_and_after_each_operation(self):
        flash = Files(self)("flash")
        for operation in range(1, 9):
            for kind, done in (("none", operation - 1), ("whole", operation)):
                self.assertEqual(WORDS[:done] + [ERASED] * (8 - done),
                                 self.cut(flash, operation, kind))
        self.assertEqual(WORDS, self.cut(flash, 9, "none"))
        self.assertEqual([ERASED] * 8, self.cut(flash, 9, "whole"))

    def test_power_cut_tears_a_word(self):
        flash, torn = Files(self)("flash"), set()
        for seed in range(4):
            words = self.cut(flash, 3, "torn", seed)
            self.assertEqual(WORDS[:2], words[:2])
            self.assertEqual([ERASED] * 5, words[3:])
            self.assertEqual(WORDS[2], words[2] & WORDS[2])  # Only zeros are missing.
            torn.add(words[2])
        self.assertGreater(len(torn), 1)
        again = Emulator.run("flash_cut", f"flash={flash}").said["word"]
        self.assertEqual(words, [word for _, word in again])

    def test_power_cut_half_erases_a_sector(self):
        flash, kinds = Files(self)("flash"), set()
        for seed in range(4):
            for before, after in zip(WORDS, self.cut(flash, 9, "torn", seed)):
                self.assertEqual(before, after & before)
                kinds.add("erased" if after == ERASED else "kept" if after == before else "torn")
        self.assertEqual({"erased", "kept", "torn"}, kinds)

    def test_a_full_run_ends_and_leaves_the_sector_erased(self):
        flash = Files(self)("flash")
        outcome = Emulator.run("flash_cut", f"flash={flash}", "erase_us=100", "cut=10")
        self.assertEqual((0, 9), (outcome.status, len(outcome.said["done"])))
        self.assertEqual({0xFF}, set(flash.read_bytes()[FIRST:FIRST + SIZE]))
