#pragma once

#include "planner/base/result.hpp"
#include "planner/geometry/path_element.hpp"
#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

enum class MotionError : std::uint8_t {
  kNothingToMove,     ///< Start and end are equal to the nanometre: skip the element.
  kBeyondMotorRange,  ///< The end or the normal is outside the range of the step counters.
  kBulgeTooLarge,     ///< The arc has more than half a turn: split it first.
};

/// A path element with its feed, its beam command and its output changes.
struct MotionRequest {
  PathElement element{};
  /// Speed along X Y Z, mm/s, or degrees/s if only A B C move; 0 for a rapid.
  float feed_mm_s = 0.0F;
  BeamCommand beam{};
  /// Part of a row of pixels that the element drives. If row.any(), the pixels set the duty.
  RowPart row{};
  OutputChanges outputs{};
  SourceLine line{};
  /// True if overrides do not change the feed, as in jogs, homing and parking.
  bool fixed_feed = false;
};

/// Builds the block of one path element, which is a line, an arc or a helix. The results of the
/// look-ahead keep their defaults, because they depend on the neighbouring blocks.
[[nodiscard]] Result<Block, MotionError> build_block(const MotionRequest& request,
                                                     const Limits& limits);

/// Return the unit tangent at the start and at the end of a block, in the six-axis metric.
[[nodiscard]] AxisArray<float> entry_tangent(const Block& block);
[[nodiscard]] AxisArray<float> exit_tangent(const Block& block);

}  // namespace cnc::motion
