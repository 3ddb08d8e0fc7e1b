#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sim::picture {

/// Greatest number of pixels of a picture. Larger pictures are refused.
inline constexpr std::size_t kMaxImagePixels = 100'000'000;

/// A picture, stored as the darkness of its pixels.
struct GreyImage {
  std::size_t width = 0;
  std::size_t height = 0;
  /// Darkness of each pixel from 0 (white) to 1 (black), row by row from the top.
  std::vector<float> darkness{};
  /// Share of each pixel that belongs to the picture, 0 to 1. The rest of the pixel is not burnt,
  /// even if the picture is inverted. Empty if every pixel belongs completely to the picture. The
  /// darkness of a pixel is at most its cover.
  std::vector<float> cover{};
};

/// Reads a PNG, JPEG or BMP picture. Detects the format by content. Transparent pixels count as
/// white, and colours are converted to grey. A JPEG is turned to the orientation that its camera
/// recorded. Throws std::invalid_argument, with `name`, the reason and a remedy, if the picture
/// cannot be read.
[[nodiscard]] GreyImage read_image(std::string_view bytes, const std::string& name);

/// Returns a picture that is turned and mirrored as an orientation requires.
/// @param orientation orientation by EXIF, 1 to 8; any other value counts as 1
[[nodiscard]] GreyImage oriented(GreyImage image, int orientation);

/// Returns the orientation that the EXIF data of a JPEG give; 1 if they give none.
[[nodiscard]] int exif_orientation(std::string_view jpeg);

/// Checks the size of a picture. Throws std::invalid_argument if the picture has no pixels, or more
/// than kMaxImagePixels.
void expect_size(std::size_t width, std::size_t height, const std::string& name);

}  // namespace sim::picture
