#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sim::picture {

/// Greatest number of pixels of a picture. Greater pictures are refused.
inline constexpr std::size_t kMaxImagePixels = 100'000'000;

/// A picture, as the darkness of its pixels.
struct GreyImage {
  std::size_t width = 0;
  std::size_t height = 0;
  /// Darkness from 0 (white) to 1 (black), row by row from the top.
  std::vector<float> darkness{};
  /// Share of each pixel that belongs to the picture. The rest of the pixel is not burnt, whether
  /// the picture is inverted or not. Empty if all pixels belong to it fully. The darkness of a
  /// pixel is at most its cover.
  std::vector<float> cover{};
};

/// Reads a PNG, JPEG or BMP picture. Detects the format by content. Transparent pixels are white,
/// and colours count by their lightness. A JPEG is turned to the orientation that its camera
/// recorded. Throws std::invalid_argument with the name, the reason and a remedy.
[[nodiscard]] GreyImage read_image(std::string_view bytes, const std::string& name);

/// Returns a picture turned and mirrored to the view that the orientation defines.
/// @param orientation of EXIF, 1 to 8; any other value counts as 1
[[nodiscard]] GreyImage oriented(GreyImage image, int orientation);

/// Returns the orientation that the EXIF data of a JPEG give, or 1 if they give none.
[[nodiscard]] int exif_orientation(std::string_view jpeg);

/// Checks the size of a picture. Throws std::invalid_argument if it has no pixels, or too many.
void expect_size(std::size_t width, std::size_t height, const std::string& name);

}  // namespace sim::picture
