#include "firmware/machine/memory_guard.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <span>

namespace cnc {
namespace {

/// Tests a few bytes of settings and positions that are watched and trusted.
class Guarded : public testing::Test {
 protected:
  Guarded() {
    guard_.watch_settings_in(settings_);
    guard_.watch_settings(std::as_bytes(std::span{timing_}));
    guard_.watch_places_in(places_);
    guard_.trust_settings(true);
    guard_.trust_places(7);
  }

  /// Returns whether rounds of small steps find no difference.
  bool stays_sound() {
    for (int i = 0; i < 100; ++i) {
      if (!guard_.check(8)) return false;
    }
    return true;
  }

  std::array<std::uint32_t, 20> settings_{1, 2, 3};
  std::array<std::uint16_t, 5> timing_{4, 5};
  std::array<std::uint64_t, 9> places_{6};
  MemoryGuard guard_;
};

TEST_F(Guarded, FindsABitThatTurnedOverInAnyPart) {
  EXPECT_TRUE(stays_sound());
  EXPECT_EQ(guard_.trusted_places(), 7U);
  timing_[4] ^= 0x100;
  EXPECT_FALSE(stays_sound());
  timing_[4] ^= 0x100;
  EXPECT_FALSE(stays_sound()) << "what was damaged once is not trusted again";
}

TEST_F(Guarded, TrustsAChangeThatItIsToldOf) {
  settings_[2] = 9;
  guard_.trust_settings(true);
  places_[8] = 3;
  guard_.trust_places(8);
  EXPECT_TRUE(stays_sound());
  EXPECT_EQ(guard_.trusted_places(), 8U);
}

TEST_F(Guarded, ReadsAllSettingsBeforeAChangeIsTrusted) {
  settings_[19] ^= 1;
  guard_.check_settings();
  guard_.trust_settings(true);
  EXPECT_FALSE(guard_.check(0));
}

TEST_F(Guarded, ReadsAllPlacesBeforeTheyAreStored) {
  EXPECT_TRUE(guard_.check_places());
  places_[0] ^= 1U << 20;
  EXPECT_FALSE(guard_.check_places());
}

TEST_F(Guarded, BelievesSettingsThatDisagreeWithTheirOwnSumNever) {
  guard_.trust_settings(false);
  guard_.trust_settings(true);
  EXPECT_FALSE(guard_.check(1000));
}

}  // namespace
}  // namespace cnc
