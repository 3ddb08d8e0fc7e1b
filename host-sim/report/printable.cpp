#include "host-sim/report/printable.hpp"

#include <fmt/format.h>

#include <cstdint>

#include "host-sim/report/utf8.hpp"

namespace sim {
namespace {

/// Returns whether a terminal interprets the character as a command: C0, DEL, C1, line and
/// paragraph separators, and marks that change the direction of writing. With such marks, the
/// displayed end of a name can differ from its real end.
bool terminal_obeys(char32_t code_point) {
  const bool is_control = code_point < 0x20 || (code_point >= 0x7F && code_point < 0xA0);
  const bool is_direction = code_point == 0x61C || code_point == 0x200E || code_point == 0x200F ||
                            (code_point >= 0x2028 && code_point <= 0x202E) ||
                            (code_point >= 0x2066 && code_point <= 0x2069);
  return is_control || is_direction;
}

bool is_line_end_or_tab(char32_t code_point) { return code_point == U'\n' || code_point == U'\t'; }

std::string escaped(std::string_view text, bool keeps_blanks) {
  std::string plain;
  while (!text.empty()) {
    const Utf8Character character = first_character(text);
    const std::string_view bytes = text.substr(0, character.bytes);
    const bool is_kept = keeps_blanks && is_line_end_or_tab(character.code_point);
    if (character.is_valid && (is_kept || !terminal_obeys(character.code_point))) {
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

}  // namespace

std::string printable(std::string_view text) { return escaped(text, true); }

std::string printable_line(std::string_view text) { return escaped(text, false); }

}  // namespace sim
