#include "host-sim/pocket/disc_spiral.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::ToolCircle;
using cnc::pocket::Use;

/// Returns a half circle to the left. It begins at `from`, which is offset from `centre` along X,
/// and ends on the other side of the centre at the distance `radius_mm`.
ToolCircle half_circle(const WideVec2& from, const WideVec2& centre, double radius_mm) {
  const double side = from.x() >= centre.x() ? 1.0 : -1.0;
  const WideVec2 to = centre - WideVec2{side * radius_mm, 0.0};
  return {0.5 * (from + to), 0.5 * (from - to).norm()};
}

/// Returns whether a tool on the half circle `half` stays within the engagement if only the disc
/// `cleared` is free of stock.
bool is_allowed(const ToolCircle& cleared,
                const ToolCircle& half,
                const WideVec2& from,
                const StepLimits& limits) {
  constexpr int kSamples = 16;
  const cnc::pocket::ClearedDisc disc{cleared.centre, cleared.radius + limits.tool_radius_mm};
  const WideVec2 start = from - half.centre;
  for (int i = 1; i <= kSamples; ++i) {
    const double angle = std::numbers::pi * i / kSamples;
    const WideVec2 out = std::cos(angle) * start + std::sin(angle) * cnc::left_normal(start);
    const WideVec2 forwards = cnc::left_normal(out) / half.radius;
    const double engaged =
        cnc::pocket::engagement(disc, limits.tool_radius_mm, half.centre + out, forwards);
    if (engaged > limits.engagement) return false;
  }
  return true;
}

/// Returns the greatest radius at the end of the next half circle that keeps the engagement. The
/// result is between `min_mm` and the radius of `circle`.
double widest_half(const ToolCircle& cleared,
                   const WideVec2& from,
                   const ToolCircle& circle,
                   double min_mm,
                   const StepLimits& limits) {
  constexpr int kHalvings = 24;
  // Least growth of each half circle, as a share of the tool's radius. It ensures that the spiral
  // ends.
  constexpr double kMinGrowth = 1.0e-3;
  const auto allows = [&](double radius_mm) {
    return is_allowed(cleared, half_circle(from, circle.centre, radius_mm), from, limits);
  };
  double good = min_mm;
  double bad = std::min(min_mm + 2.0 * limits.tool_radius_mm, circle.radius);
  if (allows(bad)) return bad;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (good + bad);
    (allows(middle) ? good : bad) = middle;
  }
  return std::min(std::max(good, min_mm + kMinGrowth * limits.tool_radius_mm), circle.radius);
}

}  // namespace

void open_by_spiral(const ToolCircle& circle, const StepLimits& limits, DepthWriter& writer) {
  double radius = (writer.place() - circle.centre).norm();
  if (radius >= circle.radius) return;
  // The half circle before the last one is on the same side as the next one.
  ToolCircle before_last{circle.centre, radius};
  ToolCircle last = before_last;
  while (radius < circle.radius) {
    const WideVec2 from = writer.place();
    radius = widest_half(before_last, from, circle, radius, limits);
    before_last = last;
    last = half_circle(from, circle.centre, radius);
    writer.light_pass(2.0 * last.centre - from, 1.0);
  }
  writer.circle(Use::kLight, circle.centre);
}

}  // namespace sim::pocket
