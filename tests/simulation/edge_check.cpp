#include "tests/simulation/edge_check.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/pulse_player.hpp"

namespace proof {
namespace {

constexpr double kTickSeconds = 1.0 / cnc::motion::kTicksPerSecond;
constexpr double kPromise = 25.0e-6;

struct Range {
  double low;
  double high;
  [[nodiscard]] double distance_to(double place) const {
    return std::max({0.0, low - place, place - high});
  }
};

class EdgeCheck final : public EdgeSink {
 public:
  EdgeCheck(const RecordedPlan& plan, const TestMachine& machine)
      : plan_{plan}, limits_{machine.limits} {}

  void on_edge(const Edge& edge) override {
    const double time = static_cast<double>(edge.tick) * kTickSeconds;
    look_at_slices_until(time);
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      if ((edge.axes >> axis & 1U) == 0) continue;
      step(axis, (edge.negative >> axis & 1U) != 0 ? -1 : 1, time);
    }
  }

  EdgeFigures finish(bool pulses_kept) {
    look_at_slices_until(plan_.seconds + 1.0);
    figures_.pulses_kept = pulses_kept;
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      figures_.final_position &= plan_.blocks.empty() || is_final(axis);
    }
    return figures_;
  }

 private:
  void step(std::size_t axis, int direction, double time) {
    const double crossing = static_cast<double>(position_[axis]) + 0.5 * direction;
    position_[axis] += direction;
    ++figures_.edges;
    const double exact = plan_.steps_at(slice_at(time), time, axis, limits_);
    if (std::abs(exact - crossing) < 0.5 * kEdgeSlack) return;
    const double off = planned_range(time, axis).distance_to(crossing) - geometry_slack(axis);
    figures_.lateness.note(off, hint_, axis);
  }

  /// Compares the motors with the plan at the end of each slice that ends before `time`.
  void look_at_slices_until(double time) {
    for (; looked_at_ < plan_.slices.size(); ++looked_at_) {
      const double end = plan_.slices[looked_at_].end_s();
      if (end >= time) return;
      if (end - last_look_ < kPromise && looked_at_ + 1 < plan_.slices.size()) continue;
      last_look_ = end;
      for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) look_at(axis, end);
    }
  }

  void look_at(std::size_t axis, double time) {
    const double off = planned_range(time, axis).distance_to(position_[axis]);
    figures_.separation.note(off - 0.5 - geometry_slack(axis), looked_at_, axis);
  }

  /// Returns the range of planned positions within 25 µs of a time.
  Range planned_range(double time, std::size_t axis) {
    const double first = plan_.steps_at(slice_at(time - kPromise), time - kPromise, axis, limits_);
    Range range{first, first};
    const auto extend = [&](double moment) {
      const double place = plan_.steps_at(slice_at(moment), moment, axis, limits_);
      range = {std::min(range.low, place), std::max(range.high, place)};
    };
    for (std::size_t i = slice_at(time - kPromise);
         i < plan_.slices.size() && plan_.slices[i].end_s() < time + kPromise;
         ++i) {
      extend(plan_.slices[i].end_s());
    }
    extend(time);
    extend(time + kPromise);
    return range;
  }

  /// Returns the slice that is driven at a time. Successive calls have almost increasing times, so
  /// the search begins at the last slice.
  std::size_t slice_at(double time) {
    while (hint_ > 0 && plan_.slices[hint_].start_s > time) --hint_;
    while (hint_ + 1 < plan_.slices.size() && plan_.slices[hint_ + 1].start_s <= time) ++hint_;
    return hint_;
  }

  [[nodiscard]] double geometry_slack(std::size_t axis) const {
    const double radius = plan_.blocks[plan_.slices[hint_].slice.block].exact.radius();
    return 1.0e-7 * radius * static_cast<double>(limits_.scale[axis].steps_per_mm());
  }

  [[nodiscard]] bool is_final(std::size_t axis) const {
    const cnc::Coordinate end = plan_.blocks.back().end[axis];
    const long double steps = static_cast<long double>(end.nanometres()) *
                              static_cast<long double>(limits_.scale[axis].steps_per_mm()) / 1.0e6L;
    const long double off = std::abs(steps - static_cast<long double>(position_[axis]));
    return off <= 0.5L + 1.0e-9L;
  }

  const RecordedPlan& plan_;
  const cnc::motion::Limits& limits_;
  cnc::AxisArray<std::int32_t> position_{};
  EdgeFigures figures_{};
  std::size_t hint_ = 0;
  std::size_t looked_at_ = 0;
  double last_look_ = -1.0;
};

}  // namespace

EdgeFigures check_edges(const RecordedPlan& plan, const TestMachine& machine) {
  EdgeCheck check{plan, machine};
  const bool pulses_kept = play(plan.segments, machine.timing, check);
  return check.finish(pulses_kept);
}

}  // namespace proof
