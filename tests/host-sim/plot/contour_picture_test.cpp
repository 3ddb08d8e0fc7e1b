#include "host-sim/plot/contour_picture.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host-sim/contour/contour_text.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim {
namespace {

using cnc::pocket::Use;

constexpr const char* kRowPath = R"(<path fill="none")";

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(ToolPathPicture, HasAPathForEachStretchOfOneUseAndDepth) {
  pocket::PathRows rows;
  rows.points = {{.x = 1, .y = 1, .z = 0, .use = Use::kEntry},
                 {.x = 1, .y = 1, .z = -1},
                 {.x = 9, .y = 1, .z = -1, .bulge = 1.0, .use = Use::kLight},
                 {.x = 9, .y = 9, .z = -1, .use = Use::kLink},
                 {.x = 5, .y = 5, .z = -2},
                 {.x = 1, .y = 5, .z = -2}};
  rows.end_row();
  const Contour walls = contour_from_text("0 0\n10 0\n10 10\n0 10\nclosed\n", "test");
  const std::string picture = draw_tool_path(walls, rows.path(), "a < b");
  // Both passes at one depth, the link, and the pass below. The plunge is a point.
  EXPECT_EQ(count_of(picture, kRowPath), 3U) << picture;
  EXPECT_EQ(count_of(picture, "stroke-dasharray"), 1U);
  EXPECT_NE(picture.find("a &lt; b"), std::string::npos);
  EXPECT_EQ(picture.find("nan"), std::string::npos);
  EXPECT_EQ(picture.substr(picture.size() - 7), "</svg>\n");
}

TEST(ToolPathPicture, OfNoRowIsTheWalls) {
  const Contour walls = contour_from_text("0 0\n10 0\n10 10\nclosed\n", "test");
  const std::string picture = draw_tool_path(walls, {}, "empty");
  EXPECT_EQ(count_of(picture, kRowPath), 0U);
  EXPECT_EQ(count_of(picture, "evenodd"), 1U);
}

}  // namespace
}  // namespace sim
