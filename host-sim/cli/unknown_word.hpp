#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sim {

/// Finds the first word of a call that is neither a command nor an option of its command. Returns a
/// message with the nearest known word; empty if all words are known.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app,
                                                      const std::vector<std::string>& words);

}  // namespace sim
