#include "host-sim/pocket/loop_contact.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "host-sim/contour/contour_text.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::pocket {
namespace {

constexpr const char* kTouchedRoom = "0 0\n60 0\n60 40\n0 40\nclosed\n";

std::optional<cnc::WideVec2> contact(const std::string& text) {
  return contact_between_loops(contour_from_text(text, "test").view());
}

TEST(LoopContact, IsAlongAStretchAtACornerOrWhereAnArcTouches) {
  const std::string room = kTouchedRoom;
  EXPECT_FALSE(contact(room));
  EXPECT_FALSE(contact(room + "20 10\n20 30\n40 30\n40 10\nclosed\n"));
  // The loops share part of a wall, but no vertex.
  EXPECT_TRUE(contact(room + "0 10\n0 20\n5 20\n5 10\nclosed\n"));
  // The loops share a complete wall; then both loops are equal.
  EXPECT_TRUE(contact(room + "0 0\n60 0\n60 10\n0 10\nclosed\n"));
  EXPECT_TRUE(contact(room + room));
  // A corner touches a wall, and a corner of a wall touches an edge of the island.
  EXPECT_TRUE(contact(room + "0 10\n5 15\n5 5\nclosed\n"));
  EXPECT_TRUE(contact(room + "30 20\n50 35\n60 40\n40 30\nclosed\n"));
  // A circle of two halves touches the lower wall, and another one crosses it.
  EXPECT_TRUE(contact(room + "25 5 1\n35 5 1\nclosed\n"));
  EXPECT_TRUE(contact(room + "25 4 1\n35 4 1\nclosed\n"));
  EXPECT_FALSE(contact(room + "25 5.001 1\n35 5.001 1\nclosed\n"));
  // The loops are an arc of more than half a turn, and circles that touch from outside.
  EXPECT_TRUE(contact(room + "29 0.1 4\n31 0.1\nclosed\n"));
  EXPECT_TRUE(contact(room + "20 10 1\n30 10 1\nclosed\n30 10 1\n40 10 1\nclosed\n"));
}

TEST(LoopContact, OfCirclesIsWhereTheirDistanceSaysSo) {
  constexpr std::array kGaps{0.0, 0.4e-4, -0.4e-4, 3.0e-4, 0.1, -0.01};
  for (const std::uint64_t seed : proof::Trials{2'000}) {
    proof::Random random{seed};
    const double large = random.between(1.0, 50.0);
    const double small = random.between(0.05, 0.8) * large;
    const double gap = kGaps[random.below(kGaps.size())];
    const bool is_within = random.chance(0.5);
    const double away = is_within ? large - small - gap : large + small + gap;
    const double angle = random.between(0.0, 2.0 * std::numbers::pi);
    const double x = away * std::cos(angle);
    const double y = away * std::sin(angle);
    const std::string text = fmt::format("{} 0 1\n{} 0 1\nclosed\n{} {} 1\n{} {} 1\nclosed\n",
                                         -large,
                                         large,
                                         x - small,
                                         y,
                                         x + small,
                                         y);
    const auto place = contact(text);
    EXPECT_EQ(place.has_value(), gap < 1.0e-4) << text;
    if (!place) continue;
    EXPECT_NEAR(place->norm(), large, 1.0e-3) << text;
  }
}

TEST(LoopContact, LeavesPlacesThatSayWhereALoopLies) {
  const Contour contour = contour_from_text(
      std::string{kTouchedRoom} + "0 0\n60 0\n60 10\n30 5\n0 10\nclosed\n", "test");
  const auto place = place_off_loop(contour.view(), 1, 0);
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->y(), 7.5, 1.0e-9);
  const Contour twice = contour_from_text(std::string{kTouchedRoom} + kTouchedRoom, "test");
  EXPECT_FALSE(place_off_loop(twice.view(), 1, 0));
}

TEST(LoopContact, BoxesHoldTheirLoops) {
  const Contour contour = contour_from_text("1 1 4\n2 1\nclosed\n", "test");
  const auto box = box_around(contour.view(), 0);
  // The radius of the circle is 1.0625.
  EXPECT_LT(box.x0, 0.4375);
  EXPECT_GT(box.x1, 2.5625);
  EXPECT_LT(box.y1 - box.y0, 10.0);
}

}  // namespace
}  // namespace sim::pocket
