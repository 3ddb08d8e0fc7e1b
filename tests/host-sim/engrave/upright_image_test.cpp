#include "host-sim/engrave/upright_image.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "host-sim/engrave/burn_raster.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::engrave {
namespace {

using drawing::Place;
using drawing::Transform;

picture::GreyImage random_image(proof::Random& random) {
  const std::size_t width = 1 + random.below(9);
  const std::size_t height = 1 + random.below(9);
  picture::GreyImage image{width, height, std::vector<float>(width * height), {}};
  for (float& pixel : image.darkness) pixel = static_cast<float>(random.unit());
  return image;
}

double sum_of(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Returns the darkness of an upright picture at a point, mm.
double darkness_at(const UprightImage& seen, const Place& place) {
  const Place size = seen.high_mm - seen.low_mm;
  const double across = (place.x() - seen.low_mm.x()) / size.x();
  const double down = (seen.high_mm.y() - place.y()) / size.y();
  const auto column = static_cast<std::size_t>(across * static_cast<double>(seen.image.width));
  const auto row = static_cast<std::size_t>(down * static_cast<double>(seen.image.height));
  return static_cast<double>(seen.image.darkness.at(row * seen.image.width + column));
}

/// With any map, each pixel is at the point to which the map moves its middle.
TEST(UprightImage, HasEachPixelInItsPlace) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    const picture::GreyImage image = random_image(random);
    const bool is_quarter = random.chance(0.5);
    const double angle = is_quarter ? 0.5 * std::numbers::pi * static_cast<double>(random.below(4))
                                    : random.between(0.0, drawing::kFullTurn);
    const Transform to_mm =
        drawing::moved_by({random.between(-50.0, 50.0), random.between(-50.0, 50.0)}) *
        drawing::turned_by(angle) *
        drawing::scaled_by(random.chance(0.5) ? random.between(0.5, 3.0) : -1.0,
                           random.chance(0.5) ? random.between(0.5, 3.0) : -1.0);
    const UprightImage seen = upright(image, to_mm, 0.1);
    EXPECT_EQ(seen.image.cover.empty(), is_quarter);
    for (std::size_t i = 0; i < image.darkness.size(); ++i) {
      const Place middle{static_cast<double>(i % image.width) + 0.5,
                         static_cast<double>(i / image.width) + 0.5};
      EXPECT_NEAR(darkness_at(seen, to_mm(middle)), image.darkness[i], 1.0e-6) << seed;
    }
  }
}

/// A rotated picture has the area and the light of the original picture, and no more.
TEST(UprightImage, TurnedKeepsAreaAndLight) {
  for (const std::uint64_t seed : proof::Trials{60}) {
    proof::Random random{seed};
    const picture::GreyImage image = random_image(random);
    const Transform to_mm{.x_axis{random.between(0.5, 2.0), random.between(0.1, 1.0)},
                          .y_axis{random.between(0.1, 1.0), random.between(-2.0, -0.6)}};
    const UprightImage seen = upright(image, to_mm, 0.1);
    const Place size = seen.high_mm - seen.low_mm;
    const double pixel_mm2 =
        size.x() * size.y() / static_cast<double>(seen.image.width * seen.image.height);
    const double area = std::abs(to_mm.determinant());
    const double whole = area * static_cast<double>(image.darkness.size());
    EXPECT_NEAR(sum_of(seen.image.cover) * pixel_mm2, whole, 0.03 * whole + 0.05) << seed;
    EXPECT_NEAR(
        sum_of(seen.image.darkness) * pixel_mm2, sum_of(image.darkness) * area, 0.03 * whole + 0.05)
        << seed;
  }
}

/// The area outside of a rotated picture is not burnt, inverted or not.
TEST(UprightImage, BurnsNothingBesideThePicture) {
  const picture::GreyImage white{4, 4, std::vector<float>(16), {}};
  const UprightImage seen = upright(white, drawing::turned_by(0.25 * std::numbers::pi), 0.1);
  const Place size = seen.high_mm - seen.low_mm;
  const BurnRaster raster = burn_raster(seen.image, size, 0.1, 0.1, {.is_inverted = true});
  EXPECT_EQ(raster.at(0, 0), 0.0F);
  EXPECT_EQ(raster.at(raster.columns - 1, raster.rows - 1), 0.0F);
  EXPECT_EQ(raster.at(raster.columns / 2, raster.rows / 2), 1.0F);
  EXPECT_NEAR(sum_of(raster.power) * raster.pixel_mm * raster.interval_mm, 16.0, 0.05);
}

}  // namespace
}  // namespace sim::engrave
