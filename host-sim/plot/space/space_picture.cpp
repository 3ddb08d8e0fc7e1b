#include "host-sim/plot/space/space_picture.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "host-sim/plot/picture.hpp"
#include "host-sim/plot/space/space_frame.hpp"
#include "host-sim/plot/svg_element.hpp"

namespace sim {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double kSpaceLeftPx = 150.0;
constexpr double kSpaceTopPx = 140.0;
constexpr double kSpaceKeyPx = 300.0;
constexpr double kSpaceBottomPx = 110.0;
constexpr double kSpaceWidthPx = kPictureWidthPx - kSpaceLeftPx - kSpaceKeyPx - 80.0;
/// Least height of the picture. It has enough space for a scale and five samples.
constexpr double kMinSpacePx = 560.0;
constexpr double kMaxSpacePx = 1000.0;
constexpr double kImageScale = 2.0;
constexpr Colour kPlainSurface{0xd4, 0xd8, 0xde};
/// Least cosine of the angle between the normal vector of a facet and the mean normal vector at a
/// corner, for which the corner is shaded smoothly. At a greater angle, the edges at the corner
/// look sharp.
constexpr double kSharp = 0.8;

/// Returns the factor by which heights are multiplied. It is 1 if heights are visible without
/// stretching.
double stretch_for(const SpaceBox& box) {
  constexpr double kMinHeightShare = 0.08;
  const Vector3d size = box.most - box.least;
  const double plan = std::hypot(size.x(), size.y());
  for (const double stretch : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0}) {
    if (stretch * size.z() >= kMinHeightShare * plan) return stretch;
  }
  return size.z() > 0.0 ? 100.0 : 1.0;
}

/// Returns the box around all points. It has some height even if all points are level.
SpaceBox box_of(const SpaceScene& scene) {
  SpaceBox box;
  for (const Vector3d& point : scene.mesh.points) box.include(point);
  for (const SpaceLines& lines : scene.lines) {
    for (const SpaceLine& line : lines.lines) {
      for (const Vector3d& point : line) box.include(point);
    }
  }
  const Vector3d size = box.most - box.least;
  const double least = 1.0e-3 * std::max(size.maxCoeff(), 1.0e-6);
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    if (size[axis] >= least) continue;
    box.least[axis] -= 0.5 * least;
    box.most[axis] += 0.5 * least;
  }
  return box;
}

/// Shades the facets of a mesh, under a light from the upper left.
class Shader {
 public:
  Shader(const SpaceScene& scene, const Axonometry& axonometry)
      : scene_{scene},
        axonometry_{axonometry},
        normals_(scene.mesh.points.size(), Vector3d::Zero()) {
    for (const auto& facet : scene.mesh.facets) {
      const Vector3d area = area_of(facet);
      for (const std::uint32_t corner : facet) normals_[corner] += area;
    }
    for (Vector3d& normal : normals_) normal.normalize();
  }

  void draw(DepthImage& image) const {
    for (const auto& facet : scene_.mesh.facets) {
      const Vector3d flat = area_of(facet).normalized();
      std::array<ShadedCorner, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t point = facet[i];
        const bool is_smooth = normals_[point].dot(flat) > kSharp;
        corners[i].place = axonometry_.seen(scene_.mesh.points[point]);
        corners[i].colour = shade(is_smooth ? normals_[point] : flat) * colour_of(point);
      }
      image.draw(corners);
    }
  }

 private:
  [[nodiscard]] Vector3d area_of(const std::array<std::uint32_t, 3>& facet) const {
    const auto& points = scene_.mesh.points;
    return (points[facet[1]] - points[facet[0]]).cross(points[facet[2]] - points[facet[0]]);
  }

  [[nodiscard]] Vector3f colour_of(std::uint32_t point) const {
    const Colour& colour = scene_.colours.empty() ? kPlainSurface : scene_.colours[point];
    return Vector3f{static_cast<float>(colour.red),
                    static_cast<float>(colour.green),
                    static_cast<float>(colour.blue)} /
           255.0F;
  }

  /// Returns the light that a surface reflects to the viewer, from either side.
  [[nodiscard]] float shade(const Vector3d& normal) const {
    const Vector3d light = Vector3d{-0.5, 0.6, 0.62}.normalized();
    Vector3d turned = axonometry_.turned(normal);
    if (turned.z() < 0.0) turned = -turned;
    return static_cast<float>(0.5 + 0.55 * std::max(0.0, turned.dot(light)));
  }

  const SpaceScene& scene_;
  const Axonometry& axonometry_;
  std::vector<Vector3d> normals_;  ///< Mean normal vector at each point of the mesh.
};

void add_lines(std::string& out,
               const SpaceLines& lines,
               const Axonometry& axonometry,
               const DepthImage& image) {
  const std::string data = visible_path(lines.lines, axonometry, image);
  if (data.empty()) return;
  fmt::format_to(std::back_inserter(out),
                 R"(<path d="{}" fill="none" stroke="{}" stroke-width="{}" )"
                 R"(stroke-linejoin="round" stroke-linecap="butt")",
                 data,
                 lines.sample.colour,
                 lines.sample.width_px);
  if (!lines.sample.dashes_px.empty()) {
    out += fmt::format(R"( stroke-dasharray="{}")", lines.sample.dashes_px);
  }
  out += "/>\n";
}

Box inside(const Extent& extent) {
  constexpr double kRimPx = 2.0;
  return {extent.left_mm - kRimPx,
          extent.bottom_mm - kRimPx,
          extent.width_mm() + 2.0 * kRimPx,
          extent.height_mm() + 2.0 * kRimPx};
}

/// Returns the part of the picture that a box in space covers if it is drawn at the greatest
/// possible width.
Box plot_for(const Viewpoint& viewpoint, const SpaceBox& box, double stretch) {
  constexpr double kSquarePx = 1000.0;
  const Extent seen =
      Axonometry{viewpoint, box, stretch, {0.0, 0.0, kSquarePx, kSquarePx}}.extent_px();
  const double natural_px = kSpaceWidthPx * seen.height_mm() / seen.width_mm();
  return {
      kSpaceLeftPx, kSpaceTopPx, kSpaceWidthPx, std::clamp(natural_px, kMinSpacePx, kMaxSpacePx)};
}

void complete_key(SpaceScene& scene, double stretch) {
  for (const SpaceLines& lines : scene.lines) {
    if (!lines.sample.label.empty() && !lines.lines.empty()) {
      scene.key.samples.push_back(lines.sample);
    }
  }
  if (stretch != 1.0) scene.key.notes.push_back(fmt::format("heights drawn × {:g}", stretch));
}

}  // namespace

std::string draw_space(const std::string& file, SpaceScene scene, const Viewpoint& viewpoint) {
  const SpaceBox box = box_of(scene);
  const double stretch = stretch_for(box);
  const Box plot = plot_for(viewpoint, box, stretch);
  const Axonometry axonometry{viewpoint, box, stretch, plot};
  const double height_px = plot.bottom_px() + kSpaceBottomPx;
  complete_key(scene, stretch);
  DepthImage image{inside(axonometry.extent_px()), kImageScale};
  Shader{scene, axonometry}.draw(image);
  std::string out = svg::document_start(kPictureWidthPx, height_px);
  svg::add_box(out, {0.0, 0.0, kPictureWidthPx, height_px}, "#ffffff");
  svg::add_text(out, 60.0, 58.0, {.size_px = 34.0, .weight = "bold"}, scene.title);
  svg::add_text(out, 60.0, 96.0, {.size_px = 23.0, .fill = "#5b626c"}, scene.subtitle);
  add_back_sides(out, axonometry, box);
  add_image(out, file, image.image(), image.box());
  for (const SpaceLines& lines : scene.lines) add_lines(out, lines, axonometry, image);
  add_space_axes(out, axonometry, box);
  const double key_left_px = kPictureWidthPx - kSpaceKeyPx;
  add_key(out, {key_left_px, kSpaceTopPx, kSpaceKeyPx, plot.height_px}, scene.key);
  return out + "</svg>\n";
}

std::vector<Colour> height_colours(const surface::Mesh& mesh, PictureKey& key) {
  double least = mesh.points.front().z();
  double most = least;
  for (const Vector3d& point : mesh.points) {
    least = std::min(least, point.z());
    most = std::max(most, point.z());
  }
  const double span = std::max(most - least, 1.0e-9);
  const auto colour_at = [](double share) {
    // Share of white that is mixed into the colours, so that lines over the surface stay visible.
    constexpr double kWhite = 0.38;
    const Colour full = speed_colour(share);
    const auto lighter = [](std::uint8_t part) {
      return static_cast<std::uint8_t>(std::lround(part + kWhite * (255 - part)));
    };
    return Colour{lighter(full.red), lighter(full.green), lighter(full.blue)};
  };
  ColourScale scale{.heading = "Z, mm", .colours = {}, .least = least, .most = least + span};
  constexpr int kSteps = 58;
  for (int i = 0; i < kSteps; ++i) scale.colours.push_back(colour_at((i + 0.5) / kSteps));
  if (most > least) key.scales.push_back(std::move(scale));
  std::vector<Colour> colours;
  colours.reserve(mesh.points.size());
  for (const Vector3d& point : mesh.points)
    colours.push_back(colour_at((point.z() - least) / span));
  return colours;
}

}  // namespace sim
