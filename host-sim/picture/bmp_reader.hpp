#pragma once

#include <string>
#include <string_view>

#include "host-sim/picture/grey_image.hpp"

namespace sim::picture {

/// Reads an uncompressed BMP with 1, 4 or 8 bits per pixel and a palette, or with 24 or 32 bits per
/// pixel. Throws the same exceptions as read_image().
[[nodiscard]] GreyImage read_bmp(std::string_view bytes, const std::string& name);

}  // namespace sim::picture
