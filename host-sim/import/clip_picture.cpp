#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "host-sim/import/clip_region.hpp"

namespace sim::drawing {
namespace {

/// A point where a row of pixels crosses the edge of a clip. `turn` is the change of the winding
/// number at this point.
struct Crossing {
  double column = 0.0;
  int turn = 0;
};

/// Returns the loops of an area, converted from mm to pixels of the picture. `to_mm` maps pixels to
/// mm.
std::vector<std::vector<Place>> in_pixels(const ClipRegion::Area& area, const Transform& to_mm) {
  const double size = to_mm.determinant();
  const auto pixel = [&](const Place& place) {
    const Place way = place - to_mm.origin;
    return Place{cross(way, to_mm.y_axis) / size, cross(to_mm.x_axis, way) / size};
  };
  std::vector<std::vector<Place>> loops;
  for (const auto& loop : area.loops) {
    std::vector<Place>& places = loops.emplace_back();
    for (const Place& place : loop) places.push_back(pixel(place));
  }
  return loops;
}

std::vector<Crossing> crossings_at(const std::vector<std::vector<Place>>& loops, double row) {
  std::vector<Crossing> crossings;
  for (const auto& loop : loops) {
    for (std::size_t i = 1; i < loop.size(); ++i) {
      const Place& a = loop[i - 1];
      const Place& b = loop[i];
      if ((a.y() <= row) == (b.y() <= row)) continue;
      const double share = (row - a.y()) / (b.y() - a.y());
      crossings.push_back({a.x() + share * (b.x() - a.x()), b.y() > row ? 1 : -1});
    }
  }
  std::ranges::sort(crossings, {}, &Crossing::column);
  return crossings;
}

/// Sets in `seen` each pixel of a row whose middle is within an area, given the crossings of the
/// row with the edge of the area.
void mark_row(const std::vector<Crossing>& crossings, FillRule rule, std::vector<bool>& seen) {
  const auto first_behind = [&seen](double column) {
    return static_cast<std::size_t>(
        std::clamp(std::ceil(column - 0.5), 0.0, static_cast<double>(seen.size())));
  };
  int winding = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    winding += crossings[i].turn;
    const bool is_inside = rule == FillRule::kNonZero ? winding != 0 : winding % 2 != 0;
    if (!is_inside) continue;
    const std::size_t end = first_behind(crossings[i + 1].column);
    for (std::size_t k = first_behind(crossings[i].column); k < end; ++k) seen[k] = true;
  }
}

}  // namespace

void clip_picture(picture::GreyImage& image, const Transform& to_mm, const ClipRegion& clip) {
  std::vector<std::pair<std::vector<std::vector<Place>>, FillRule>> areas;
  for (const ClipRegion::Area& area : clip.areas) {
    areas.emplace_back(in_pixels(area, to_mm), area.rule);
  }
  if (image.cover.empty()) image.cover.assign(image.darkness.size(), 1.0F);
  for (std::size_t row = 0; row < image.height; ++row) {
    std::vector<bool> seen(image.width, false);
    for (const auto& [loops, rule] : areas) {
      mark_row(crossings_at(loops, static_cast<double>(row) + 0.5), rule, seen);
    }
    for (std::size_t column = 0; column < image.width; ++column) {
      if (seen[column]) continue;
      image.cover[row * image.width + column] = 0.0F;
      image.darkness[row * image.width + column] = 0.0F;
    }
  }
}

}  // namespace sim::drawing
