#include "host-sim/serve/web_frame.hpp"

#include <algorithm>
#include <array>

namespace sim {
namespace {

constexpr std::uint8_t kFinal = 0x80;
constexpr std::uint8_t kReserved = 0x70;
constexpr std::uint8_t kMasked = 0x80;
constexpr std::uint8_t kOpcode = 0x0F;
constexpr std::size_t kMaskBytes = 4;
constexpr std::uint8_t kTwoBytes = 126;    ///< The length is in the next two bytes,
constexpr std::uint8_t kEightBytes = 127;  ///< or in the next eight.
constexpr std::uint64_t kMostControl = 125;

std::uint8_t byte_at(const std::string& text, std::size_t at) {
  return static_cast<std::uint8_t>(text[at]);
}

std::size_t length_bytes(std::uint8_t short_length) {
  if (short_length == kTwoBytes) return 2;
  return short_length == kEightBytes ? 8 : 0;
}

void put_number(std::string& text, std::uint64_t number, std::size_t bytes) {
  for (std::size_t i = bytes; i > 0; --i) text += static_cast<char>(number >> (8 * (i - 1)));
}

}  // namespace

std::string web_frame(std::uint8_t opcode, std::string_view payload) {
  std::string frame(1, static_cast<char>(kFinal | opcode));
  if (payload.size() < kTwoBytes) {
    put_number(frame, payload.size(), 1);
  } else if (payload.size() <= 0xFFFF) {
    put_number(frame, kTwoBytes, 1);
    put_number(frame, payload.size(), 2);
  } else {
    put_number(frame, kEightBytes, 1);
    put_number(frame, payload.size(), 8);
  }
  return frame.append(payload);
}

std::string web_close_frame(std::uint16_t reason) {
  std::string payload;
  put_number(payload, reason, 2);
  return web_frame(web_opcode::kClose, payload);
}

void WebFrameReader::take(std::string_view bytes, std::string& data, std::string& answers) {
  while (!closed_ && (!bytes.empty() || in_payload_)) {
    if (!in_payload_) {
      head_ += bytes.front();
      bytes.remove_prefix(1);
      if (!read_head()) continue;
    }
    read_payload(bytes, data);
    if (left_ > 0) return;
    end_frame(answers);
  }
}

/// True when the head is complete, and sound.
bool WebFrameReader::read_head() {
  if (head_.size() < 2) return false;
  const std::uint8_t first = byte_at(head_, 0);
  const std::uint8_t second = byte_at(head_, 1);
  if (head_.size() == 2 && !head_is_sound(first, second)) {
    close(web_close::kProtocolFault);
    return false;
  }
  const std::uint8_t short_length = second & static_cast<std::uint8_t>(~kMasked);
  const std::size_t wide = length_bytes(short_length);
  if (head_.size() < 2 + wide + kMaskBytes) return false;
  left_ = wide == 0 ? short_length : 0;
  for (std::size_t i = 0; i < wide; ++i) left_ = left_ << 8 | byte_at(head_, 2 + i);
  for (std::size_t i = 0; i < kMaskBytes; ++i) mask_ = mask_ << 8 | byte_at(head_, 2 + wide + i);
  head_.clear();
  if (left_ > kMostPayload) {
    close(web_close::kTooLarge);
    return false;
  }
  opcode_ = first & kOpcode;
  final_ = (first & kFinal) != 0;
  at_ = 0;
  in_payload_ = true;
  return true;
}

bool WebFrameReader::head_is_sound(std::uint8_t first, std::uint8_t second) {
  if ((first & kReserved) != 0 || (second & kMasked) == 0) return false;
  const bool final = (first & kFinal) != 0;
  switch (first & kOpcode) {
    case web_opcode::kContinuation:
      return in_message_;
    case web_opcode::kText:
    case web_opcode::kBinary:
      return !in_message_;
    case web_opcode::kClose:
    case web_opcode::kPing:
    case web_opcode::kPong:
      return final && (second & ~kMasked) <= kMostControl;
    default:
      return false;
  }
}

void WebFrameReader::read_payload(std::string_view& bytes, std::string& data) {
  const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(left_, bytes.size()));
  std::string& into = is_control() ? control_ : data;
  const std::array<std::uint8_t, kMaskBytes> mask{static_cast<std::uint8_t>(mask_ >> 24),
                                                  static_cast<std::uint8_t>(mask_ >> 16),
                                                  static_cast<std::uint8_t>(mask_ >> 8),
                                                  static_cast<std::uint8_t>(mask_)};
  const std::size_t before = into.size();
  into.append(bytes.substr(0, count));
  for (std::size_t i = 0; i < count; ++i) {
    into[before + i] = static_cast<char>(byte_at(into, before + i) ^ mask[(at_ + i) % kMaskBytes]);
  }
  bytes.remove_prefix(count);
  at_ += count;
  left_ -= count;
}

void WebFrameReader::end_frame(std::string& answers) {
  in_payload_ = false;
  if (opcode_ == web_opcode::kPing) answers += web_frame(web_opcode::kPong, control_);
  if (opcode_ == web_opcode::kClose) close(web_close::kNormal);
  if (!is_control()) in_message_ = !final_;
  control_.clear();
}

void WebFrameReader::close(std::uint16_t reason) {
  closed_ = true;
  reason_ = reason;
}

}  // namespace sim
