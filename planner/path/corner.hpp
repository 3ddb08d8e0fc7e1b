#pragma once

#include "planner/path/leg.hpp"
#include "planner/path/path_item.hpp"

namespace cnc::path {

/// Greatest distance of a rounded position from its curve, in mm, for elements of one curve.
inline constexpr float kRoundedPlaceMm = 1.2e-5F;
/// Greatest change of direction, in radians, that is attributed to the rounding of positions.
inline constexpr float kSmoothTurn = 0.02F;

/// Length in mm below which distances and chords consist only of rounding to nanometres.
inline constexpr float kCrumbMm = 2.0e-5F;

/// Treatment of the corner between two elements, and its shape if it can be rounded.
struct Corner {
  enum class Kind : std::uint8_t {
    kSmooth,  ///< The path does not change its direction at the corner.
    kStop,    ///< The corner cannot be rounded: the machine stops there.
    kBlend,
  };
  Kind kind = Kind::kStop;

  // The following members are used only for a kBlend.
  Leg before{};
  Leg after{};
  /// Angle from the direction before to the direction after, rad, positive to the left.
  float turn = 0.0F;
  /// Greatest permitted distance of the blend from the path and of the path from the blend, mm.
  float tolerance_mm = 0.0F;
  float wish_mm = 0.0F;  ///< Trim that the corner requests of both neighbours, mm.

  /// Returns the position on the path at the distance `way` mm after the corner, or before it if
  /// `way` is negative.
  [[nodiscard]] Position place(const Position& corner, float way) const {
    return moved_by(corner, (way < 0.0F ? before : after).place(way));
  }
  /// Returns the plane in which the direction turns. Returns nothing if the direction hardly
  /// changes or is reversed.
  [[nodiscard]] std::optional<ArcPlane> plane() const {
    return plane_of(before.direction(0.0F), after.direction(0.0F));
  }
  [[nodiscard]] bool is_straight() const {
    return before.curvature == 0.0F && after.curvature == 0.0F;
  }
};

/// Examines the corner between two elements.
///
/// A corner can be rounded unless the path turns back. Between two lines, the blend is one arc in
/// their plane, in all six axes with their units. Next to an arc, it is two arcs. The tolerance is
/// the smaller one of the tolerances of the two elements. A rapid is blended only with a rapid.
/// Motion with a fixed feed (jogs, homing) is not blended.
///
/// The blend is only as large as this machine requires for twice the feed of the elements, which is
/// the greatest override.
/// @param corner receives the result
void examine(const PathItem& before,
             const PathItem& after,
             const motion::Limits& limits,
             Corner& corner);

/// Returns whether two elements are of kinds that are never blended with each other.
[[nodiscard]] bool stop_between(const PathItem& before, const PathItem& after);

/// Returns the greatest trim, up to `max_mm` and equal on both sides, with which the blend is
/// within the tolerance. Returns 0 if there is none.
/// @pre the corner is a kBlend
[[nodiscard]] float fitting_trim(const Corner& corner, float max_mm);

}  // namespace cnc::path
