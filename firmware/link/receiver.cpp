#include "firmware/link/receiver.hpp"

#include <algorithm>
#include <utility>

namespace cnc {
namespace {

constexpr std::uint8_t kLatinLead = 0xC2;  ///< First byte of the UTF-8 form of 0x80…0xBF.

constexpr bool is_continuation(std::uint8_t byte) { return (byte & 0xC0U) == 0x80U; }

/// Returns the number of bytes that follow `lead` in its UTF-8 character.
constexpr std::uint8_t continuations_after(std::uint8_t lead) {
  if (lead >= 0xF0) return lead < 0xF8 ? 3 : 0;
  if (lead >= 0xE0) return 2;
  return lead >= 0xC2 ? 1 : 0;
}

constexpr bool is_stop(RealtimeByte command) {
  return command == RealtimeByte::kFeedHold || command == RealtimeByte::kFeedHoldRaw ||
         command == RealtimeByte::kSafetyDoor || command == RealtimeByte::kJogCancel;
}

}  // namespace

std::size_t Receiver::receive(std::span<const char> received) {
  std::size_t count = 0;
  while (count < received.size()) {
    if (plain_) {
      count += lines_.push_while(received.subspan(count), is_plain);
    }
    if (count == received.size() || !receive(received[count])) break;
    ++count;
  }
  return count;
}

bool Receiver::receive_other(std::uint8_t byte) {
  const bool taken = strict_        ? receive_strict(byte)
                     : byte >= 0x80 ? receive_high(byte)
                                    : receive_low(byte);
  judge_plain();
  return taken;
}

void Receiver::judge_plain() {
  plain_ =
      comment_ == Comment::kNone && !lead_waits_ && continuation_ == 0 && once_ == 0 && !overrun_;
}

void Receiver::receive_all(std::span<const char> received) {
  while (!received.empty()) {
    received = received.subspan(receive(received));
    if (received.empty()) return;
    overrun_ = true;
    // The incomplete character before this byte is lost; the byte itself may still act.
    if (std::exchange(lead_waits_, false)) continue;
    lose(received.front());
    received = received.subspan(1);
  }
}

/// Drops a byte of a lost line. Comments are tracked in lost lines, too, because within a comment
/// no byte except a reset acts. CR, LF and CR LF end a line.
void Receiver::lose(char byte) {
  const auto code = static_cast<std::uint8_t>(byte);
  if (!is_continuation(code)) {
    continuation_ = continuations_after(code);
  } else if (continuation_ > 0) {
    --continuation_;
  }
  follow_comment(byte);
  judge_plain();
  const bool ends = byte == '\r' || (byte == '\n' && lost_last_ != '\r');
  lost_last_ = byte;
  if (ends) lost_lines_.store(lost_lines_.load() + 1);
}

bool Receiver::take_lost_line() {
  const std::uint32_t lost = lost_lines_.load();
  if (lost == 0) return false;
  lost_lines_.store(lost - 1);
  return true;
}

bool Receiver::receive_strict(std::uint8_t byte) {
  const char last = overrun_ ? lost_last_ : lines_.last();
  const bool between = last == '\n' || last == '\r';
  const std::uint8_t before = std::exchange(once_, std::uint8_t{0});
  if (!between || !(is_continuation(byte) || is_ascii_realtime(byte))) return store(byte);
  if (byte != before && byte != static_cast<std::uint8_t>(RealtimeByte::kStatus)) {
    once_ = byte;
  } else {
    act(byte);
  }
  return true;
}

bool Receiver::receive_low(std::uint8_t byte) {
  if (byte == static_cast<std::uint8_t>(RealtimeByte::kReset)) {
    reset();
    return true;
  }
  // An incomplete character is stored in its line, where the reader of the line refuses it.
  if (lead_waits_ && !store(kLatinLead)) return false;
  lead_waits_ = false;
  continuation_ = 0;
  if (is_ascii_realtime(byte) && comment_ == Comment::kNone) {
    act(byte);
    return true;
  }
  if (!store(byte)) return false;
  follow_comment(static_cast<char>(byte));
  return true;
}

bool Receiver::receive_high(std::uint8_t byte) {
  if (lead_waits_) {
    if (is_continuation(byte)) {
      lead_waits_ = false;
      act(byte);
      return true;
    }
    if (!store(kLatinLead)) return false;
    lead_waits_ = false;
  }
  if (is_continuation(byte)) {
    if (continuation_ == 0 && comment_ == Comment::kNone) {
      act(byte);
      return true;
    }
    if (!store(byte)) return false;
    if (continuation_ > 0) --continuation_;
    return true;
  }
  if (byte == kLatinLead && comment_ == Comment::kNone) {
    continuation_ = 0;
    lead_waits_ = true;
    return true;
  }
  if (!store(byte)) return false;
  continuation_ = continuations_after(byte);
  return true;
}

void Receiver::follow_comment(char byte) {
  const bool bracket_closes = comment_ == Comment::kBrackets && byte == ')';
  if (byte == '\r' || byte == '\n' || bracket_closes) {
    comment_ = Comment::kNone;
  } else if (comment_ == Comment::kNone) {
    if (byte == '(') comment_ = Comment::kBrackets;
    if (byte == ';') comment_ = Comment::kRestOfLine;
  }
}

void Receiver::act_at_once(std::uint8_t code) {
  if (code >= 0x80 || is_ascii_realtime(code)) act(code);
}

void Receiver::act(std::uint8_t code) {
  const auto command = static_cast<RealtimeByte>(code);
  switch (command) {
    case RealtimeByte::kReset:
    case RealtimeByte::kStop:
      return reset();
    case RealtimeByte::kStatus:
    case RealtimeByte::kStatusRaw:
      return status_.store(true);
    case RealtimeByte::kFullStatus:
      return full_status_.store(true);
    case RealtimeByte::kToolAcknowledge:
      acknowledged_.store(lines_.place());
      break;
    case RealtimeByte::kCycleStart:
    case RealtimeByte::kCycleStartRaw:
      started_.store(lines_.place());
      break;
    default:
      break;
  }
  // An override for which there is no free space is dropped, as if the operator turned the knob
  // less. A stop is never dropped.
  if (!commands_.try_push(command) && is_stop(command)) late_hold_.store(true);
}

/// Resets the state within a line: no comment and no character of several bytes is open, and no
/// byte waits for its repetition.
void Receiver::end_text() {
  comment_ = Comment::kNone;
  lead_waits_ = false;
  continuation_ = 0;
  once_ = 0;
}

void Receiver::reset() {
  end_text();
  strict_ = false;
  end_overrun();
  lines_begin_.store(lines_.place());
  commands_begin_.store(commands_.place());
  late_hold_.store(false);
  reset_.store(true);
}

void Receiver::be_strict(bool strict) {
  if (strict == strict_) return;
  strict_ = strict;
  end_text();
  plain_ = true;
}

void Receiver::begin_anew() {
  drop_waiting();
  end_text();
  strict_ = false;
  plain_ = true;
}

void Receiver::keep_back() {
  const auto waiting = static_cast<std::int32_t>(acknowledged_.load() - lines_.taken());
  kept_ = waiting > 0 ? static_cast<std::uint32_t>(waiting) : 0;
  kept_at_ = lines_.taken();
  keeps_back_ = true;
}

/// Extends the bytes that are kept back to the end of their last line. This is necessary if
/// kToolAcknowledge arrived in the middle of a line, or between its CR and LF. Returns false if the
/// end of that line has not arrived.
bool Receiver::has_whole_kept() {
  if (kept_ == 0 || lines_.taken() != kept_at_) return true;
  while (lines_.at(kept_ - 1) != '\n' && lines_.at(kept_ - 1) != '\r') {
    if (kept_ >= lines_.size()) return false;
    ++kept_;
  }
  const bool pair =
      lines_.at(kept_ - 1) == '\r' && kept_ < lines_.size() && lines_.at(kept_) == '\n';
  if (pair) ++kept_;
  return true;
}

void Receiver::release() {
  keeps_back_ = false;
  kept_ = 0;
}

bool Receiver::take_line_feed() {
  if (kept_ >= lines_.size() || lines_.at(kept_) != '\n') return false;
  return lines_.pop_behind(kept_, [](char) { return true; });
}

bool Receiver::take_reset() {
  if (!reset_.exchange(false)) return false;
  keeps_back_ = false;
  kept_ = 0;
  lines_.drop_before(lines_begin_.load());
  commands_.drop_before(commands_begin_.load());
  return true;
}

bool Receiver::take_command(RealtimeByte& command) {
  if (commands_.try_pop(command)) return true;
  if (!late_hold_.exchange(false)) return false;
  command = RealtimeByte::kFeedHold;
  return true;
}

std::uint32_t Receiver::room() const {
  const std::uint32_t held = lines_.size() + (lead_waits_ ? 1U : 0U);
  return kRealBytes - std::min(held, kRealBytes);
}

std::uint32_t Receiver::advertised_room() const {
  return kAdvertisedBytes - std::min(lines_.size(), kAdvertisedBytes);
}

}  // namespace cnc
