/// libFuzzer: any bytes from the link through protocol, planner and step
/// generator. Whatever arrives, nothing crashes, every line is answered once,
/// motors stay inside their counters and below their rates, and the beam is
/// off when the machine has come to rest.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>

#include "firmware/application.hpp"
#include "hal/host/memory_store.hpp"
#include "hal/host/recording_port.hpp"

namespace {

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

/// Hands out the fuzzer's bytes and counts the answers.
class BytesLink final : public hal::ByteStream {
 public:
  explicit BytesLink(std::span<const std::uint8_t> bytes) : bytes_{bytes} {}

  std::size_t read(std::span<std::byte> into) override {
    if (read_ == bytes_.size() || into.empty()) return 0;
    into[0] = static_cast<std::byte>(bytes_[read_++]);
    return 1;
  }

  std::size_t write(std::span<const std::byte> from) override {
    for (const std::byte byte : from) {
      const char character = static_cast<char>(byte);
      if (character == '\n') {
        if (!in_message_) ++answers;
        at_start_ = true;
        continue;
      }
      if (at_start_) in_message_ = character == '[';
      at_start_ = false;
    }
    return from.size();
  }

  [[nodiscard]] bool empty() const { return read_ == bytes_.size(); }
  [[nodiscard]] std::size_t lines() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < bytes_.size(); ++i) {
      const bool pair = bytes_[i] == '\n' && i > 0 && bytes_[i - 1] == '\r';
      if ((bytes_[i] == '\n' && !pair) || bytes_[i] == '\r') ++count;
    }
    return count;
  }

  std::size_t answers = 0;

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t read_ = 0;
  bool at_start_ = true;
  bool in_message_ = false;  ///< `[MSG:…]` lines come before an answer and are none.
};

/// The controller in virtual time, a millisecond a turn.
class Bench {
 public:
  explicit Bench(std::span<const std::uint8_t> bytes) : link_{bytes} {}

  /// Until the bytes are used up and the machine rests, at most `turns`.
  void run(unsigned turns) {
    for (unsigned turn = 0; turn < turns && !rests(); ++turn) {
      application_.poll(hal::TickCount{turn * 1000U});
      advance_millisecond();
    }
  }

  /// As an operator who has waited long enough.
  void abort() {
    application_.machine().reset();
    for (unsigned turn = 0; turn < 4; ++turn) {
      application_.poll(hal::TickCount{0});
      advance_millisecond();
    }
  }

  [[nodiscard]] bool rests() {
    return link_.empty() && application_.machine().idle() && !timer_runs_;
  }

  void check() {
    const bool laser = application_.machine().settings().get(cnc::setting::kLaserMode) != 0.0F;
    require(!laser || port_.power == 0, "the beam is off at rest");
    // Homing gives the steps other numbers.
    require(
        application_.machine().homed() != 0 || port_.position == application_.steps().position(),
        "no step is lost");
    require(application_.machine().alarm() != cnc::Alarm::kStarved, "segments come in time");
  }

  [[nodiscard]] const BytesLink& link() const { return link_; }

 private:
  void advance_millisecond() {
    constexpr std::uint64_t kTicks = cnc::motion::kTicksPerSecond / 1000;
    if (port_.timer_started) {
      port_.timer_started = false;
      timer_runs_ = true;
      next_ = now_;
    }
    const auto before = port_.position;
    while (timer_runs_ && next_ < now_ + kTicks) {
      const std::uint32_t wait = application_.on_step_interrupt();
      timer_runs_ = wait != 0;
      next_ += wait;
    }
    now_ += kTicks;
    for (std::size_t motor = 0; motor < before.size(); ++motor) {
      const std::int64_t steps = std::int64_t{port_.position[motor]} - before[motor];
      require(std::llabs(steps) <= kMostStepsPerMillisecond, "step rate");
    }
  }

  /// A pulse is at least 1 µs up and 1 µs down, nine of ten slots are used.
  static constexpr std::int64_t kMostStepsPerMillisecond = 451;

  hal::host::RecordingPort port_{};
  hal::host::MemoryStore store_{};
  BytesLink link_;
  cnc::Application<hal::host::RecordingPort> application_{port_, port_, port_, store_, link_};
  std::uint64_t now_ = 0;
  std::uint64_t next_ = 0;
  bool timer_runs_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bench bench{{data, size}};
  bench.run(400);
  if (bench.rests()) {
    require(bench.link().answers == bench.link().lines(), "one answer for every line");
  } else {
    bench.abort();
  }
  bench.check();
  return 0;
}
