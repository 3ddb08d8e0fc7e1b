#include <utility>

#include "firmware/protocol/line_protocol.hpp"

/// A tool change in which the sender takes part: 0xA3, then lines of its own before those that it
/// had sent ahead, until `~`.
namespace cnc {

/// Checked lines that wait have numbers before those of the change, and can be judged in their
/// order only: their sender acknowledges a tool when all are answered.
void LineProtocol::acknowledge_tool() {
  if (check_.strict() && receiver_.has_text()) return;
  if (machine_.acknowledge_tool()) receiver_.keep_back(assembler_.ends_with_return());
}

/// True where `~` belongs to a tool change: what came before it is done first.
bool LineProtocol::ends_tool_change(RealtimeByte command) {
  const bool start =
      command == RealtimeByte::kCycleStart || command == RealtimeByte::kCycleStartRaw;
  if (!start || !machine_.changes_tool()) return false;
  tool_change_ends_ = true;
  return true;
}

void LineProtocol::attend_tool_change() {
  if (!receiver_.keeps_back()) return;
  if (machine_.changes_tool()) {
    if (!tool_change_ends_ || machine_.busy() || owed_ != Owed::kNothing) return;
    const bool within_line = assembler_.has_begun();
    if (within_line || !receiver_.is_at_start(assembler_.ends_with_return())) return;
    tool_change_ends_ = false;
    return machine_.resume();
  }
  if (assembler_.has_begun()) return;  // Its end lies behind what was kept back.
  receiver_.release(assembler_.ends_with_return());
}

}  // namespace cnc
