#pragma once

#include <optional>
#include <string>
#include <vector>

namespace sim {

/// Returns the name that the user may have meant by `word`. If exactly one name begins with `word`,
/// the result is this name. Otherwise it is the name with the fewest slips. A slip is a letter that
/// is wrong, missing, surplus or swapped with its neighbour. At most a third of the letters may be
/// slips. A difference in case counts as one slip in total. Returns none if no name is near.
[[nodiscard]] std::optional<std::string> nearest_name(const std::string& word,
                                                      const std::vector<std::string>& names);

/// Returns `; did you mean NAME?` for the end of a message, or an empty text if no name is near.
[[nodiscard]] std::string did_you_mean(const std::string& word,
                                       const std::vector<std::string>& names);

}  // namespace sim
