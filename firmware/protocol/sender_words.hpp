#pragma once

#include <algorithm>
#include <string_view>

namespace cnc {

/// Returns whether a sender could count a line with `text` as an acknowledgement, or whether `text`
/// contains a bracket that would end or open the brackets around it.
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
