#include "hal/host/slcan_text.hpp"

#include <charconv>
#include <cstdint>

namespace hal::host {
namespace {

/// Reads a hexadecimal number. Returns false if `digits` is not exactly one number.
bool read_number(std::string_view digits, std::uint32_t& number) {
  const char* const end = digits.data() + digits.size();
  const auto [rest, error] = std::from_chars(digits.data(), end, number, 16);
  return error == std::errc{} && rest == end && !digits.empty() && digits[0] != '-';
}

void append_number(std::string& text, std::uint32_t number, int digits) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  while (digits-- > 0) text += kDigits[number >> (4 * digits) & 0xFU];
}

}  // namespace

std::optional<CanFrame> read_slcan(std::string_view line) {
  if (line.find_first_of("tTrR") != 0) return std::nullopt;
  CanFrame frame;
  frame.extended = line[0] == 'T' || line[0] == 'R';
  frame.remote = line[0] == 'r' || line[0] == 'R';
  const std::size_t id_digits = frame.extended ? 8 : 3;
  const std::uint32_t most = frame.extended ? 0x1FFF'FFFF : 0x7FF;
  std::uint32_t length = 0;
  if (line.size() < 2 + id_digits) return std::nullopt;
  if (!read_number(line.substr(1, id_digits), frame.id) || frame.id > most) return std::nullopt;
  if (!read_number(line.substr(1 + id_digits, 1), length) || length > 8) return std::nullopt;
  frame.length = static_cast<std::uint8_t>(length);
  const std::string_view data = line.substr(2 + id_digits);
  if (data.size() != (frame.remote ? 0 : 2 * length)) return std::nullopt;
  for (std::size_t at = 0; 2 * at < data.size(); ++at) {
    std::uint32_t byte = 0;
    if (!read_number(data.substr(2 * at, 2), byte)) return std::nullopt;
    frame.data[at] = static_cast<std::byte>(byte);
  }
  return frame;
}

std::string slcan_line(const CanFrame& frame) {
  std::string text;
  text += frame.extended ? (frame.remote ? 'R' : 'T') : (frame.remote ? 'r' : 't');
  append_number(text, frame.id, frame.extended ? 8 : 3);
  append_number(text, frame.length, 1);
  for (std::size_t at = 0; at < frame.length && !frame.remote; ++at) {
    append_number(text, std::to_integer<std::uint32_t>(frame.data[at]), 2);
  }
  return text += kSlcanDone;
}

}  // namespace hal::host
