#pragma once

#include "planner/path/leg.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Within one curve places are this far beside it, mm, and never more than this
/// much, in radians, is put down to that.
inline constexpr float kRoundedPlaceMm = 1.2e-5F;
inline constexpr float kSmoothTurn = 0.02F;

/// Ways and chords shorter than this, mm, are all rounding to nanometres.
inline constexpr float kCrumbMm = 2.0e-5F;

/// What happens where two elements meet, and if it can be rounded, how.
struct Corner {
  enum class Kind : std::uint8_t {
    kSmooth,  ///< It does not turn.
    kStop,    ///< It turns and cannot be rounded: the machine stops.
    kBlend,
  };
  Kind kind = Kind::kStop;

  // The members below are there for a kBlend.
  Leg before{};
  Leg after{};
  float turn = 0.0F;          ///< Radians from direction to direction in that plane, positive left.
  float tolerance_mm = 0.0F;  ///< Greatest distance of the blend from the path, and back.
  float wish_mm = 0.0F;       ///< The trim that it would take of both neighbours.

  /// Returns where the path is `way` mm after the corner, or before it if negative.
  [[nodiscard]] Position place(const Position& corner, float way) const {
    return moved_by(corner, (way < 0.0F ? before : after).place(way));
  }
  /// Returns the plane in which the direction turns; empty if it hardly does, or turns back.
  [[nodiscard]] std::optional<ArcPlane> plane() const {
    return plane_of(before.direction(0.0F), after.direction(0.0F));
  }
  [[nodiscard]] bool is_straight() const {
    return before.curvature == 0.0F && after.curvature == 0.0F;
  }
};

/// Judges the corner between two elements.
///
/// It can be rounded unless it turns back: two lines by an arc in their plane, in all six axes,
/// each in its unit; an arc and its neighbour by two arcs. The tolerance is the smaller of the two
/// elements', and only rapids are blended with rapids. Motion that an operator's override does not
/// touch (jogs, homing) is not blended.
///
/// A blend is not made larger than what its elements' feed needs on this
/// machine, at twice the feed.
/// @param corner takes the result
void examine(const PathItem& before,
             const PathItem& after,
             const motion::Limits& limits,
             Corner& corner);

/// Elements of these kinds are never blended with each other.
[[nodiscard]] bool stop_between(const PathItem& before, const PathItem& after);

/// The largest trim up to `most_mm`, the same on both sides, whose blend is
/// within the tolerance; 0 for none.
/// @pre a kBlend
[[nodiscard]] float fitting_trim(const Corner& corner, float most_mm);

}  // namespace cnc::path
