#include "host-sim/import/drawing_unit.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string dxf_circle(double radius) {
  return dxf_of(fmt::format("0\nCIRCLE\n8\n0\n40\n{}\n", radius));
}

TEST(DrawingUnit, NamesAreLengths) {
  EXPECT_EQ(drawing_unit_mm("inch"), 25.4);
  EXPECT_EQ(drawing_unit_mm("72dpi"), 25.4 / 72.0);
  EXPECT_EQ(drawing_unit_mm("ell"), std::nullopt);
  EXPECT_THAT(drawing_unit_names(), HasSubstr("mm, inch, cm"));
}

TEST(DrawingUnit, AnUnusualSizeIsQuestionedWithTheLikelyUnit) {
  EXPECT_THAT(read(dxf_circle(1.6)).faults, IsEmpty());
  EXPECT_THAT(read(dxf_circle(1499.0)).faults, IsEmpty());
  const Drawing small = read(dxf_circle(1.25));
  ASSERT_THAT(kinds_of(small), ElementsAre(FaultKind::kNote));
  EXPECT_FALSE(small.has_errors());
  EXPECT_THAT(to_string(small.faults[0], "f"),
              AllOf(HasSubstr("2.5 by 2.5 mm, which is unusually small"),
                    HasSubstr("if its unit is inch, its size is 63.5 by 63.5 mm"),
                    HasSubstr("--drawing-unit inch")));
  EXPECT_THAT(read(dxf_circle(2.0e4)).faults.at(0).remedy, HasSubstr("--drawing-unit mil"));
  EXPECT_THAT(read(dxf_circle(1.0e-9)).faults, testing::Not(IsEmpty()));
}

TEST(DrawingUnit, SvgAndJsonAreScaledWithTheirFaults) {
  const auto scaled = [](const std::string& text, double unit_mm) {
    return read_drawing("f", text, {.unit_mm = unit_mm});
  };
  const std::string svg = "<svg width='100' height='100'><path d='M0 0H72V72'/></svg>";
  const Drawing points = scaled(svg, 25.4 / 72.0);
  EXPECT_NEAR(points.contours.at(0).length_mm, 50.8, 1e-9);
  EXPECT_NEAR(points.faults.at(0).place_mm->y(), 100.0 * 25.4 / 72.0, 1e-9);
  const std::string json = R"([{"partid": "A", "paths": [[[0,0,1],[1,0,1],[0,0,1]]]}])";
  EXPECT_NEAR(scaled(json, 25.4).contours.at(0).length_mm, 25.4 * 3.14159265358979, 1e-9);
}

}  // namespace
}  // namespace sim::drawing
