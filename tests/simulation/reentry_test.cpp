#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/laser_bench.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::Alarm;
using cnc::MachineState;

struct Place {
  double x = 0.0;
  double y = 0.0;
};

double distance(const Place& a, const Place& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// A line of a program, and the position of the tool before it.
struct Line {
  std::string words;
  Place start;
};

/// Returns lines, a closed circle, a circle of several turns, chords that are welded, corners that
/// are rounded, and a row of pixels. The path never comes within 0.3 mm of itself, except where it
/// closes.
std::vector<Line> program() {
  std::vector<Line> lines;
  Place at{-40.0, -20.0};
  const auto add = [&](const std::string& words, const Place& end) {
    lines.push_back({words, at});
    at = end;
  };
  const auto to = [&](const char* code, double x, double y, const std::string& more = "") {
    add(std::string{code} + " X" + std::to_string(x) + " Y" + std::to_string(y) + more, {x, y});
  };
  to("G1", -30.0, -20.0);
  to("G1", -30.0, -14.0);
  to("G2", -30.0, -14.0, " I4 J0");
  to("G1", -31.0, -6.0);
  for (int i = 1; i <= 80; ++i) {
    const double angle = 0.02 * i;
    to("G1", -31.0 + 12.0 * (1.0 - std::cos(angle)), -6.0 + 2.0 * std::sin(angle));
  }
  to("G0", -15.0, -10.0);
  for (int i = 1; i <= 60; ++i) to("G1", -15.0 + 0.1 * i, -10.0, i % 2 == 0 ? " S300" : " S900");
  to("G3", -5.0, -14.0, " I0 J-4 S800");
  to("G1", -5.0, -2.0);
  return lines;
}

/// Records a point for each step with the beam on, and the last time at which it was on.
class Burn : private sim::TraceSink {
 public:
  explicit Burn(MachineBench& bench) : bench_{bench} { bench.controller.add_sink(*this); }

  std::vector<Place> places;
  std::uint64_t last_light_ns = 0;

 private:
  void on_row(const sim::TraceRow& row) override {
    if (row.duty <= 0.0F) return;
    const double per_step = 1.0 / LaserBench::kStepsPerMm;
    places.push_back({row.position[0] * per_step, row.position[1] * per_step});
    last_light_ns = row.time_ns;
  }

  MachineBench& bench_;
};

/// A bench that receives each line as soon as the machine accepts it, as from a sender.
class InterruptedJob {
 public:
  InterruptedJob() : lines_{program()} {
    bench_.set({{120, 2000}, {121, 2000}, {110, 12000}, {111, 12000}});
    begin(0);
  }

  /// Begins at the start of a line, with the modes that apply there.
  void begin(std::size_t line) {
    const Place& start = lines_[line].start;
    bench_.send("G21 G90 M5");
    bench_.send("G0 X" + std::to_string(start.x) + " Y" + std::to_string(start.y));
    bench_.send("G1 F6000 M4 S800");
    next_ = line;
  }
  /// Runs one cycle. Returns false when the whole job has been driven.
  bool turn() {
    cnc::Machine& machine = bench_.machine();
    while (next_ < lines_.size() && !machine.busy() && !machine.locked()) {
      const std::string words = "N" + std::to_string(next_ + 1) + lines_[next_].words;
      EXPECT_FALSE(machine.accept(words).has_value()) << words;
      ++next_;
    }
    bench_.run(1);
    return next_ < lines_.size() || machine.busy() || !machine.idle();
  }
  void run_to_end() {
    for (int left = 60'000; turn() && left > 0; --left) {
    }
  }

  LaserBench& bench() { return bench_; }

 private:
  std::vector<Line> lines_;
  LaserBench bench_;
  std::size_t next_ = 0;
};

/// Returns the distance from the start of a burn to each of its points, mm, without rapids.
std::vector<double> ways_of(const std::vector<Place>& places) {
  std::vector<double> ways(places.size(), 0.0);
  for (std::size_t i = 1; i < places.size(); ++i) {
    const double way = distance(places[i - 1], places[i]);
    ways[i] = ways[i - 1] + (way < 1.0 ? way : 0.0);
  }
  return ways;
}

class Reentry : public testing::Test {
 protected:
  Reentry() {
    InterruptedJob job;
    Burn burn{job.bench()};
    for (duration_ms = 0; job.turn(); ++duration_ms) {
    }
    whole = burn.places;
    ways = ways_of(whole);
  }

  /// Returns the distance along the complete burn at which a point lies; `way` is its approximate
  /// value.
  [[nodiscard]] double way_of(const Place& place, double way) const {
    double best = 1.0e9;
    double found = 0.0;
    for (std::size_t i = 0; i < whole.size(); ++i) {
      if (std::abs(ways[i] - way) > 2.0) continue;
      const double off = distance(whole[i], place);
      if (off < best) {
        best = off;
        found = ways[i];
      }
    }
    EXPECT_LT(best, 0.03) << "beside the path";
    return found;
  }

  std::vector<Place> whole;
  std::vector<double> ways;
  int duration_ms = 0;
};

/// Result of an interrupted job and of its continuation.
struct Outcome {
  double dark_after_ms = 0.0;
  double twice_mm = 0.0;  ///< Length that is burnt twice, mm; negative if it is left out.
};

/// The sender is lost at every hundredth of a second of a job. The beam must be off within a
/// millisecond, and when the job is resumed the part must become complete.
TEST_F(Reentry, CompletesAPartWhoseSenderWasLostAtEveryHundredthOfASecond) {
  double worst_dark_ms = 0.0;
  double max_twice_mm = -1.0;
  double max_left_mm = -1.0;
  int taken_up = 0;
  for (int after = 0; after < duration_ms; after += 10) {
    SCOPED_TRACE(after);
    InterruptedJob job;
    Burn before{job.bench()};
    for (int ms = 0; ms < after; ++ms) static_cast<void>(job.turn());
    cnc::Machine& machine = job.bench().machine();
    const std::uint64_t lost_ns =
        job.bench().controller.now_ticks() * sim::VirtualController::kNanosecondsPerTick;
    job.bench().controller.firmware().lose_sender();
    for (int left = 3000; !machine.motion().at_rest() && left > 0; --left) job.bench().run(1);
    job.bench().run(50);
    const std::size_t burnt = before.places.size();
    if (before.last_light_ns > lost_ns) {
      worst_dark_ms =
          std::max(worst_dark_ms, 1.0e-6 * static_cast<double>(before.last_light_ns - lost_ns));
    }
    machine.reset();
    job.bench().run(20);
    ASSERT_EQ(machine.state(), MachineState::kIdle);
    EXPECT_EQ(machine.interpreter().position(), machine.motion().tool_place());
    if (!machine.progress().noted().any()) {
      EXPECT_EQ(burnt, 0U);
      continue;
    }
    ASSERT_TRUE(machine.progress().can_reenter(machine.homed()));
    machine.reenter();
    const std::size_t line = machine.progress().noted().line.number;
    const cnc::Position noted = machine.motion().place_of(machine.progress().noted().steps);
    const Place place{1.0e-6 * static_cast<double>(noted[0].nanometres()),
                      1.0e-6 * static_cast<double>(noted[1].nanometres())};
    job.begin(line - 1);
    job.run_to_end();
    EXPECT_EQ(machine.alarm(), Alarm::kNone);
    EXPECT_FALSE(machine.progress().reentry().active());
    EXPECT_EQ(machine.state(), MachineState::kIdle);
    ++taken_up;
    if (burnt == 0 || burnt >= whole.size()) continue;
    if (before.places.size() == burnt) {
      max_left_mm = std::max(max_left_mm, ways.back() - ways[burnt - 1]);
      continue;
    }
    const double came_to = ways[burnt - 1];
    const double twice = came_to - way_of(before.places[burnt], came_to);
    EXPECT_LT(twice, 0.06) << "taken up in line " << line << " at " << place.x << "," << place.y
                           << ", lit from " << before.places[burnt].x << ","
                           << before.places[burnt].y << " on";
    max_twice_mm = std::max(max_twice_mm, twice);
    max_left_mm = std::max(max_left_mm, -twice);
    EXPECT_LT(distance(before.places.back(), whole.back()), 0.01);
  }
  std::printf("%d of %d ms taken up %d times: dark after %.3f ms, %.3f mm burnt twice, %.3f left\n",
              duration_ms,
              duration_ms,
              taken_up,
              worst_dark_ms,
              max_twice_mm,
              max_left_mm);
  EXPECT_GT(taken_up, duration_ms / 15);
  EXPECT_LE(worst_dark_ms, 1.0);
  // Both limits allow for the ends of elements that are near enough, and for steps.
  EXPECT_LE(max_twice_mm, 0.06);
  EXPECT_LE(max_left_mm, 0.02);
}

}  // namespace
}  // namespace proof
