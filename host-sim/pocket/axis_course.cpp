#include "host-sim/pocket/axis_course.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::ToolCircle;

/// Greatest distance between the centres of neighbouring circles, as a share of the sum of their
/// radii. At a greater distance, the circles hardly intersect.
constexpr double kMaxApart = 0.95;

bool is_allowed(const ToolCircle& cleared, const ToolCircle& next, const StepLimits& limits) {
  if (next.radius < limits.min_circle_mm) return false;
  const double distance = (next.centre - cleared.centre).norm();
  // The disc of the next circle is completely within the cleared disc.
  if (distance + next.radius <= cleared.radius) return true;
  if (distance > kMaxApart * (cleared.radius + next.radius)) return false;
  if (!crescent_between(cleared, next).exists) return false;
  return crescent_engagement(cleared, next, limits.tool_radius_mm) <= limits.engagement;
}

}  // namespace

AxisCourse::AxisCourse(const OwnedArea& area, std::vector<AxisPoint> points, double tool_radius_mm)
    : area_{area}, points_{std::move(points)}, lengths_{0.0}, tool_radius_mm_{tool_radius_mm} {
  for (std::size_t i = 1; i < points_.size(); ++i) {
    lengths_.push_back(lengths_.back() + (points_[i].place - points_[i - 1].place).norm());
  }
}

ToolCircle AxisCourse::circle_at(double s) const {
  const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - lengths_.begin());
  const double stretch = lengths_[i] - lengths_[i - 1];
  const double share = stretch > 0.0 ? std::clamp((s - lengths_[i - 1]) / stretch, 0.0, 1.0) : 1.0;
  const WideVec2 place = points_[i - 1].place + share * (points_[i].place - points_[i - 1].place);
  return {place, area_->depth(place) - tool_radius_mm_};
}

std::vector<WideVec2> AxisCourse::places_between(double from, double to) const {
  std::vector<WideVec2> places;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (lengths_[i] > from && lengths_[i] < to) places.push_back(points_[i].place);
  }
  return places;
}

std::optional<double> AxisCourse::farthest_reach(const WideVec2& place,
                                                 double from,
                                                 double to) const {
  std::optional<double> farthest;
  double most = 0.0;
  const auto first = std::upper_bound(lengths_.begin(), lengths_.end(), from);
  for (auto i = static_cast<std::size_t>(first - lengths_.begin());
       i < points_.size() && lengths_[i] < to;
       ++i) {
    const double reach = (points_[i].place - place).norm() + points_[i].radius;
    if (farthest && reach <= most) continue;
    most = reach;
    farthest = lengths_[i];
  }
  return farthest;
}

double next_crescent(const AxisCourse& course,
                     double from,
                     const ToolCircle& cleared,
                     const StepLimits& limits) {
  const auto allows = [&](double s) { return is_allowed(cleared, course.circle_at(s), limits); };
  // First step along the course, as a share of the tool's radius.
  constexpr double kFirstStep = 0.01;
  // Greatest step along the course, as a share of the tool's radius.
  constexpr double kGreatestStep = 0.1;
  constexpr double kGrowth = 1.5;
  constexpr int kHalvings = 24;
  double good = from;
  double bad = course.length();
  bool is_bounded = false;
  double step = kFirstStep * limits.tool_radius_mm;
  while (good < course.length() && !is_bounded) {
    const double end = std::min(good + step, course.length());
    const double peak = course.farthest_reach(cleared.centre, good, end).value_or(end);
    for (const double s : {peak, end}) {
      if (allows(s)) {
        good = s;
      } else {
        bad = s;
        is_bounded = true;
        break;
      }
    }
    step = std::min(kGrowth * step, kGreatestStep * limits.tool_radius_mm);
  }
  if (!is_bounded) return good;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (good + bad);
    (allows(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace sim::pocket
