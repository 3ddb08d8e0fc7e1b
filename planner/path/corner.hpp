#pragma once

#include "planner/geometry/biarc.hpp"
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

  // Of a kBlend.
  Plane plane = Plane::kXY;
  Leg before{};
  Leg after{};
  float turn = 0.0F;          ///< Radians from tangent to tangent, positive left.
  float tolerance_mm = 0.0F;  ///< Of the blend from the path and of the path from it.
  float wish_mm = 0.0F;       ///< What it would take of both neighbours.

  [[nodiscard]] bool is_straight() const {
    return before.curvature == 0.0F && after.curvature == 0.0F;
  }
};

/// Judges the corner between two elements.
///
/// It can be rounded where both lie in one coordinate plane, all other axes with
/// the same slope, and where that slope is so small that the shorter way round
/// the corner changes it by less than kTangentTurn. The tolerance is the
/// smaller of the two elements', and only rapids are blended with rapids. What
/// an operator's override does not touch (jogs, homing) is not blended.
///
/// A blend is not made larger than what its elements' feed needs on this
/// machine, at twice the feed.
[[nodiscard]] Corner examine(const PathItem& before,
                             const PathItem& after,
                             const motion::Limits& limits);

/// Elements of these kinds are never blended with each other.
[[nodiscard]] bool stop_between(const PathItem& before, const PathItem& after);

/// The largest trim up to `most_mm`, the same on both sides, whose blend is
/// within the tolerance; 0 for none.
/// @pre a kBlend
[[nodiscard]] float fitting_trim(const Corner& corner, float most_mm);

/// The blend for a trim, seen from the corner in its plane.
[[nodiscard]] BiarcEnds ends_of(const Corner& corner, float trim_mm);

}  // namespace cnc::path
