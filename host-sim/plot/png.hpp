#pragma once

#include <string>
#include <string_view>

namespace sim {

/// Draws an SVG document by librsvg and cairo, as wide as asked and as tall as
/// its shape needs, and writes it as a PNG (`--png FILE`).
///
/// Throws std::runtime_error naming the file when the document cannot be drawn,
/// std::system_error when the file cannot be written. @pre width_px > 0
void write_png(const std::string& file, std::string_view svg, int width_px = 1600);

}  // namespace sim
