#pragma once

#include <cstddef>
#include <span>

#include "planner/motion/block/axes_in_plane.hpp"
#include "planner/motion/block/path_units.hpp"

namespace cnc::motion {

/// The positions on an arc where an axis of its plane reverses. In a coordinate plane, these are at
/// each quarter turn of the tangent. A straight block has none. The nearest reversals before and
/// after the present position are stored, so that a slice usually requires only comparisons.
class Reversals {
 public:
  Reversals() = default;
  /// Finds the reversals of a block, with the present position at its start.
  Reversals(const Block& block, PathUnits length);

  /// Sets the present position on the block, which must not decrease.
  void pass(PathUnits place) {
    if (place >= next_ && next_ < length_) look_on_from(place);
  }
  /// Returns the first reversal after the present position, or the end of the block.
  [[nodiscard]] PathUnits next() const { return next_; }
  /// Returns whether a reversal is within a 96th of a turn before or after `place`. So near to a
  /// reversal, the speed of an axis soon changes by more than its present value.
  [[nodiscard]] bool near(PathUnits place) const {
    return place < near_until_ || place > near_from_;
  }

 private:
  [[nodiscard]] std::span<const float> turns() const { return {turns_.data(), turn_count_}; }
  void look_on_from(PathUnits place);
  [[nodiscard]] PathUnits place_of(float quarters) const;
  [[nodiscard]] float last_until(float quarters) const;
  [[nodiscard]] float first_behind(float quarters) const;

  /// For each axis, an angle of the tangent, in quarter turns, at which the axis reverses. The axis
  /// also reverses at every half turn from this angle.
  AxisArray<float> turns_{};
  std::size_t turn_count_ = 0;  ///< Number of angles in turns_.
  PathUnits length_ = 0;
  PathUnits next_ = 0;
  PathUnits near_until_ = 0;  ///< End of the positions near the last reversal passed.
  PathUnits near_from_ = 0;   ///< Start of the positions near the next reversal.
  /// Angle of the tangent at the start, in quarter turns; mirrored on a clockwise arc, so that the
  /// angle grows.
  float start_ = 0.0F;
  float sweep_ = 0.0F;  ///< Sweep in quarter turns; 0 for a straight block.
};

}  // namespace cnc::motion
