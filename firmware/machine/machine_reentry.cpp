#include "firmware/machine/machine.hpp"

namespace cnc {

/// Notes the progress while the tool works on a numbered line. Motion after the beam was blocked,
/// because of a door or a lost link, does not count as progress.
void Machine::note_progress() {
  if (!progress_.counts(tool_.suspended()) || !drive_.running()) return;
  if (state_.in(Mode::kJog) || state_.in(Mode::kJogEnding) || state_.in(Mode::kHome)) return;
  if (drive_.line().number == 0) return;
  progress_.note(drive_.line(), motion_.tool_steps());
}

/// Returns whether a program was interrupted and the machine is at rest. After a restart this is so
/// in every mode, because the restart has interrupted the program whose progress was restored.
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

/// Switches the beam of an item off until the path passes the noted position. The path may pass
/// this position at a distance of at most the sum of the corner tolerance, the weld tolerance, and
/// kMoreMm for the effect of shapers.
void Machine::darken_until_place(path::PathItem& item) {
  constexpr float kMoreMm = 0.1F;
  const float beside = item.tolerance.corner_mm + item.tolerance.weld_mm + kMoreMm;
  const Reentry::Verdict verdict = progress_.reentry().judge(item, beside);
  if (verdict == Reentry::Verdict::kLit) return;
  item.request.beam = tool_.command_for(true);
  if (verdict == Reentry::Verdict::kLost) stop_for(Alarm::kPlaceNotMet);
}

/// Appends the rest of an element that was split by re-entry. It must be appended before any other
/// motion. Returns false if the planner has no free space.
bool Machine::drive_rest() {
  if (!progress_.reentry().has_rest()) return true;
  if (!motion_.has_room()) return false;
  CNC_ASSERT(motion_.append(progress_.reentry().rest()).ok());
  progress_.reentry().drop_rest();
  return true;
}

}  // namespace cnc
