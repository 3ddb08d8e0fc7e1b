#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "host-sim/plot/colour_map.hpp"
#include "host-sim/plot/view.hpp"

namespace sim {

/// An image of pixels for a part of a picture. A pixel is transparent until it is set.
class PixelImage {
 public:
  /// @pre `width` and `height` are above 0
  PixelImage(int width, int height);

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

  /// Sets the colour of a pixel. Row 0 is the top row.
  /// @pre 0 <= column < width(), 0 <= row < height()
  void set(int column, int row, const Colour& colour) {
    pixels_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(column)] =
        0xFF000000U | static_cast<std::uint32_t>(colour.red) << 16U |
        static_cast<std::uint32_t>(colour.green) << 8U | colour.blue;
  }

  /// Returns the image as the bytes of a PNG. Throws std::runtime_error, with the name `file`, if
  /// cairo cannot make the PNG.
  [[nodiscard]] std::string png(const std::string& file) const;

 private:
  int width_;
  int height_;
  /// Pixels, row by row. Each consists of alpha, red, green and blue, from the highest byte to the
  /// lowest.
  std::vector<std::uint32_t> pixels_;
};

/// Appends an image, stretched over a box, to an SVG document. Throws the exceptions of
/// PixelImage::png().
void add_image(std::string& out, const std::string& file, const PixelImage& image, const Box& box);

/// The combination of an image with the content of the picture below it.
enum class Blend : std::uint8_t {
  kOver,    ///< The image hides the content below.
  kDarken,  ///< The content below is visible through white parts of the image.
};

/// Appends an image, which is given as the bytes of a PNG and is stretched over a box, to an SVG
/// document.
void add_png(std::string& out, const std::string& png, const Box& box, Blend blend = Blend::kOver);

}  // namespace sim
