#include "host-sim/pocket/mill_tool.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace sim::pocket {
namespace {

constexpr const char* kTools =
    "# Tools of the small router.\n"
    "\n"
    "6mm: diameter=6, flutes=2, feed-per-tooth=0.05, spindle=18000, plunge-feed=400\n"
    "v60: diameter=12.7, angle=60, feed=900, plunge-feed=200\n";

TEST(MillTools, HaveAFeedByTheirTeeth) {
  const auto tools = read_mill_tools(kTools, "tools.txt");
  ASSERT_EQ(tools.size(), 2U);
  const MillTool& flat = tool_named(tools, "6mm", "tools.txt");
  EXPECT_EQ(flat.diameter_mm, 6.0);
  EXPECT_EQ(flat.place, "tools.txt:3");
  EXPECT_DOUBLE_EQ(flat.feed_at(18000.0).value(), 1800.0);
  EXPECT_DOUBLE_EQ(flat.feed_at(9000.0).value(), 900.0);
  EXPECT_FALSE(flat.v_angle_deg.has_value());
  EXPECT_FALSE(flat.stepover_mm.has_value());
  const MillTool& v = tool_named(tools, "v60", "tools.txt");
  EXPECT_EQ(v.v_angle_deg, 60.0);
  EXPECT_EQ(v.feed_at(0.0), 900.0);
}

std::string refusal_of(const char* text) {
  try {
    static_cast<void>(read_mill_tools(text, "t"));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(MillTools, RefuseWhatIsNoTool) {
  for (const auto& [text, words] : {
           std::pair{"", "t: has no tool `NAME: diameter=MM, key=value`"},
           std::pair{"6mm", "t:1: 6mm: must be a tool"},
           std::pair{"a: flutes=2", "t:1: a tool without diameter=MM"},
           std::pair{": diameter=2", "t:1: a tool without a name"},
           std::pair{"a: diameter=0", "t:1: diameter=0: out of range, 0.01 to 500 mm"},
           std::pair{"\na: diameter=6, flute=2", "t:2: flute: tools have no such value"},
           std::pair{"a: diameter=6, flute=2", "did you mean flutes?"},
           std::pair{"a: diameter=6, flutes=1.5", "flutes=1.5: requires an integer"},
           std::pair{"a: diameter=6, feed-per-tooth=0.1", "feed-per-tooth: requires flutes"},
           std::pair{"a: diameter=6, flutes=2, feed-per-tooth=0.1, feed=9", "give one of them"},
           std::pair{"a: diameter=six", "diameter=six: not a number"},
           std::pair{"a: diameter=6\na: diameter=7", "t:2: there is a tool a in t:1 already"},
       }) {
    EXPECT_NE(refusal_of(text).find(words), std::string::npos) << refusal_of(text);
  }
  const auto tools = read_mill_tools(kTools, "t");
  EXPECT_THROW(static_cast<void>(tool_named(tools, "6m", "t")), std::invalid_argument);
}

}  // namespace
}  // namespace sim::pocket
