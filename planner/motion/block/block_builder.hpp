#pragma once

#include "planner/base/result.hpp"
#include "planner/geometry/path_element.hpp"
#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

enum class MotionError : std::uint8_t {
  kNothingToMove,     ///< Start and end agree to the nanometre: skip it.
  kBeyondMotorRange,  ///< An end lies outside what the step counters hold.
  kBulgeTooLarge,     ///< More than half a turn: split the arc first.
};

/// What to move, how fast and with what beam.
struct MotionRequest {
  PathElement element{};
  float feed_mm_s = 0.0F;  ///< Along X Y Z, or degrees/s when only A B C move; 0 is a rapid.
  BeamCommand beam{};
  RowPart row{};  ///< Where there is one, its pixels say the duty.
  OutputChanges outputs{};
  SourceLine line{};
  bool fixed_feed = false;  ///< Overrides do not touch it: jogs, homing, parking.
};

/// Turns a path element into a block: one for one, line, arc or helix.
/// The corner speed is left at 0; it needs the block before.
[[nodiscard]] Result<Block, MotionError> build_block(const MotionRequest& request,
                                                     const Limits& limits);

/// Unit tangents in the six-axis metric.
[[nodiscard]] AxisArray<float> entry_tangent(const Block& block);
[[nodiscard]] AxisArray<float> exit_tangent(const Block& block);

}  // namespace cnc::motion
