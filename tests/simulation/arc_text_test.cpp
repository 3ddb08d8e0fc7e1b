#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "host-sim/machine/simulator.hpp"
#include "host-sim/measure/path_deviation.hpp"
#include "tests/support/exact_block.hpp"
#include "tests/support/program_text.hpp"
#include "tests/support/random_arc.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

/// Returns a program that consists of the arc alone, starting at zero.
std::string text_of(const cnc::CentreArc& arc, double feed_mm_min) {
  constexpr std::array kPlaneWords{"G17", "G18", "G19"};
  const cnc::PlaneAxes axes = cnc::axes_of(arc.plane);
  const Vector end = to_mm(arc.end);
  std::string text = "G21 G90 G94 ";
  text += kPlaneWords[static_cast<std::size_t>(arc.plane)];
  text += word('F', feed_mm_min) + (arc.clockwise ? "\nG2" : "\nG3");
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const bool round = axis == axes.first || axis == axes.second;
    if (round || end[axis] != 0.0) text += word(cnc::kAxisLetters[axis], end[axis]);
  }
  text += word("IJK"[axes.first], static_cast<double>(arc.centre[0].nanometres()) * 1.0e-6);
  text += word("IJK"[axes.second], static_cast<double>(arc.centre[1].nanometres()) * 1.0e-6);
  if (arc.turns > 1) text += " P" + std::to_string(arc.turns);
  return text + "\nM2\n";
}

cnc::AxisArray<double> set_up(sim::Simulator& simulator, const cnc::motion::Limits& limits) {
  cnc::AxisArray<double> scales{};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const float scale = limits.scale[axis].steps_per_mm();
    change(simulator, cnc::setting::kStepsPerMm + axis, static_cast<double>(scale));
    change(
        simulator, cnc::setting::kRate + axis, static_cast<double>(60.0F * limits.rate_mm_s[axis]));
    change(simulator,
           cnc::setting::kAcceleration + axis,
           static_cast<double>(limits.acceleration_mm_s2[axis]));
    scales[axis] = static_cast<double>(scale);
  }
  return scales;
}

struct TextSummary {
  double excess = 0.0;  ///< Greatest distance beyond half a step, mm.
  std::size_t arcs = 0;
};

void try_text(std::uint64_t seed, TextSummary& summary) {
  Random random{seed};
  const TestArc arc = random_arc(random);
  const TestMachine machine = machine_for(random, arc, 2.0e3);
  const double feed = 60.0 * std::max(1.0, arc.exact.length()) * random.magnitude(0.3, 100.0);
  const std::string text = text_of(arc.arc, feed);
  SCOPED_TRACE(text);
  sim::Simulator simulator{text, {}};
  const auto scales = set_up(simulator, machine.limits);
  const sim::ProgrammedPath path = sim::read_program(text);
  sim::PathDeviation deviation{path, scales};
  deviation.on_row({});
  simulator.add_sink(deviation);
  const sim::RunResult result = simulator.run();
  for (const auto& refusal : result.refusals) ADD_FAILURE() << refusal.reason;
  EXPECT_EQ(result.alarm, 0);
  EXPECT_EQ(result.blocks, arc.elements()) << "sweep " << arc.sweep;
  EXPECT_LE(deviation.greatest_axis_excess().value, kArcPromise) << "R " << arc.radius;
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const double steps = static_cast<double>(result.final_position[axis]);
    EXPECT_LE(std::abs(steps - path.end[axis] * scales[axis]), 0.501) << "axis " << axis;
  }
  summary.excess = std::max(summary.excess, deviation.greatest_axis_excess().value);
  ++summary.arcs;
}

// Issue 2, acceptance 2, tested from the text of the program on.
TEST(RandomArcTexts, ArePulsedOnTheExactCurveInOneBlockPerHalfTurn) {
  const Trials trials{300};
  TextSummary summary;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    try_text(seed, summary);
  }
  std::printf("arcs as text: %zu, greatest distance beyond half a step %.3f um\n",
              summary.arcs,
              summary.excess * 1.0e3);
}

/// A time at which the angle on a known circle is known exactly.
struct AngleFix {
  double time_s = 0.0;
  double angle = 0.0;  ///< Angle, radians, from −π to π.
};

/// Measures the angle on a circle over time. An ideal motor steps when the path crosses a half
/// step, so an edge of the axis that moves faster gives the angle without quantisation.
class CircleTimer final : public sim::TraceSink {
 public:
  CircleTimer(std::array<double, 2> centre, double radius, double steps_per_mm)
      : centre_{centre}, radius_{radius}, scale_{steps_per_mm} {}

  void on_row(const sim::TraceRow& row) override {
    const std::array at{offset(0, row.position[0]), offset(1, row.position[1])};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (row.position[axis] == last_[axis]) continue;
      const double across = (offset(axis, row.position[axis]) + offset(axis, last_[axis])) / 2.0;
      if (std::abs(across) < 0.6 * radius_) note(row.time_ns, axis, across, at[1 - axis]);
    }
    last_ = row.position;
  }

  /// Returns the greatest part of v²/R on one axis, mm/s², over windows of `window_s`. `from` and
  /// `to` are shares of the motion's time.
  [[nodiscard]] double greatest_centripetal(double from, double to, double window_s) const {
    double greatest = 0.0;
    const double end = fixes_.back().time_s;
    std::size_t first = 0;
    for (const AngleFix& last : fixes_) {
      if (last.time_s < from * end + window_s || last.time_s > to * end) continue;
      while (fixes_[first + 1].time_s <= last.time_s - window_s) ++first;
      const double turned =
          std::remainder(last.angle - fixes_[first].angle, 2.0 * std::numbers::pi);
      const double speed = radius_ * turned / (last.time_s - fixes_[first].time_s);
      const double middle = fixes_[first].angle + 0.5 * turned;
      const double share = std::max(std::abs(std::cos(middle)), std::abs(std::sin(middle)));
      greatest = std::max(greatest, speed * speed / radius_ * share);
    }
    return greatest;
  }

 private:
  [[nodiscard]] double offset(std::size_t axis, std::int32_t steps) const {
    return static_cast<double>(steps) / scale_ - centre_[axis];
  }
  void note(std::uint64_t time_ns, std::size_t axis, double across, double other) {
    const double exact = std::copysign(std::sqrt(radius_ * radius_ - across * across), other);
    const double angle = axis == 0 ? std::atan2(exact, across) : std::atan2(across, exact);
    fixes_.push_back({static_cast<double>(time_ns) * 1.0e-9, angle});
  }

  std::array<double, 2> centre_;
  double radius_;
  double scale_;
  cnc::AxisArray<std::int32_t> last_{};
  std::vector<AngleFix> fixes_;
};

TEST(FullCircle, OfRadius20IsTwoBlocksAtTheCentripetalLimit) {
  constexpr float kLimit = 500.0F;
  constexpr float kScale = 160.0F;
  sim::Simulator simulator{"G21 G90 G17\nG2 X0 Y0 I20 J0 F12000\nM2\n", {}};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    change(simulator, cnc::setting::kStepsPerMm + axis, static_cast<double>(kScale));
    change(simulator, cnc::setting::kRate + axis, 12'000.0);
    change(simulator, cnc::setting::kAcceleration + axis, static_cast<double>(kLimit));
  }
  CircleTimer timer{{20.0, 0.0}, 20.0, static_cast<double>(kScale)};
  simulator.add_sink(timer);
  const sim::RunResult result = simulator.run();
  EXPECT_EQ(result.blocks, 2U);
  // The windows lie in the cruise; each ramp is shorter than a third of the motion.
  const double share = timer.greatest_centripetal(0.35, 0.65, 0.02) / static_cast<double>(kLimit);
  std::printf("circle R 20 at F12000, limit 500 mm/s²: v²/R %.5f of it, %.3f s\n",
              share,
              result.job_time_s);
  EXPECT_LE(share, 1.0);
  EXPECT_GE(share, 0.98);
  EXPECT_LE(timer.greatest_centripetal(0.0, 1.0, 0.02), static_cast<double>(kLimit));
}

}  // namespace
}  // namespace proof
