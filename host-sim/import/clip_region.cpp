#include "host-sim/import/clip_region.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/import/curve_measure.hpp"

namespace sim::drawing {
namespace {

/// Returns the winding number of a loop of chords around a point, positive if the loop turns left.
int winding_of(const std::vector<Place>& loop, const Place& place) {
  int winding = 0;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const Place& a = loop[i - 1];
    const Place& b = loop[i];
    if ((a.y() <= place.y()) == (b.y() <= place.y())) continue;
    const double side = cross(b - a, place - a);
    if (b.y() > place.y() && side > 0.0) ++winding;
    if (b.y() <= place.y() && side < 0.0) --winding;
  }
  return winding;
}

bool has_place(int winding, FillRule rule) {
  return rule == FillRule::kNonZero ? winding != 0 : winding % 2 != 0;
}

bool is_within(const ClipRegion& clip, const Place& place) {
  return std::ranges::any_of(clip.areas, [&](const ClipRegion::Area& area) {
    int winding = 0;
    for (const auto& loop : area.loops) winding += winding_of(loop, place);
    return has_place(winding, area.rule);
  });
}

double distance_to(const Place& place, const Place& a, const Place& b) {
  const Place way = b - a;
  const double square = way.squaredNorm();
  const double share = square > 0.0 ? std::clamp(dot(place - a, way) / square, 0.0, 1.0) : 0.0;
  return distance(place, a + share * way);
}

template <typename Visit>
void each_edge(const ClipRegion& clip, const Visit& visit) {
  for (const ClipRegion::Area& area : clip.areas) {
    for (const auto& loop : area.loops) {
      for (std::size_t i = 1; i < loop.size(); ++i) visit(loop[i - 1], loop[i]);
    }
  }
}

bool is_on_edge(const ClipRegion& clip, const Place& place) {
  bool on_edge = false;
  each_edge(clip, [&](const Place& a, const Place& b) {
    on_edge = on_edge || distance_to(place, a, b) <= kClipEdgeMm;
  });
  return on_edge;
}

/// Appends the positions at which a chord crosses edges of a clip. Each position is the distance
/// from `from`, as a share of the chord's length.
void meet(const ClipRegion& clip, const Place& from, const Place& to, std::vector<double>& shares) {
  const Place way = to - from;
  each_edge(clip, [&](const Place& a, const Place& b) {
    const Place edge = b - a;
    const double turn = cross(way, edge);
    if (turn == 0.0) return;
    const double share = cross(a - from, edge) / turn;
    const double along = cross(a - from, way) / turn;
    if (share > 0.0 && share < 1.0 && along >= 0.0 && along <= 1.0) shares.push_back(share);
  });
}

/// Returns whether the shapes can be divided into chords: all of them are finite and their ends are
/// within kFarthestMm.
bool are_near(const std::vector<Shape>& shapes) {
  return std::ranges::all_of(shapes, [](const Shape& shape) {
    return finite(shape) && start_of(shape).cwiseAbs().maxCoeff() <= kFarthestMm &&
           end_of(shape).cwiseAbs().maxCoeff() <= kFarthestMm;
  });
}

}  // namespace

void ClipRegion::add(const std::vector<std::vector<Shape>>& subpaths, FillRule rule) {
  Area area{.loops{}, .rule = rule, .box{}};
  for (const std::vector<Shape>& shapes : subpaths) {
    if (!std::ranges::all_of(shapes, [](const Shape& shape) { return finite(shape); })) continue;
    std::vector<Place> loop = outline_of(shapes, kClipChordMm);
    if (loop.size() < 2) continue;
    loop.push_back(loop.front());
    for (const Place& place : loop) area.box.include(place);
    area.loops.push_back(std::move(loop));
  }
  areas.push_back(std::move(area));
}

std::size_t ClipRegion::size() const {
  std::size_t count = 0;
  for (const Area& area : areas) {
    for (const auto& loop : area.loops) count += loop.size();
  }
  return count;
}

ClipSide side_of(const std::vector<Place>& chords, const ClipRegion& clip) {
  bool inside = false;
  bool outside = false;
  std::vector<double> shares;
  for (std::size_t i = 1; i < chords.size() && !(inside && outside); ++i) {
    shares.assign({0.0, 1.0});
    meet(clip, chords[i - 1], chords[i], shares);
    std::ranges::sort(shares);
    for (std::size_t k = 1; k < shares.size(); ++k) {
      const double middle = 0.5 * (shares[k - 1] + shares[k]);
      const Place place = chords[i - 1] + middle * (chords[i] - chords[i - 1]);
      if (is_on_edge(clip, place)) continue;
      (is_within(clip, place) ? inside : outside) = true;
    }
  }
  if (inside && outside) return ClipSide::kAcross;
  return outside ? ClipSide::kOutside : ClipSide::kInside;
}

bool covers_edge(const std::vector<Place>& chords, FillRule rule, const ClipRegion& clip) {
  if (chords.empty()) return false;
  std::vector<Place> closed = chords;
  closed.push_back(closed.front());
  bool covered = false;
  each_edge(clip, [&](const Place& a, const Place& b) {
    const Place middle = 0.5 * (a + b);
    if (!covered && has_place(winding_of(closed, middle), rule)) covered = true;
  });
  return covered;
}

SightOfShapes ClipComparison::compare(const std::vector<Shape>& shapes,
                                      const ClipRegions& clips,
                                      std::optional<FillRule> fill) {
  // Shapes beyond kFarthestMm are not compared: Sketch::add() refuses them and reports the reason.
  if (clips.empty() || shapes.empty() || !are_near(shapes)) return {};
  const std::vector<Place> chords = outline_of(shapes, kClipChordMm);
  for (const auto& clip : clips) {
    const std::size_t cost = chords.size() * (1 + clip->size());
    if (cost > steps_) return {Sight::kTooMuch, clip.get()};
    steps_ -= cost;
    const ClipSide side = side_of(chords, *clip);
    if (side == ClipSide::kInside) continue;
    const bool shows_edge = fill && covers_edge(chords, *fill, *clip);
    const bool is_unseen = side == ClipSide::kOutside && !shows_edge;
    return {is_unseen ? Sight::kNothing : Sight::kPart, clip.get()};
  }
  return {};
}

}  // namespace sim::drawing
