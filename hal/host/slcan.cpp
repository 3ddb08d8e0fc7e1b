#include "hal/host/slcan.hpp"

#include <charconv>
#include <cstdint>

namespace hal::host {
namespace {

constexpr char kDone = '\r';
constexpr char kRefused = '\a';

/// All of `digits` as a hexadecimal number; false when that is not what they are.
bool read_number(std::string_view digits, std::uint32_t& number) {
  const char* const end = digits.data() + digits.size();
  const auto [rest, error] = std::from_chars(digits.data(), end, number, 16);
  return error == std::errc{} && rest == end && !digits.empty() && digits[0] != '-';
}

void append_number(std::string& text, std::uint32_t number, int digits) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  while (digits-- > 0) text += kDigits[number >> (4 * digits) & 0xFU];
}

bool read_frame(std::string_view line, CanFrame& frame) {
  frame.extended = line[0] == 'T' || line[0] == 'R';
  frame.remote = line[0] == 'r' || line[0] == 'R';
  const std::size_t id_digits = frame.extended ? 8 : 3;
  const std::uint32_t most = frame.extended ? 0x1FFF'FFFF : 0x7FF;
  std::uint32_t length = 0;
  if (line.size() < 2 + id_digits) return false;
  if (!read_number(line.substr(1, id_digits), frame.id) || frame.id > most) return false;
  if (!read_number(line.substr(1 + id_digits, 1), length) || length > 8) return false;
  frame.length = static_cast<std::uint8_t>(length);
  const std::string_view data = line.substr(2 + id_digits);
  if (data.size() != (frame.remote ? 0 : 2 * length)) return false;
  for (std::size_t at = 0; 2 * at < data.size(); ++at) {
    std::uint32_t byte = 0;
    if (!read_number(data.substr(2 * at, 2), byte)) return false;
    frame.data[at] = static_cast<std::byte>(byte);
  }
  return true;
}

}  // namespace

bool Slcan::receive(CanFrame& frame) {
  if (received_.empty()) return false;
  frame = received_.front();
  received_.pop_front();
  return true;
}

/// As on a bus without anybody else nothing goes out while the channel is closed; it is not kept
/// either, because nobody waits for what was said before.
bool Slcan::send(const CanFrame& frame) {
  if (frame.length > frame.data.size() || room() == 0) return false;
  if (!open_) return true;
  to_say_ += frame.extended ? (frame.remote ? 'R' : 'T') : (frame.remote ? 'r' : 't');
  append_number(to_say_, frame.id, frame.extended ? 8 : 3);
  append_number(to_say_, frame.length, 1);
  for (std::size_t at = 0; at < frame.length && !frame.remote; ++at) {
    append_number(to_say_, std::to_integer<std::uint32_t>(frame.data[at]), 2);
  }
  to_say_ += kDone;
  return true;
}

std::size_t Slcan::room() const {
  return to_say_.size() >= kMostToSay ? 0 : (kMostToSay - to_say_.size()) / kLongestLine;
}

void Slcan::hear(std::span<const std::byte> bytes) {
  for (const std::byte byte : bytes) {
    const char letter = std::to_integer<char>(byte);
    if (letter != kDone && letter != '\n') {
      if (line_.size() <= kLongestLine) line_ += letter;
      continue;
    }
    if (!line_.empty()) to_say_ += obey(line_) ? kDone : kRefused;
    line_.clear();
  }
}

bool Slcan::obey(std::string_view line) {
  if (line.size() > kLongestLine) return false;
  switch (line[0]) {
    case 'O':
    case 'L':  // Listens only; here the same, as nobody else is there.
      open_ = true;
      return true;
    case 'C':
      open_ = false;
      return true;
    case 'S':
    case 's':
      return !open_;
    case 't':
    case 'T':
    case 'r':
    case 'R':
      return open_ && take_frame(line);
    case 'F':
      to_say_ += "F00";
      return true;
    case 'V':
      to_say_ += "V1013";
      return true;
    case 'N':
      to_say_ += "NKERF";
      return true;
    case 'Z':
      return line == "Z0";  // Frames have no times.
    default:
      return false;
  }
}

bool Slcan::take_frame(std::string_view line) {
  CanFrame frame;
  if (!read_frame(line, frame)) return false;
  if (received_.size() == kFrames) {
    ++counts_.lost_frames;
    return false;
  }
  received_.push_back(frame);
  return true;
}

void Slcan::close() {
  open_ = false;
  line_.clear();
  to_say_.clear();
  received_.clear();
}

}  // namespace hal::host
