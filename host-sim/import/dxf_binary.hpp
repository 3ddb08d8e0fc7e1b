#pragma once

#include <string>
#include <string_view>

namespace sim::drawing {

/// Returns whether a file begins as binary DXF does.
[[nodiscard]] bool is_binary_dxf(std::string_view text);

/// Returns the groups of a binary DXF file as lines of an ASCII file. The text ends at a group that
/// is cut off, so that the text lacks its EOF. Chunks of binary data become empty values.
/// @pre is_binary_dxf(text)
[[nodiscard]] std::string ascii_of_binary_dxf(std::string_view text);

}  // namespace sim::drawing
