#include "host-sim/send/sender.hpp"

#include <gtest/gtest.h>

#include <random>

#include "host-sim/machine/virtual_controller.hpp"
#include "host-sim/send/job_lines.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using std::chrono::milliseconds;

/// A serial line that transfers a number of bytes per millisecond, each of which may be damaged or
/// lost.
class SerialWire {
 public:
  SerialWire(double bytes_per_ms, double bit_errors, double drops, std::uint64_t seed)
      : rate_{bytes_per_ms}, bit_errors_{bit_errors}, drops_{drops}, random_{seed} {
    draw_bits();
    draw_drop();
  }

  /// Bytes that an adapter queues before the writer must wait.
  static constexpr std::size_t kQueue = 64;

  [[nodiscard]] std::size_t room() const {
    return waiting_.size() < kQueue ? kQueue - waiting_.size() : 0;
  }
  void send(std::string_view bytes) { waiting_ += bytes; }

  /// Returns the bytes that arrive in a millisecond.
  std::string pass() {
    due_ += rate_;
    const auto count = std::min(waiting_.size(), static_cast<std::size_t>(due_));
    due_ = std::min(due_ - static_cast<double>(count), rate_);
    std::string arrived;
    for (std::size_t i = 0; i < count; ++i) carry(waiting_[i], arrived);
    waiting_.erase(0, count);
    carried += count;
    return arrived;
  }

  std::size_t carried = 0;
  std::size_t injected = 0;

 private:
  void carry(char byte, std::string& arrived) {
    for (; to_bit_ < 8; draw_bits()) {
      byte = static_cast<char>(byte ^ (1 << to_bit_));
      ++injected;
    }
    to_bit_ -= 8;
    if (to_drop_-- > 0) {
      arrived += byte;
      return;
    }
    ++injected;
    draw_drop();
  }
  std::uint64_t draw(double probability) {
    if (probability <= 0.0) return 1ULL << 62U;
    return std::geometric_distribution<std::uint64_t>{probability}(random_);
  }
  void draw_bits() { to_bit_ += 1 + draw(bit_errors_); }
  void draw_drop() { to_drop_ = draw(drops_); }

  double rate_;
  double bit_errors_;
  double drops_;
  double due_ = 0.0;
  std::mt19937_64 random_;
  std::uint64_t to_bit_ = 0;  ///< Number of bits before the next damaged bit.
  std::uint64_t to_drop_ = 0;
  std::string waiting_;
};

/// The controller's end of two wires.
class WiredLink final : public hal::ByteStream {
 public:
  std::size_t read(std::span<std::byte> into) override {
    const std::size_t count = std::min(into.size(), incoming.size());
    for (std::size_t i = 0; i < count; ++i) into[i] = static_cast<std::byte>(incoming[i]);
    incoming.erase(0, count);
    return count;
  }
  std::size_t write(std::span<const std::byte> from) override {
    for (const std::byte byte : from) outgoing += static_cast<char>(byte);
    return from.size();
  }

  std::string incoming;
  std::string outgoing;
};

/// One motor after the other turns by a number of steps. The job is the sequence of these motors
/// and steps, whatever the time each takes.
struct MotorTurn {
  std::size_t axis = 0;
  int steps = 0;
  bool operator==(const MotorTurn&) const = default;
};

class TurnRecorder final : public TraceSink {
 public:
  void on_row(const TraceRow& row) override {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const int steps = row.position[axis] - position_[axis];
      position_[axis] = row.position[axis];
      if (steps == 0) continue;
      if (turns.empty()) first_ns = row.time_ns;
      last_ns = row.time_ns;
      if (turns.empty() || turns.back().axis != axis) turns.push_back({.axis = axis});
      turns.back().steps += steps;
    }
  }
  void on_end(std::uint64_t) override {}

  std::vector<MotorTurn> turns;
  std::uint64_t first_ns = 0;  ///< Time of the first step, ns.
  std::uint64_t last_ns = 0;   ///< Time of the last step, ns.

 private:
  std::array<int, 3> position_{};
};

struct TurningJob {
  std::vector<JobLine> lines;
  std::vector<MotorTurn> turns;
};

/// Returns lines of the length that a CAM program has, each of which turns another motor.
TurningJob random_job(std::size_t count, std::uint64_t seed) {
  TurningJob job;
  std::mt19937_64 random{seed};
  job.lines.push_back({.text = "G91G1G61.1F30000M3S0", .number = 1});
  for (std::size_t i = 0; i < count; ++i) {
    const int steps = std::uniform_int_distribution{1, 4}(random) * (random() % 2 == 0 ? 1 : -1);
    job.turns.push_back({.axis = i % 3, .steps = steps});
    std::string text = "G1F30000S";
    text += std::to_string(random() % 1000);
    text += "XYZ"[i % 3];
    text += std::to_string(0.004 * steps);
    job.lines.push_back({.text = text, .number = i + 2});
  }
  return job;
}

/// Returns a row of pixels of 0.1 mm, each with its power, in the shortest notation.
TurningJob raster_row(std::size_t pixels) {
  TurningJob job;
  job.lines = {{.text = "G91G1F6000M4", .number = 1}};
  for (std::size_t i = 0; i < pixels; ++i) {
    job.lines.push_back({.text = "X.1S" + std::to_string(100 + i * 37 % 900), .number = i + 2});
  }
  return job;
}

struct WireRate {
  double bytes_per_ms = 11.52;  ///< Rate of 115,200 baud.
  double bit_errors = 0.0;
  double drops = 0.0;
  std::uint64_t seed = 1;
};

/// An operator that resumes a held machine after a while: before lines are numbered, a damaged byte
/// may hold it. The operator also presses hold once, if the test sets a time for it.
struct Operator {
  milliseconds patience{1000};
  milliseconds hold_at{milliseconds::max()};

  void look(Sender& sender, milliseconds now) {
    if (now == hold_at) sender.hold();
    // A damaged report may contain a state that does not exist, so only these two states count.
    const bool goes = sender.machine_state() == "Run" || sender.machine_state() == "Idle";
    if (goes) since = now;
    if (now - since < patience) return;
    since = now;
    sender.resume();
  }

  milliseconds since{};
};

struct SendOutcome {
  Sender::State state{};
  std::string trouble;
  double seconds = 0.0;
  std::size_t injected = 0;
  std::size_t carried = 0;
  std::size_t resent = 0;
  double motion_seconds = 0.0;  ///< Time from the first step to the last, s.
  std::vector<MotorTurn> turns;
};

SendOutcome run(const TurningJob& job,
                const SendOptions& options,
                const WireRate& line,
                Operator human = {}) {
  WiredLink link;
  VirtualController controller{link, {}};
  for (const auto& [number, value] : {std::pair{32, 1.0F}, {11, 0.0F}, {0, 1.0F}}) {
    EXPECT_TRUE(
        controller.machine().change_setting(static_cast<std::uint16_t>(number), value).ok());
  }
  for (std::uint16_t axis = 0; axis < 3; ++axis) {
    for (const auto& [number, value] : {std::pair{110, 30'000.0F}, {120, 1.0e6F}}) {
      const auto each = static_cast<std::uint16_t>(number + axis);
      EXPECT_TRUE(controller.machine().change_setting(each, value).ok());
    }
  }
  TurnRecorder recorder;
  controller.add_sink(recorder);
  SerialWire there{line.bytes_per_ms, line.bit_errors, line.drops, 2 * line.seed};
  SerialWire back{line.bytes_per_ms, line.bit_errors, line.drops, 2 * line.seed + 1};
  Sender sender{job.lines, options, milliseconds{0}};
  milliseconds now{0};
  const auto most = milliseconds{static_cast<std::int64_t>(job.lines.size()) * 100 + 60'000};
  for (; !sender.over() && now < most; ++now) {
    while (!sender.output().empty() && there.room() > 0) {
      const std::string_view part = sender.output().substr(0, there.room());
      there.send(part);
      sender.wrote(part.size());
    }
    link.incoming += there.pass();
    controller.turn();
    back.send(link.outgoing);
    link.outgoing.clear();
    sender.receive(back.pass(), now);
    human.look(sender, now);
    sender.attend(now);
  }
  controller.end();
  return {.state = sender.state(),
          .trouble = sender.trouble(),
          .seconds = 1e-3 * static_cast<double>(now.count()),
          .injected = there.injected + back.injected,
          .carried = there.carried,
          .resent = sender.resent(),
          .motion_seconds = 1e-9 * static_cast<double>(recorder.last_ns - recorder.first_ns),
          .turns = std::move(recorder.turns)};
}

TEST(Sender, SendsPlainLinesToTheEnd) {
  const TurningJob job = random_job(2000, 1);
  const SendOutcome outcome = run(job, {}, {});
  EXPECT_EQ(outcome.state, Sender::State::kDone) << outcome.trouble;
  EXPECT_TRUE(outcome.turns == job.turns);
}

TEST(Sender, SendsCheckedLinesToTheEnd) {
  const TurningJob job = random_job(2000, 2);
  const SendOutcome outcome = run(job, {.checked = true}, {});
  EXPECT_EQ(outcome.state, Sender::State::kDone) << outcome.trouble;
  EXPECT_TRUE(outcome.turns == job.turns);
  EXPECT_EQ(outcome.resent, 0U);
}

/// Numbers have a greatest value, but a job may have more lines.
TEST(Sender, CountsAnewAfterTheGreatestNumber) {
  const TurningJob job = random_job(1000, 3);
  const SendOutcome outcome =
      run(job, {.checked = true, .max_number = 99}, {.bit_errors = 1e-4, .drops = 1e-4});
  EXPECT_EQ(outcome.state, Sender::State::kDone) << outcome.trouble;
  EXPECT_TRUE(outcome.turns == job.turns);
}

/// 115,200 baud are 11,520 bytes a second.
TEST(Sender, KeepsASerialLineFull) {
  for (const bool checked : {false, true}) {
    const TurningJob job = random_job(20'000, 4);
    const SendOutcome outcome = run(job, {.checked = checked}, {});
    const double share = static_cast<double>(outcome.carried) / (11'520.0 * outcome.seconds);
    std::printf("%s: %.1f %% of the line\n", checked ? "checked" : "plain", 100.0 * share);
    EXPECT_GE(share, 0.95) << checked;
  }
}

/// At 100 mm/s a pixel lasts a millisecond, in which the line transfers eleven bytes.
TEST(Sender, KeepsARasterAtSpeed) {
  constexpr std::size_t kPixels = 5000;
  const SendOutcome outcome = run(raster_row(kPixels), {}, {});
  EXPECT_EQ(outcome.state, Sender::State::kDone) << outcome.trouble;
  const double seconds = static_cast<double>(kPixels) * 1e-3;
  std::printf("%.3f s for %.3f s of pixels\n", outcome.motion_seconds, seconds);
  EXPECT_GT(outcome.motion_seconds, 0.999 * seconds);
  EXPECT_LT(outcome.motion_seconds, 1.005 * seconds);
}

/// Whatever happens to bytes in both directions, the complete job is executed, in its order.
TEST(Sender, CheckedLinesMoveRightOnADamagingLine) {
  constexpr std::size_t kLines = 20'000;
  std::size_t injected = 0;
  double clean_s = 0.0;
  double damaged_s = 0.0;
  double rounds = 0.0;
  for (const std::uint64_t seed : proof::Trials{8}) {
    const TurningJob job = random_job(kLines, seed);
    const WireRate line{.bit_errors = 1e-4, .drops = 1e-4, .seed = seed};
    const SendOutcome outcome = run(job, {.checked = true}, line);
    EXPECT_EQ(outcome.state, Sender::State::kDone) << outcome.trouble;
    EXPECT_TRUE(outcome.turns == job.turns);
    injected += outcome.injected;
    damaged_s += outcome.seconds;
    // Jobs differ little in length, so the first one represents all.
    if (clean_s == 0.0) clean_s = run(job, {.checked = true}, {}).seconds;
    ++rounds;
  }
  const double throughput = clean_s * rounds / damaged_s;
  std::printf("%zu errors, throughput %.3f of the clean line's\n", injected, throughput);
  EXPECT_GE(throughput, 0.8);
}

/// The same test with many more errors, so that several of them hit one line and its repetition.
TEST(Sender, CheckedLinesMoveRightOnATerribleLine) {
  std::size_t injected = 0;
  for (const std::uint64_t seed : proof::Trials{60}) {
    const TurningJob job = random_job(2000, seed);
    const WireRate line{.bit_errors = 1.5e-3, .drops = 1e-3, .seed = seed};
    const SendOutcome outcome = run(job, {.checked = true}, line);
    EXPECT_EQ(outcome.state, Sender::State::kDone) << outcome.trouble;
    EXPECT_TRUE(outcome.turns == job.turns);
    injected += outcome.injected;
  }
  std::printf("%zu errors\n", injected);
}

/// A machine on hold accepts no line. So no line may be repeated until the link of the machine is
/// full.
TEST(Sender, WaitsThroughALongHoldOnATerribleLine) {
  for (const std::uint64_t seed : proof::Trials{20}) {
    const TurningJob job = random_job(1000, seed);
    const WireRate line{.bit_errors = 1.5e-3, .drops = 1e-3, .seed = seed};
    const Operator human{.patience = milliseconds{90'000}, .hold_at = milliseconds{4000}};
    const SendOutcome outcome = run(job, {.checked = true}, line, human);
    EXPECT_EQ(outcome.state, Sender::State::kDone) << outcome.trouble;
    EXPECT_TRUE(outcome.turns == job.turns);
    EXPECT_GT(outcome.seconds, 80.0);
  }
}

}  // namespace
}  // namespace sim
