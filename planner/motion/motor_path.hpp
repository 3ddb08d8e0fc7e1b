#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/geometry/chord_frame.hpp"
#include "planner/motion/block.hpp"

namespace cnc::motion {

/// Where the motors are along one block: evaluates its line, arc or helix by
/// arc-length fraction, in fixed point (Q32.32 steps), to 20 nm at 4 m.
class MotorPath {
 public:
  /// A place on the block, for the axes to be asked about.
  struct Point {
    std::uint64_t fraction = 0;
    ChordPoint turn{};  ///< Of a block that turns.
  };

  MotorPath() = default;
  MotorPath(const Block& block, const AxisArray<StepPosition>& start);

  /// @param fraction of the block's length; 2^32 is its end, which is met exactly.
  [[nodiscard]] Point at(std::uint64_t fraction) const;

  /// The axes that move on the block; the others stay where they are.
  [[nodiscard]] std::span<const std::uint8_t> moving() const { return {moving_.data(), count_}; }
  [[nodiscard]] StepPosition place(std::size_t axis, const Point& point) const;
  /// Steps per mm of path; times the path speed it is steps/s.
  [[nodiscard]] float speed(std::size_t axis, const Point& point) const;

 private:
  static constexpr std::size_t kOffPlane = 2;

  /// 0 or 1 of an axis of the plane in which the block turns.
  [[nodiscard]] std::size_t in_plane(std::size_t axis) const {
    if (!turns_) return kOffPlane;
    return axis == axes_.first ? 0 : axis == axes_.second ? 1 : kOffPlane;
  }

  ChordFrame frame_{};
  AxisArray<StepPosition> start_{};
  AxisArray<StepPosition> end_{};
  AxisArray<std::int64_t> chord_{};  ///< end − start, Q32.32 steps.
  std::array<std::int64_t, 2> normal_{};
  AxisArray<float> chord_per_mm_{};  ///< Steps of chord per mm of path.
  std::array<float, 2> normal_per_mm_{};
  AxisArray<std::uint8_t> moving_{};
  std::size_t count_ = 0;
  PlaneAxes axes_{0, 1, 2};
  bool turns_ = false;
};

}  // namespace cnc::motion
