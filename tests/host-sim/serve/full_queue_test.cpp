#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <functional>
#include <memory>
#include <string>

#include "host-sim/serve/pty_transport.hpp"
#include "host-sim/serve/tcp_transport.hpp"
#include "host-sim/serve/web_transport.hpp"
#include "tests/host-sim/serve/far_sender.hpp"
#include "tests/host-sim/serve/loop_bench.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"

namespace sim {
namespace {

using Clock = LoopBench::Clock;
using Way = FarSender::Way;
using Milliseconds = std::chrono::duration<double, std::milli>;

constexpr Milliseconds kLimit{20.0};
/// From less than the controller announces to more than any buffer on the way holds.
constexpr std::array<std::size_t, 6> kFills{600, 3'000, 5'000, 20'000, 200'000, 8'000'000};

/// Nothing is asked here.
class NoPage final : public PageService {
 public:
  std::optional<WebReply> refusal(const HttpRequest&) const override { return {}; }
  Answer answer(HttpRequest) override { return WebReply{}; }
};

/// Lines that keep the machine cutting for longer than the test lasts.
std::string lines_of(std::size_t bytes) {
  std::string text = "G21 G90 M3 S500 F1200\n";
  for (int line = 0; text.size() < bytes; ++line) {
    text += line % 2 == 0 ? "G1 X250 Y100\n" : "G1 X0 Y0\n";
  }
  return text;
}

/// A sender far ahead of a machine that cuts.
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
      case Way::kPty: {
        bench.emplace(std::make_unique<PtyTransport>(link_.path()));
        sender.emplace(FarSender::over_pty(link_.path()));
        break;
      }
      case Way::kWebSocket: {
        auto web = std::make_unique<WebTransport>(InternetAddress{}, page_);
        const InternetAddress address = parse_address(web->address());
        bench.emplace(std::move(web));
        sender.emplace(FarSender::over_web_socket(address));
        break;
      }
    }
    EXPECT_TRUE(sender->hears("for help]"));
    sender->send(lines_of(fill));
    EXPECT_TRUE(LoopBench::wait([this] { return bench->lit(); }));
    sender->forget();
  }

 private:
  const ScratchFile link_{".tty"};
  NoPage page_;

 public:
  std::optional<LoopBench> bench;
  std::optional<FarSender> sender;
};

using Act = std::function<void(Ahead&)>;
using Done = std::function<bool(Ahead&)>;

Milliseconds processor_time() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return std::chrono::seconds{time.tv_sec} + std::chrono::nanoseconds{time.tv_nsec};
}

/// Where others use the processor, what this process worked and slept counts instead of the time
/// that passed: what waits for a queue sleeps, what waits for a processor does not.
Milliseconds time_of(Way way, std::size_t fill, const Act& act, const Done& done) {
  Ahead ahead{way, fill};
  act(ahead);
  const auto begin = Clock::now();
  const Milliseconds work = processor_time();
  const unsigned sleeps = ahead.bench->sleeps();
  EXPECT_TRUE(LoopBench::wait([&] { return done(ahead); }));
  const Milliseconds passed = Clock::now() - begin;
  const Milliseconds slept{static_cast<double>(ahead.bench->sleeps() - sleeps)};
  return std::min(passed, processor_time() - work + slept);
}

/// Where the time is long, it is measured again: what waits for a queue does so every time.
void expect_at_once(Way way, const std::string& what, const Act& act, const Done& done) {
  constexpr int kTries = 4;
  Milliseconds worst{0.0};
  for (const std::size_t fill : kFills) {
    Milliseconds time = time_of(way, fill, act, done);
    for (int tries = 1; tries < kTries && time > kLimit; ++tries) {
      time = std::min(time, time_of(way, fill, act, done));
    }
    EXPECT_LE(time.count(), kLimit.count()) << what << " behind " << fill << " bytes";
    worst = std::max(worst, time);
  }
  std::printf("%s: %.1f ms at worst\n", what.c_str(), worst.count());
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
  if (GetParam() == Way::kPty) return;  // Has no other end.
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
  for (std::size_t sent = 0; sent <= LookAhead::kMost + part.size(); sent += part.size())
    ahead.sender->send(part);
  EXPECT_TRUE(ahead.sender->hears(Reception::kTooFarAhead));
  EXPECT_TRUE(LoopBench::wait([&] { return !ahead.bench->lit(); }));
}

}  // namespace
}  // namespace sim
