#include "host-sim/contour/material_side.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim {
namespace {

struct Loop {
  std::uint32_t first;
  std::uint32_t end;

  [[nodiscard]] std::uint32_t next(std::uint32_t index) const {
    return index + 1 < end ? index + 1 : first;
  }
};

/// Twice the area between an arc and its chord.
double twice_segment_area(const ContourVertex& from, const ContourVertex& to) {
  if (from.bulge == 0.0) return 0.0;
  const double sweep = 4.0 * std::atan(from.bulge);
  const double radius =
      std::hypot(to.x - from.x, to.y - from.y) / (2.0 * std::abs(std::sin(0.5 * sweep)));
  return radius * radius * (sweep - std::sin(sweep));
}

double twice_area(const Contour& contour, const Loop& loop) {
  double sum = 0.0;
  for (std::uint32_t i = loop.first; i < loop.end; ++i) {
    const ContourVertex& from = contour.vertices[i];
    const ContourVertex& to = contour.vertices[loop.next(i)];
    sum += from.x * to.y - to.x * from.y + twice_segment_area(from, to);
  }
  return sum;
}

/// Whether a place is between an arc and its chord: on the chord's outer side,
/// the arc is seen under more than half of what it turns, less than half a turn.
bool in_segment(const ContourVertex& from, const ContourVertex& to, const ContourVertex& place) {
  if (from.bulge == 0.0) return false;
  const double side = (to.x - from.x) * (place.y - from.y) - (to.y - from.y) * (place.x - from.x);
  if (side * from.bulge >= 0.0) return false;
  const double ahead_x = to.x - place.x;
  const double ahead_y = to.y - place.y;
  const double behind_x = from.x - place.x;
  const double behind_y = from.y - place.y;
  const double seen = std::atan2(std::abs(behind_x * ahead_y - behind_y * ahead_x),
                                 behind_x * ahead_x + behind_y * ahead_y);
  return seen > std::numbers::pi - 2.0 * std::atan(std::abs(from.bulge));
}

bool is_around(const Contour& contour, const Loop& loop, const ContourVertex& place) {
  bool inside = false;
  for (std::uint32_t i = loop.first; i < loop.end; ++i) {
    const ContourVertex& from = contour.vertices[i];
    const ContourVertex& to = contour.vertices[loop.next(i)];
    const double side = (to.x - from.x) * (place.y - from.y) - (to.y - from.y) * (place.x - from.x);
    if ((from.y <= place.y) != (to.y <= place.y) && (side > 0.0) == (to.y > from.y)) {
      inside = !inside;
    }
    if (in_segment(from, to, place)) inside = !inside;
  }
  return inside;
}

void turn_round(Contour& contour, const Loop& loop) {
  const auto first = contour.vertices.begin() + loop.first;
  const auto end = contour.vertices.begin() + loop.end;
  std::reverse(first + 1, end);  // The first vertex stays the first.
  const double closing = first->bulge;
  for (auto vertex = first; vertex + 1 != end; ++vertex) vertex->bulge = -(vertex + 1)->bulge;
  (end - 1)->bulge = -closing;
}

}  // namespace

void put_material_left(Contour& contour) {
  std::vector<Loop> loops;
  for (std::size_t i = 0; i < contour.loop_ends.size(); ++i) {
    loops.push_back({contour.view().loop_begin(i), contour.loop_ends[i]});
  }
  std::vector<bool> outlines;
  for (const Loop& loop : loops) {
    const ContourVertex& place = contour.vertices[loop.first];
    bool outline = true;
    for (const Loop& other : loops) {
      if (other.first != loop.first && is_around(contour, other, place)) outline = !outline;
    }
    outlines.push_back(outline);
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if ((twice_area(contour, loops[i]) > 0.0) != outlines[i]) turn_round(contour, loops[i]);
  }
}

}  // namespace sim
