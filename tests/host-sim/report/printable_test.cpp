#include "host-sim/report/printable.hpp"

#include <gtest/gtest.h>

namespace sim {
namespace {

TEST(Printable, LeavesLettersAndLineEnds) {
  for (const char* text : {"part.nc: line 3\n", "Größe 5 µm → \xF0\x9F\x94\xA5", "a\tb"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(printable("\x1B[31mred\x1B]0;title\x07"), R"(\x1B[31mred\x1B]0;title\x07)");
  EXPECT_EQ(printable("a\rb\x08\x7F"), R"(a\x0Db\x08\x7F)");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            R"(\xC2\x9B31m)")
      << "CSI in UTF-8";
  EXPECT_EQ(printable("\x9B"
                      "31m\xE2\x82"),
            R"(\x9B31m\xE2\x82)")
      << "CSI alone, and half a sign";
}

TEST(Printable, KeepsALineInOneLine) {
  EXPECT_EQ(printable_line("part\nkerfline: fine\t"), R"(part\x0Akerfline: fine\x09)");
  EXPECT_EQ(printable_line("größe → 5"), "größe → 5");
}

TEST(Printable, ShowsMarksOfDirection) {
  EXPECT_EQ(printable("part\u202Ecn.nc"), R"(part\xE2\x80\xAEcn.nc)") << "reads as part.nc.nc";
}

}  // namespace
}  // namespace sim
