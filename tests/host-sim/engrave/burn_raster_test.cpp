#include "host-sim/engrave/burn_raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::engrave {
namespace {

GreyImage random_image(proof::Random& random, std::size_t width, std::size_t height) {
  GreyImage image{width, height, std::vector<float>(width * height), {}};
  for (float& pixel : image.darkness) pixel = static_cast<float>(random.unit());
  return image;
}

double mean_of(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// At any size of the raster, the sum of light is kept.
TEST(BurnRaster, KeepsTheMeanOfThePicture) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    const GreyImage image = random_image(random, 1 + random.below(40), 1 + random.below(40));
    const BurnRaster raster =
        burn_raster(image, 1 + random.below(90), 1 + random.below(90), ToneCurve{});
    EXPECT_NEAR(mean_of(raster.power), mean_of(image.darkness), 1.0e-4);
  }
}

TEST(BurnRaster, IsThePictureUpsideDownAtItsOwnSize) {
  proof::Random random{7};
  const GreyImage image = random_image(random, 5, 4);
  const BurnRaster raster = burn_raster(image, 5, 4, ToneCurve{});
  for (std::size_t y = 0; y < 4; ++y) {
    for (std::size_t x = 0; x < 5; ++x) {
      EXPECT_NEAR(raster.at(x, 3 - y), image.darkness[y * 5 + x], 1.0e-6F);
    }
  }
}

TEST(BurnRaster, DitheringKeepsTheMeanAndHasTwoPowersOnly) {
  for (const std::uint64_t seed : proof::Trials{40}) {
    proof::Random random{seed};
    const auto grey = static_cast<float>(random.between(0.05, 0.95));
    const GreyImage image{64, 64, std::vector<float>(64 * 64, grey), {}};
    for (const Shading shading :
         {Shading::kOrdered, Shading::kFloydSteinberg, Shading::kJarvis, Shading::kStucki}) {
      const BurnRaster raster = burn_raster(image, 64, 64, {.shading = shading, .max_power = 0.5});
      for (const float power : raster.power) EXPECT_TRUE(power == 0.0F || power == 0.5F);
      EXPECT_NEAR(mean_of(raster.power), 0.5 * static_cast<double>(grey), 0.012);
    }
  }
}

TEST(BurnRaster, HasPowersOfTheCurve) {
  const ToneCurve curve{.min_power = 0.1, .max_power = 0.8, .gamma = 2.0};
  EXPECT_EQ(power_of(0.0, curve), 0.0);
  EXPECT_DOUBLE_EQ(power_of(1.0, curve), 0.8);
  EXPECT_DOUBLE_EQ(power_of(0.5, curve), 0.1 + 0.7 * 0.25);
}

}  // namespace
}  // namespace sim::engrave
