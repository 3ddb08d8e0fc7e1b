#include "host-sim/serve/escaped_text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>

namespace sim {
namespace {

struct Escape {
  char byte;
  char letter;
};
constexpr std::array<Escape, 5> kEscapes{
    {{'\n', 'n'}, {'\r', 'r'}, {'\t', 't'}, {'"', '"'}, {'\\', '\\'}}};
constexpr std::size_t kHexDigits = 2;

bool is_plain(char byte) { return byte >= ' ' && byte <= '~'; }

void append(std::string& text, char byte) {
  for (const Escape& escape : kEscapes) {
    if (escape.byte != byte) continue;
    text += '\\';
    text += escape.letter;
    return;
  }
  if (is_plain(byte)) {
    text += byte;
  } else {
    text += fmt::format("\\x{:02X}", static_cast<unsigned char>(byte));
  }
}

/// Removes the part of an escape that follows its backslash from the front of `text`. Returns the
/// character that the escape stands for.
std::optional<char> take_escape(std::string_view& text) {
  if (text.empty()) return {};
  const char letter = text.front();
  text.remove_prefix(1);
  for (const Escape& escape : kEscapes) {
    if (escape.letter == letter) return escape.byte;
  }
  if (letter != 'x' || text.size() < kHexDigits) return {};
  unsigned value = 0;
  const char* end = text.data() + kHexDigits;
  if (std::from_chars(text.data(), end, value, 16).ptr != end) return {};
  text.remove_prefix(kHexDigits);
  return static_cast<char>(value);
}

}  // namespace

std::string escaped(std::string_view bytes) {
  std::string text{'"'};
  for (const char byte : bytes) append(text, byte);
  return text += '"';
}

std::optional<std::string> unescaped(std::string_view text) {
  if (text.size() < 2 || text.front() != '"' || text.back() != '"') return {};
  text = text.substr(1, text.size() - 2);
  std::string bytes;
  while (!text.empty()) {
    const char byte = text.front();
    text.remove_prefix(1);
    if (byte == '"' || !is_plain(byte)) return {};
    const std::optional<char> meant = byte == '\\' ? take_escape(text) : byte;
    if (!meant) return {};
    bytes += *meant;
  }
  return bytes;
}

}  // namespace sim
