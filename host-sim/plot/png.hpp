#pragma once

#include <string>
#include <string_view>

namespace sim {

/// Draws an SVG document by librsvg and cairo, and writes it as a PNG (`--png FILE`). The image is
/// `width_px` wide, and as tall as the shape of the document requires.
///
/// Throws std::runtime_error naming the file if the document cannot be drawn, or std::system_error
/// if the file cannot be written.
/// @pre width_px > 0
void write_png(const std::string& file, std::string_view svg, int width_px = 1600);

}  // namespace sim
