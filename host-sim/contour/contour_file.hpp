#pragma once

#include <string>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Reads contours from a file, `-` being standard input, as contour_text.hpp has
/// them; formats of drawings come in here as well. Throws std::system_error naming
/// the file, and ContourTextError.
[[nodiscard]] Contour read_contour_file(const std::string& file);

}  // namespace sim
