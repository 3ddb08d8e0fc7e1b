#pragma once

#include <string>
#include <string_view>

namespace sim {

/// Throws std::invalid_argument naming the option where a file's name has an end other than `.svg`
/// and `.png`. Names without one, such as those of devices, pass.
void require_picture_name(std::string_view option, const std::string& file);

/// Writes an SVG document as it is, or as pixels into a file whose name ends in `.png`. Throws as
/// write_file() and write_png() do.
void write_picture(const std::string& file, const std::string& svg);

}  // namespace sim
