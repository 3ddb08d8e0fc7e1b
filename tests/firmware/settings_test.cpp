#include "firmware/machine/settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "firmware/machine/configuration.hpp"

namespace cnc {
namespace {

TEST(Settings, AreSortedByNumberAndEachIsThereOnce) {
  const auto table = setting_table();
  EXPECT_TRUE(std::is_sorted(table.begin(), table.end(), [](const auto& a, const auto& b) {
    return a.number < b.number;
  }));
  EXPECT_EQ(std::adjacent_find(table.begin(),
                               table.end(),
                               [](const auto& a, const auto& b) { return a.number == b.number; }),
            table.end());
}

TEST(Settings, BeginWithLegalStandards) {
  const Settings settings;
  for (const SettingInfo& info : setting_table()) {
    EXPECT_EQ(settings.get(info.number), info.standard) << info.number;
    EXPECT_GE(info.standard, info.least) << info.number;
    EXPECT_LE(info.standard, info.most) << info.number;
    EXPECT_FALSE(std::string_view{info.name}.empty()) << info.number;
    EXPECT_FALSE(std::string_view{info.unit}.empty()) << info.number;
  }
}

TEST(Settings, TakeBothEndsOfTheirRange) {
  Settings settings;
  for (const SettingInfo& info : setting_table()) {
    ASSERT_TRUE(settings.set(info.number, info.most).ok()) << info.number;
    EXPECT_EQ(settings.get(info.number), info.most);
    ASSERT_TRUE(settings.set(info.number, info.least).ok()) << info.number;
    EXPECT_EQ(settings.get(info.number), info.least);
  }
}

TEST(Settings, RefuseWhatIsOutOfRangeAndStayAsTheyWere) {
  const float infinity = std::numeric_limits<float>::infinity();
  Settings settings;
  for (const SettingInfo& info : setting_table()) {
    const float above = std::nextafter(info.most, infinity);
    const float below = std::nextafter(info.least, -infinity);
    EXPECT_EQ(settings.set(info.number, above).error(), SettingError::kAboveRange) << info.number;
    EXPECT_EQ(settings.set(info.number, below).error(), SettingError::kBelowRange) << info.number;
    EXPECT_FALSE(settings.set(info.number, infinity).ok()) << info.number;
    EXPECT_FALSE(settings.set(info.number, -infinity).ok()) << info.number;
    EXPECT_FALSE(settings.set(info.number, std::nanf("")).ok()) << info.number;
    EXPECT_EQ(settings.get(info.number), info.standard) << info.number;
  }
}

TEST(Settings, RefuseEveryOtherNumber) {
  Settings settings;
  for (unsigned number = 0; number <= 0xFFFFU; ++number) {
    const auto table = setting_table();
    const bool known = std::any_of(
        table.begin(), table.end(), [&](const SettingInfo& info) { return info.number == number; });
    if (known) continue;
    EXPECT_EQ(settings.set(static_cast<std::uint16_t>(number), 1.0F).error(),
              SettingError::kUnknown);
  }
}

TEST(Settings, AreWholeUnlessTheyAreDecimals) {
  Settings settings;
  for (const SettingInfo& info : setting_table()) {
    const auto set = settings.set(info.number, info.least + 0.5F);
    if (info.type == SettingType::kDecimal || info.least + 0.5F > info.most) continue;
    EXPECT_EQ(set.error(), SettingError::kNotWhole) << info.number;
  }
}

TEST(Settings, RefuseBrokenNumbersWhereOnlyWholeOnesMeanAnything) {
  Settings settings;
  EXPECT_EQ(settings.set(setting::kLaserMode, 0.5F).error(), SettingError::kNotWhole);
  EXPECT_TRUE(settings.set(setting::kLaserMode, 1.0F).ok());
}

TEST(Settings, KnowThatAValueTurnedOverThoughAnotherIsSet) {
  Settings settings;
  EXPECT_TRUE(settings.sound());
  ASSERT_TRUE(settings.set(setting::kRate, 4000.0F).ok());
  EXPECT_TRUE(settings.sound());
  constexpr std::size_t kByte = 4 * 7 + 1;
  auto* const byte = reinterpret_cast<unsigned char*>(&settings) + kByte;
  *byte = static_cast<unsigned char>(*byte ^ 0x10U);
  ASSERT_TRUE(settings.set(setting::kRate, 5000.0F).ok());
  EXPECT_FALSE(settings.sound());
}

TEST(SettingsDeathTest, StopWhoReadsANumberThatIsNotThere) {
  EXPECT_DEATH(static_cast<void>(Settings{}.get(7)), "contract failed");
}

TEST(Configuration, ReadsRatesPerMinuteAndAccelerationPerSecond) {
  Settings settings;
  ASSERT_TRUE(settings.set(111, 6000.0F).ok());
  ASSERT_TRUE(settings.set(122, 250.0F).ok());
  ASSERT_TRUE(settings.set(104, 12.5F).ok());
  ASSERT_TRUE(settings.set(setting::kJunctionDeviation, 0.02F).ok());
  const motion::Limits limits = limits_from(settings);
  EXPECT_FLOAT_EQ(limits.rate_mm_s[1], 100.0F);
  EXPECT_FLOAT_EQ(limits.rate_mm_s[0], 200.0F);
  EXPECT_FLOAT_EQ(limits.acceleration_mm_s2[2], 250.0F);
  EXPECT_FLOAT_EQ(limits.scale[4].steps_per_mm(), 12.5F);
  EXPECT_FLOAT_EQ(limits.junction_deviation_mm, 0.02F);
}

// The rate and acceleration for taking up backlash are part of those of the axis. The plan has the
// rest.
TEST(Configuration, LeavesRoomForTakingUpBacklash) {
  Settings settings;
  const motion::Limits whole = limits_from(settings);
  const float acceleration = settings.get(setting::kAcceleration);
  ASSERT_TRUE(settings.set(setting::kBacklash, 0.1F).ok());
  const motion::Limits limits = limits_from(settings);
  const motion::BacklashSetting backlash = motor_stage_from(settings).backlash[0];
  EXPECT_EQ(backlash.steps, 25);
  EXPECT_FLOAT_EQ(limits.acceleration_mm_s2[0] + backlash.acceleration / 250.0F, acceleration);
  EXPECT_FLOAT_EQ(limits.rate_mm_s[0] + backlash.rate / 250.0F, whole.rate_mm_s[0]);
  EXPECT_EQ(limits.acceleration_mm_s2[1], whole.acceleration_mm_s2[1]);
  EXPECT_EQ(limits.rate_mm_s[1], whole.rate_mm_s[1]);
  EXPECT_EQ(motor_stage_from(settings).backlash[1].steps, 0);
}

// At 4 MHz, 5 µs are 20 ticks and 0.25 µs is one.
TEST(Configuration, ReadsPulseTimesInTicks) {
  Settings settings;
  EXPECT_EQ(step_timing_from(settings).pulse, 20U);
  EXPECT_EQ(step_timing_from(settings).direction_set_up, 20U) << "external drivers want 5 µs";
  ASSERT_TRUE(settings.set(setting::kDirectionSetUp, 0.25F).ok());
  EXPECT_EQ(step_timing_from(settings).direction_set_up, 1U);
}

TEST(Configuration, NeverShortensAPulseTime) {
  Settings settings;
  for (float microseconds = 1.0F; microseconds <= 12.0F; microseconds += 0.0625F) {
    ASSERT_TRUE(settings.set(setting::kStepPulse, microseconds).ok());
    const auto ticks = static_cast<double>(step_timing_from(settings).pulse);
    EXPECT_GE(ticks / 4.0, static_cast<double>(microseconds));
    EXPECT_LT(ticks / 4.0, static_cast<double>(microseconds) + 0.25);
  }
}

// A tenth of the slots remains free, and the interrupt takes a microsecond to reach each edge.
TEST(Configuration, LeavesEveryMotorTimeToSpareInItsSlots) {
  Settings settings;
  for (float microseconds = 1.0F; microseconds <= 12.0F; microseconds += 0.25F) {
    ASSERT_TRUE(settings.set(setting::kStepPulse, microseconds).ok());
    const double slot = 2.0 * static_cast<double>(step_timing_from(settings).pulse);
    const auto rate = static_cast<double>(limits_from(settings).steps_per_s_one_motor);
    EXPECT_NEAR(rate * (slot + 8.0) / 4.0e6, 0.97, 1.0e-6);
    EXPECT_LE(rate * slot / 4.0e6, 0.9);
  }
}

TEST(Configuration, ReadsTheArcRepairAsMillimetresAndShare) {
  Settings settings;
  ASSERT_TRUE(settings.set(setting::kArcRepairMm, 0.2F).ok());
  ASSERT_TRUE(settings.set(setting::kArcRepairPercent, 3.0F).ok());
  EXPECT_FLOAT_EQ(gcode_options_from(settings).arc.absolute_mm, 0.2F);
  EXPECT_FLOAT_EQ(gcode_options_from(settings).arc.relative, 0.03F);
}

}  // namespace
}  // namespace cnc
