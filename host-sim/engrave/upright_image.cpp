#include "host-sim/engrave/upright_image.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "planner/base/contract.hpp"

namespace sim::engrave {
namespace {

using drawing::Place;
using drawing::Transform;
using picture::GreyImage;

constexpr double kSamplesAlongPixel = 4.0;
/// Greatest number of pixels of a sampled picture, as a share of the greatest number of pixels of a
/// picture in a file.
constexpr double kShareOfPixels = 0.25;
/// Greatest deviation of a vector from an axis at which the vector counts as parallel to the axis,
/// as a share of its length.
constexpr double kAlongAxis = 1.0e-9;

/// Returns the EXIF orientation of a map that is a quarter turn or a mirroring; 0 for any other
/// map.
int orientation_of(const Transform& to_mm) {
  const Place& x = to_mm.x_axis;
  const Place& y = to_mm.y_axis;
  const double slack = kAlongAxis * std::max(x.norm(), y.norm());
  const auto number = [](bool flips_x, bool flips_y, const std::array<int, 4>& numbers) {
    return numbers.at((flips_x ? 1U : 0U) + (flips_y ? 2U : 0U));
  };
  if (std::abs(x.y()) <= slack && std::abs(y.x()) <= slack) {
    return number(x.x() < 0.0, y.y() > 0.0, {1, 2, 4, 3});
  }
  if (std::abs(x.x()) <= slack && std::abs(y.y()) <= slack) {
    return number(x.y() > 0.0, y.x() < 0.0, {5, 8, 6, 7});
  }
  return 0;
}

/// Sets the rectangle around a picture.
void set_box(const GreyImage& image, const Transform& to_mm, UprightImage& result) {
  const auto width = static_cast<double>(image.width);
  const auto height = static_cast<double>(image.height);
  result.low_mm = result.high_mm = to_mm.origin;
  for (const Place& corner : {Place{width, 0.0}, Place{0.0, height}, Place{width, height}}) {
    const Place place = to_mm(corner);
    result.low_mm = result.low_mm.cwiseMin(place);
    result.high_mm = result.high_mm.cwiseMax(place);
  }
}

Transform inverse_of(const Transform& map) {
  const double area = map.determinant();
  const Place x{map.y_axis.y() / area, -map.x_axis.y() / area};
  const Place y{-map.y_axis.x() / area, map.x_axis.x() / area};
  const Transform turned{.x_axis = x, .y_axis = y};
  return {.x_axis = x, .y_axis = y, .origin = -turned.way(map.origin)};
}

/// Returns the side of the squares in which a picture is sampled, mm.
double sample_size(const Transform& to_mm, const Place& size, double burnt_mm) {
  const double finest =
      std::min({burnt_mm / kSamplesAlongPixel, to_mm.x_axis.norm(), to_mm.y_axis.norm()});
  const double most = kShareOfPixels * static_cast<double>(picture::kMaxImagePixels);
  return std::max(finest, std::sqrt(size.x() * size.y() / most));
}

/// Fills the squares of the rectangle. Each square gets the value of the picture's pixel at the
/// middle of the square.
void sample(const GreyImage& image, const Transform& to_mm, double step_mm, UprightImage& result) {
  const Place size = result.high_mm - result.low_mm;
  GreyImage& seen = result.image;
  seen.width = static_cast<std::size_t>(std::max(1.0, std::round(size.x() / step_mm)));
  seen.height = static_cast<std::size_t>(std::max(1.0, std::round(size.y() / step_mm)));
  seen.darkness.assign(seen.width * seen.height, 0.0F);
  seen.cover.assign(seen.width * seen.height, 0.0F);
  const Place step{size.x() / static_cast<double>(seen.width),
                   size.y() / static_cast<double>(seen.height)};
  const Transform to_pixels = inverse_of(to_mm);
  for (std::size_t i = 0; i < seen.darkness.size(); ++i) {
    const std::size_t line = i / seen.width;
    const double across = static_cast<double>(i % seen.width) + 0.5;
    const double down = static_cast<double>(line) + 0.5;
    const Place at =
        to_pixels({result.low_mm.x() + across * step.x(), result.high_mm.y() - down * step.y()});
    const double column = std::floor(at.x());
    const double row = std::floor(at.y());
    if (column < 0.0 || row < 0.0 || column >= static_cast<double>(image.width) ||
        row >= static_cast<double>(image.height)) {
      continue;
    }
    const std::size_t from =
        static_cast<std::size_t>(row) * image.width + static_cast<std::size_t>(column);
    seen.darkness[i] = image.darkness[from];
    seen.cover[i] = image.cover.empty() ? 1.0F : image.cover[from];
  }
}

}  // namespace

UprightImage upright(const GreyImage& image, const Transform& to_mm, double burnt_mm) {
  CNC_ASSERT(to_mm.finite() && to_mm.determinant() != 0.0 && burnt_mm > 0.0);
  UprightImage result;
  set_box(image, to_mm, result);
  const int orientation = orientation_of(to_mm);
  if (orientation != 0) {
    result.image = picture::oriented(image, orientation);
  } else {
    const Place size = result.high_mm - result.low_mm;
    sample(image, to_mm, sample_size(to_mm, size, burnt_mm), result);
  }
  return result;
}

}  // namespace sim::engrave
