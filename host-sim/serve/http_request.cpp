#include "host-sim/serve/http_request.hpp"

#include <algorithm>
#include <charconv>

namespace sim {
namespace {

/// Removes from the front of `text` the part before `mark`, and `mark`. Returns that part.
std::string_view take_to(std::string_view& text, char mark) {
  const std::size_t end = std::min(text.find(mark), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

/// Decodes escapes: `%41` is A. Returns nothing if a digit is missing.
std::optional<std::string> decoded(std::string_view text) {
  std::string plain;
  for (; !text.empty(); text.remove_prefix(1)) {
    if (text.front() != '%') {
      plain += text.front();
      continue;
    }
    unsigned byte = 0;
    const char* digits = text.data() + 1;
    if (text.size() < 3) return {};
    if (std::from_chars(digits, digits + 2, byte, 16).ptr != digits + 2) return {};
    plain += static_cast<char>(byte);
    text.remove_prefix(2);
  }
  return plain;
}

}  // namespace

bool read_target(std::string_view target, HttpRequest& request) {
  if (!target.starts_with('/')) return false;
  const auto path = decoded(take_to(target, '?'));
  if (!path) return false;
  request.path = *path;
  while (!target.empty()) {
    std::string_view value = take_to(target, '&');
    const auto name = decoded(take_to(value, '='));
    const auto meant = decoded(value);
    if (!name || !meant) return false;
    request.query[*name] = *meant;
  }
  return true;
}

}  // namespace sim
