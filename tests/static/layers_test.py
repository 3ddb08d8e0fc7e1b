"""Plants violations in a copy of a small source tree and checks that layers.py, hygiene.py and
private_names.py find them."""
import contextlib
import io
import pathlib
import tempfile
import unittest

import hygiene
import layers
import private_names

HOUSE = {
    "planner/base/axes.hpp": "#pragma once\n#include <array>\n#include <Eigen/Core>\n",
    "planner/CMakeLists.txt": "kerfline_layer(kerfline_planner kerfline_controller_flags\n"
                              "  Eigen3::Eigen)\n",
    "hal/interface/pin.hpp": "#pragma once\n#include <cstdint>\n",
    "hal/host/pin.hpp": '#pragma once\n#include <vector>\n#include "hal/interface/pin.hpp"\n',
    "hal/host/CMakeLists.txt": "kerfline_layer(kerfline_hal_host kerfline_flags "
                               "kerfline_hal_interface)\n",
    "firmware/steps.hpp": '#pragma once\n#include "hal/interface/pin.hpp"\n#include "planner/base/axes.hpp"\n',
    "firmware/CMakeLists.txt": "kerfline_layer(kerfline_firmware kerfline_controller_flags\n"
                               "  kerfline_planner kerfline_hal_interface)  # down only\n",
    "firmware/target/stm32f405_main.cpp": '#include "hal/stm32f405/pin.hpp"\n',
    "host-sim/cli.hpp": '#pragma once\n#include <fmt/core.h>\n#include "planner/base/axes.hpp"\n',
    "host-sim/CMakeLists.txt": "kerfline_layer(kerfline_sim kerfline_flags kerfline_firmware "
                               "fmt::fmt)\n",
}


class PlantedViolations(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name, text in HOUSE.items():
            self.plant(name, text)

    def plant(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def layer_complaints(self):
        with contextlib.redirect_stdout(io.StringIO()):
            return layers.complaints(self.root)

    def assert_found(self, name, text, expected):
        self.plant(name, text)
        found = "\n".join(self.layer_complaints())
        self.assertIn(expected, found)
        self.assertIn(name, found)

    def assert_hygiene_finds(self, name, text, expected):
        self.plant(name, text)
        self.assertIn(expected, "\n".join(hygiene.complaints(self.root)))

    def test_the_house_itself_is_clean(self):
        self.assertEqual([], self.layer_complaints())
        self.assertEqual([], list(hygiene.complaints(self.root)))

    def test_includes_that_point_up(self):
        for name, target in [("planner/base/a.cpp", "hal/interface/pin.hpp"),
                             ("planner/base/b.cpp", "firmware/steps.hpp"),
                             ("hal/host/a.cpp", "planner/base/axes.hpp"),
                             ("hal/interface/a.cpp", "hal/host/pin.hpp"),
                             ("firmware/a.cpp", "hal/host/pin.hpp"),
                             ("firmware/b.cpp", "host-sim/cli.hpp")]:
            with self.subTest(name):
                self.assert_found(name, f'#include "{target}"\n', f"must not include {target}")

    def test_rooms_of_a_pipeline(self):
        self.plant("planner/motion/segment/ticks.hpp", "#pragma once\n")
        self.plant("planner/motion/motors/a.cpp", '#include "planner/motion/segment/ticks.hpp"\n')
        self.assertEqual([], self.layer_complaints())
        self.assert_found("planner/motion/block/a.cpp", '#include "planner/motion/segment/ticks.hpp"\n', "a later room")
        self.assert_found("planner/motion/a.cpp", "int f();\n", "lies in none of block, lookahead")

    def test_include_that_is_no_path_from_the_root(self):
        self.assert_found("planner/base/a.cpp", '#include "axes.hpp"\n', "not a path from the root")

    def test_include_of_a_source(self):
        self.plant("hal/host/pin.cpp", "")
        self.assert_found("hal/host/a.cpp", '#include "hal/host/pin.cpp"\n', "is a source")

    def test_banned_standard_headers(self):
        for name, header in [("planner/base/a.cpp", "vector"), ("planner/base/b.cpp", "atomic"),
                             ("firmware/a.cpp", "chrono"), ("firmware/b.cpp", "iostream"),
                             ("hal/interface/a.cpp", "algorithm")]:
            with self.subTest(name):
                self.assert_found(name, f"#include <{header}>\n", f"<{header}> is not for")

    def test_foreign_library_below_host_sim(self):
        self.assert_found("firmware/a.cpp", "#include <fmt/core.h>\n", "does not use the library")

    def test_c_header_below_host_sim(self):
        self.assert_found("planner/base/a.cpp", "#include <math.h>\n", "use its C++ form")

    def test_library_sine_in_code_that_decides_motion(self):
        self.assert_found("planner/base/a.cpp", "float f = std::sin(1.0F);\n", "scalar_math")

    def test_conditional_compilation(self):
        self.assert_found("firmware/a.cpp", "#ifdef LASER\n#endif\n", "conditional compilation")

    def test_header_without_guard(self):
        self.assert_found("planner/base/a.hpp", "int f();\n", "no #pragma once")

    def test_long_file_and_long_line(self):
        self.assert_found("planner/base/a.cpp", "int f();\n" * 501, "501 lines")
        self.assert_found("planner/base/b.cpp", "// " + "é" * 98 + "\n", "101 columns")

    def test_link_that_points_up(self):
        self.assert_found("planner/CMakeLists.txt",
                          "kerfline_layer(kerfline_planner flags kerfline_hal_interface)\n",
                          "planner must not link kerfline_hal_interface")

    def test_link_of_a_foreign_library(self):
        self.assert_found("firmware/CMakeLists.txt",
                          HOUSE["firmware/CMakeLists.txt"]
                          + "target_link_libraries(kerfline_firmware PRIVATE fmt::fmt)\n",
                          "does not use the library fmt::fmt")

    def test_target_of_no_layer(self):
        self.assert_found("firmware/CMakeLists.txt",
                          HOUSE["firmware/CMakeLists.txt"]
                          + "target_link_libraries(kerfline_extra PRIVATE kerfline_sim)\n",
                          "kerfline_extra belongs to no layer")

    def test_include_that_is_not_linked(self):
        self.plant("host-sim/a.cpp", '#include "hal/host/pin.hpp"\n')
        self.assertIn("host-sim does not link hal/host", "\n".join(self.layer_complaints()))

    def test_path_of_a_build_machine(self):
        for path in ["/wor" + "k/main", "/hom" + "e/me/x", "/tmp/bash_job" + "s/1"]:
            with self.subTest(path):
                self.assert_hygiene_finds("tests/a.txt", f"see {path}\n", "path of a build machine")

    def test_unowned_mark(self):
        self.assert_hygiene_finds("tests/a.txt", "// TO" + "DO later\n", "open an issue")

    def test_stray_file_at_the_top(self):
        self.assert_hygiene_finds("notes.txt", "", "not one of the top level's")

    def test_private_names_of_two_sources(self):
        text = "namespace cnc {\nnamespace {\n%s\n}  // namespace\n}  // namespace cnc\n"
        for definition in ["constexpr float kSlack = 1.0F;", "struct Arm {\n  int x;\n};",
                           "double area_of(const base::Box& box,\n               double scale) {\n  return 1;\n}"]:
            with self.subTest(definition):
                self.plant("planner/a.cpp", text % definition)
                self.plant("planner/b/b.cpp", text % definition)
                self.plant("firmware/c.cpp", text % definition)  # Another program.
                found = list(private_names.complaints(self.root))
                self.assertEqual(len(found), 1)
                self.assertIn("is in planner/a.cpp, too", found[0])

    def test_private_functions_of_other_parameters(self):
        text = "namespace cnc {\nnamespace {\ndouble area_of(%s) {\n  return 1;\n}\n}  // namespace\n}\n"
        self.plant("planner/a.cpp", text % "const Box& box")
        self.plant("planner/b.cpp", text % "const Ring& ring")
        self.assertEqual(list(private_names.complaints(self.root)), [])
        self.plant("planner/c.cpp", text % "const base::Ring& other")
        self.assertEqual(len(list(private_names.complaints(self.root))), 1)


if __name__ == "__main__":
    unittest.main()
