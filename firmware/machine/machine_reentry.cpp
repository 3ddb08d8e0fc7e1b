#include <utility>

#include "firmware/machine/machine.hpp"

namespace cnc {

/// While the tool works on a numbered line. A beam that is kept dark, by the door or because
/// nobody is at the link, works no more, although the motors have a way to go until they stand.
void Machine::note_progress() {
  const bool was_dark = std::exchange(seen_suspended_, tool_.suspended());
  if (reentry_.active() || !drive_.running() || was_dark) return;
  if (state_.in(Mode::kJog) || state_.in(Mode::kJogEnding) || state_.in(Mode::kHome)) return;
  if (drive_.line().number == 0) return;
  progress_.line = drive_.line();
  place_is_kept_ = true;
  place_progress(motion_.tool_steps());
}

/// The tool worked there last, on the line that is known or behind it.
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

/// What was noted before a restart is of a program that the restart interrupted.
bool Machine::interrupted() const {
  const bool stopped = state_.in(Mode::kHold) || state_.in(Mode::kDoor) ||
                       state_.in(Mode::kAlarm) || !place_is_kept_;
  return stopped && progress_.any() && at_rest();
}

void Machine::reenter() {
  CNC_ASSERT(idle() && progress_.any() && can_reenter());
  reentry_.begin(progress_.line, progress_place());
}

/// The path may round corners and weld lines within its tolerances, and shapers let it
/// leave them; so much more is allowed.
void Machine::darken_until_place(path::PathItem& item) {
  constexpr float kMoreMm = 0.1F;
  const float beside = item.tolerance.corner_mm + item.tolerance.weld_mm + kMoreMm;
  const Reentry::Verdict verdict = reentry_.judge(item, beside);
  if (verdict == Reentry::Verdict::kLit) return;
  item.request.beam = tool_.command_for(true);
  if (verdict == Reentry::Verdict::kLost) stop_for(Alarm::kPlaceNotMet);
}

/// What is left of an element that was split goes before all else. False while there is no room.
bool Machine::drive_rest() {
  if (!reentry_.has_rest()) return true;
  if (!motion_.has_room()) return false;
  CNC_ASSERT(motion_.append(reentry_.rest()).ok());
  reentry_.drop_rest();
  return true;
}

}  // namespace cnc
