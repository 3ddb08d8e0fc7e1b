#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/pocket/medial_axis.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// A piece of the axis by the length along it. At each length it has the circle on which the centre
/// of a tool comes up to the boundary: around the axis, by the tool's radius less than the disc.
class AxisCourse {
 public:
  /// @param points two at least
  AxisCourse(const OwnedArea& area, std::vector<AxisPoint> points, double tool_radius_mm);

  [[nodiscard]] double length() const { return lengths_.back(); }
  /// The radius is below 0 where the tool is too wide. @pre 0 <= s <= length()
  [[nodiscard]] cnc::pocket::ToolCircle circle_at(double s) const;

  /// Points of the axis strictly between two lengths, in order.
  [[nodiscard]] std::vector<cnc::WideVec2> places_between(double from, double to) const;

  /// The length at the point of the axis strictly between two lengths whose circle reaches farthest
  /// from a place; none without points. Between neighbouring points no circle reaches farther than
  /// theirs, but for the tolerance of the axis.
  [[nodiscard]] std::optional<double> farthest_reach(const cnc::WideVec2& place,
                                                     double from,
                                                     double to) const;

 private:
  const OwnedArea& area_;
  std::vector<AxisPoint> points_;
  std::vector<double> lengths_;  ///< Up to each point.
  double tool_radius_mm_;
};

/// What a step along a course has to keep to.
struct StepLimits {
  double tool_radius_mm = 0.0;
  double engagement = 0.0;       ///< Radians.
  double least_circle_mm = 0.0;  ///< Radius below which a circle is not worth a crescent.
};

/// Returns the greatest length along a course up to which a tool that has cleared the disc around
/// `cleared`, at `from`, may go on at once, by a crescent within the engagement; `from` if there
/// is none. At most the course's own length.
///
/// Crescents to all circles on the way are within the engagement, too. So is the pass along the
/// wall, therefore, where these circles come up to it: the course may lead into a bay of a large
/// disc and out of it again, as small discs within the large one.
[[nodiscard]] double next_crescent(const AxisCourse& course,
                                   double from,
                                   const cnc::pocket::ToolCircle& cleared,
                                   const StepLimits& limits);

}  // namespace sim::pocket
