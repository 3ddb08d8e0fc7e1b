#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/pocket/medial_axis.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// A piece of the medial axis as a function of the length along the piece. At each length, it has a
/// circle around the point of the axis. The circle's radius is the radius of the greatest disc
/// around this point in the area, minus the tool's radius. A tool whose centre is on this circle
/// reaches the boundary.
class AxisCourse {
 public:
  /// @param points at least two
  AxisCourse(const OwnedArea& area, std::vector<AxisPoint> points, double tool_radius_mm);

  [[nodiscard]] double length() const { return lengths_.back(); }
  /// Returns the circle at the length `s`, mm. Its radius is negative where the tool is too wide.
  /// @pre 0 <= s <= length()
  [[nodiscard]] cnc::pocket::ToolCircle circle_at(double s) const;

  /// Returns the points of the axis strictly between two lengths, in the order of the axis.
  [[nodiscard]] std::vector<cnc::WideVec2> places_between(double from, double to) const;

  /// Evaluates the points of the axis strictly between two lengths. Returns the length of the point
  /// whose circle reaches farthest from `place`, or none if there are no such points. Within the
  /// tolerance of the axis, no circle between two neighbouring points reaches farther than the
  /// circles of these two points.
  [[nodiscard]] std::optional<double> farthest_reach(const cnc::WideVec2& place,
                                                     double from,
                                                     double to) const;

 private:
  const OwnedArea& area_;
  std::vector<AxisPoint> points_;
  std::vector<double> lengths_;  ///< For each point, the length from the first point, mm.
  double tool_radius_mm_;
};

/// Limits for one step along a course.
struct StepLimits {
  double tool_radius_mm = 0.0;
  double engagement = 0.0;     ///< Greatest engagement, radians.
  double min_circle_mm = 0.0;  ///< Least radius of a circle that gets a crescent, mm.
};

/// Returns the greatest length along a course that a tool may reach by one crescent within the
/// engagement. Before the crescent, the tool has cleared the disc around the circle `cleared`,
/// which belongs to the length `from`. Returns `from` if no crescent is within the engagement. The
/// result is at most the length of the course.
///
/// Crescents to all circles at lengths between `from` and the result are also within the
/// engagement. Therefore the pass along the wall is within the engagement, too, where these circles
/// reach the wall. This matters where the course leads into a bay of a large disc and out again:
/// the small discs in the bay lie within the large disc.
[[nodiscard]] double next_crescent(const AxisCourse& course,
                                   double from,
                                   const cnc::pocket::ToolCircle& cleared,
                                   const StepLimits& limits);

}  // namespace sim::pocket
