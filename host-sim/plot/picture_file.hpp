#pragma once

#include <string>
#include <string_view>

namespace sim {

/// Checks that the name of a file ends in `.svg` or `.png`. For another ending, throws
/// std::invalid_argument with the name of the option. Accepts names without an ending, such as
/// names of devices.
void require_picture_name(std::string_view option, const std::string& file);

/// Writes an SVG document unchanged, or as an image of pixels if the name of the file ends in
/// `.png`. Throws the exceptions of write_file() and write_png().
void write_picture(const std::string& file, const std::string& svg);

}  // namespace sim
