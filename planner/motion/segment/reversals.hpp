#pragma once

#include <cstddef>
#include <span>

#include "planner/motion/block/axes_in_plane.hpp"
#include "planner/motion/block/path_units.hpp"

namespace cnc::motion {

/// Where on an arc an axis of its plane reverses: in a coordinate plane at each quarter turn of
/// its tangent. A straight block has none. Knows the one before and the one behind the
/// present place, so that each slice costs comparisons only.
class Reversals {
 public:
  Reversals() = default;
  /// At the start of the block.
  Reversals(const Block& block, PathUnits length);

  /// The place on the block is this now; it only grows.
  void pass(PathUnits place) {
    if (place >= next_ && next_ < length_) look_on_from(place);
  }
  /// The first one behind the present place, or the end of the block.
  [[nodiscard]] PathUnits next() const { return next_; }
  /// Whether one is so near that the speed of an axis changes by more than
  /// itself soon: within a 96th of a turn.
  [[nodiscard]] bool near(PathUnits place) const {
    return place < near_until_ || place > near_from_;
  }

 private:
  [[nodiscard]] std::span<const float> turns() const { return {turns_.data(), turn_count_}; }
  void look_on_from(PathUnits place);
  [[nodiscard]] PathUnits place_of(float quarters) const;
  [[nodiscard]] float last_until(float quarters) const;
  [[nodiscard]] float first_behind(float quarters) const;

  AxisArray<float> turns_{};    ///< Where each of those axes reverses, in quarter turns; and…
  std::size_t turn_count_ = 0;  ///< …every half turn from there.
  PathUnits length_ = 0;
  PathUnits next_ = 0;
  PathUnits near_until_ = 0;  ///< To the one passed last…
  PathUnits near_from_ = 0;   ///< …and from here on to the next.
  float start_ = 0.0F;        ///< Tangent at the start in quarter turns, mirrored so that it grows.
  float sweep_ = 0.0F;        ///< In quarter turns; 0 for a straight block.
};

}  // namespace cnc::motion
