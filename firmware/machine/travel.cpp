#include "firmware/machine/travel.hpp"

#include <algorithm>

#include "planner/geometry/arc_reach.hpp"
#include "planner/geometry/spline_reach.hpp"
#include "planner/motion/block/axis_limits.hpp"
#include "planner/motion/block/block_builder.hpp"

namespace cnc {
namespace {

/// Distance, nm, by which a circle may exceed the end of the travel. The radius is a float, so a
/// circle that only touches the end may exceed it by rounding.
constexpr Coordinate kSlack{1000};

}  // namespace

bool has_homing_option(const Settings& settings, unsigned option) {
  return (static_cast<unsigned>(settings.get(setting::kHoming)) & option) != 0;
}

AxisTravel travel_of(const Settings& settings, std::size_t axis) {
  const Coordinate length = from_mm(settings.get(setting::kTravel, axis));
  const auto mask = static_cast<unsigned>(settings.get(setting::kHomingDirectionInvert));
  const bool homes_low = (mask >> axis & 1U) != 0;
  const bool positive = homes_low && has_homing_option(settings, homing_option::kSetOrigin);
  return positive ? AxisTravel{.least = {}, .most = length}
                  : AxisTravel{.least = -length, .most = {}};
}

void Travel::configure(const Settings& settings) {
  judged_ = 0;
  if (settings.get(setting::kSoftLimits) == 0.0F) return;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const auto bit = static_cast<std::uint8_t>(1U << axis);
    if ((homed_ & bit) == 0 || settings.get(setting::kTravel, axis) <= 0.0F) continue;
    judged_ = static_cast<std::uint8_t>(judged_ | bit);
    const AxisTravel travel = travel_of(settings, axis);
    min_[axis] = travel.least;
    max_[axis] = travel.most;
  }
}

bool Travel::left_by(gcode::Actions actions, const Position& from) const {
  if (judged_ == 0) return false;
  Position here = from;
  for (const gcode::Action& action : actions) {
    switch (action.kind) {
      case gcode::ActionKind::kArc:
        if (!contains_arc(here, action)) return true;
        break;
      case gcode::ActionKind::kSpline:
        if (!contains_spline(here, action)) return true;
        break;
      case gcode::ActionKind::kRapid:
      case gcode::ActionKind::kLine:
      case gcode::ActionKind::kProbe:
        if (!contains(action.end)) return true;
        break;
      default:
        continue;
    }
    here = action.end;
  }
  return false;
}

bool Travel::left_by(gcode::Actions actions,
                     const Position& from,
                     const FiveAxes& machine,
                     ActionElements& elements) const {
  constexpr std::uint32_t kPartsOfATurn = 64;
  Position here = from;
  bool stays = true;
  for (const gcode::Action& action : actions) {
    if (!stays || !ActionElements::accepts(action)) continue;
    const bool turns = action.kind == gcode::ActionKind::kArc;
    const std::uint32_t parts = machine.centre.parts_of(here, action.end);
    elements.begin(action,
                   here,
                   ArcFit::kMinToleranceMm,
                   turns ? std::max(parts, kPartsOfATurn * action.turns) : parts);
    while (stays && !elements.done()) stays = contains_axes(elements.next().element, machine);
    elements.clear();
    here = action.end;
  }
  return !stays;
}

bool Travel::contains_axes(const PathElement& element, const FiveAxes& machine) const {
  const kinematics::RotaryMachine& axes = machine.centre.machine();
  const float tilt = element.end[index_of(axes.tilting)].mm();
  if (tilt < axes.min_tilt_deg || tilt > axes.max_tilt_deg) return false;
  if (judged_ == 0) return true;
  const auto block = motion::build_block({.element = element}, machine.limits);
  if (!block.ok()) return block.error() == motion::MotionError::kNothingToMove;
  const motion::AxisCourse course =
      motion::axis_course(block.value(), element.start, machine.centre);
  Position least = element.end;
  Position most = element.end;
  for (std::size_t axis = 0; axis < kLinearAxisCount; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    least[axis] = machine.centre.centre()[axis] + from_mm(course.least[i]);
    most[axis] = machine.centre.centre()[axis] + from_mm(course.most[i]);
  }
  return contains(least) && contains(most);
}

bool Travel::contains(const Position& place) const {
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if ((judged_ >> axis & 1U) == 0) continue;
    if (place[axis] < min_[axis] - kSlack || place[axis] > max_[axis] + kSlack) return false;
  }
  return true;
}

bool Travel::contains_arc(const Position& start, const gcode::Action& arc) const {
  const Box reach = reach_of({.start = start,
                              .end = arc.end,
                              .plane = arc.plane,
                              .centre = arc.centre,
                              .clockwise = arc.clockwise,
                              .turns = arc.turns});
  return contains(reach.least) && contains(reach.most);
}

bool Travel::contains_spline(const Position& start, const gcode::Action& spline) const {
  constexpr Coordinate kAnywhere{2 * Coordinate::kFarthestNanometres};
  std::array<Coordinate, 2> least{-kAnywhere, -kAnywhere};
  std::array<Coordinate, 2> most{kAnywhere, kAnywhere};
  for (std::size_t axis = 0; axis < least.size(); ++axis) {
    if ((judged_ >> axis & 1U) == 0) continue;
    least[axis] = min_[axis] - kSlack - start[axis];
    most[axis] = max_[axis] + kSlack - start[axis];
  }
  return stays_within(*spline.spline,
                      {.least = {least[0].nanometres(), least[1].nanometres()},
                       .most = {most[0].nanometres(), most[1].nanometres()}});
}

Position Travel::clamped(const Position& place) const {
  Position inside = place;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if ((judged_ >> axis & 1U) == 0) continue;
    inside[axis] = std::clamp(place[axis], min_[axis], max_[axis]);
  }
  return inside;
}

}  // namespace cnc
