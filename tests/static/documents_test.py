"""Plants faults in a copy of a small set of documents and checks that documents.py finds them."""
import pathlib
import tempfile
import unittest

import documents

PAGES = {
    "README.md": "# A\n\nSee [the docs](docs/README.md#what-it-is) and [code](planner/a.cpp).\n",
    "docs/README.md": "# Docs\n\n## What it is\n\n[one](one.md), [decisions](decisions/README.md)\n",
    "docs/one.md": "# One\n\n```sh\nkerfline --a [b](no.md) " + "x" * 100 +
                   "\n```\n\n[up](../README.md), `[c](no.md)`\n",
    "docs/decisions/README.md": "# Decisions\n\n[1](0001-floats.md)\n",
    "docs/decisions/0001-floats.md": "# 1. Floats\n\nWhy.\n",
    "planner/a.cpp": "",
}


class PlantedFaults(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name, text in PAGES.items():
            self.plant(name, text)

    def plant(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def add(self, name, text):
        self.plant(name, PAGES[name] + text)

    def expect(self, *complaints):
        found = list(documents.complaints(self.root))
        self.assertEqual(len(found), len(complaints), found)
        for complaint in complaints:
            self.assertTrue(any(complaint in each for each in found), (complaint, found))

    def test_sound_documents_are_clean(self):
        self.expect()

    def test_a_link_to_no_file(self):
        self.add("docs/one.md", "\nA\n[b](two.md)\n")
        self.expect("docs/one.md:10: two.md leads to no file")

    def test_a_link_to_no_heading(self):
        self.add("docs/one.md", "\n[b](README.md#what-was)\n[c](#two)\n")
        self.expect("README.md#what-was has no such heading", "#two has no such heading")

    def test_a_page_without_a_link_to_it(self):
        self.plant("docs/two.md", "# Two\n\n[itself](two.md)\n")
        self.expect("docs/two.md: no page has a link to it")

    def test_long_lines_but_of_tables_links_and_code(self):
        self.add("docs/one.md", "\n" + "word " * 21 + "\n\n| " + "x" * 100 + " |\n\n[b](one.md) " + "x" * 100 + "\n")
        self.expect("docs/one.md:9: 105 columns")

    def test_pages_that_are_too_long(self):
        self.add("README.md", "\n" * 118)
        self.add("docs/decisions/0001-floats.md", "\nwhy\n" * 14)
        self.expect("README.md: 121 lines, 120 at most", "0001-floats.md: 31 lines, 30 at most")

    def test_two_decisions_of_one_number(self):
        self.add("docs/decisions/README.md", "[2](0001-doubles.md), [3](0003-halves.md)\n")
        self.plant("docs/decisions/0001-doubles.md", "# 1. Doubles\n")
        self.plant("docs/decisions/0003-halves.md", "# 4. Halves\n")
        self.expect("has the number of docs/decisions/0001-doubles.md", "does not begin with `# 3. `")


if __name__ == "__main__":
    unittest.main()
