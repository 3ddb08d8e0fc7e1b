#pragma once

#include <set>
#include <string>
#include <string_view>

namespace sim::drawing {

/// Returns the handles of the INSERTs that a boundary clips (XCLIP), as far as the boundary is on.
[[nodiscard]] std::set<std::string, std::less<>> clipped_inserts(std::string_view text);

}  // namespace sim::drawing
