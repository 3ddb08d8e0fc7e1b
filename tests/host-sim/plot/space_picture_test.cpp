#include "host-sim/plot/space/space_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <stdexcept>
#include <string>

#include "host-sim/plot/picture_file.hpp"
#include "tests/host-sim/trace/scratch_file.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing::Not;

constexpr Box kPicture{100.0, 50.0, 800.0, 600.0};

SpaceBox box_to(const Vector3d& most) {
  SpaceBox box;
  box.include(Vector3d::Zero());
  box.include(most);
  return box;
}

/// Returns a square of the plan at a height.
surface::Mesh square(double side, double height) {
  return {.points = {{0, 0, height}, {side, 0, height}, {side, side, height}, {0, side, height}},
          .facets = {{0, 1, 2}, {0, 2, 3}}};
}

TEST(Axonometry, FitsABoxIntoThePictureAndKeepsRightAngles) {
  for (const std::uint64_t seed : proof::Trials{50}) {
    proof::Random random{seed};
    const SpaceBox box = box_to(
        {random.magnitude(1.0, 500.0), random.magnitude(1.0, 500.0), random.magnitude(0.1, 100.0)});
    const Viewpoint viewpoint{random.between(-360.0, 360.0), random.between(5.0, 85.0)};
    const double stretch = random.chance(0.5) ? 1.0 : 5.0;
    const Axonometry axonometry{viewpoint, box, stretch, kPicture};
    const Extent& seen = axonometry.extent_px();
    EXPECT_GE(seen.left_mm, kPicture.left_px - 1.0e-6);
    EXPECT_LE(seen.right_mm, kPicture.right_px() + 1.0e-6);
    EXPECT_GE(seen.bottom_mm, kPicture.top_px - 1.0e-6);
    EXPECT_LE(seen.top_mm, kPicture.bottom_px() + 1.0e-6);
    // Lengths at right angles to the view keep the scale. Along the view, the distance grows.
    const double azimuth = viewpoint.azimuth_deg * std::numbers::pi / 180.0;
    const Vector3d right{-std::sin(azimuth), std::cos(azimuth), 0.0};
    const SeenPoint from = axonometry.seen(box.least);
    const SeenPoint to = axonometry.seen(box.least + right);
    EXPECT_NEAR(to.x_px - from.x_px, axonometry.px_per_mm(), 1.0e-9);
    EXPECT_NEAR(to.y_px, from.y_px, 1.0e-9);
    EXPECT_NEAR(to.depth_px, from.depth_px, 1.0e-9);
    const SeenPoint above = axonometry.seen(box.least + Vector3d::UnitZ());
    EXPECT_LT(above.y_px, from.y_px);
    EXPECT_LT(above.depth_px, from.depth_px);
  }
}

TEST(HiddenLines, AreLeftOutBehindASurfaceAndStayOnIt) {
  const Axonometry axonometry{{}, box_to({10.0, 10.0, 4.0}), 1.0, kPicture};
  DepthImage image{kPicture, 2.0};
  const surface::Mesh mesh = square(10.0, 2.0);
  for (const auto& facet : mesh.facets) {
    image.draw({{{axonometry.seen(mesh.points[facet[0]])},
                 {axonometry.seen(mesh.points[facet[1]])},
                 {axonometry.seen(mesh.points[facet[2]])}}});
  }
  const auto path = [&](const Vector3d& from, const Vector3d& to) {
    return visible_path({{from, to}}, axonometry, image);
  };
  EXPECT_EQ(path({4.0, 4.0, 0.0}, {6.0, 6.0, 0.0}), "");
  EXPECT_THAT(path({4.0, 4.0, 3.0}, {6.0, 6.0, 3.0}), HasSubstr("L"));
  EXPECT_THAT(path({1.0, 1.0, 2.0}, {9.0, 9.0, 2.0}), HasSubstr("L"));
  // Only the part of a line above the surface is visible: one part of about half
  // its length.
  const std::string through = path({5.0, 5.0, 0.0}, {5.0, 5.0, 4.0});
  EXPECT_EQ(through.find('M'), 0U);
  EXPECT_EQ(through.rfind('M'), 0U);
  const double visible =
      std::stod(through.substr(through.find(' '))) - axonometry.seen({5.0, 5.0, 4.0}).y_px;
  const double whole =
      axonometry.seen({5.0, 5.0, 0.0}).y_px - axonometry.seen({5.0, 5.0, 4.0}).y_px;
  EXPECT_NEAR(visible / whole, 0.5, 0.05);
}

TEST(HiddenLines, AreThinnedWithinATenthOfAPixel) {
  const Axonometry axonometry{{}, box_to({10.0, 10.0, 4.0}), 1.0, kPicture};
  const DepthImage empty{kPicture, 2.0};
  SpaceLine line;
  for (int i = 0; i <= 1000; ++i) line.emplace_back(0.01 * i, 5.0, 1.0);
  const std::string straight = visible_path({line}, axonometry, empty);
  EXPECT_LT(straight.size(), 300U);
}

TEST(SpacePicture, HasTitleScalesKeyAndLines) {
  SpaceScene scene{.title = "A <title>", .subtitle = "sub", .mesh = square(20.0, 3.0)};
  scene.mesh.points[2].z() = 9.0;
  scene.colours = height_colours(scene.mesh, scene.key);
  scene.lines.push_back({{.colour = "#123456", .label = "edge"}, {{{0, 0, 3}, {20, 0, 3}}}});
  const std::string svg = draw_space("out.svg", scene, {});
  for (const char* part : {"A &lt;title&gt;",
                           "sub",
                           "X, mm",
                           "Y, mm",
                           "Z, mm",
                           "edge",
                           "#123456",
                           "data:image/png;base64,",
                           ">20</text>"}) {
    EXPECT_THAT(svg, HasSubstr(part));
  }
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("heights drawn")));
}

TEST(SpacePicture, StretchesLowHeightsAndSaysSo) {
  SpaceScene scene{.mesh = square(100.0, 0.0)};
  scene.mesh.points[0].z() = 2.0;
  EXPECT_THAT(draw_space("out.svg", scene, {}), HasSubstr("heights drawn × 10"));
}

TEST(SpacePicture, DrawsALevelSquareAndAnUprightOne) {
  const std::string level = draw_space("out.svg", {.mesh = square(10.0, 1.0)}, {});
  EXPECT_THAT(level, Not(HasSubstr("nan")));
  const surface::Mesh upright{.points = {{0, 0, 0}, {0, 5, 0}, {0, 5, 5}}, .facets = {{0, 1, 2}}};
  EXPECT_THAT(draw_space("out.svg", {.mesh = upright}, {}), Not(HasSubstr("nan")));
}

TEST(PictureFile, IsChosenByTheEndOfItsName) {
  EXPECT_NO_THROW(require_picture_name("--x", ""));
  EXPECT_NO_THROW(require_picture_name("--x", "a.SVG"));
  EXPECT_THROW(require_picture_name("--x", "a.jpg"), std::invalid_argument);
  EXPECT_NO_THROW(require_picture_name("--x", "/dev/stdout"));
  EXPECT_THROW(require_picture_name("--x", "a.svg.txt"), std::invalid_argument);
}

}  // namespace
}  // namespace sim
