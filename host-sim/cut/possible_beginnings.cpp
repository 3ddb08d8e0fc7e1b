#include "host-sim/cut/possible_beginnings.hpp"

#include "host-sim/cut/beginning.hpp"
#include "host-sim/cut/start_marks.hpp"

namespace sim::cut {

namespace {

/// Lists both directions of an open line as its beginnings. A cut at an offset with tabs, or with
/// loops or dwells at corners, has only the forward direction, because its tabs and corners were
/// made for this direction.
void list_both_ends(UnbegunCut& cut, bool is_beside) {
  const LayerSettings& settings = cut.settings;
  cut.beginnings = beginnings_of_line(cut.path);
  cut.may_move = false;
  if (!is_beside) return;
  // Open lines require no leads, so none is missing.
  for (Beginning& beginning : cut.beginnings) beginning.has_leads = true;
  const bool has_work = settings.corner_loop_mm > 0.0 || settings.corner_dwell_s > 0.0;
  if (settings.tabs != 0 || has_work) cut.beginnings.pop_back();
}

}  // namespace

void find_possible_beginnings(UnbegunCut& cut,
                              const Outline& outline,
                              const LeadRoom& leads,
                              const BeginningRoom& room) {
  const LayerSettings& settings = cut.settings;
  if (cut.is_open) {
    list_both_ends(cut, outline.is_beside);
    return;
  }
  BeginningWish wish{.where = settings.start, .count = room.count};
  const auto is_any = [&wish] {
    return wish.where == StartAt::kAny || wish.where == StartAt::kTab;
  };
  // A cut cannot begin at a corner at which the beam makes a loop or a dwell.
  const bool has_work_at_corners = settings.corner_loop_mm > 0.0 || settings.corner_dwell_s > 0.0;
  if (is_any() && has_work_at_corners) wish.where = StartAt::kStraight;
  // The beam of the controller reaches the edge a little later than the planned beam. Only in the
  // middle of a stroke is there always enough free space for this.
  if (is_any() && !room.is_planned_here) wish.where = StartAt::kUsual;
  if (room.mark) wish.marked_mm = way_nearest_to(cut.path, *room.mark);
  cut.beginnings = outline.is_beside ? beginnings_of(cut.path, settings, leads, wish)
                                     : beginnings_on_line(cut.path, settings, wish);
  cut.may_move = !wish.marked_mm && !has_work_at_corners && room.is_planned_here &&
                 (is_any() || wish.where == StartAt::kStraight);
}

}  // namespace sim::cut
