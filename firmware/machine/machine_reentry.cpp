#include "firmware/machine/machine.hpp"

namespace cnc {

/// Notes the progress while the tool works on a numbered line. A beam that is blocked, by the door
/// or because the link is lost, no longer works, although the motors still move until they rest.
void Machine::note_progress() {
  if (!progress_.counts(tool_.suspended()) || !drive_.running()) return;
  if (state_.in(Mode::kJog) || state_.in(Mode::kJogEnding) || state_.in(Mode::kHome)) return;
  if (drive_.line().number == 0) return;
  progress_.note(drive_.line(), motion_.tool_steps());
}

/// Progress that was noted before a restart belongs to a program that the restart interrupted.
bool Machine::interrupted() const {
  const bool stopped = state_.in(Mode::kHold) || state_.in(Mode::kDoor) ||
                       state_.in(Mode::kAlarm) || !progress_.place_is_kept();
  return stopped && progress_.noted().any() && motion_.at_rest();
}

void Machine::reenter() {
  const Progress& noted = progress_.noted();
  CNC_ASSERT(idle() && noted.any() && progress_.can_reenter(homed()));
  progress_.reentry().begin(noted.line, motion_.place_of(noted.steps));
}

/// Switches the beam of an item off until the position of the progress is passed. The path may be
/// off that position by the tolerances of corners and welded lines, and by kMoreMm, which shapers
/// may add.
void Machine::darken_until_place(path::PathItem& item) {
  constexpr float kMoreMm = 0.1F;
  const float beside = item.tolerance.corner_mm + item.tolerance.weld_mm + kMoreMm;
  const Reentry::Verdict verdict = progress_.reentry().judge(item, beside);
  if (verdict == Reentry::Verdict::kLit) return;
  item.request.beam = tool_.command_for(true);
  if (verdict == Reentry::Verdict::kLost) stop_for(Alarm::kPlaceNotMet);
}

/// Appends the rest of an element that was split, before all other motion. Returns false if there
/// is no free space.
bool Machine::drive_rest() {
  if (!progress_.reentry().has_rest()) return true;
  if (!motion_.has_room()) return false;
  CNC_ASSERT(motion_.append(progress_.reentry().rest()).ok());
  progress_.reentry().drop_rest();
  return true;
}

}  // namespace cnc
