#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sim::picture {

/// Greater pictures are refused.
inline constexpr std::size_t kMaxImagePixels = 100'000'000;

/// A picture as how dark its pixels are.
struct GreyImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<float> darkness{};  ///< 0 white to 1 black, row by row from the top.
  /// Share of each pixel that belongs to the picture: the rest is not burnt, inverted or not. Empty
  /// where all of them do. Darkness is at most this.
  std::vector<float> cover{};
};

/// Reads a PNG, JPEG or BMP picture, told by content. What is transparent is white; colours count
/// by their lightness; a JPEG of a camera is turned as it says. Throws std::invalid_argument with
/// the name, the reason and what to do.
[[nodiscard]] GreyImage read_image(std::string_view bytes, const std::string& name);

/// Returns a picture as it is seen. @param orientation of EXIF, 1 to 8; others are 1
[[nodiscard]] GreyImage oriented(GreyImage image, int orientation);

/// Returns the orientation that the EXIF data of a JPEG gives, 1 where it gives none.
[[nodiscard]] int exif_orientation(std::string_view jpeg);

/// Throws std::invalid_argument for a picture without pixels, or with too many.
void expect_size(std::size_t width, std::size_t height, const std::string& name);

}  // namespace sim::picture
