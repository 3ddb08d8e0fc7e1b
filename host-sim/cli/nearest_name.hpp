#pragma once

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace sim {

/// The name that a slip of the keyboard turns into `word`: with the fewest letters that are wrong,
/// missing, too many or exchanged with their neighbour, but at most a third of them; or the only
/// name that begins with it. None where nothing is near.
[[nodiscard]] std::optional<std::string> nearest_name(const std::string& word,
                                                      const std::vector<std::string>& names);

/// Finds the first word of a call that is no command and the first option that its command does not
/// have, and says so with the nearest one. None where all words are known.
[[nodiscard]] std::optional<std::string> unknown_word(const CLI::App& app,
                                                      const std::vector<std::string>& words);

}  // namespace sim
