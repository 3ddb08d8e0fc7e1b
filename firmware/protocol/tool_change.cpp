#include "firmware/protocol/line_protocol.hpp"

/// Handles a tool change in which the sender takes part. The sender sends 0xA3, then lines for the
/// change. Until `~`, these lines are executed before the program lines that the sender had sent
/// earlier.
namespace cnc {

/// Lets the sender take part if it is certain which lines arrived before 0xA3. All of these lines
/// must still wait in the receiver and leave free space for another line. If lines are checked,
/// none may wait, because later lines cannot be checked before them.
void LineProtocol::acknowledge_tool() {
  if (machine_.state() != MachineState::kTool || sender_part_.taken()) return;
  take_line_feed();
  if (receiver_.has_overrun() || receiver_.room() < kLongestLine + 2) return refuse_tool();
  if (check_.active() && receiver_.has_text()) {
    sender_part_.refuse("Tool change: numbered lines wait, ~ goes on");
    return;
  }
  if (!machine_.tool_change().open() && !machine_.acknowledge_tool()) return;
  receiver_.keep_back();
  sender_part_.begin();
}

void LineProtocol::refuse_tool() {
  if (machine_.state() != MachineState::kTool || sender_part_.taken()) return;
  sender_part_.refuse("Tool change: too many lines came before 0xA3, ~ goes on");
}

/// Takes the LF after a CR that ended a line, because the LF alone would count as the end of
/// another line.
void LineProtocol::take_line_feed() {
  if (assembler_.ends_with_return() && receiver_.take_line_feed()) {
    static_cast<void>(assembler_.add('\n'));
  }
}

/// Resets the sender's part in the change. The tool change itself stays open and waits for `~` or
/// another 0xA3.
void LineProtocol::forget_tool_change() { sender_part_ = {}; }

/// Returns whether a tool is being changed and the sender has not sent 0xA3.
bool LineProtocol::awaits_tool() const {
  return machine_.tool_change().open() && !sender_part_.taken();
}

/// Returns whether `command` is a `~` that ends a tool change. The change ends only after the lines
/// that arrived before `~` are done.
bool LineProtocol::ends_tool_change(RealtimeByte command) {
  const bool start =
      command == RealtimeByte::kCycleStart || command == RealtimeByte::kCycleStartRaw;
  if (!start || !machine_.tool_change().open()) return false;
  sender_part_.note_resume();
  return true;
}

void LineProtocol::attend_tool_change() {
  if (machine_.tool_change().open()) {
    if (!sender_part_.resumes() || machine_.busy() || owed_ != Owed::kNothing) return;
    take_line_feed();
    const bool lines_wait = assembler_.has_begun() || !receiver_.is_at_start();
    if (sender_part_.taken() && lines_wait) return;
    sender_part_.end_resume();
    return machine_.resume();
  }
  if (!sender_part_.taken()) return;
  // The lines that were kept back are read only after the line that has begun is complete.
  if (assembler_.has_begun()) return;
  take_line_feed();
  receiver_.release();
  sender_part_.end();
}

}  // namespace cnc
