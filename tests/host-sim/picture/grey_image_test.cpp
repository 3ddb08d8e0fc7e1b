#include "host-sim/picture/grey_image.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::picture {
namespace {

TEST(GreyImage, IsTurnedAsACameraSays) {
  // a b c
  // d e f
  const GreyImage image{3, 2, {1, 2, 3, 4, 5, 6}, {}};
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

/// A picture that is truncated or damaged is refused or read. No other effect is allowed.
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
}  // namespace sim::picture
