#include "firmware/machine/compensated_path.hpp"

#include "planner/base/contract.hpp"

namespace cnc {

const kerf::KerfCourse& CompensatedPath::course_from(const kerf::Condition& condition) {
  const auto refusal = course_.begin(kerf_.view, condition);
  CNC_ASSERT(!refusal);
  return course_;
}

bool CompensatedPath::begin_with(const PathElement& element) {
  if (!is_wanted() || active()) return true;
  if (!compensation::moves_in(wanted_plane_, element)) return false;
  const bool left = wanted_.side == gcode::CutterSide::kLeft;
  const float offset_mm = 0.5F * wanted_.width_mm;
  begin(element.start, wanted_plane_, left ? -offset_mm : offset_mm);
  return true;
}

void CompensatedPath::move_apart(PathElement& element) {
  stand_at(element.end);
  if (!beside()) return;
  const PlaneAxes axes = axes_of(plane());
  for (const std::size_t axis : {axes.first, axes.second}) {
    element.start[axis] = element.end[axis] = driven()[axis];
  }
}

bool CompensatedPath::stays_beside(const Position& end) const {
  const PathElement motion{.start = programmed(), .end = end};
  return motion.start != motion.end && !compensation::moves_in(plane(), motion);
}

}  // namespace cnc
