#include "host-sim/engrave/burn_picture.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace sim::engrave {

std::string burn_picture(const BurnRaster& raster) {
  std::vector<std::uint8_t> lightness;
  lightness.reserve(raster.power.size());
  for (std::size_t row = raster.rows; row-- > 0;) {
    for (std::size_t column = 0; column < raster.columns; ++column) {
      const double light = 255.0 * (1.0 - static_cast<double>(raster.at(column, row)));
      lightness.push_back(static_cast<std::uint8_t>(std::lround(std::clamp(light, 0.0, 255.0))));
    }
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(raster.columns);
  image.height = static_cast<png_uint_32>(raster.rows);
  image.format = PNG_FORMAT_GRAY;
  png_alloc_size_t size = 0;
  std::string bytes;
  const auto write = [&](void* memory) {
    return png_image_write_to_memory(&image, memory, &size, 0, lightness.data(), 0, nullptr) != 0;
  };
  bool is_written = write(nullptr);
  if (is_written) {
    bytes.resize(size);
    is_written = write(bytes.data());
    bytes.resize(size);
  }
  if (is_written) return bytes;
  throw std::runtime_error(fmt::format("--picture: the PNG cannot be made: {}", &image.message[0]));
}

}  // namespace sim::engrave
