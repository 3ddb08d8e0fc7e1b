#include "host-sim/report/printable.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "host-sim/report/utf8.hpp"

namespace sim {
namespace {

/// C0, DEL and C1.
bool terminal_obeys(char32_t code_point) {
  if (code_point == U'\n' || code_point == U'\t') return false;
  return code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0);
}

}  // namespace

std::string printable(std::string_view text) {
  std::string plain;
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    const std::string_view bytes = text.substr(0, character.bytes);
    if (character.is_valid && !terminal_obeys(character.code_point)) {
      plain += bytes;
    } else {
      for (const char byte : bytes) {
        plain += fmt::format("\\x{:02X}", static_cast<std::uint8_t>(byte));
      }
    }
    text.remove_prefix(bytes.size());
  }
  return plain;
}

}  // namespace sim
