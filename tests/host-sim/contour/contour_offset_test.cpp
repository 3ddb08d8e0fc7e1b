#include "host-sim/contour/contour_offset.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace sim {
namespace {

/// Teeth whose offsets cross each other: a crowd in one place, and some at another.
Contour teeth() {
  Contour contour;
  for (int i = 0; i < 10; ++i) contour.vertices.push_back({4.0 * i, 4.0 * (i % 2), 0.0});
  for (int i = 0; i < 40; ++i) {
    contour.vertices.push_back({50.0 + 0.1 * i, (i % 2) * (2.0 + 0.4 * (i * i % 7)), 0.0});
  }
  contour.vertices.push_back({60.0, -5.0, 0.0});
  contour.vertices.push_back({0.0, -5.0, 0.0});
  contour.end_loop();
  return contour;
}

TEST(ContourOffset, SaysWhereTooMuchOfItMeets) {
  const Contour contour = teeth();
  EXPECT_NO_THROW(ContourOffset{}.offset(contour.view(), 1.0));
  ContourOffset small{8};
  try {
    small.offset(contour.view(), 1.0);
    FAIL() << "more than 8 meetings are none";
  } catch (const NoOffset& failure) {
    EXPECT_THAT(failure.what(), testing::HasSubstr("cross each other more than 8 times"));
    EXPECT_THAT(failure.what(), testing::HasSubstr("in a square of 1 mm; simplify it there"));
    EXPECT_GE(failure.place().x(), 50.0);
    EXPECT_LE(failure.place().x(), 54.0);
  }
}

TEST(ContourOffset, OfNothingIsNothing) {
  ContourOffset offset;
  EXPECT_EQ(offset.offset(Contour{}.view(), 1.0).loop_ends.size(), 0U);
  EXPECT_GT(offset.offset(teeth().view(), 1.0).loop_ends.size(), 0U);
  EXPECT_EQ(offset.offset(Contour{}.view(), -1.0).loop_ends.size(), 0U);
}

TEST(ContourOffset, SaysWhatIsNoNumber) {
  Contour contour = teeth();
  contour.vertices[3].x = std::nan("");
  EXPECT_THROW(ContourOffset{}.offset(contour.view(), 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace sim
