#include "host-sim/pocket/wall_ramp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host-sim/pocket/pocket_plan.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::pocket::Use;

/// Greatest number of legs of a ramp, forth, back or around.
constexpr double kMaxLegs = 1000.0;

/// Returns the middle of the longest element of a loop.
cnc::pocket::LoopPlace<double> longest_middle(const cnc::contour::ContourView<double>& locus,
                                              std::size_t loop) {
  cnc::pocket::LoopPlace<double> best;
  double longest = -1.0;
  for (std::uint32_t i = locus.loop_begin(loop); i < locus.loop_ends[loop]; ++i) {
    const auto element = cnc::pocket::element_at(locus, loop, i);
    const double chord = (element.end - element.start).norm();
    if (chord <= longest) continue;
    longest = chord;
    best = {loop, i, {element.middle(), {1.0, 0.0}}};
  }
  return best;
}

}  // namespace

double legs_of_ramp(const WallDrive& drive, double length_mm, const WideVec2& place) {
  const double legs = std::max(1.0, std::ceil(drive.depth_mm / (drive.slope * length_mm)));
  if (legs <= kMaxLegs) return legs;
  throw NoPocketPath{
      fmt::format("at {:.3f} {:.3f} a ramp would be only {:.3g} mm long; choose --entry plunge or "
                  "a smaller tool",
                  place.x(),
                  place.y(),
                  length_mm)};
}

void revolve(const cnc::contour::ContourView<double>& locus,
             const cnc::pocket::LoopPlace<double>& place,
             cnc::pocket::Milling milling,
             const cnc::pocket::LoopDrive<double>& drive,
             PathRows& out) {
  const std::size_t first = out.points.size();
  // The element that contains the starting point is divided in two, so there is one more element.
  out.points.resize(first + locus.loop_ends[place.loop] - locus.loop_begin(place.loop) + 1);
  cnc::pocket::ToolPathWriter<double> writer{{out.points.data() + first, out.points.size() - first},
                                             {}};
  const bool has_space = cnc::pocket::drive_loop<double>(locus, place, milling, drive, writer);
  CNC_ASSERT(has_space);
}

void ramp_along_wall(const cnc::contour::ContourView<double>& locus,
                     std::size_t loop,
                     const WallDrive& drive,
                     PathRows& out) {
  const auto place = longest_middle(locus, loop);
  const WideVec2& start = place.pose.point;
  const double floor = -drive.depth_mm;
  if (drive.plunges) {
    out.points.push_back({start.x(), start.y(), 0.0, 0.0, Use::kEntry});
  } else {
    const double legs = legs_of_ramp(drive, cnc::pocket::loop_length(locus, loop), start);
    for (double leg = 0.0; leg < legs; leg += 1.0) {
      const double from = floor * leg / legs;
      const double to = floor * (leg + 1.0) / legs;
      revolve(locus, place, drive.milling, {from, to, Use::kEntry}, out);
    }
  }
  revolve(locus, place, drive.milling, {floor, floor, Use::kPass}, out);
  out.points.push_back({start.x(), start.y(), floor, 0.0, Use::kPass});
  out.end_row();
}

}  // namespace sim::pocket
