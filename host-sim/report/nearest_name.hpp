#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sim {

/// Returns the name that the user may have meant by `word`. If exactly one name begins with `word`,
/// it is that name. Otherwise it is the name with the fewest slips: letters that are wrong,
/// missing, surplus or exchanged with their neighbour. At most a third of the letters may be slips;
/// a word in the other case counts as one slip. Returns an empty value if no name is near.
[[nodiscard]] std::optional<std::string> nearest_name(const std::string& word,
                                                      const std::vector<std::string>& names);

/// Returns `; did you mean NAME?` for the end of a message, or an empty text if no name is near.
[[nodiscard]] std::string did_you_mean(const std::string& word,
                                       const std::vector<std::string>& names);

}  // namespace sim
