#include "firmware/protocol/code_texts.hpp"
#include "firmware/protocol/line_protocol.hpp"
#include "planner/gcode/decimal.hpp"

namespace cnc {

/// Writes `[RESUME:120|12.000,3.500,0.000|can]`: number of the interrupted line, position in
/// machine coordinates, and `can` or `home`, depending on whether the position is still valid.
/// Writes `[RESUME:0]` if no program was interrupted.
void LineProtocol::tell_progress() {
  const Progress& progress = machine_.progress().noted();
  Reply reply = begin_answer();
  reply.text("[RESUME:").number(progress.line.number);
  if (progress.any()) {
    reply.letter('|');
    put_places(reply, machine_.motion().place_of(progress.steps), form_);
    reply.text(machine_.progress().can_reenter(machine_.homed()) ? "|can" : "|home");
  }
  answer(reply.letter(']').end());
  acknowledge();
}

/// Begins re-entry into the interrupted program. The sender must name the interrupted line, so that
/// the operator does not continue a wrong program. The number 0 ends re-entry.
void LineProtocol::reenter(const Statement& statement) {
  const auto line = gcode::read_decimal(statement.text);
  const bool whole = line.ok() && line.value().length == statement.text.size() &&
                     line.value().value.is_integer() && !line.value().value.is_negative();
  const std::uint32_t wanted = whole ? line.value().value.whole : 0;
  if (!whole) {
    return refuse(error_number::kBadNumber, statement.column, "not the number of a line");
  }
  if (wanted == 0) {
    machine_.progress().reentry().cancel();
    return acknowledge();
  }
  if (wanted != machine_.progress().noted().line.number) {
    return refuse(
        error_number::kBadNumber, statement.column, "no program was interrupted at this line");
  }
  if (!machine_.progress().can_reenter(machine_.homed())) {
    return refuse(error_number::kLocked, 0, "the position may be lost: home first");
  }
  if (machine_.locked()) return refuse(error_number::kLocked);
  machine_.reenter();
  message("Beam off until the position is passed");
  acknowledge();
}

/// Saves the progress while the machine is at rest. So the progress of a program in a hold or an
/// alarm survives a loss of power. Erases the stored progress after the program has ended. If the
/// store is damaged, nothing is saved: a save would remove the sign of damage before the operator
/// has acknowledged it.
void LineProtocol::save_progress() {
  if (machine_.alarm() == Alarm::kStoreDamaged) return;
  const Progress& progress = machine_.progress().noted();
  if (progress.any() ? !machine_.interrupted() : !stored_.has_progress()) return;
  if (stored_.has_saved(progress) || saving_failed_ || machine_.tool_runs() ||
      !machine_.motion().at_rest())
    return;
  if (stored_.save_progress(progress)) return;
  saving_failed_ = true;
  message("The store cannot keep the program's progress");
}

}  // namespace cnc
