#pragma once

#include "planner/geometry/chord_frame.hpp"
#include "planner/motion/block.hpp"

namespace cnc::motion {

/// Motor positions and speeds at one moment.
struct MotorState {
  AxisArray<StepPosition> place{};
  AxisArray<float> speed{};  ///< Steps per mm of path; times the path speed it is steps/s.
};

/// Where the motors are along one block: evaluates its line, arc or helix by
/// arc-length fraction, in fixed point (Q32.32 steps), to 20 nm at 4 m.
class MotorPath {
 public:
  MotorPath() = default;
  MotorPath(const Block& block, const AxisArray<StepPosition>& start);

  /// @param fraction of the block's length; 2^32 is its end, which is met exactly.
  [[nodiscard]] MotorState at(std::uint64_t fraction) const;

 private:
  void lay_turn_over(std::uint32_t fraction, MotorState& state) const;

  ChordFrame frame_{};
  AxisArray<StepPosition> start_{};
  AxisArray<StepPosition> end_{};
  AxisArray<std::int64_t> chord_{};  ///< end − start, Q32.32 steps.
  std::array<std::int64_t, 2> normal_{};
  AxisArray<float> chord_per_mm_{};  ///< Steps of chord per mm of path.
  std::array<float, 2> normal_per_mm_{};
  PlaneAxes axes_{0, 1, 2};
  bool turns_ = false;
};

}  // namespace cnc::motion
