#include "host-sim/surface/path/level_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "planner/surface/drop.hpp"

namespace sim::surface {
namespace {

/// Returns the height of a tool's lower surface at a distance from its axis; infinity beyond the
/// radius, where the tool's side is vertical.
double height_beside(const cnc::surface::Profile& tool, double distance_mm) {
  const double out = std::abs(distance_mm);
  if (out > tool.radius_mm) return std::numeric_limits<double>::infinity();
  return cnc::surface::height_at(tool, out);
}

/// Returns the greatest height, perpendicular to an inclined plane, of the stock that two poses
/// leave between their points of contact.
/// @param slope slope of the plane, mm per mm, above 0
double left_on_plane(const cnc::surface::Profile& tool, double slope, double distance_mm) {
  constexpr int kLooks = 1'000;
  const cnc::surface::PlaneContact contact = cnc::surface::contact_with_plane(tool, slope);
  const double across = distance_mm / slope;
  double greatest = 0.0;
  for (int i = 0; i < kLooks; ++i) {
    // Horizontal distance of the sample from the axis of the lower pose. The samples are between
    // the contact of the lower pose and the contact of the higher pose.
    const double beside = contact.out + across * (i + 0.5) / kLooks;
    const double left =
        std::min(height_beside(tool, beside), distance_mm + height_beside(tool, beside - across));
    greatest = std::max(greatest, left - contact.height - slope * (beside - contact.out));
  }
  return greatest / std::sqrt(1.0 + slope * slope);
}

}  // namespace

double level_distance(const cnc::surface::Profile& tool, double scallop_mm) {
  constexpr std::array kSlopes{1.0, 1.5, 3.0, 10.0, 100.0};
  constexpr int kHalvings = 50;
  double low = 0.0;
  double high = 4.0 * tool.radius_mm;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const bool is_near = std::ranges::all_of(
        kSlopes, [&](double slope) { return left_on_plane(tool, slope, middle) <= scallop_mm; });
    (is_near ? low : high) = middle;
  }
  return low;
}

}  // namespace sim::surface
