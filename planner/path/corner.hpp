#pragma once

#include "planner/path/leg.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Within one curve, rounded positions are at most kRoundedPlaceMm off the curve, mm. A turn is
/// attributed to that rounding only up to kSmoothTurn, in radians.
inline constexpr float kRoundedPlaceMm = 1.2e-5F;
inline constexpr float kSmoothTurn = 0.02F;

/// Distances and chords shorter than this, mm, consist of nothing but rounding to nanometres.
inline constexpr float kCrumbMm = 2.0e-5F;

/// Treatment of the corner between two elements and, if it can be rounded, its shape.
struct Corner {
  enum class Kind : std::uint8_t {
    kSmooth,  ///< The path does not turn there.
    kStop,    ///< The path turns and cannot be rounded: the machine stops.
    kBlend,
  };
  Kind kind = Kind::kStop;

  // The members below are meaningful for a kBlend only.
  Leg before{};
  Leg after{};
  float turn = 0.0F;  ///< Angle between the two directions in their plane, rad, positive left.
  /// Greatest distance of the blend from the path, and of the path from the blend.
  float tolerance_mm = 0.0F;
  float wish_mm = 0.0F;  ///< The trim that the corner would take of both neighbours.

  /// Returns the position on the path at `way` mm after the corner, or before it if negative.
  [[nodiscard]] Position place(const Position& corner, float way) const {
    return moved_by(corner, (way < 0.0F ? before : after).place(way));
  }
  /// Returns the plane in which the direction turns. Empty if it hardly turns, or turns back.
  [[nodiscard]] std::optional<ArcPlane> plane() const {
    return plane_of(before.direction(0.0F), after.direction(0.0F));
  }
  [[nodiscard]] bool is_straight() const {
    return before.curvature == 0.0F && after.curvature == 0.0F;
  }
};

/// Examines the corner between two elements.
///
/// A corner can be rounded unless it turns back: between two lines by an arc in their plane, in all
/// six axes, each in its unit; between an arc and its neighbour by two arcs. The tolerance is the
/// smaller one of the two elements. Rapids are blended with rapids only. Motion that is exempt from
/// the operator's overrides (jogs, homing) is not blended.
///
/// A blend is not made larger than the feed of its elements needs on this machine, computed for
/// twice that feed.
/// @param corner receives the result
void examine(const PathItem& before,
             const PathItem& after,
             const motion::Limits& limits,
             Corner& corner);

/// Returns whether elements of these kinds are never blended with each other.
[[nodiscard]] bool stop_between(const PathItem& before, const PathItem& after);

/// Returns the largest trim up to `max_mm`, the same on both sides, whose blend is within the
/// tolerance; 0 if there is none.
/// @pre the corner is a kBlend
[[nodiscard]] float fitting_trim(const Corner& corner, float max_mm);

}  // namespace cnc::path
