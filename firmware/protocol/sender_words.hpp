#pragma once

#include <algorithm>
#include <string_view>

namespace cnc {

/// Returns whether a printed `text` would confuse senders: it contains a word of an acknowledgement
/// ("ok" or "error"), or a square bracket, which would disturb the brackets around it.
[[nodiscard]] inline bool confuses_senders(std::string_view text) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  const auto holds = [&](std::string_view word) {
    return std::search(text.begin(), text.end(), word.begin(), word.end(), [&](char a, char b) {
             return lower(a) == b;
           }) != text.end();
  };
  return holds("ok") || holds("error") || holds("[") || holds("]");
}

}  // namespace cnc
