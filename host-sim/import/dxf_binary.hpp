#pragma once

#include <string>
#include <string_view>

namespace sim::drawing {

/// Returns whether a file begins with the sentinel of binary DXF.
[[nodiscard]] bool is_binary_dxf(std::string_view text);

/// Returns the groups of a binary DXF file as lines of an ASCII file. If the file is cut off within
/// a group, the text ends before that group, and therefore without EOF. Chunks of binary data
/// become empty values.
/// @pre is_binary_dxf(text)
[[nodiscard]] std::string ascii_of_binary_dxf(std::string_view text);

}  // namespace sim::drawing
