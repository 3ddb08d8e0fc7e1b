#pragma once

#include <optional>

#include "host-sim/pocket/depth_writer.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// A point of the tool's path and the direction of travel at this point, a unit vector.
struct Pose {
  cnc::WideVec2 place{0.0, 0.0};
  cnc::WideVec2 direction{1.0, 0.0};
};

/// Least radius of a turn, mm. A turn with a smaller radius counts as a corner.
inline constexpr double kMinTurnMm = 1.0e-6;
/// Least sweep of an arc, radians. An arc with a smaller sweep counts as a line.
inline constexpr double kMinArc = 1.0e-6;

/// Returns whether a point is within or on a circle.
[[nodiscard]] bool is_in(const cnc::WideVec2& place, const cnc::pocket::ToolCircle& circle);

/// Returns `vector` rotated to the left by `angle` radians.
[[nodiscard]] cnc::WideVec2 turned(const cnc::WideVec2& vector, double angle);

/// Returns the angle of the left turn from one direction to another, 0 to 2 π.
[[nodiscard]] double turn_between(const cnc::WideVec2& from, const cnc::WideVec2& to);

/// Returns the angle of the turn from one direction to another, 0 to 2 π. The turn is to the left
/// if `side` is positive, and to the right if it is negative.
[[nodiscard]] double turn_to(double side, const cnc::WideVec2& from, const cnc::WideVec2& to);

/// An arc that replaces the corner between two lines.
struct Rounding {
  cnc::WideVec2 start{0.0, 0.0};
  cnc::WideVec2 end{0.0, 0.0};
  double bulge = 0.0;

  [[nodiscard]] cnc::WideVec2 middle() const;
};

/// Returns the arc that rounds a corner.
/// @param trim_mm distance from the corner to the start and to the end of the arc
/// @pre the corner is neither `before` nor `after`
[[nodiscard]] Rounding rounding_of(const cnc::WideVec2& before,
                                   const cnc::WideVec2& corner,
                                   const cnc::WideVec2& after,
                                   double trim_mm);

/// An arc of the tool's path.
struct RoundTurn {
  cnc::WideVec2 centre{0.0, 0.0};
  cnc::WideVec2 start{0.0, 0.0};
  double side = 1.0;  ///< +1 for a left turn, −1 for a right turn.
  double turn = 0.0;  ///< Sweep of the arc, radians, 0 to 2 π.

  /// Returns a point of the arc. @param share of the arc, 0…1
  [[nodiscard]] cnc::WideVec2 place_at(double share) const;
  /// Returns whether the arc is completely within or on the circle `disc`.
  [[nodiscard]] bool stays_in(const cnc::pocket::ToolCircle& disc) const;
  /// Writes the arc. Its end is replaced by `end`, which may differ from it by rounding. An arc of
  /// more than half a turn is written in two halves.
  void write(DepthWriter& writer, const cnc::WideVec2& end) const;
};

/// An arc, a line and an arc of the same radius, joined with one tangent. Unless the poses are near
/// to each other, this is the shortest path between two poses with a least turn radius (Dubins,
/// 1957).
struct RoundWay {
  RoundTurn first;
  cnc::WideVec2 line_start{0.0, 0.0};
  RoundTurn last;
  cnc::WideVec2 end{0.0, 0.0};
  double length_mm = 0.0;

  void write(DepthWriter& writer) const;
};

/// Returns the shortest round path within a circle. Its turns have the radius `radius_mm` or, if
/// that does not fit, half of it, a quarter and so on. Returns none if no radius down to kMinTurnMm
/// fits.
[[nodiscard]] std::optional<RoundWay> round_way(const Pose& from,
                                                const Pose& to,
                                                const cnc::pocket::ToolCircle& disc,
                                                double radius_mm);

}  // namespace sim::pocket
