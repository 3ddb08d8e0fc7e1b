#include "host-sim/engrave/burn_raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

#include "host-sim/engrave/grey_image.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::engrave {
namespace {

GreyImage random_image(proof::Random& random, std::size_t width, std::size_t height) {
  GreyImage image{width, height, std::vector<float>(width * height)};
  for (float& pixel : image.darkness) pixel = static_cast<float>(random.unit());
  return image;
}

double mean_of(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Whatever the size, no light is lost.
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
    const GreyImage image{64, 64, std::vector<float>(64 * 64, grey)};
    for (const Shading shading :
         {Shading::kOrdered, Shading::kFloydSteinberg, Shading::kJarvis, Shading::kStucki}) {
      const BurnRaster raster = burn_raster(image, 64, 64, {.shading = shading, .most_power = 0.5});
      for (const float power : raster.power) EXPECT_TRUE(power == 0.0F || power == 0.5F);
      EXPECT_NEAR(mean_of(raster.power), 0.5 * static_cast<double>(grey), 0.012);
    }
  }
}

TEST(BurnRaster, HasPowersOfTheCurve) {
  const ToneCurve curve{.least_power = 0.1, .most_power = 0.8, .gamma = 2.0};
  EXPECT_EQ(power_of(0.0, curve), 0.0);
  EXPECT_DOUBLE_EQ(power_of(1.0, curve), 0.8);
  EXPECT_DOUBLE_EQ(power_of(0.5, curve), 0.1 + 0.7 * 0.25);
}

TEST(GreyImage, IsTurnedAsACameraSays) {
  // a b c
  // d e f
  const GreyImage image{3, 2, {1, 2, 3, 4, 5, 6}};
  using Row = std::vector<float>;
  EXPECT_EQ(oriented(image, 1).darkness, (Row{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(oriented(image, 2).darkness, (Row{3, 2, 1, 6, 5, 4}));
  EXPECT_EQ(oriented(image, 3).darkness, (Row{6, 5, 4, 3, 2, 1}));
  EXPECT_EQ(oriented(image, 4).darkness, (Row{4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(oriented(image, 5).darkness, (Row{1, 4, 2, 5, 3, 6}));
  EXPECT_EQ(oriented(image, 6).darkness, (Row{4, 1, 5, 2, 6, 3}));
  EXPECT_EQ(oriented(image, 7).darkness, (Row{6, 3, 5, 2, 4, 1}));
  EXPECT_EQ(oriented(image, 8).darkness, (Row{3, 6, 2, 5, 1, 4}));
  EXPECT_EQ(oriented(image, 6).width, 2U);
  const std::string exif{
      "\xFF\xD8\xFF\xE1\x00\x1E"
      "Exif\0\0MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0\x06\0\0",
      34};
  EXPECT_EQ(exif_orientation(exif), 6);
  EXPECT_EQ(exif_orientation(exif.substr(0, 20)), 1);
  EXPECT_EQ(exif_orientation("\xFF\xD8"), 1);
}

/// What is cut short or damaged is refused or read, and nothing else happens.
TEST(GreyImage, SurvivesDamage) {
  const std::string bmp{
      "BM\x46\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x02\0\0\0\x02\0\0\0\x01\0\x18\0\0\0\0\0"
      "\x10\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"
      "\x10\x20\x30\x40\x50\x60\0\0\x70\x80\x90\xA0\xB0\xC0\0\0",
      70};
  EXPECT_EQ(read_image(bmp, "a.bmp").width, 2U);
  for (const std::uint64_t seed : proof::Trials{2000}) {
    proof::Random random{seed};
    std::string damaged = bmp.substr(0, random.chance(0.5) ? bmp.size() : random.below(bmp.size()));
    for (std::size_t i = 1 + random.below(4); i > 0 && damaged.size() > 2; --i) {
      damaged[2 + random.below(damaged.size() - 2)] = static_cast<char>(random.below(256));
    }
    try {
      const GreyImage image = read_image(damaged, "a.bmp");
      EXPECT_EQ(image.darkness.size(), image.width * image.height);
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string{error.what()}.find("a.bmp"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace sim::engrave
