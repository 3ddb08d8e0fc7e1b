"""Checks packages.txt: no package twice, no cross compiler or browser among the packages for
running, plain names."""
import re
import unittest

from source_files import ROOT

NOT_FOR_RUNNING = re.compile("arm-none-eabi|qemu|chromium|firefox|nodejs|clang|python")


def parts() -> dict:
    found, section = {}, None
    for line in (ROOT / "toolchain/packages.txt").read_text(encoding="utf-8").splitlines():
        line = line.split("#")[0].strip()
        if line.startswith("["):
            section = found.setdefault(line.strip("[]"), [])
        elif line:
            section.append(line)
    return found


class Packages(unittest.TestCase):
    def test_three_parts(self):
        self.assertEqual(["run", "test", "prove"], list(parts()))

    def test_names_are_plain_and_given_once(self):
        names = [name for part in parts().values() for name in part]
        self.assertEqual(sorted(set(names)), sorted(names))
        for name in names:
            self.assertRegex(name, r"^[a-z0-9][a-z0-9.+-]+( +unless [a-z]+)?$")

    def test_running_needs_no_cross_compiler_and_no_browser(self):
        self.assertEqual([], [name for name in parts()["run"] if NOT_FOR_RUNNING.search(name)])


if __name__ == "__main__":
    unittest.main()
