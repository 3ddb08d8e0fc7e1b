#include "planner/motion/segment/filtered_plan.hpp"

namespace cnc::motion {

Stretch FilteredPlan::next(std::uint32_t max_ns) {
  const bool stands = plan_.speed() <= 0.0F && filter_.at_rest();
  if (stands && drive_ == Drive::kOn) choose_window();
  if (!window_.filters()) return plan_.next(max_ns, drive_, true);
  Stretch stretch;
  while (!stretch.lasts() && fill_cell()) stretch = filter_.take();
  return stretch;
}

void FilteredPlan::reset() {
  plan_.reset();
  window_ = {};
  filter_ = {};
  plan_.set_window({});
}

/// Chooses the time window for the motion up to the next rest. @pre the motion is at rest
void FilteredPlan::choose_window() {
  if (plan_.at_end()) return;
  const TimeWindow window = plan_.choose_window();
  if (window == window_) return;
  window_ = window;
  plan_.set_window(window);
  filter_.begin(window);
}

/// Fills the present cell of the filter with the plan. Returns false if the plan and the motion are
/// both at rest and stay at rest.
bool FilteredPlan::fill_cell() {
  const bool may_start = filter_.at_rest();
  bool moves = !may_start;
  while (filter_.room_ns() > 0) {
    const Stretch stretch = plan_.next(filter_.room_ns(), drive_, may_start && !moves);
    if (stretch.lasts()) {
      filter_.add(stretch);
      moves = true;
    } else if (moves) {
      filter_.rest();
    } else {
      return false;
    }
  }
  return true;
}

}  // namespace cnc::motion
