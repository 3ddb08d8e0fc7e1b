#include "firmware/link/link_choice.hpp"

#include <array>

#include "firmware/link/realtime_byte.hpp"

namespace cnc {
namespace {

constexpr std::byte kLineFeed{'\n'};
constexpr std::byte kReturn{'\r'};

/// Returns whether `byte` is a realtime byte, which acts within a line or between two lines. No
/// line begins with such a byte.
constexpr bool is_realtime(std::byte byte) {
  const auto code = std::to_integer<std::uint8_t>(byte);
  return code >= 0x80 || is_ascii_realtime(code);
}

}  // namespace

LinkChoice::Change LinkChoice::attend() {
  const std::uint32_t now = first_.session();
  if (session_ != 0) drop_second();
  if (now == session_) return Change::kNone;
  session_ = now;
  skipping_ = within_line_;
  // This call drops unread bytes of the closed session. Otherwise they would fill the receive
  // memory, and the next sender would have to wait.
  if (now == 0) static_cast<void>(first_.read({}));
  return now != 0 ? Change::kCame : Change::kWent;
}

/// Drops bytes that arrived on the second link, a bounded number in each call.
void LinkChoice::drop_second() {
  constexpr int kChunks = 16;
  std::array<std::byte, 64> dropped{};
  for (int chunk = 0; chunk < kChunks; ++chunk) {
    const std::size_t count = second_.read(dropped);
    if (count == 0) return;
    for (std::size_t at = 0; at < count; ++at) {
      static_cast<void>(belongs_to_whole_line(dropped[at]));
    }
  }
}

bool LinkChoice::belongs_to_whole_line(std::byte byte) {
  if (is_realtime(byte)) return true;
  const bool skipped = skipping_;
  within_line_ = byte != kLineFeed && byte != kReturn;
  if (!within_line_) skipping_ = false;
  return !skipped;
}

std::size_t LinkChoice::read(std::span<std::byte> into) {
  if (session_ != 0) return first_.session() == session_ ? first_.read(into) : 0;
  const std::size_t count = second_.read(into);
  std::size_t kept = 0;
  for (std::size_t at = 0; at < count; ++at) {
    if (belongs_to_whole_line(into[at])) into[kept++] = into[at];
  }
  return kept;
}

std::size_t LinkChoice::write(std::span<const std::byte> from) {
  if (session_ == 0) return second_.write(from);
  return first_.session() == session_ ? first_.write(from) : 0;
}

}  // namespace cnc
