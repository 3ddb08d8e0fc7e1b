#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

#include "host-sim/picture/base64.hpp"
#include "tests/host-sim/import/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::drawing {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Returns a BMP of one row: its first pixel is black, the others are white.
std::string bmp(std::size_t width = 2) {
  std::string header{
      "BM\x3E\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0\x02\0\0\0\x01\0\0\0\x01\0\x18\0\0\0\0\0\x08\0\0\0"
      "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0",
      54};
  header[18] = static_cast<char>(width % 256);
  header[19] = static_cast<char>(width / 256);
  std::string pixels(3 * width, '\xFF');
  for (std::size_t i = 0; i < 3; ++i) pixels[i] = '\0';
  return header + pixels + std::string((4 - pixels.size() % 4) % 4, '\0');
}

std::string data_uri(std::size_t width = 2) {
  return "data:image/bmp;base64," + picture::base64_encoded(bmp(width));
}

/// Returns a page of 100 x 60 mm whose units are mm.
std::string page(const std::string& body) {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" )"
         R"(width="100mm" height="60mm" viewBox="0 0 100 60">)" +
         body + "</svg>";
}

std::string image(const std::string& attributes, const std::string& link = data_uri()) {
  return fmt::format(R"(<image id="p" {} href="{}"/>)", attributes, link);
}

void expect_near(const Place& place, const Place& wanted) {
  EXPECT_NEAR(place.x(), wanted.x(), 1.0e-9);
  EXPECT_NEAR(place.y(), wanted.y(), 1.0e-9);
}

TEST(Base64, ComesBackAsItWas) {
  for (const std::uint64_t seed : proof::Trials{200}) {
    proof::Random random{seed};
    std::string bytes(random.below(40), '\0');
    for (char& byte : bytes) byte = static_cast<char>(random.below(256));
    const std::string text = picture::base64_encoded(bytes);
    EXPECT_EQ(text.size() % 4, 0U);
    EXPECT_EQ(picture::base64_decoded(text), bytes);
  }
  EXPECT_EQ(picture::base64_encoded("Man"), "TWFu");
  EXPECT_EQ(picture::base64_encoded("Ma"), "TWE=");
  EXPECT_EQ(picture::base64_decoded("TW\nFu "), "Man");
  EXPECT_EQ(picture::base64_decoded("TW*u"), std::nullopt);
}

TEST(SvgImage, LiesWhereItIsDrawn) {
  const Drawing drawn = read(page(image(R"(x="10" y="20" width="40" height="20")")));
  ASSERT_THAT(drawn.pictures, SizeIs(1));
  const DrawnPicture& picture = drawn.pictures.front();
  EXPECT_EQ(picture.image->width, 2U);
  EXPECT_EQ(drawn.layers[picture.entity.layer].colour, "image");
  EXPECT_EQ(picture.entity.name, "image \"p\"");
  expect_near(picture.to_mm({0.0, 0.0}), {10.0, 40.0});
  expect_near(picture.to_mm({2.0, 1.0}), {50.0, 20.0});
  ASSERT_THAT(drawn.faults, SizeIs(1));
  EXPECT_EQ(drawn.faults.front().kind, FaultKind::kPicture);
  EXPECT_FALSE(drawn.has_errors());
  EXPECT_THAT(drawn.faults.front().remedy, HasSubstr("image: kind=image"));
}

TEST(SvgImage, FollowsAspectAndTransform) {
  struct Case {
    std::string attributes;
    Place first;  ///< Position of the picture's upper left corner.
    Place last;   ///< Position of the picture's lower right corner.
  };
  const std::array cases{
      Case{R"(width="40" height="40")", {0.0, 50.0}, {40.0, 30.0}},
      Case{R"(width="40" height="40" preserveAspectRatio="xMidYMin")", {0.0, 60.0}, {40.0, 40.0}},
      Case{R"(width="40" height="40" preserveAspectRatio="none")", {0.0, 60.0}, {40.0, 20.0}},
      Case{R"(width="40")", {0.0, 60.0}, {40.0, 40.0}},
      Case{R"(height="10")", {0.0, 60.0}, {20.0, 50.0}},
      Case{"", {0.0, 60.0}, {2.0, 59.0}},
      Case{R"x(width="2" height="1" transform="translate(10 10) rotate(90)")x",
           {10.0, 50.0},
           {9.0, 48.0}},
      Case{R"x(width="2" height="1" transform="matrix(-1 0 0 1 50 0)")x",
           {50.0, 60.0},
           {48.0, 59.0}},
  };
  for (const Case& each : cases) {
    SCOPED_TRACE(each.attributes);
    const Drawing drawn = read(page(image(each.attributes)));
    ASSERT_THAT(drawn.pictures, SizeIs(1));
    expect_near(drawn.pictures.front().to_mm({0.0, 0.0}), each.first);
    expect_near(drawn.pictures.front().to_mm({2.0, 1.0}), each.last);
  }
}

TEST(SvgImage, IsClippedToItsPixels) {
  const std::string clip =
      R"(<clipPath id="c"><rect x="20" y="0" width="80" height="60"/></clipPath>)";
  const std::string half = R"x(width="40" height="20" clip-path="url(#c)")x";
  const Drawing drawn = read(page(clip + image(half)));
  ASSERT_THAT(drawn.pictures, SizeIs(1));
  const picture::GreyImage& seen = *drawn.pictures.front().image;
  EXPECT_EQ(seen.cover, (std::vector<float>{0.0F, 1.0F}));
  EXPECT_EQ(seen.darkness, (std::vector<float>{0.0F, 0.0F}));
  const Drawing outside =
      read(page(clip + image(R"x(width="10" height="5" clip-path="url(#c)")x")));
  EXPECT_THAT(outside.pictures, IsEmpty());
  ASSERT_THAT(outside.faults, SizeIs(1));
  EXPECT_THAT(outside.faults.front().reason, HasSubstr("outside of their clip"));
  const Drawing slice =
      read(page(image(R"(width="10" height="10" preserveAspectRatio="xMinYMid slice")")));
  ASSERT_THAT(slice.pictures, SizeIs(1));
  EXPECT_EQ(slice.pictures.front().image->cover, (std::vector<float>{1.0F, 0.0F}));
}

TEST(SvgImage, IsReadBesideTheDrawingOnly) {
  ImportOptions options;
  std::vector<std::string> read;
  options.read_beside = [&read](const std::string& name) {
    read.push_back(name);
    if (name == "gone.bmp") throw std::runtime_error("gone.bmp: no such file");
    return bmp();
  };
  const auto picture = [&](const std::string& link) {
    return read_drawing("f.svg", page(image(R"(width="2")", link)), options);
  };
  const Drawing fine = picture("my%20photos/a.bmp");
  ASSERT_THAT(fine.pictures, SizeIs(1));
  EXPECT_EQ(fine.pictures.front().file, "my photos/a.bmp");
  EXPECT_EQ(read, std::vector<std::string>{"my photos/a.bmp"});
  for (const auto& [link, told] : std::vector<std::pair<std::string, std::string>>{
           {"http://a.b/c.png", "is a web address"},
           {"file:///c.png", "is a web address"},
           {"/etc/c.png", "is a path"},
           {"C:\\c.png", "is a path"},
           {"../c.png", "is not below"},
           {"a/%2e%2e/c.png", "is not below"},
           {"", "links no picture"},
           {"gone.bmp", "no such file"},
           {"data:image/png,abc", "is no data in base 64"},
           {"data:image/png;base64,AAAA", "no PNG, JPEG or BMP"}}) {
    SCOPED_TRACE(link);
    const Drawing drawn = picture(link);
    EXPECT_THAT(drawn.pictures, IsEmpty());
    EXPECT_FALSE(drawn.has_errors());
    ASSERT_THAT(drawn.faults, SizeIs(1));
    EXPECT_EQ(drawn.faults.front().kind, FaultKind::kBadPicture);
    EXPECT_THAT(drawn.faults.front().reason, HasSubstr(told));
  }
  EXPECT_THAT(read, SizeIs(2));
  options.read_beside = {};
  EXPECT_THAT(picture("a.bmp").faults.front().reason, HasSubstr("not read here"));
}

TEST(SvgImage, TakesNoMorePixelsThanTheEffortAllows) {
  std::string body;
  for (std::size_t i = 0; i < 3; ++i) body += image(R"(width="2")", data_uri(600 + i));
  const Drawing drawn = read_drawing("f.svg", page(body), {.effort = 1.3e-5});
  EXPECT_THAT(drawn.pictures, SizeIs(2));
  EXPECT_EQ(kinds_of(drawn), (std::vector{FaultKind::kPicture, FaultKind::kBadPicture}));
}

TEST(LbrnPicture, LiesAboutItsMiddle) {
  const std::string project = fmt::format(
      R"(<LightBurnProject MirrorX="False" MirrorY="False">)"
      R"(<CutSetting_Img type="Image"><index Value="3"/><name Value="photo"/>)"
      R"(<minPower Value="5"/><maxPower Value="30"/><speed Value="100"/><interval Value="0.2"/>)"
      R"(<ditherMode Value="grayscale"/></CutSetting_Img>)"
      R"(<Shape Type="Bitmap" CutIndex="3" W="40" H="20" Data="{}">)"
      R"(<XForm>1 0 0 1 50 30</XForm></Shape>)"
      R"(<Shape Type="Bitmap" CutIndex="3" W="40" H="20"><XForm>1 0 0 1 50 30</XForm></Shape>)"
      "</LightBurnProject>",
      picture::base64_encoded(bmp()));
  const Drawing drawn = read(project);
  ASSERT_THAT(drawn.pictures, SizeIs(1));
  expect_near(drawn.pictures.front().to_mm({0.0, 0.0}), {30.0, 40.0});
  expect_near(drawn.pictures.front().to_mm({2.0, 1.0}), {70.0, 20.0});
  const Layer& layer = drawn.layers[drawn.pictures.front().entity.layer];
  EXPECT_EQ(layer.name, "photo");
  EXPECT_EQ(layer.offered->kind, "Image");
  EXPECT_EQ(layer.offered->shading, "grayscale");
  EXPECT_THAT(drawn.faults, SizeIs(2));
}

}  // namespace
}  // namespace sim::drawing
