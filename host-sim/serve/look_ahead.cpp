#include "host-sim/serve/look_ahead.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "planner/base/contract.hpp"

namespace sim {
namespace {

// Maximum number of bytes that the receiver sorts in one step. The receiver has capacity for this
// number in any state.
constexpr std::size_t kChunk = 64;
static_assert(kChunk < cnc::Receiver::kRealBytes);

/// Returns whether `byte` is a realtime byte whose position among the lines may matter: the
/// acknowledgement of a tool change (0xA3) or one of the two bytes for cycle start (`~` and 0x81).
bool marks_a_place(char byte) {
  const auto code = static_cast<cnc::RealtimeByte>(byte);
  return code == cnc::RealtimeByte::kToolAcknowledge || code == cnc::RealtimeByte::kCycleStart ||
         code == cnc::RealtimeByte::kCycleStartRaw;
}

/// Returns the length of the next chunk, which ends after the first byte for which marks_a_place()
/// is true. So the receiver contains no text after this byte when it reports the byte.
std::size_t length_of_chunk(std::span<const char> bytes) {
  const std::span<const char> chunk = bytes.first(std::min(bytes.size(), kChunk));
  const auto mark = std::find_if(chunk.begin(), chunk.end(), marks_a_place);
  return static_cast<std::size_t>(mark - chunk.begin()) + (mark != chunk.end() ? 1 : 0);
}

std::span<const char> as_chars(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

LookAhead::LookAhead() : receiver_{std::make_unique<cnc::Receiver>()} {}

void LookAhead::hear(std::span<const std::byte> bytes, Session& session) {
  const bool strict = session.controller().firmware().checks_lines();
  receiver_->be_strict(strict);
  std::span<const char> rest = as_chars(bytes);
  while (!rest.empty()) {
    // Most bytes are text without realtime bytes, which requires no sorting. Only the last byte of
    // a run of such bytes goes through the receiver, so that the receiver knows the position in the
    // line.
    const std::size_t run = strict ? 0 : receiver_->plain_run(rest);
    if (run > kChunk) {
      lines_.append(rest.first(run - 1));
      rest = rest.subspan(run - 1);
    }
    const std::span<const char> chunk = rest.first(length_of_chunk(rest));
    const std::size_t count = receiver_->receive(chunk);
    CNC_ASSERT(count == chunk.size());
    rest = rest.subspan(count);
    act_on_realtime(session);
    keep_lines();
  }
}

/// Lets realtime bytes act in the order of the receiver. A reset acts first, because the receiver
/// has dropped all bytes before the reset.
void LookAhead::act_on_realtime(Session& session) {
  if (receiver_->take_reset()) {
    lines_.clear();
    marks_.clear();
    session.link().drop_incoming();
    session.act_at_once(static_cast<std::byte>(cnc::RealtimeByte::kReset));
  }
  if (receiver_->take_status_request()) {
    session.act_at_once(static_cast<std::byte>(cnc::RealtimeByte::kStatus));
  }
  if (receiver_->take_full_status_request()) {
    session.act_at_once(static_cast<std::byte>(cnc::RealtimeByte::kFullStatus));
  }
  for (cnc::RealtimeByte command{}; receiver_->take_command(command);) {
    if (!keep_in_order(command, session)) session.act_at_once(static_cast<std::byte>(command));
  }
}

/// Keeps a realtime byte among the lines if its position among them matters, and returns whether it
/// was kept. In a tool change, 0xA3 and the `~` after it separate lines that were sent before these
/// bytes from lines that were sent later. If the controller lacks the capacity for all lines before
/// 0xA3, the byte overtakes these lines, and the controller refuses it.
bool LookAhead::keep_in_order(cnc::RealtimeByte command, Session& session) {
  if (!marks_a_place(static_cast<char>(command))) return false;
  keep_lines();
  const auto& firmware = session.controller().firmware();
  const std::size_t ahead = size() + session.link().waiting();
  if (ahead == 0) marks_.clear();
  if (command == cnc::RealtimeByte::kToolAcknowledge) {
    if (ahead + kChunk > firmware.text_room()) return false;
  } else if (marks_.empty() && !firmware.machine().tool_change().open()) {
    return false;
  }
  marks_.push_back(command);
  const std::array<char, 2> twice{static_cast<char>(command), static_cast<char>(command)};
  lines_.append(std::span{twice}.first(firmware.checks_lines() ? 2 : 1));
  return true;
}

void LookAhead::keep_lines() {
  static_cast<void>(receiver_->take_until([this](char byte) {
    lines_.append({&byte, 1});
    return false;
  }));
}

void LookAhead::hand_over(Session& session) {
  std::size_t left = std::min(session.link().room(), size());
  while (left > 0) {
    const std::size_t count = std::min(left, lines_.front().size());
    session.link().receive(std::as_bytes(lines_.front().first(count)));
    lines_.pop(count);
    left -= count;
  }
}

std::string LookAhead::take_lines(Session& session) {
  std::string lines = lines_.text();
  lines_.clear();
  for (const cnc::RealtimeByte mark : std::exchange(marks_, {})) {
    session.act_at_once(static_cast<std::byte>(mark));
  }
  return lines;
}

void LookAhead::forget() {
  marks_.clear();
  if (size() == 0) return receiver_->begin_anew();
  receiver_->begin_anew();
  static_cast<void>(receiver_->take_reset());
  lines_.clear();
}

}  // namespace sim
