#include "host-sim/serve/pacer.hpp"

#include <gtest/gtest.h>

namespace sim {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;
using std::chrono::seconds;

const Pacer::Clock::time_point kStart{seconds{1000}};

TEST(Pacer, GivesATurnForEachMillisecond) {
  Pacer pacer{1.0, kStart};
  EXPECT_EQ(pacer.take_due(kStart), 0U);
  EXPECT_EQ(pacer.take_due(kStart + microseconds{999}), 0U);
  EXPECT_EQ(pacer.take_due(kStart + milliseconds{1}), 1U);
  EXPECT_EQ(pacer.take_due(kStart + milliseconds{1}), 0U);
  EXPECT_EQ(pacer.take_due(kStart + milliseconds{8}), 7U);
}

TEST(Pacer, ScalesWithTheSpeed) {
  Pacer fast{20.0, kStart};
  EXPECT_EQ(fast.take_due(kStart + milliseconds{3}), 60U);
  Pacer slow{0.1, kStart};
  EXPECT_EQ(slow.take_due(kStart + milliseconds{9}), 0U);
  EXPECT_EQ(slow.take_due(kStart + milliseconds{10}), 1U);
}

TEST(Pacer, CatchesUpInBoundedBursts) {
  Pacer pacer{1.0, kStart};
  const auto late = kStart + milliseconds{200};
  EXPECT_EQ(pacer.take_due(late), Pacer::kMaxTurns);
  EXPECT_EQ(pacer.take_due(late), 200 - Pacer::kMaxTurns);
  EXPECT_EQ(pacer.take_due(late), 0U);
}

TEST(Pacer, DoesNotRaceAfterALongSleep) {
  Pacer pacer{1.0, kStart};
  const auto late = kStart + seconds{3600};
  std::uint64_t turns = 0;
  while (const std::uint64_t due = pacer.take_due(late)) turns += due;
  EXPECT_LE(turns, 251U);
  EXPECT_GE(turns, 249U);
  EXPECT_EQ(pacer.take_due(late + milliseconds{10}), 10U);
}

TEST(Pacer, SaysHowLongToSleep) {
  Pacer pacer{1.0, kStart};
  EXPECT_EQ(pacer.until_next(kStart), milliseconds{1});
  EXPECT_EQ(pacer.until_next(kStart + microseconds{400}), microseconds{600});
  EXPECT_EQ(pacer.until_next(kStart + milliseconds{5}), milliseconds{0});
}

TEST(Pacer, NeverRunsAheadOfTheClock) {
  for (const double speed : {0.01, 0.3, 1.0, 7.0, 1000.0}) {
    Pacer pacer{speed, kStart};
    std::uint64_t turns = 0;
    auto now = kStart;
    for (int step = 1; step < 3000; ++step) {
      now += microseconds{37 * (step % 70)};
      turns += pacer.take_due(now);
      const double allowed = std::chrono::duration<double>{now - kStart}.count() * speed * 1000.0;
      ASSERT_LE(static_cast<double>(turns), allowed) << "speed " << speed << " step " << step;
    }
  }
}

}  // namespace
}  // namespace sim
