"""Plants comments without subjects in a small source and checks that language.py finds them."""
import pathlib
import tempfile
import unittest

import language

SOUND = """#pragma once

/// Returns the length of the path, mm. Of course the caller knows `somebody`.
/// The operator, who holds it, may go on.
[[nodiscard]] double length();  ///< Whose unit is mm.
int count = 0;                  ///< Number of steps; "who" is text.
const char* text = "// Who is there?";
"""


class PlantedComments(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        (self.root / "planner").mkdir()

    def expect(self, text, *complaints):
        (self.root / "planner/a.hpp").write_text(SOUND + text, encoding="utf-8")
        found = list(language.complaints(self.root))
        self.assertEqual(len(found), len(complaints), found)
        for complaint in complaints:
            self.assertTrue(any(complaint in each for each in found), (complaint, found))

    def test_sound_comments_are_clean(self):
        self.expect("")

    def test_comments_without_a_subject(self):
        self.expect("int a = 0;  ///< Of the newest.\n/// What is left of it.\nint b = 0;\n",
                    "planner/a.hpp:8: begins with `Of`", "planner/a.hpp:9: begins with `What is`")

    def test_a_paragraph_begins_anew(self):
        self.expect("/// Returns it.\n///\n/// Whoever is late.\nint c();\n", "planner/a.hpp:10: begins", "`Whoever`")

    def test_words_that_name_nothing(self):
        self.expect("// The block who is late, and somebody waits.\n// It is made anew.\nint d();\n",
                    "`who` is for persons", "`somebody` names nothing", "`anew`")

    def test_names_of_bounds(self):
        self.expect("constexpr int kMostSteps = 3;\nconstexpr int kLeast = 1;\n",
                    "`kMost` is named `kMax", "`kLeast` is named `kMin")

    def test_printed_texts_without_a_subject(self):
        self.expect('const char* help = "Of the lightest grey; 0";\nconst char* other = "Power of grey";\n',
                    "a text begins with `Of the lightest grey`")


if __name__ == "__main__":
    unittest.main()
