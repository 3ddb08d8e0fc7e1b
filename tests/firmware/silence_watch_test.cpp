#include "firmware/link/silence_watch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

constexpr std::uint32_t kTurnUs = 1000;

/// Drives the watch by milliseconds, beginning shortly before the ticks wrap.
class SilenceWatchTest : public testing::Test {
 protected:
  void hear() { watch.hear(now()); }
  void poll() {
    hear();
    watch.poll(now());
  }
  void answer() { watch.answer(now()); }
  [[nodiscard]] bool gone(bool owes = true) { return watch.gone(now(), allowed_ms, owes); }
  /// Returns the first millisecond at which the sender counts as gone, or -1.
  int gone_after(int max_ms, bool owes = true) {
    for (int ms = 1; ms <= max_ms; ++ms) {
      ++now_ms;
      if (gone(owes)) return ms;
    }
    return -1;
  }
  void polls_every(int interval_ms, int count = 4) {
    for (; count > 0; --count) {
      poll();
      now_ms += static_cast<std::uint32_t>(interval_ms);
    }
    poll();
  }
  [[nodiscard]] hal::TickCount now() const { return hal::TickCount{kBegin + kTurnUs * now_ms}; }

  static constexpr std::uint32_t kBegin = 0xFFFF'0000;
  SilenceWatch watch;
  float allowed_ms = 250.0F;
  std::uint32_t now_ms = 0;
};

TEST_F(SilenceWatchTest, NobodyWhoNeverSpokeIsGone) { EXPECT_EQ(gone_after(5000), -1); }

TEST_F(SilenceWatchTest, WhoStreamsOwesAByteAfterItsLastAnswerOnly) {
  hear();
  EXPECT_EQ(gone_after(5000, false), -1) << "all is unanswered, or its program has ended";
  answer();
  EXPECT_EQ(gone_after(5000), 301);
  hear();
  EXPECT_EQ(gone_after(5000), 301);
}

TEST_F(SilenceWatchTest, WhoPollsIsExpectedByItsOwnInterval) {
  for (const auto& [interval_ms, limit_ms] :
       {std::pair{10, 300}, {100, 300}, {200, 500}, {250, 625}, {500, 1250}, {1000, 2000}}) {
    watch = {};
    polls_every(interval_ms);
    EXPECT_EQ(gone_after(5000, false), limit_ms + 1) << interval_ms;
  }
}

TEST_F(SilenceWatchTest, TheLongestOfTheLastThreeIntervalsCounts) {
  polls_every(100);
  polls_every(400, 1);
  polls_every(100, 2);
  EXPECT_EQ(gone_after(5000), 1001);
  polls_every(100, 3);
  EXPECT_EQ(gone_after(5000), 301);
}

TEST_F(SilenceWatchTest, WhoLooksNowAndThenDoesNotPoll) {
  polls_every(1700);
  EXPECT_FALSE(watch.polls());
  polls_every(100);
  EXPECT_TRUE(watch.polls());
  now_ms += 1700;
  hear();
  EXPECT_FALSE(watch.polls()) << "it spoke, and did not ask";
  polls_every(100, 1);
  EXPECT_TRUE(watch.polls());
  watch.begin_sender();
  EXPECT_FALSE(watch.polls());
}

TEST_F(SilenceWatchTest, MoreMayBeAllowedThanAnyIntervalIs) {
  allowed_ms = 5000.0F;
  polls_every(1000);
  EXPECT_EQ(gone_after(10'000), 6001);
}

TEST_F(SilenceWatchTest, OfAnHourOfSilenceNothingWrapsAround) {
  polls_every(100);
  bool always = true;
  for (int ms = 0; ms < 5'000'000; ms += 500) {
    now_ms += 500;
    always = always && gone();
  }
  EXPECT_TRUE(always);
  hear();
  EXPECT_FALSE(watch.polls());
}

/// Simulates a sender that follows a schedule: it polls or does not, and has lines to send within a
/// window.
class SilenceWatchRandom : public SilenceWatchTest {
 protected:
  void begin(std::uint64_t seed) {
    random = proof::Random{seed};
    watch = {};
    polled.clear();
    polls = random.chance(0.5);
    interval_ms = 50 + below(900);
    window = 1 + below(8);
    unanswered = 0;
    last_byte_ms = last_answer_ms = now_ms;
    next_poll_ms = next_line_ms = now_ms + 1;
  }
  void live() {
    ++now_ms;
    if (polls && now_ms >= next_poll_ms) {
      poll();
      polled.push_back(last_byte_ms = now_ms);
      next_poll_ms = now_ms + interval_ms * (80 + below(41)) / 100;
    }
    if (unanswered < window && now_ms >= next_line_ms) {
      hear();
      last_byte_ms = now_ms;
      if (unanswered++ == 0) answer_ms = now_ms + below(1500);
      next_line_ms = now_ms + below(250);
    }
    if (unanswered > 0 && now_ms >= answer_ms) {
      answer();
      --unanswered;
      last_answer_ms = now_ms;
      answer_ms = now_ms + below(1500);
      next_line_ms = now_ms + below(250);
    }
  }
  /// Returns the time at which the sender must count as gone, if all its lines are answered and no
  /// byte follows.
  [[nodiscard]] std::uint32_t expected_ms() const {
    if (!polls) return std::max(last_byte_ms, last_answer_ms) + 301;
    std::uint32_t longest_ms = 0;
    for (std::size_t i = polled.size() - 3; i < polled.size(); ++i) {
      longest_ms = std::max(longest_ms, polled[i] - polled[i - 1]);
    }
    return last_byte_ms + std::clamp(longest_ms * 5 / 2, 300U, 2000U) + 1;
  }
  std::uint32_t below(std::size_t count) { return static_cast<std::uint32_t>(random.below(count)); }

  proof::Random random{0};
  std::vector<std::uint32_t> polled;
  bool polls = false;
  std::uint32_t interval_ms = 0, window = 0, unanswered = 0;
  std::uint32_t last_byte_ms = 0, last_answer_ms = 0;
  std::uint32_t next_poll_ms = 0, next_line_ms = 0, answer_ms = 0;
};

/// A sender that is alive must never count as gone. A dead sender must count as gone after a time
/// that depends on its earlier polls and answers. The test computes this time independently.
TEST_F(SilenceWatchRandom, TheLivingAreLeftAloneAndTheDeadAreNot) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    begin(seed);
    for (std::uint32_t left = 5000 + below(10'000); left > 0; --left) {
      live();
      ASSERT_FALSE(gone(unanswered == 0)) << now_ms;
    }
    const std::uint32_t dead_ms = now_ms;
    while (!gone() && now_ms < dead_ms + 5000) ++now_ms;
    EXPECT_EQ(now_ms, std::max(expected_ms(), dead_ms));
  }
}

}  // namespace
}  // namespace cnc
