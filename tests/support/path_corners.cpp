#include "tests/support/path_corners.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "planner/pocket/loop_measures.hpp"

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::Use;

constexpr double kSmooth_deg = 0.1;
constexpr double kSamePlace_mm = 1.0e-6;

/// Returns the angle between two directions, degrees.
double angle_between(const WideVec2& a, const WideVec2& b) {
  return std::abs(std::atan2(cnc::cross(a, b), a.dot(b))) * 180.0 / std::numbers::pi;
}

}  // namespace

std::vector<WideVec2> corners_of(const cnc::contour::ContourView<double>& contour) {
  std::vector<WideVec2> corners;
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    const std::uint32_t first = contour.loop_begin(loop);
    const std::uint32_t last = contour.loop_ends[loop] - 1;
    for (std::uint32_t i = first; i <= last; ++i) {
      cnc::contour::Curve<double> before, after;
      const std::uint32_t previous = i > first ? i - 1 : last;
      const bool are_curves =
          cnc::pocket::make_curve(cnc::pocket::element_at(contour, loop, previous), before) &&
          cnc::pocket::make_curve(cnc::pocket::element_at(contour, loop, i), after);
      const bool turns =
          !are_curves || angle_between(before.end_tangent, after.start_tangent) > kSmooth_deg;
      if (turns) corners.push_back(contour.vertices[i].point());
    }
  }
  return corners;
}

std::string corner_elsewhere(const sim::pocket::PathRows& milled,
                             const std::vector<WideVec2>& places) {
  const auto path = milled.path();
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    cnc::contour::Curve<double> before;
    bool has_before = false;
    for (std::uint32_t i = path.row_begin(row); i + 1 < path.row_ends[row]; ++i) {
      const auto& from = path.points[i];
      const auto& to = path.points[i + 1];
      cnc::contour::Curve<double> curve;
      const bool is_flat = from.z == to.z && from.use != Use::kEntry;
      const bool moves = cnc::pocket::make_curve({from.point(), to.point(), from.bulge}, curve);
      if (is_flat && !moves) continue;
      if (is_flat && has_before) {
        const double angle = angle_between(before.end_tangent, curve.start_tangent);
        const bool is_there = std::ranges::any_of(places, [&](const WideVec2& place) {
          return (place - from.point()).norm() <= kSamePlace_mm;
        });
        if (angle > kSmooth_deg && !is_there) {
          return std::to_string(angle) + " degrees at " + std::to_string(from.x) + " " +
                 std::to_string(from.y) + ", uses " +
                 std::to_string(static_cast<int>(path.points[i - 1].use)) + " " +
                 std::to_string(static_cast<int>(from.use));
        }
      }
      before = curve;
      has_before = is_flat;
    }
  }
  return {};
}

}  // namespace proof
