#include "firmware/machine/input_filter.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

constexpr std::int32_t kMillisecond = 1000;

TEST(InputFilter, BelievesThreeLooksThatAgree) {
  InputFilter filter;
  const hal::InputState open{.door = true};
  EXPECT_FALSE(filter.poll(open, kMillisecond));
  EXPECT_FALSE(filter.poll(open, kMillisecond));
  EXPECT_TRUE(filter.poll(open, kMillisecond));
  EXPECT_EQ(filter.settled(), open);
  EXPECT_EQ(filter.before(), hal::InputState{});
  EXPECT_FALSE(filter.poll(open, kMillisecond));
}

TEST(InputFilter, LooksNoOftenerThanOnceAMillisecond) {
  InputFilter filter;
  for (int i = 0; i < 25; ++i) EXPECT_FALSE(filter.poll({.hold = true}, kMillisecond / 10));
  EXPECT_EQ(filter.raw(), hal::InputState{.hold = true});
}

TEST(InputFilter, SeesAnEmergencyStopThroughAChatteringSwitch) {
  InputFilter filter;
  for (int i = 0; i < 5; ++i) {
    const auto chatter = static_cast<std::uint8_t>(i % 2 == 0 ? 4 : 0);
    filter.poll({.limits = chatter, .emergency_stop = true}, kMillisecond);
  }
  EXPECT_EQ(filter.settled(), hal::InputState{.emergency_stop = true});
}

TEST(InputFilter, KeepsEveryInputInItsPlace) {
  const hal::InputState states[] = {{.limits = 0x2A},
                                    {.second_limits = 0x15},
                                    {.probe = true},
                                    {.door = true},
                                    {.hold = true},
                                    {.start = true},
                                    {.reset = true},
                                    {.emergency_stop = true}};
  for (const hal::InputState& state : states) {
    InputFilter filter;
    for (int i = 0; i < 3; ++i) filter.poll(state, kMillisecond);
    EXPECT_EQ(filter.settled(), state);
  }
}

}  // namespace
}  // namespace cnc
