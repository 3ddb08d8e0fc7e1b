#include "firmware/protocol/compensation_text.hpp"

#include <string_view>

#include "firmware/protocol/line_protocol.hpp"

namespace cnc {
namespace {

std::string_view words_of(compensation::Reason reason) {
  using enum compensation::Reason;
  switch (reason) {
    case kEntryTooShort:
      return " is the entry, and must be longer than half the cut";
    case kExitNotALine:
      return " is the exit, and must be a straight line";
    case kOtherAxis:
      return " moves out of the plane";
    case kUnreachable:
      return " is narrower than the cut";
    case kTooNear:
      return " leads into";
    case kWouldSplit:
      return " is cut off by";
  }
  return "";
}

void put_element(Reply& reply, std::uint32_t element, std::uint32_t line) {
  reply.text("element ").number(element);
  if (line != 0) reply.text(" (N").number(line).letter(')');
}

}  // namespace

void put_compensation_fault(Reply& reply, const compensation::Fault& fault) {
  put_element(reply, fault.element, fault.line);
  reply.text(words_of(fault.reason));
  const bool two = fault.reason == compensation::Reason::kTooNear ||
                   fault.reason == compensation::Reason::kWouldSplit;
  if (two) put_element(reply.letter(' '), fault.other, fault.other_line);
}

/// Refuses a line with the error "invalid target", because of `fault`, which is in this line or an
/// earlier line.
void LineProtocol::refuse(const compensation::Fault& fault) {
  Reply reason = begin_reason(0);
  put_compensation_fault(reason.text("since G41 or G42, "), fault);
  refuse(static_cast<std::uint8_t>(gcode::ErrorCode::kInvalidTarget), reason);
}

}  // namespace cnc
