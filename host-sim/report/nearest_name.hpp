#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sim {

/// The name that a slip of the keyboard turns into `word`: with the fewest letters that are wrong,
/// missing, too many or exchanged with their neighbour, but at most a third of them; or the only
/// name that begins with it. All letters of the other case are one slip. None where nothing is
/// near.
[[nodiscard]] std::optional<std::string> nearest_name(const std::string& word,
                                                      const std::vector<std::string>& names);

/// `; did you mean NAME?`, or nothing, for the end of a message.
[[nodiscard]] std::string did_you_mean(const std::string& word,
                                       const std::vector<std::string>& names);

}  // namespace sim
