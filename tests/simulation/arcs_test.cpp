#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "host-sim/measure/path_deviation.hpp"
#include "tests/simulation/edge_check.hpp"
#include "tests/support/drive.hpp"
#include "tests/support/pulse_player.hpp"
#include "tests/support/random_arc.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

/// Measures the distance of every pulse from the exact curve.
class CurveCheck final : public EdgeSink {
 public:
  /// @param known excess, mm; only greater ones are searched for
  CurveCheck(const sim::ProgrammedPath& path, const TestMachine& machine, double known)
      : deviation_{path, scales(machine), known} {
    deviation_.on_row(row_);
  }

  void on_edge(const Edge& edge) override {
    row_.time_ns = edge.tick * 250;
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      if ((edge.axes >> axis & 1U) == 0) continue;
      row_.position[axis] += (edge.negative >> axis & 1U) != 0 ? -1 : 1;
    }
    deviation_.on_row(row_);
    ++edges_;
  }

  [[nodiscard]] const sim::DeviationPeak& excess() const {
    return deviation_.greatest_axis_excess();
  }
  [[nodiscard]] std::size_t edges() const { return edges_; }

 private:
  static cnc::AxisArray<double> scales(const TestMachine& machine) {
    cnc::AxisArray<double> scales{};
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      scales[axis] = static_cast<double>(machine.limits.scale[axis].steps_per_mm());
    }
    return scales;
  }

  sim::PathDeviation deviation_;
  sim::TraceRow row_{};
  std::size_t edges_ = 0;
};

struct ArcSummary {
  double excess = 0.0;  ///< Greatest distance beyond half a step, mm.
  double centripetal = 0.0;
  double acceleration = 0.0;
  std::size_t edges = 0;
  std::size_t arcs = 0;
};

/// Returns the distance that an axis may move while its edge waits for the slot of another motor's
/// edge, mm. The wait is one slot: a pulse up and down (step_generator.hpp).
double distance_in_slot(const TestMachine& machine) {
  const double slot_s =
      2.0 * machine.timing.pulse / static_cast<double>(cnc::motion::kTicksPerSecond);
  const auto& rates = machine.limits.rate_mm_s;
  return slot_s * static_cast<double>(*std::max_element(rates.begin(), rates.end()));
}

void try_arc(std::uint64_t seed, ArcSummary& summary) {
  Random random{seed};
  const TestArc arc = random_arc(random);
  const double steps = random.chance(0.004) ? 2.0e5 : 2.0e3;
  const TestMachine machine = machine_for(random, arc, steps);
  const double feed =
      random.chance(0.3) ? 0.0 : std::max(1.0, arc.exact.length()) * random.magnitude(0.3, 100.0);
  const Program program = arc.program(feed);
  EXPECT_EQ(program.items.size(), arc.elements()) << "sweep " << arc.sweep;
  const RecordedPlan plan = drive(program, machine);
  // The ends of slices are at most a millisecond apart. For one arc in twenty, samples are closer.
  const Sampling sampling = seed % 20 == 0 ? Sampling::kAt20kHz : Sampling::kAtSlicesOnly;
  const PlanFigures figures = check_plan(plan, machine, sampling);
  EXPECT_LE(figures.centripetal.value, 1.0);
  EXPECT_LE(figures.acceleration.value, 1.001)
      << "slice " << figures.acceleration.slice << ", axis " << figures.acceleration.axis;
  EXPECT_LE(figures.rate.value, 1.001);
  const auto judge =
      [&](const char* what, const cnc::StepTiming& timing, double known, double promise) {
        CurveCheck check{arc.exact, machine, known};
        EXPECT_TRUE(play(plan.segments, timing, check));
        EXPECT_LE(check.excess().value, promise)
            << what << ", R " << arc.radius << ", sweep " << arc.sweep << " at "
            << static_cast<double>(check.excess().time_ns) * 1e-9 << " of " << plan.seconds << " s";
        return std::pair{check.excess().value, check.edges()};
      };
  // With the finest slots, of half a microsecond, the pulses show the error of the arc alone.
  cnc::StepTiming finest = machine.timing;
  finest.pulse = 1;
  const auto [excess, edges] = judge("arc", finest, 0.0, kArcPromise);
  const double late = kArcPromise + distance_in_slot(machine);
  static_cast<void>(judge("pulses", machine.timing, std::max(0.0, late - 1.0e-6), late));
  summary.excess = std::max(summary.excess, excess);
  summary.centripetal = std::max(summary.centripetal, figures.centripetal.value);
  summary.acceleration = std::max(summary.acceleration, figures.acceleration.value);
  summary.edges += edges;
  ++summary.arcs;
}

// KERFLINE_TRIALS=100000 runs all trials of issue 2, acceptance 2.
TEST(RandomArcs, StayOnTheExactCurveWithinTheirLimits) {
  const Trials trials{2000};
  ArcSummary summary;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    EXPECT_NO_THROW(try_arc(seed, summary));
  }
  std::printf(
      "arcs: %zu, %zu edges, greatest distance beyond half a step %.3f um, "
      "v²/R %.5f and acceleration %.5f of the limit\n",
      summary.arcs,
      summary.edges,
      summary.excess * 1.0e3,
      summary.centripetal,
      summary.acceleration);
}

}  // namespace
}  // namespace proof
