#include "host-sim/import/wider_gap.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

/// Returns a square of four lines, each `gap` away from the next.
std::string loose_square(double x, double side, double gap) {
  const auto line = [](double x1, double y1, double x2, double y2) {
    return fmt::format("0\nLINE\n8\nA\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", x1, y1, x2, y2);
  };
  return line(x + gap, 0, x + side, 0) + line(x + side, gap, x + side, side) +
         line(x + side - gap, side, x, side) + line(x, side - gap, x, 0);
}

Drawing by_auto(const std::string& entities) {
  return read_drawing("f", dxf_of(entities), {.finds_gap = true});
}

TEST(WiderGap, IsNamedWhereItClosesMostEnds) {
  const std::string squares = loose_square(0, 9, 0.07) + loose_square(20, 9, 0.03);
  const Drawing drawn = read(dxf_of(squares));
  ASSERT_THAT(kinds_of(drawn), Contains(FaultKind::kOpen));
  EXPECT_THAT(drawn.faults[0].remedy,
              AllOf(HasSubstr("--gap 0.1 closes 16 of 16 open ends"), HasSubstr("--gap auto")));
  const Drawing closed = by_auto(squares);
  EXPECT_THAT(closed.contours, SizeIs(2));
  ASSERT_THAT(kinds_of(closed), ElementsAre(FaultKind::kNote));
  EXPECT_THAT(closed.faults[0].reason, HasSubstr("gaps up to 0.1 mm are joined"));
  EXPECT_FALSE(closed.has_errors());
}

TEST(WiderGap, IsNoneWhereMostEndsAreFartherApart) {
  const std::string squares = loose_square(0, 9, 0.6) + loose_square(20, 9, 0.03);
  const Drawing one_of_two = by_auto(squares);
  EXPECT_THAT(kinds_of(one_of_two), Not(Contains(FaultKind::kNote)));
  EXPECT_THAT(one_of_two.faults.at(0).remedy, HasSubstr("join gaps wider than 0.01 mm"));
  EXPECT_THAT(by_auto(loose_square(0, 9, 0.0)).faults, IsEmpty());
}

TEST(WiderGap, LosesNoShortLine) {
  const std::string squares = loose_square(0, 9, 0.08) + loose_square(20, 0.1, 0.0);
  const Drawing drawn = by_auto(squares);
  EXPECT_THAT(drawn.contours, SizeIs(5));
  EXPECT_THAT(kinds_of(drawn), Not(Contains(FaultKind::kTooSmall)));
}

TEST(WiderGap, JoinsNoLayers) {
  std::string one = loose_square(0, 9, 0.05);
  one.replace(one.find("8\nA"), 3, "8\nB");
  EXPECT_FALSE(by_auto(one).contours.at(0).closed);
}

}  // namespace
}  // namespace sim::drawing
