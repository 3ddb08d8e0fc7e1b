#pragma once

#include <optional>

#include "host-sim/pocket/depth_writer.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// A place of the tool and the direction in which it moves there, a unit vector.
struct Pose {
  cnc::WideVec2 place{0.0, 0.0};
  cnc::WideVec2 direction{1.0, 0.0};
};

/// mm: a smaller turn is a corner.
inline constexpr double kLeastTurnMm = 1.0e-6;
/// Radians: an arc that turns by less is a line.
inline constexpr double kLeastArc = 1.0e-6;

/// Whether a place is within or on a circle.
[[nodiscard]] bool is_in(const cnc::WideVec2& place, const cnc::pocket::ToolCircle& circle);

/// A vector turned to the left, by radians.
[[nodiscard]] cnc::WideVec2 turned(const cnc::WideVec2& vector, double angle);

/// The turn to the left from one direction to another, 0 to 2 π.
[[nodiscard]] double turn_between(const cnc::WideVec2& from, const cnc::WideVec2& to);

/// The same to the left where `side` is above 0, to the right where it is below.
[[nodiscard]] double turn_to(double side, const cnc::WideVec2& from, const cnc::WideVec2& to);

/// An arc in place of the corner between two lines.
struct Rounding {
  cnc::WideVec2 start{0.0, 0.0};
  cnc::WideVec2 end{0.0, 0.0};
  double bulge = 0.0;

  [[nodiscard]] cnc::WideVec2 middle() const;
};

/// @param trim_mm how far before and after the corner the arc begins and ends
/// @pre the corner is neither `before` nor `after`
[[nodiscard]] Rounding rounding_of(const cnc::WideVec2& before,
                                   const cnc::WideVec2& corner,
                                   const cnc::WideVec2& after,
                                   double trim_mm);

/// An arc.
struct RoundTurn {
  cnc::WideVec2 centre{0.0, 0.0};
  cnc::WideVec2 start{0.0, 0.0};
  double side = 1.0;  ///< 1 to the left, -1 to the right.
  double turn = 0.0;  ///< Radians, 0 to 2 π.

  /// @param share of the arc, 0…1
  [[nodiscard]] cnc::WideVec2 place_at(double share) const;
  /// Whether no place of it is outside of a circle.
  [[nodiscard]] bool stays_in(const cnc::pocket::ToolCircle& disc) const;
  /// Moves the tool from the start to `end`, which is the arc's own end but for rounding. Arcs of
  /// more than half a turn are written in two halves.
  void write(DepthWriter& writer, const cnc::WideVec2& end) const;
};

/// An arc, a line and an arc of the same radius, each with the tangent of the one before it: the
/// shortest way from one pose to another where turns have a least radius (Dubins, 1957), unless
/// both are near to each other.
struct RoundWay {
  RoundTurn first;
  cnc::WideVec2 line_start{0.0, 0.0};
  RoundTurn last;
  cnc::WideVec2 end{0.0, 0.0};
  double length_mm = 0.0;

  void write(DepthWriter& writer) const;
};

/// Returns the shortest round way within a circle, by turns of the radius asked for or, where none
/// fits, half of it, a quarter and so on; none below kLeastTurnMm.
[[nodiscard]] std::optional<RoundWay> round_way(const Pose& from,
                                                const Pose& to,
                                                const cnc::pocket::ToolCircle& disc,
                                                double radius_mm);

}  // namespace sim::pocket
