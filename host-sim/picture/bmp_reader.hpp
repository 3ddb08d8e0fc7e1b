#pragma once

#include <string>
#include <string_view>

#include "host-sim/picture/grey_image.hpp"

namespace sim::picture {

/// Reads a BMP of 1, 4 or 8 bits with a palette, or of 24 or 32 bits, without compression. Throws
/// the same exceptions as read_image().
[[nodiscard]] GreyImage read_bmp(std::string_view bytes, const std::string& name);

}  // namespace sim::picture
