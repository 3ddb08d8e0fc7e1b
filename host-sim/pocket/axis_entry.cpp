#include "host-sim/pocket/axis_entry.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "host-sim/pocket/wall_ramp.hpp"
#include "planner/pocket/moving_disc.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::EntryKind;
using cnc::pocket::ToolCircle;
using cnc::pocket::Use;

/// Greatest radius of a helix, as a share of the tool's radius. A wider helix would leave a core.
constexpr double kGreatestHelix = 0.9;
/// Least radius of a helix, as a share of the tool's radius. A narrower helix is nearly a plunge; a
/// ramp is better.
constexpr double kMinHelix = 0.1;

/// Returns the number of rounds in which an entry reaches the floor. A round is half a turn of a
/// helix, or a trip forth and back. Throws NoPocketPath if that number is too great.
double rounds_of(double round_mm, const WideVec2& place, const AdaptiveOptions& options) {
  return legs_of_ramp({.depth_mm = options.depth_mm, .slope = options.slope}, round_mm, place);
}

void sink_by_helix(const WideVec2& centre,
                   double radius_mm,
                   const AdaptiveOptions& options,
                   DepthWriter& writer) {
  const double half_mm = std::numbers::pi * radius_mm;
  const double halves = rounds_of(half_mm, centre, options);
  writer.begin_row(centre + WideVec2{radius_mm, 0.0});
  for (double half = 1.0; half <= halves; half += 1.0) {
    const double z = writer.floor_z() * (half / halves);
    writer.go(Use::kEntry, 2.0 * centre - writer.place(), 1.0, z);
  }
  writer.circle(Use::kEntry, centre);
}

/// Descends evenly along the path `way`, forth and back.
void sink_by_ramp(const std::vector<WideVec2>& way,
                  const AdaptiveOptions& options,
                  DepthWriter& writer) {
  const double round_mm = 2.0 * way_length(way);
  const double rounds = rounds_of(round_mm, way.front(), options);
  std::vector<WideVec2> round{way.begin() + 1, way.end()};
  round.insert(round.end(), way.rbegin() + 1, way.rend());
  writer.begin_row(way.front());
  for (double done = 0.0; done < rounds; done += 1.0) {
    double along_mm = 0.0;
    for (const WideVec2& place : round) {
      along_mm += (place - writer.place()).norm();
      const double share = (done + along_mm / round_mm) / rounds;
      writer.go(Use::kEntry, place, 0.0, writer.floor_z() * std::min(share, 1.0));
    }
  }
  writer.settle();
}

/// Goes around the centre, which is the tool's position, so that a spiral can begin. A spiral
/// cannot begin in a hole as wide as the tool: at least a quarter of the circumference would be
/// engaged.
void widen(const ToolCircle& circle, const AdaptiveOptions& options, DepthWriter& writer) {
  const double radius_mm = std::min(circle.radius, kMinHelix * options.tool_radius_mm);
  if (radius_mm <= 0.0) return;
  writer.go(Use::kEntry, circle.centre + WideVec2{radius_mm, 0.0}, 0.0, writer.floor_z());
  writer.circle(Use::kEntry, circle.centre);
}

}  // namespace

bool fits_in_line(const WideVec2& from,
                  const WideVec2& to,
                  const cnc::pocket::AreaDistance& area,
                  double tool_radius_mm) {
  // Greatest distance by which rounding may move the tool across the boundary.
  constexpr double kExcessMm = 1.0e-7;
  return excess_of({from, to, tool_radius_mm, tool_radius_mm}, area) <= kExcessMm;
}

double way_length(const std::vector<WideVec2>& way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return length;
}

std::vector<WideVec2> fitting_way(const std::vector<WideVec2>& way,
                                  const cnc::pocket::AreaDistance& area,
                                  double tool_radius_mm,
                                  double longest_mm) {
  std::vector<WideVec2> fitting{way.front()};
  double left_mm = longest_mm;
  for (std::size_t i = 1; i < way.size() && left_mm > 0.0; ++i) {
    const WideVec2 line = way[i] - fitting.back();
    const double length = line.norm();
    if (length == 0.0) continue;
    const WideVec2 end = fitting.back() + std::min(left_mm / length, 1.0) * line;
    if (!fits_in_line(fitting.back(), end, area, tool_radius_mm)) break;
    fitting.push_back(end);
    left_mm -= length;
  }
  return fitting;
}

void enter_stock(const ToolCircle& circle,
                 const std::vector<WideVec2>& way,
                 const AdaptiveOptions& options,
                 DepthWriter& writer) {
  if (options.entry == EntryKind::kPlunge) {
    writer.begin_row(circle.centre);
    writer.go(Use::kEntry, circle.centre, 0.0, writer.floor_z());
    return widen(circle, options, writer);
  }
  const double helix_mm = std::clamp(circle.radius, 0.0, kGreatestHelix * options.tool_radius_mm);
  const bool has_wide_helix = helix_mm >= kMinHelix * options.tool_radius_mm;
  const bool has_longer_ramp = way_length(way) > std::numbers::pi * helix_mm;
  if (has_longer_ramp && (!has_wide_helix || options.entry == EntryKind::kRamp)) {
    sink_by_ramp(way, options, writer);
    widen(circle, options, writer);
  } else {
    sink_by_helix(circle.centre, helix_mm, options, writer);
  }
}

}  // namespace sim::pocket
