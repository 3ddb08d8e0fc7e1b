#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/machine_bench.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::MachineState;

constexpr double kStepsPerMm = 250.0;
/// Between two edges of one step, and of one dark pixel or less.
constexpr double kLongestStepMm = 0.02;
constexpr double kLongestPixelMm = 1.0;
constexpr double kAcceleration = 2000.0;  // mm/s²
constexpr double kJerk = 60'000.0;        // mm/s³
/// Left out or burnt twice at most, mm.
constexpr double kMostGap = 0.1;

/// A program by lines, all of them cut at up to 200 mm/s. Nowhere does a path come within 0.3 mm of
/// itself.
struct Job {
  const char* name;
  std::vector<std::string> lines;
};

std::string xy(double x, double y) { return " X" + std::to_string(x) + " Y" + std::to_string(y); }

/// Rounded corners, exact stops, and lines of all lengths.
Job corners() {
  Job job{"corners", {"G64 P0.05"}};
  double x = 0.0;
  for (int i = 0; i < 8; ++i) {
    const double step = 0.4 + 1.7 * (i % 4);
    job.lines.push_back("G1" + xy(x, i % 2 == 0 ? 9.0 : 0.0));
    x += step;
    job.lines.push_back("G1" + xy(x, i % 2 == 0 ? 9.0 : 0.0));
  }
  job.lines.emplace_back("G61");
  job.lines.push_back("G1" + xy(x + 30.0, -2.0));
  job.lines.push_back("G1" + xy(x + 31.0, 8.0));
  job.lines.push_back("G0" + xy(x + 33.0, 8.0));
  job.lines.push_back("G1" + xy(x + 33.0, -12.0));
  return job;
}

/// Arcs, a helix and a spline.
Job arcs() {
  return {"arcs",
          {"G2 X20 Y0 I10 J0",
           "G3 X36 Y0 I8 J0 Z1",
           "G1 X36 Y10",
           "G3 X30 Y16 I-6 J0",
           "G5 X10 Y30 I-12 J0 P12 Q0",
           "G2 X20 Y40 I10 J0",
           "G2 X20 Y40 I6 J0"}};
}

/// Chords that are welded, and such that are not.
Job chords() {
  Job job{"chords", {"G64 P0.05 Q0.02"}};
  for (int i = 1; i <= 120; ++i) {
    const double angle = 0.025 * i;
    job.lines.push_back("G1" + xy(12.0 * (1.0 - std::cos(angle)), 9.0 * std::sin(angle)));
  }
  job.lines.emplace_back("G64 P0.005 Q0");
  for (int i = 1; i <= 120; ++i) {
    job.lines.push_back("G1" + xy(24.0 + 0.15 * i, 0.6 + 1.5 * std::sin(0.05 * i)));
  }
  return job;
}

/// Rows of pixels there and back, some of them dark.
Job pixels() {
  Job job{"pixels", {}};
  constexpr int kPixels = 140;
  for (int row = 0; row < 3; ++row) {
    const bool there = row % 2 == 0;
    for (int i = 1; i <= kPixels; ++i) {
      const int power = i < 12 || i > kPixels - 12 ? 0 : 200 + (i * 37 + row * 11) % 700;
      const double x = 0.1 * (there ? i : kPixels - i);
      job.lines.push_back("G1" + xy(x, row) + " S" + std::to_string(i % 9 == 0 ? 0 : power));
    }
    job.lines.push_back("G1" + xy(there ? 0.1 * kPixels : 0.0, row + 1.0) + " S0");
  }
  return job;
}

/// Offset from a contour of lines and arcs.
Job offset() {
  return {"offset",
          {"G0 X20 Y6",
           "G41.1 D0.4 G1 X20 Y0",
           "G1 X30 Y0",
           "G3 X36 Y6 I0 J6",
           "G1 X36 Y20",
           "G1 X28 Y20",
           "G2 X22 Y26 I0 J6",
           "G1 X22 Y32",
           "G1 X10 Y32",
           "G1 X10 Y0",
           "G1 X20 Y0",
           "G40 G1 X20 Y5"}};
}

/// How a job is driven and interrupted.
struct Variant {
  const char* mode = "M3";
  bool pin = false;  ///< The door's input; else 0x84.
  bool jerk = false;
  bool parks = false;   ///< $41, on a machine that was homed.
  bool shaped = false;  ///< All axes alike.
};

const std::vector<Variant> kVariants{{"M3", true, false, false},
                                     {"M4", false, false, false},
                                     {"M3", false, true, true},
                                     {"M4", true, true, false},
                                     {"M4", false, true, false, true}};

struct Row {
  double x = 0.0;
  double y = 0.0;
  double duty = 0.0;
};

double distance(const Row& a, const Row& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// A bench that is fed as a sender feeds it, and all edges with the beam on.
class Cut : private sim::TraceSink {
 public:
  Cut(const Job& job, const Variant& variant) : job_{job}, jerk_{variant.jerk}, bench_{model()} {
    bench_.set({{32, 1}});
    for (int axis = 0; axis < 3; ++axis) {
      bench_.set({{110 + axis, 12'000}, {120 + axis, kAcceleration}});
      if (variant.jerk) bench_.set({{800 + axis, kJerk}});
      if (variant.shaped) bench_.set({{810 + axis, 2}, {820 + axis, 40}});
    }
    if (variant.parks) {
      bench_.set({{22, 1}, {24, 600}, {25, 6000}, {26, 5}, {27, 2}, {41, 1}, {58, -1}});
      bench_.home();
      bench_.send("G92 X0 Y0 Z0");
    }
    bench_.send("G21 G90 G17");
    bench_.send(std::string{variant.mode} + " S1000 F12000");
    bench_.controller.add_sink(*this);
    for (std::size_t axis = 0; axis < 2; ++axis) from_[axis] = bench_.motor(axis);
  }

  /// False when all is driven.
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
  /// Opens the door, waits for standstill, closes it and goes on until the job does.
  void pass_door(bool pin) {
    cnc::Machine& machine = bench_.machine();
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
    std::vector<Row> back;
    for (int left = 3000; machine.state() == MachineState::kDoor && left > 0; --left) {
      bench_.run(1);
      back.push_back({bench_.motor(0) / kStepsPerMm, bench_.motor(1) / kStepsPerMm, 0.0});
    }
    judge_limits(back);
    EXPECT_EQ(burnt.size(), lit) << "lit behind the door";
    EXPECT_NE(machine.state(), MachineState::kHold) << "the path is not known";
    EXPECT_EQ(machine.take_uncut(), nullptr);
  }

  MachineBench& bench() { return bench_; }
  std::vector<Row> burnt;

 private:
  /// Mean acceleration and jerk of an axis over 10 ms, of which a step makes 40 mm/s² and 4,000
  /// mm/s³.
  void judge_limits(const std::vector<Row>& ms) const {
    constexpr std::size_t kApart = 10;
    constexpr double kSeconds = 0.001 * kApart;
    for (std::size_t i = 3 * kApart; i < ms.size(); ++i) {
      const Row &d = ms[i], &c = ms[i - kApart], &b = ms[i - 2 * kApart], &a = ms[i - 3 * kApart];
      for (const double change : {d.x - 2.0 * c.x + b.x, d.y - 2.0 * c.y + b.y}) {
        EXPECT_LE(std::abs(change) / (kSeconds * kSeconds), kAcceleration + 120.0);
      }
      if (!jerk_) continue;
      for (const double change :
           {d.x - 3.0 * c.x + 3.0 * b.x - a.x, d.y - 3.0 * c.y + 3.0 * b.y - a.y}) {
        EXPECT_LE(std::abs(change) / (kSeconds * kSeconds * kSeconds), kJerk + 24'000.0);
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
    burnt.push_back({(row.position[0] - from_[0]) / kStepsPerMm,
                     (row.position[1] - from_[1]) / kStepsPerMm,
                     static_cast<double>(row.duty)});
  }

  const Job& job_;
  bool jerk_;
  MachineBench bench_;
  std::array<std::int32_t, 2> from_{};
  std::size_t next_ = 0;
};

/// The same job without a door.
struct Whole {
  Whole(const Job& job, const Variant& variant) {
    Cut cut{job, variant};
    while (cut.turn()) ++duration_ms;
    rows = cut.burnt;
    ways.assign(rows.size(), 0.0);
    lit.assign(rows.size(), 0.0);
    for (std::size_t i = 1; i < rows.size(); ++i) {
      const double way = distance(rows[i - 1], rows[i]);
      ways[i] = ways[i - 1] + (way < kLongestPixelMm ? way : 0.0);
      lit[i] = lit[i - 1] + (way < kLongestStepMm ? way : 0.0);
    }
  }

  /// The row nearest to a place, of those up to so many mm of path around `near`.
  [[nodiscard]] std::size_t nearest(const Row& place, std::size_t near, double reach_mm) const {
    std::size_t best = near;
    for (std::size_t i = near; i-- > 0 && ways[near] - ways[i] < reach_mm;) {
      if (distance(rows[i], place) < distance(rows[best], place)) best = i;
    }
    for (std::size_t i = near; i < rows.size() && ways[i] - ways[near] < reach_mm; ++i) {
      if (distance(rows[i], place) < distance(rows[best], place)) best = i;
    }
    return best;
  }
  /// Whether any row within 0.03 mm of path has this output.
  [[nodiscard]] bool burns_so(std::size_t row, double duty) const {
    for (std::size_t i = row; i < rows.size() && ways[i] - ways[row] < 0.03; ++i) {
      if (std::abs(rows[i].duty - duty) < 1.0e-4) return true;
    }
    for (std::size_t i = row; i-- > 0 && ways[row] - ways[i] < 0.03;) {
      if (std::abs(rows[i].duty - duty) < 1.0e-4) return true;
    }
    return false;
  }

  int duration_ms = 0;
  std::vector<Row> rows;
  std::vector<double> ways;  ///< mm from the start, without rapids.
  std::vector<double> lit;   ///< The same, without dark pixels.
};

/// Both 0 if nothing is missing and nothing burnt twice.
struct Gap {
  double twice_mm = 0.0;
  double left_mm = 0.0;
  double beside_mm = 0.0;
};

/// Compares what was burnt with the whole, of which the first `before` rows are the same.
Gap judge(const Whole& whole, const std::vector<Row>& burnt, std::size_t before, bool same_power) {
  Gap gap;
  if (before >= burnt.size()) {
    if (before > 0) gap.left_mm = whole.lit.back() - whole.lit[before - 1];
    return gap;
  }
  const std::size_t came_to = before == 0 ? 0 : before - 1;
  std::size_t at = whole.nearest(burnt[before], came_to, 2.0);
  gap.twice_mm = std::max(0.0, whole.lit[came_to] - whole.lit[at]);
  std::size_t covered = came_to;
  int other_power = 0;
  for (std::size_t i = before; i < burnt.size(); ++i) {
    at = whole.nearest(burnt[i], at, 0.6);
    gap.beside_mm = std::max(gap.beside_mm, distance(whole.rows[at], burnt[i]));
    gap.left_mm = std::max(gap.left_mm, whole.lit[at] - whole.lit[covered]);
    covered = std::max(covered, at);
    if (same_power && !whole.burns_so(at, burnt[i].duty)) ++other_power;
  }
  gap.left_mm = std::max(gap.left_mm, whole.lit.back() - whole.lit[covered]);
  EXPECT_EQ(other_power, 0);
  return gap;
}

class DoorGap : public testing::TestWithParam<Job> {};

/// The door is opened at every hundredth of a second of each job, in each variant; or at an even
/// share of these instants, where not all trials are wanted.
TEST_P(DoorGap, IsCutWhenTheJobGoesOn) {
  const Job& job = GetParam();
  std::vector<Whole> wholes;
  std::vector<std::pair<std::size_t, int>> doors;
  for (std::size_t variant = 0; variant < kVariants.size(); ++variant) {
    wholes.emplace_back(job, kVariants[variant]);
    ASSERT_FALSE(wholes.back().rows.empty());
    for (int ms = 0; ms < wholes.back().duration_ms; ms += 10) doors.emplace_back(variant, ms);
  }
  const std::size_t count = std::min<std::size_t>(doors.size(), trials_wanted(60));
  Gap worst;
  std::size_t gone_back = 0;
  for (std::size_t i = 0; i < count && !too_many_failures(); ++i) {
    const auto& [index, after_ms] = doors[i * doors.size() / count];
    const Variant& variant = kVariants[index];
    SCOPED_TRACE(std::string{job.name} + ", " + variant.mode + (variant.pin ? ", pin" : ", 0x84") +
                 (variant.jerk ? ", jerk" : "") + (variant.parks ? ", parking" : "") +
                 (variant.shaped ? ", shaped" : "") + ", after " +
                 std::to_string(after_ms) + " ms");
    Cut cut{job, variant};
    for (int ms = 0; ms < after_ms; ++ms) static_cast<void>(cut.turn());
    cut.pass_door(variant.pin);
    const std::size_t before = cut.burnt.size();
    cut.run_to_end();
    EXPECT_EQ(cut.bench().machine().alarm(), cnc::Alarm::kNone);
    const bool same_power = std::string{variant.mode} == "M3";
    const Gap gap = judge(wholes[index], cut.burnt, before, same_power);
    gone_back += before < cut.burnt.size() ? 1 : 0;
    // A shaped motion leaves its path by its speed, which is another one after a stop.
    EXPECT_LE(gap.twice_mm, variant.shaped ? 1.5 * kMostGap : kMostGap);
    EXPECT_LE(gap.left_mm, variant.shaped ? 1.5 * kMostGap : kMostGap);
    EXPECT_LE(gap.beside_mm, variant.shaped ? 0.1 : 0.03);
    if (variant.shaped) continue;
    worst.twice_mm = std::max(worst.twice_mm, gap.twice_mm);
    worst.left_mm = std::max(worst.left_mm, gap.left_mm);
    worst.beside_mm = std::max(worst.beside_mm, gap.beside_mm);
  }
  std::printf("%s: %zu doors, %zu with light after them; %.4f mm twice, %.4f left, %.4f beside\n",
              job.name,
              count,
              gone_back,
              worst.twice_mm,
              worst.left_mm,
              worst.beside_mm);
  EXPECT_GT(gone_back, count / 2);
}

INSTANTIATE_TEST_SUITE_P(All,
                         DoorGap,
                         testing::Values(corners(), arcs(), chords(), pixels(), offset()),
                         [](const testing::TestParamInfo<Job>& job) { return job.param.name; });

}  // namespace
}  // namespace proof
