"""Tests that random tests in Python have the same seeds as in C++, and that seed files are read
completely."""
import os
import unittest
from unittest import mock

import seeds


class SeedsTest(unittest.TestCase):
    def test_a_first_seed_is_that_of_trials(self):
        self.assertEqual(seeds.first_seed_of("", "FirstSeed.IsAsInPython"), 1)
        self.assertEqual(seeds.first_seed_of("2789883", "FirstSeed.IsAsInPython"), 2_943_632_798)

    def test_seeds_that_once_failed_come_first(self):
        with mock.patch.dict(os.environ, {"KERFLINE_SEED_BASE": "a", "KERFLINE_TRIALS": "2"}):
            first = seeds.first_seed_of("a", seeds.name_of(self))
            self.assertEqual(seeds.seeds_of(self, 60), [4711, first, first + 1])
        with mock.patch.dict(os.environ, {"KERFLINE_SEED": "9"}):
            self.assertEqual(seeds.seeds_of(self, 60)[0], 9)

    def test_shares_of_all_bases_are_all_cases(self):
        cases, found = list(range(19)), set()
        for base in "abcdefghijkl":
            with mock.patch.dict(os.environ, {"KERFLINE_SEED_BASE": base, "KERFLINE_TIER": "test"}):
                share = seeds.share_of(cases, 6, "Some.test")
                self.assertIn(len(share), (6, 7))
                found.update(share)
                self.assertEqual(seeds.share_of(cases, 12, "Some.test"), cases)
        self.assertEqual(sorted(found), cases)
        with mock.patch.dict(os.environ, {"KERFLINE_TIER": "prove"}):
            self.assertEqual(seeds.share_of(cases, 6, "Some.test"), cases)

    def test_a_line_that_is_no_seed_is_refused(self):
        self.assertEqual(seeds.read_seeds("# x\n\n[A.b]\n3  # Late.\n"), {"A.b": [3]})
        for text in ("3 # Late.", "[A.b]\n3", "[A.b]\n3 #", "[A.b]\nthree # Late.", "[A.b\n3 # x"):
            with self.subTest(text=text), self.assertRaises(ValueError):
                seeds.read_seeds(text)


if __name__ == "__main__":
    unittest.main()
