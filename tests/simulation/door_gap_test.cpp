#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host-sim/machine/play_model.hpp"
#include "host-sim/measure/tool_trace.hpp"
#include "tests/simulation/burnt_path.hpp"
#include "tests/simulation/door_jobs.hpp"
#include "tests/support/machine_bench.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::MachineState;

constexpr double kDoorStepsPerMm = 250.0;
constexpr double kDoorAcceleration = 2000.0;  // mm/s²
constexpr double kDoorJerk = 60'000.0;        // mm/s³
/// Greatest length that is left out or burnt twice, mm.
constexpr double kMaxGap = 0.1;
/// Returns the greatest distance of an axis from its plan that a shaper with three impulses causes
/// at the greatest acceleration, mm. The variance of the impulses is (1 / 2f)² / 2, and the plan
/// differs from its mean by a/2 times the variance.
constexpr double displaced_mm(double hertz) { return kDoorAcceleration / (16.0 * hertz * hertz); }
/// Returns the gap with a shaper, mm: the old burn ends displaced, and the new one begins on the
/// plan from rest, in both directions.
constexpr double shaped_gap(double hertz) { return kMaxGap + 2.0 * displaced_mm(hertz); }

/// Variant of machine and interruption.
struct Variant {
  const char* name;
  const char* mode = "M3";
  bool pin = false;  ///< Opens the door by its input; otherwise by byte 0x84.
  bool jerk = false;
  bool homed = false;  ///< The machine is homed and has $41=1, but a beam is never parked.
  bool held = false;   ///< A feed hold comes shortly before the door.
  std::vector<std::pair<int, double>> settings{};
  double max_gap = kMaxGap;
  double max_beside = 0.03;
};

const std::vector<Variant> kVariants{
    {.name = "plain", .pin = true},
    {.name = "by speed", .mode = "M4"},
    {.name = "jerk, homed", .jerk = true, .homed = true},
    {.name = "jerk, homed, by speed", .mode = "M4", .pin = true, .jerk = true, .homed = true},
    {.name = "held before", .held = true},
    // Where an axis reverses, half of its play lies on either side of the path until it is taken
    // up.
    {.name = "backlash",
     .settings = {{160, 0.05}, {161, 0.03}},
     .max_beside = 0.03 + std::hypot(0.5 * 0.05, 0.5 * 0.03)},
    {.name = "beam delays", .settings = {{855, 400}, {856, 300}, {857, -500}}},
    {.name = "shapers alike",
     .mode = "M4",
     .jerk = true,
     .settings = {{810, 2}, {811, 2}, {812, 2}, {820, 40}, {821, 40}, {822, 40}},
     .max_gap = 0.15,
     .max_beside = 0.15},
    {.name = "shapers that differ",
     .settings = {{810, 2}, {811, 1}, {820, 40}, {821, 40}},
     .max_gap = shaped_gap(40.0),
     .max_beside = shaped_gap(40.0)},
    {.name = "one shaper",
     .settings = {{810, 2}, {820, 20}},
     .max_gap = shaped_gap(20.0),
     .max_beside = shaped_gap(20.0)}};

/// A bench that receives lines as from a sender, and stores all edges with the beam on.
class Cut : private sim::TraceSink {
 public:
  Cut(const DoorJob& job, const Variant& variant)
      : job_{job}, jerk_{variant.jerk}, bench_{model()} {
    bench_.set({{32, 1}});
    for (int axis = 0; axis < 3; ++axis) {
      bench_.set({{110 + axis, 12'000}, {120 + axis, kDoorAcceleration}});
      if (variant.jerk) bench_.set({{800 + axis, kDoorJerk}});
    }
    bench_.set(variant.settings);
    if (variant.homed) {
      bench_.set({{22, 1}, {24, 600}, {25, 6000}, {26, 5}, {27, 2}, {41, 1}, {58, -1}});
      bench_.home();
      bench_.send("G92 X0 Y0 Z0");
    }
    bench_.send("G21 G90 G17");
    bench_.send(std::string{variant.mode} + " S1000 F12000");
    sim::PlayModel play{model()};
    play.place(bench_.machine().settings());
    tool_.emplace(play);
    tool_->add_sink(*this);
    bench_.controller.add_sink(*tool_);
    for (std::size_t axis = 0; axis < 2; ++axis) from_[axis] = bench_.motor(axis);
  }

  /// Runs one cycle. Returns false when the whole job has been driven.
  bool turn() {
    cnc::Machine& machine = bench_.machine();
    while (next_ < job_.lines.size() && !machine.busy() && !machine.locked()) {
      EXPECT_FALSE(machine.accept(job_.lines[next_]).has_value()) << job_.lines[next_];
      ++next_;
    }
    bench_.run(1);
    return next_ < job_.lines.size() || machine.busy() || !machine.idle();
  }
  void run_to_end() {
    int left = 60'000;
    while (turn() && left > 0) --left;
    EXPECT_GT(left, 0) << "the machine hangs";
  }
  /// Opens the door, waits for standstill, closes it, and resumes until the job goes on.
  void pass_door(bool pin, bool held) {
    cnc::Machine& machine = bench_.machine();
    if (held) {
      machine.feed_hold();
      bench_.run(15);
    }
    if (pin) {
      bench_.controller.panel().door = true;
    } else {
      machine.safety_door();
    }
    bench_.run(30);
    const std::size_t lit = burnt.size();
    for (int left = 3000; machine.status().substate == 2 && left > 0; --left) bench_.run(1);
    bench_.controller.panel().door = false;
    bench_.run(30);
    ASSERT_EQ(machine.state(), MachineState::kDoor);
    ASSERT_EQ(machine.status().substate, 0);
    machine.resume();
    std::vector<Burnt> back;
    for (int left = 3000; machine.state() == MachineState::kDoor && left > 0; --left) {
      bench_.run(1);
      back.push_back({bench_.motor(0) / kDoorStepsPerMm, bench_.motor(1) / kDoorStepsPerMm, 0.0});
    }
    judge_limits(back);
    EXPECT_EQ(burnt.size(), lit) << "lit behind the door";
    EXPECT_NE(machine.state(), MachineState::kHold) << "the path is not known";
    EXPECT_EQ(machine.take_uncut(), nullptr);
  }

  MachineBench& bench() { return bench_; }
  std::vector<Burnt> burnt;

 private:
  /// Checks mean acceleration and jerk of an axis over 10 ms. A single step changes these means by
  /// 40 mm/s² and 4,000 mm/s³.
  void judge_limits(const std::vector<Burnt>& ms) const {
    constexpr std::size_t kApart = 10;
    constexpr double kSeconds = 0.001 * kApart;
    for (std::size_t i = 3 * kApart; i < ms.size(); ++i) {
      const Burnt &d = ms[i], &c = ms[i - kApart], &b = ms[i - 2 * kApart], &a = ms[i - 3 * kApart];
      for (const double change : {d.x - 2.0 * c.x + b.x, d.y - 2.0 * c.y + b.y}) {
        EXPECT_LE(std::abs(change) / (kSeconds * kSeconds), kDoorAcceleration + 120.0);
      }
      if (!jerk_) continue;
      for (const double change :
           {d.x - 3.0 * c.x + 3.0 * b.x - a.x, d.y - 3.0 * c.y + 3.0 * b.y - a.y}) {
        EXPECT_LE(std::abs(change) / (kSeconds * kSeconds * kSeconds), kDoorJerk + 24'000.0);
      }
    }
  }

  static sim::MachineModel model() {
    sim::MachineModel model;
    model.switch_mm = {12.0, 7.0, 3.0, {}, {}, {}};
    return model;
  }

  void on_row(const sim::TraceRow& row) override {
    if (row.duty <= 0.0F) return;
    burnt.push_back({(row.position[0] - from_[0]) / kDoorStepsPerMm,
                     (row.position[1] - from_[1]) / kDoorStepsPerMm,
                     static_cast<double>(row.duty)});
  }

  const DoorJob& job_;
  bool jerk_;
  MachineBench bench_;
  /// Simulates the position of the tool, which lags the motors by the play.
  std::optional<sim::ToolTrace> tool_;
  std::array<std::int32_t, 2> from_{};
  std::size_t next_ = 0;
};

class DoorGap : public testing::TestWithParam<DoorJob> {};

/// Opens the door at every hundredth of a second of each job in each variant. With fewer trials, it
/// opens at an even share of these times.
TEST_P(DoorGap, IsCutWhenTheJobGoesOn) {
  const DoorJob& job = GetParam();
  std::vector<BurntPath> wholes;
  std::vector<std::pair<std::size_t, int>> doors;
  for (std::size_t variant = 0; variant < kVariants.size(); ++variant) {
    Cut whole{job, kVariants[variant]};
    for (int ms = 0; whole.turn(); ++ms) {
      if (ms % 10 == 0) doors.emplace_back(variant, ms);
    }
    wholes.emplace_back(std::move(whole.burnt));
    ASSERT_FALSE(wholes.back().empty());
  }
  const std::size_t count = std::min<std::size_t>(doors.size(), trials_wanted(60));
  std::vector<BurntPath::Gap> worst(kVariants.size());
  std::size_t gone_back = 0;
  for (std::size_t i = 0; i < count && !too_many_failures(); ++i) {
    const auto& [index, after_ms] = doors[i * doors.size() / count];
    const Variant& variant = kVariants[index];
    SCOPED_TRACE(std::string{job.name} + ", " + variant.name + ", after " +
                 std::to_string(after_ms) + " ms");
    Cut cut{job, variant};
    for (int ms = 0; ms < after_ms; ++ms) static_cast<void>(cut.turn());
    cut.pass_door(variant.pin, variant.held);
    const std::size_t before = cut.burnt.size();
    cut.run_to_end();
    EXPECT_EQ(cut.bench().machine().alarm(), cnc::Alarm::kNone);
    const BurntPath::Gap gap = wholes[index].judge(cut.burnt, before);
    // Beam delays and play shift the powers along the motors' path.
    const bool same_power = std::string{variant.mode} == "M3" && variant.settings.empty();
    EXPECT_TRUE(gap.other_power == 0 || !same_power);
    gone_back += before < cut.burnt.size() ? 1 : 0;
    EXPECT_LE(gap.twice_mm, variant.max_gap);
    EXPECT_LE(gap.left_mm, variant.max_gap);
    EXPECT_LE(gap.beside_mm, variant.max_beside);
    worst[index].twice_mm = std::max(worst[index].twice_mm, gap.twice_mm);
    worst[index].left_mm = std::max(worst[index].left_mm, gap.left_mm);
    worst[index].beside_mm = std::max(worst[index].beside_mm, gap.beside_mm);
  }
  std::printf("%s: %zu doors, %zu with light after them\n", job.name, count, gone_back);
  for (std::size_t index = 0; index < kVariants.size(); ++index) {
    std::printf("  %s: %.4f mm twice, %.4f left, %.4f offset\n",
                kVariants[index].name,
                worst[index].twice_mm,
                worst[index].left_mm,
                worst[index].beside_mm);
  }
  EXPECT_GT(gone_back, count / 2);
}

INSTANTIATE_TEST_SUITE_P(All,
                         DoorGap,
                         testing::ValuesIn(door_jobs()),
                         [](const testing::TestParamInfo<DoorJob>& job) { return job.param.name; });

}  // namespace
}  // namespace proof
