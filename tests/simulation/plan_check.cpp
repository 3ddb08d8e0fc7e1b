#include "tests/simulation/plan_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace proof {
namespace {

constexpr double kSampling = 50.0e-6;

/// Returns the rounding error of a float of this size: half its last bit.
double float_noise(double value) { return std::abs(value) * 0x1.0p-24; }

/// Number of roundings in the difference of two speeds: each speed of a slice is a float after four
/// roundings (start, share, product, sum).
constexpr double kRoundings = 8.0;

/// Greatest angle that counts as no turn, radians, and the rounding error of the points at both
/// ends of a block, mm.
constexpr double kTurn = 2.0e-4 * 1.01;
constexpr double kRoundedPlaces = 1.2e-5;

class PlanCheck {
 public:
  PlanCheck(const RecordedPlan& plan, const TestMachine& machine, Sampling sampling)
      : plan_{plan}, limits_{machine.limits}, sampling_{sampling} {}

  PlanFigures run() {
    for (index_ = 0; index_ < plan_.slices.size(); ++index_) check_slice();
    if (plan_.slices.empty()) return figures_;
    figures_.end_speed.note(plan_.slices.back().end_speed(), plan_.slices.size() - 1);
    const cnc::motion::Slice& last = plan_.slices.back().slice;
    if (last.block + 1 != plan_.blocks.size() || last.to_fraction >> 32 != 1) {
      figures_.contiguous = false;
    }
    return figures_;
  }

 private:
  [[nodiscard]] const TimedSlice& slice() const { return plan_.slices[index_]; }
  [[nodiscard]] const PlannedBlock& block() const { return plan_.blocks[slice().slice.block]; }

  void check_slice() {
    const bool new_block =
        index_ == 0 || plan_.slices[index_ - 1].slice.block != slice().slice.block;
    check_order(new_block);
    check_way();
    if (new_block) has_sample_ = false;
    const auto duration = static_cast<double>(slice().slice.duration);
    figures_.finite &= std::isfinite(slice().start_s + duration + slice().end_speed());
    check_moment(0.0);
    check_moment(duration);
    if (sampling_ == Sampling::kAtSlicesOnly) return;
    const double first = std::ceil(slice().start_s / kSampling) * kSampling - slice().start_s;
    for (double within = first; within < duration; within += kSampling) sample(within);
  }

  void check_order(bool new_block) {
    const cnc::motion::Slice& now = slice().slice;
    if (index_ == 0) {
      figures_.contiguous &= now.block == 0 && now.from_fraction == 0;
      figures_.end_speed.note(static_cast<double>(now.start_speed), index_);
      return;
    }
    const TimedSlice& before = plan_.slices[index_ - 1];
    const double jump = std::abs(static_cast<double>(now.start_speed) - before.end_speed());
    figures_.speed_jump.note(jump, index_);
    if (!new_block) {
      figures_.contiguous &= now.from_fraction == before.slice.to_fraction;
      return;
    }
    figures_.contiguous &= now.block == before.slice.block + 1 && now.from_fraction == 0 &&
                           before.slice.to_fraction >> 32 == 1;
    check_joint(before);
  }

  void check_joint(const TimedSlice& before) {
    const double speed =
        std::max(before.end_speed(), static_cast<double>(slice().slice.start_speed));
    if (block().from_rest) {
      figures_.end_speed.note(speed, index_);
      return;
    }
    const ExactBlock& old = plan_.blocks[before.slice.block].exact;
    const double turn = turn_between(old.tangent_at(1.0), block().exact.tangent_at(0.0));
    const double shorter = std::min(old.length(), block().exact.length());
    figures_.joint.note(turn / (kTurn + kRoundedPlaces / shorter), index_);
  }

  /// Checks that speeds and fractions yield the same distance.
  void check_way() {
    const auto duration = static_cast<double>(slice().slice.duration);
    const double by_speed =
        0.5 * (static_cast<double>(slice().slice.start_speed) + slice().end_speed()) * duration;
    const double by_fraction =
        (slice().fraction_at(duration) - slice().fraction_at(0.0)) * block().exact.length();
    figures_.way_error.note(std::abs(by_speed - by_fraction), index_);
  }

  void check_moment(double within) {
    const double fraction = slice().fraction_at(within);
    const double speed = slice().speed_at(within);
    const auto acceleration = static_cast<double>(slice().slice.acceleration);
    const Vector tangent = block().exact.tangent_at(fraction);
    const Vector bend = block().exact.bend_at(fraction);
    double steps_per_s = 0.0;
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      const double axis_speed = std::abs(tangent[axis]) * speed;
      steps_per_s += axis_speed * static_cast<double>(limits_.scale[axis].steps_per_mm());
      figures_.rate.note(axis_speed / static_cast<double>(motor_rate(limits_, axis)), index_, axis);
      const double turning = bend[axis] * speed * speed;
      figures_.centripetal.note(std::abs(turning) / acceleration_limit(axis), index_, axis);
      const double axis_acceleration = tangent[axis] * acceleration + turning;
      figures_.acceleration.note(
          std::abs(axis_acceleration) / acceleration_limit(axis), index_, axis);
    }
    figures_.rate.note(
        steps_per_s / static_cast<double>(limits_.steps_per_s_all_motors), index_, cnc::kAxisCount);
    check_path(speed);
  }

  void check_path(double speed) {
    const double wanted = static_cast<double>(block().block.feed);
    if (wanted > 0.0) figures_.feed.note(speed / wanted, index_);
  }

  /// Takes one of the 20,000 samples per second.
  void sample(double within) {
    check_moment(within);
    const double speed = slice().speed_at(within);
    Vector now = block().exact.tangent_at(slice().fraction_at(within));
    for (double& share : now) share *= speed;
    for (std::size_t axis = 0; has_sample_ && axis < cnc::kAxisCount; ++axis) {
      const double noise = kRoundings * float_noise(now[axis]);
      const double change = std::abs(now[axis] - sample_[axis]) - noise;
      figures_.speed_change.note(change / kSampling / acceleration_limit(axis), index_, axis);
    }
    sample_ = now;
    has_sample_ = true;
  }

  [[nodiscard]] double acceleration_limit(std::size_t axis) const {
    return static_cast<double>(limits_.acceleration_mm_s2[axis]);
  }

  const RecordedPlan& plan_;
  const cnc::motion::Limits& limits_;
  Sampling sampling_;
  PlanFigures figures_{};
  std::size_t index_ = 0;
  Vector sample_{};
  bool has_sample_ = false;
};

}  // namespace

PlanFigures check_plan(const RecordedPlan& plan, const TestMachine& machine, Sampling sampling) {
  return PlanCheck{plan, machine, sampling}.run();
}

double turn_between(const Vector& before, const Vector& after) {
  Vector change{};
  for (std::size_t axis = 0; axis < change.size(); ++axis)
    change[axis] = after[axis] - before[axis];
  return 2.0 * std::asin(std::min(1.0, 0.5 * norm(change)));
}

}  // namespace proof
