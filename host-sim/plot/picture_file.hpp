#pragma once

#include <string>
#include <string_view>

namespace sim {

/// Checks that a file's name ends in `.svg` or `.png`. Throws std::invalid_argument naming the
/// option for another ending. Names without an ending, such as those of devices, are accepted.
void require_picture_name(std::string_view option, const std::string& file);

/// Writes an SVG document unchanged, or as pixels if the file's name ends in `.png`. Throws as
/// write_file() and write_png() do.
void write_picture(const std::string& file, const std::string& svg);

}  // namespace sim
