#include "firmware/machine/travel.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

constexpr std::uint8_t kX = 1;

/// Soft limits, and 100 mm of travel in X and Y below zero.
Settings limited() {
  Settings settings;
  for (const auto& [number, value] : {std::pair<std::uint16_t, float>{setting::kSoftLimits, 1.0F},
                                      {setting::kTravel, 100.0F},
                                      {setting::kTravel + 1, 100.0F}}) {
    EXPECT_TRUE(settings.set(number, value).ok());
  }
  return settings;
}

Position at(int x_mm, int y_mm) {
  return {Coordinate{x_mm * 1'000'000}, Coordinate{y_mm * 1'000'000}};
}

TEST(Travel, HoldsEverythingBeforeHoming) {
  Travel travel;
  travel.configure(limited());
  EXPECT_EQ(travel.homed(), 0);
  EXPECT_TRUE(travel.holds(at(500, 500)));
}

TEST(Travel, HoldsHomedAxesAlone) {
  Travel travel;
  travel.set_homed(kX, limited());
  EXPECT_EQ(travel.homed(), kX);
  EXPECT_TRUE(travel.holds(at(-100, 500)));
  EXPECT_FALSE(travel.holds(at(-101, 500)));
  EXPECT_FALSE(travel.holds(at(1, 0)));
  EXPECT_EQ(travel.clamped(at(20, 20)), at(0, 20));
}

TEST(Travel, KeepsTheHomedAxesWhenSettingsChange) {
  Travel travel;
  travel.set_homed(kX, limited());
  travel.configure(Settings{});
  EXPECT_TRUE(travel.holds(at(1, 0))) << "without soft limits";
  travel.configure(limited());
  EXPECT_EQ(travel.homed(), kX);
  EXPECT_FALSE(travel.holds(at(1, 0)));
}

}  // namespace
}  // namespace cnc
