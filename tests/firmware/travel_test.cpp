#include "firmware/machine/travel.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

/// Soft limits, and 100 mm of travel in X and Y below zero.
Settings limited_to_100_mm() {
  Settings settings;
  for (const auto& [number, value] : {std::pair<std::uint16_t, float>{setting::kSoftLimits, 1.0F},
                                      {setting::kTravel, 100.0F},
                                      {setting::kTravel + 1, 100.0F}}) {
    EXPECT_TRUE(settings.set(number, value).ok());
  }
  return settings;
}

Position in_xy(int x_mm, int y_mm) {
  return {Coordinate{x_mm * 1'000'000}, Coordinate{y_mm * 1'000'000}};
}

TEST(Travel, HoldsEverythingBeforeHoming) {
  Travel travel;
  travel.configure(limited_to_100_mm());
  EXPECT_EQ(travel.homed(), 0);
  EXPECT_TRUE(travel.holds(in_xy(500, 500)));
}

TEST(Travel, HoldsHomedAxesAlone) {
  Travel travel;
  travel.set_homed(1, limited_to_100_mm());
  EXPECT_EQ(travel.homed(), 1);
  EXPECT_TRUE(travel.holds(in_xy(-100, 500)));
  EXPECT_FALSE(travel.holds(in_xy(-101, 500)));
  EXPECT_FALSE(travel.holds(in_xy(1, 0)));
  EXPECT_EQ(travel.clamped(in_xy(20, 20)), in_xy(0, 20));
}

TEST(Travel, KeepsTheHomedAxesWhenSettingsChange) {
  Travel travel;
  travel.set_homed(1, limited_to_100_mm());
  travel.configure(Settings{});
  EXPECT_TRUE(travel.holds(in_xy(1, 0))) << "without soft limits";
  travel.configure(limited_to_100_mm());
  EXPECT_EQ(travel.homed(), 1);
  EXPECT_FALSE(travel.holds(in_xy(1, 0)));
}

}  // namespace
}  // namespace cnc
