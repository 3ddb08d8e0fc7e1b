#include "host-sim/pocket/axis_course.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::ToolCircle;

/// Of the sum of both radii, that the centres of neighbouring circles may be apart: farther, they
/// hardly meet.
constexpr double kMostApart = 0.95;

bool is_allowed(const ToolCircle& cleared, const ToolCircle& next, const StepLimits& limits) {
  if (next.radius < limits.least_circle_mm) return false;
  const double distance = (next.centre - cleared.centre).norm();
  if (distance + next.radius <= cleared.radius) return true;  // All of it is cleared.
  if (distance > kMostApart * (cleared.radius + next.radius)) return false;
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

double next_crescent(const AxisCourse& course,
                     double from,
                     const ToolCircle& cleared,
                     const StepLimits& limits) {
  const auto allows = [&](double s) { return is_allowed(cleared, course.circle_at(s), limits); };
  constexpr double kFirstStep = 0.01;  // Of the tool's radius.
  constexpr double kGrowth = 1.5;
  constexpr int kHalvings = 24;
  double good = from;
  double bad = course.length();
  bool is_bounded = false;
  for (double step = kFirstStep * limits.tool_radius_mm; good < course.length(); step *= kGrowth) {
    const double end = std::min(from + step, course.length());
    if (!allows(end)) {
      bad = end;
      is_bounded = true;
      break;
    }
    good = end;
  }
  if (!is_bounded) return good;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (good + bad);
    (allows(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace sim::pocket
