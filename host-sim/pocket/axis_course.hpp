#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/pocket/medial_axis.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// A piece of the axis as a function of the length along it. At each length it has a circle around
/// the axis, of the disc's radius minus the tool's radius. A tool whose centre is on this circle
/// reaches the boundary.
class AxisCourse {
 public:
  /// @param points at least two
  AxisCourse(const OwnedArea& area, std::vector<AxisPoint> points, double tool_radius_mm);

  [[nodiscard]] double length() const { return lengths_.back(); }
  /// Returns the circle at a length. Its radius is below 0 where the tool is too wide.
  /// @pre 0 <= s <= length()
  [[nodiscard]] cnc::pocket::ToolCircle circle_at(double s) const;

  /// Returns the points of the axis strictly between two lengths, in order.
  [[nodiscard]] std::vector<cnc::WideVec2> places_between(double from, double to) const;

  /// Considers the points of the axis strictly between two lengths. Returns the length of the point
  /// whose circle reaches farthest from `place`; none without points. Within the tolerance of the
  /// axis, no circle between two neighbouring points reaches farther than theirs.
  [[nodiscard]] std::optional<double> farthest_reach(const cnc::WideVec2& place,
                                                     double from,
                                                     double to) const;

 private:
  const OwnedArea& area_;
  std::vector<AxisPoint> points_;
  std::vector<double> lengths_;  ///< Length up to each point.
  double tool_radius_mm_;
};

/// Limits of a step along a course.
struct StepLimits {
  double tool_radius_mm = 0.0;
  double engagement = 0.0;     ///< Radians.
  double min_circle_mm = 0.0;  ///< Circles with a smaller radius get no crescent.
};

/// Returns the greatest length along a course that a tool may reach by one crescent within the
/// engagement. The tool has cleared the disc around `cleared`, at `from`. Returns `from` if there
/// is no such crescent, and at most the length of the course.
///
/// Crescents to all circles between are within the engagement, too. Therefore the pass along the
/// wall is also within it, where these circles reach the wall. That matters where the course leads
/// into a bay of a large disc and out of it again, as small discs within the large disc.
[[nodiscard]] double next_crescent(const AxisCourse& course,
                                   double from,
                                   const cnc::pocket::ToolCircle& cleared,
                                   const StepLimits& limits);

}  // namespace sim::pocket
