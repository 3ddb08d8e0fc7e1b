#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "host-sim/serve/pty_transport.hpp"
#include "host-sim/serve/tcp_transport.hpp"
#include "tests/host-sim/serve/far_sender.hpp"
#include "tests/host-sim/serve/page_traffic.hpp"
#include "tests/host-sim/serve/scheduling_delay.hpp"
#include "tests/host-sim/serve/server_bench.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"
#include "tests/support/sanitized.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using Clock = ServerBench::Clock;
using Way = FarSender::Way;
using Milliseconds = std::chrono::duration<double, std::milli>;

/// The product must react within 20 ms. Code that a sanitizer instruments takes up to five times as
/// long.
constexpr Milliseconds kLimit{proof::kSanitized ? 100.0 : 20.0};
/// The sizes are from less than the controller announces to more than all buffers on the path
/// contain.
constexpr std::array<std::size_t, 6> kFills{600, 3'000, 5'000, 20'000, 200'000, 8'000'000};

/// Returns lines that keep the machine cutting for longer than the test lasts.
std::string lines_of(std::size_t bytes) {
  std::string text = "G21 G90 M3 S500 F1200\n";
  for (int line = 0; text.size() < bytes; ++line) {
    text += line % 2 == 0 ? "G1 X250 Y100\n" : "G1 X0 Y0\n";
  }
  return text;
}

/// A sender far ahead of a machine that cuts, while pages are connected.
class Ahead {
 public:
  Ahead(Way way, std::size_t fill) {
    switch (way) {
      case Way::kTcp: {
        auto tcp = std::make_unique<TcpTransport>(InternetAddress{});
        const InternetAddress address = parse_address(tcp->address());
        bench.emplace(std::move(tcp));
        sender.emplace(FarSender::over_tcp(address));
        break;
      }
      case Way::kPty:
        bench.emplace(std::make_unique<PtyTransport>(link_.path()));
        sender.emplace(FarSender::over_pty(link_.path()));
        break;
      case Way::kWebSocket:
        bench.emplace(nullptr);
        sender.emplace(FarSender::over_web_socket(bench->page()));
        break;
    }
    EXPECT_TRUE(sender->hears("for help]"));
    pages.emplace(bench->page());
    sender->send(lines_of(fill));
    EXPECT_TRUE(ServerBench::wait([this] { return bench->lit(); }));
    EXPECT_TRUE(ServerBench::wait([this] { return pages->answered() > 0 && pages->news() > 0; }));
    sender->forget();
  }

 private:
  const ScratchFile link_{".tty"};

 public:
  std::optional<ServerBench> bench;
  std::optional<FarSender> sender;
  std::optional<PageTraffic> pages;
};

using Act = std::function<void(Ahead&)>;
using Done = std::function<bool(Ahead&)>;

/// Measures the worst of all tries by the wall clock, from before the first byte. If other work
/// keeps the processors busy, the limit is greater by the time for which the threads of loop and
/// test were ready and waited for a processor. This does not excuse a loop that blocks, or that
/// works for too long.
void expect_at_once(Way way, const std::string& what, const Act& act, const Done& done) {
  constexpr int kTries = 2;
  Milliseconds worst{0.0};
  Milliseconds worst_delay{0.0};
  constexpr std::size_t kShares = 3;
  for (std::size_t i = 0; i < kFills.size(); ++i) {
    if (!proof::is_in_share(i, kShares)) continue;
    const std::size_t fill = kFills[i];
    for (int tries = 0; tries < kTries; ++tries) {
      Ahead ahead{way, fill};
      const auto delay = [&ahead] {
        return scheduling_delay(ahead.bench->loop_thread()) + scheduling_delay(::gettid());
      };
      const Milliseconds delay_before = delay();
      const auto begin = Clock::now();
      act(ahead);
      EXPECT_TRUE(ServerBench::wait([&] { return done(ahead); }));
      const Milliseconds passed = Clock::now() - begin;
      const Milliseconds late = delay() - delay_before;
      EXPECT_LE(passed.count(), kLimit.count() + late.count())
          << what << " behind " << fill << " bytes, processors were waited for " << late.count()
          << " ms";
      worst = std::max(worst, passed);
      worst_delay = std::max(worst_delay, late);
    }
  }
  std::printf("%s: %.1f ms at worst, processors were waited for %.1f ms at worst\n",
              what.c_str(),
              worst.count(),
              worst_delay.count());
}

class FullQueue : public testing::TestWithParam<Way> {};

TEST_P(FullQueue, HoldsAtOnce) {
  expect_at_once(
      GetParam(),
      "hold",
      [](Ahead& ahead) { ahead.sender->send("!"); },
      [](Ahead& ahead) { return ahead.bench->state() == cnc::MachineState::kHold; });
}

TEST_P(FullQueue, ReportsAtOnce) {
  expect_at_once(
      GetParam(),
      "report",
      [](Ahead& ahead) { ahead.sender->send("?"); },
      [](Ahead& ahead) { return ahead.sender->hears("<Run"); });
}

TEST_P(FullQueue, ResetsAtOnceAndForgetsTheLinesBefore) {
  expect_at_once(
      GetParam(),
      "reset",
      [](Ahead& ahead) { ahead.sender->send("\x18"); },
      [](Ahead& ahead) { return !ahead.bench->lit(); });
  Ahead ahead{GetParam(), 20'000};
  ahead.sender->send("\x18$X\n");
  EXPECT_TRUE(ahead.sender->hears("[MSG:")) << "unlocked: the lines after the reset are heard";
  ahead.sender->send("?");
  EXPECT_TRUE(ahead.sender->hears("<Idle")) << "and those before it are not";
}

TEST_P(FullQueue, NoticesAtOnceThatTheSenderIsGone) {
  expect_at_once(
      GetParam(),
      "close",
      [](Ahead& ahead) { ahead.sender->leave(FarSender::End::kClose); },
      [](Ahead& ahead) { return !ahead.bench->lit() && !ahead.bench->has_sender(); });
  if (GetParam() == Way::kPty) return;  // A pty has no other end to close.
  expect_at_once(
      GetParam(),
      "reset of the connection",
      [](Ahead& ahead) { ahead.sender->leave(FarSender::End::kReset); },
      [](Ahead& ahead) { return !ahead.bench->lit() && !ahead.bench->has_sender(); });
}

std::string name_of_way(const testing::TestParamInfo<Way>& info) {
  constexpr std::array kNames{"Tcp", "Pty", "WebSocket"};
  return kNames[static_cast<std::size_t>(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Every,
                         FullQueue,
                         testing::Values(Way::kTcp, Way::kPty, Way::kWebSocket),
                         name_of_way);

TEST(FullQueueLimits, ASenderFurtherAheadThanTheLimitIsToldAndHungUpOn) {
  Ahead ahead{Way::kTcp, 1'000};
  const std::string part = lines_of(std::size_t{1} << 20);
  for (std::size_t sent = 0; sent <= LookAhead::kMax + part.size(); sent += part.size())
    ahead.sender->send(part);
  EXPECT_TRUE(ahead.sender->hears(Reception::kTooFarAhead));
  EXPECT_TRUE(ServerBench::wait([&] { return !ahead.bench->lit(); }));
}

}  // namespace
}  // namespace sim
