#include "host-sim/pocket/fitting_approach.hpp"

#include "planner/contour/meeting.hpp"
#include "planner/pocket/loop_measures.hpp"
#include "planner/pocket/moving_disc.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::MovingDisc;
using Curve = cnc::contour::Curve<double>;

/// Returns whether a line between two points of an area leaves the area.
bool leaves(const WideVec2& from, const WideVec2& to, const OwnedArea& area) {
  Curve line;
  if (!cnc::pocket::make_curve<double>({from, to, 0.0}, line)) return false;
  bool meets = false;
  area->search(line.box(), [&](const Curve& wall) {
    constexpr double kOneMeetingMm = 1.0e-9;
    meets = cnc::contour::meetings_of(wall, line, kOneMeetingMm).count > 0;
    return !meets;
  });
  return meets;
}

/// Returns whether the tool stays in the area on the line from `from` and on the arc of an
/// approach.
bool fits(const Approach& approach,
          const WideVec2& from,
          const OwnedArea& area,
          double tool_radius_mm) {
  constexpr double kRoundingMm = 1.0e-6;
  if (leaves(from, approach.arc_start, area)) return false;
  const MovingDisc tool{from, approach.arc_start, tool_radius_mm, tool_radius_mm};
  if (excess_of(tool, *area) > kRoundingMm) return false;
  constexpr int kLooks = 16;
  for (int i = 1; i < kLooks; ++i) {
    const WideVec2 place = approach.place_at(static_cast<double>(i) / kLooks);
    if (area->depth(place) < tool_radius_mm - kRoundingMm) return false;
  }
  return true;
}

}  // namespace

Approach fitting_approach(const WideVec2& from,
                          const Pose& cut,
                          const OwnedArea& area,
                          double tool_radius_mm) {
  for (double turn_mm = kTurnOfTool * tool_radius_mm; turn_mm >= kMinTurnMm; turn_mm *= 0.5) {
    Approach approach = approach_from(from, cut, turn_mm);
    if (approach.exists && fits(approach, from, area, tool_radius_mm)) return approach;
  }
  return {};
}

}  // namespace sim::pocket
