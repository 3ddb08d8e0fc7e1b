#include <utility>

#include "firmware/protocol/line_protocol.hpp"

/// Handles a tool change in which the sender takes part. The sender sends 0xA3, then lines for the
/// change. Until `~`, these lines are executed before the program lines that the sender had sent
/// earlier.
namespace cnc {

/// Lets the sender take part if the lines that arrived before 0xA3 are known with certainty. All
/// these lines must still wait in the receiver and leave free space for a line. Numbered lines can
/// be checked only in their order, so no numbered line may wait.
void LineProtocol::acknowledge_tool() {
  if (machine_.state() != MachineState::kTool || takes_part_) return;
  take_line_feed();
  if (receiver_.has_overrun() || receiver_.room() < kLongestLine + 2) return refuse_tool();
  if (check_.active() && receiver_.has_text()) {
    tool_refusal_ = "Tool change: numbered lines wait, ~ goes on";
    return;
  }
  if (!machine_.tool_change().open() && !machine_.acknowledge_tool()) return;
  receiver_.keep_back();
  takes_part_ = true;
}

void LineProtocol::refuse_tool() {
  if (machine_.state() != MachineState::kTool || takes_part_) return;
  tool_refusal_ = "Tool change: too many lines came before 0xA3, ~ goes on";
}

/// Takes the LF after a CR that ended a line, because a separate LF would end another line.
void LineProtocol::take_line_feed() {
  if (assembler_.ends_with_return() && receiver_.take_line_feed()) {
    static_cast<void>(assembler_.add('\n'));
  }
}

/// Resets the sender's part in the change. The tool change itself stays open and waits for `~` or
/// another 0xA3.
void LineProtocol::forget_tool_change() {
  takes_part_ = false;
  tool_change_ends_ = false;
  tool_refusal_ = {};
}

/// Returns whether a tool is being changed and the sender has not sent 0xA3.
bool LineProtocol::awaits_tool() const { return machine_.tool_change().open() && !takes_part_; }

/// Returns whether `command` is a `~` that ends a tool change. The change ends only after the lines
/// that arrived before `~` are done.
bool LineProtocol::ends_tool_change(RealtimeByte command) {
  const bool start =
      command == RealtimeByte::kCycleStart || command == RealtimeByte::kCycleStartRaw;
  if (!start || !machine_.tool_change().open()) return false;
  tool_change_ends_ = true;
  return true;
}

void LineProtocol::attend_tool_change() {
  if (machine_.tool_change().open()) {
    if (!tool_change_ends_ || machine_.busy() || owed_ != Owed::kNothing) return;
    take_line_feed();
    const bool lines_wait = assembler_.has_begun() || !receiver_.is_at_start();
    if (takes_part_ && lines_wait) return;
    tool_change_ends_ = false;
    return machine_.resume();
  }
  if (!takes_part_) return;
  // The lines that were kept back may continue only after the end of this line.
  if (assembler_.has_begun()) return;
  take_line_feed();
  receiver_.release();
  takes_part_ = false;
}

}  // namespace cnc
