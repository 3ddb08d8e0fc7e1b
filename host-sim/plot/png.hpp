#pragma once

#include <string>
#include <string_view>

namespace sim {

/// Draws an SVG document with librsvg and cairo, and writes it as a PNG (`--png FILE`). The image
/// has the width `width_px` and the proportions of the document.
///
/// Throws std::runtime_error, with the name of the file, if the document cannot be drawn, and
/// std::system_error if the file cannot be written.
/// @pre width_px > 0
void write_png(const std::string& file, std::string_view svg, int width_px = 1600);

}  // namespace sim
