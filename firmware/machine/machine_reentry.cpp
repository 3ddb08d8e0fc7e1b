#include <utility>

#include "firmware/machine/machine.hpp"

namespace cnc {

/// Notes the progress while the tool works on a numbered line. A beam that is blocked, by the door
/// or because the link is lost, no longer works, although the motors still move until they rest.
void Machine::note_progress() {
  const bool was_dark = std::exchange(seen_suspended_, tool_.suspended());
  if (reentry_.active() || !drive_.running() || was_dark) return;
  if (state_.in(Mode::kJog) || state_.in(Mode::kJogEnding) || state_.in(Mode::kHome)) return;
  if (drive_.line().number == 0) return;
  progress_.line = drive_.line();
  place_is_kept_ = true;
  place_progress(motion_.tool_steps());
}

/// Notes the position at which the tool worked last, on the known line or a later one.
void Machine::place_progress(const AxisArray<std::int32_t>& steps) {
  if (!progress_.any()) return;
  progress_.steps = steps;
  if (kept_progress_ != nullptr) kept_progress_->keep(progress_);
}

void Machine::forget_progress() { set_progress({}); }

void Machine::set_progress(const Progress& progress) {
  progress_ = progress;
  place_is_kept_ = false;
  if (kept_progress_ != nullptr) kept_progress_->keep(progress_);
}

/// Progress that was noted before a restart belongs to a program that the restart interrupted.
bool Machine::interrupted() const {
  const bool stopped = state_.in(Mode::kHold) || state_.in(Mode::kDoor) ||
                       state_.in(Mode::kAlarm) || !place_is_kept_;
  return stopped && progress_.any() && at_rest();
}

void Machine::reenter() {
  CNC_ASSERT(idle() && progress_.any() && can_reenter());
  reentry_.begin(progress_.line, progress_place());
}

/// Switches the beam of an item off until the position of the progress is passed. The path may be
/// off that position by the tolerances of corners and welded lines, and by kMoreMm, which shapers
/// may add.
void Machine::darken_until_place(path::PathItem& item) {
  constexpr float kMoreMm = 0.1F;
  const float beside = item.tolerance.corner_mm + item.tolerance.weld_mm + kMoreMm;
  const Reentry::Verdict verdict = reentry_.judge(item, beside);
  if (verdict == Reentry::Verdict::kLit) return;
  item.request.beam = tool_.command_for(true);
  if (verdict == Reentry::Verdict::kLost) stop_for(Alarm::kPlaceNotMet);
}

/// Appends the rest of an element that was split, before all other motion. Returns false if there
/// is no free space.
bool Machine::drive_rest() {
  if (!reentry_.has_rest()) return true;
  if (!motion_.has_room()) return false;
  CNC_ASSERT(motion_.append(reentry_.rest()).ok());
  reentry_.drop_rest();
  return true;
}

}  // namespace cnc
