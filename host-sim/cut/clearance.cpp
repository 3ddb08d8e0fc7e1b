#include "host-sim/cut/clearance.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/cut/stroke_distance.hpp"
#include "host-sim/import/near_order.hpp"

namespace sim::cut {
namespace {

/// Returns the square of the distance between a point and a box, mm².
double squared_distance(const cnc::contour::FlatBox<double>& box, const Place& place) {
  const double x = std::max({box.x0 - place.x(), place.x() - box.x1, 0.0});
  const double y = std::max({box.y0 - place.y(), place.y() - box.y1, 0.0});
  return x * x + y * y;
}

}  // namespace

/// Returns a box around a stroke. The box is larger than necessary, because the height of the arc
/// is added on all sides.
Clearance::Box Clearance::box_of(const Stroke& stroke) {
  const Place chord = stroke.to - stroke.from;
  const double size = std::abs(stroke.bulge);
  const double aside =
      size == 0.0 ? 0.0 : 0.5 * std::max(size, size * size) * std::hypot(chord.x(), chord.y());
  const Place least = stroke.from.cwiseMin(stroke.to);
  const Place most = stroke.from.cwiseMax(stroke.to);
  return {least.x() - aside, least.y() - aside, most.x() + aside, most.y() + aside};
}

void Clearance::add(const Stroke& stroke, std::size_t owner) {
  entries_.push_back({stroke, owner});
}

void Clearance::prepare() {
  sort_by_place();
  boxes_.resize(cnc::contour::BoxTree<double>::size_for(entries_.size()));
  tree_ = cnc::contour::BoxTree<double>{{boxes_.data(), boxes_.size()}};
  for (std::uint32_t i = 0; i < entries_.size(); ++i) tree_.leaf(i) = box_of(entries_[i].stroke);
  tree_.build(static_cast<std::uint32_t>(entries_.size()));
}

void Clearance::sort_by_place() {
  if (entries_.empty()) return;
  Box all = box_of(entries_.front().stroke);
  for (const Entry& entry : entries_) all.include(box_of(entry.stroke));
  constexpr double kCells = 1 << 20;
  const double size = std::max({all.x1 - all.x0, all.y1 - all.y0, 1.0e-9});
  const auto cell = [size](double along) {
    return static_cast<std::uint32_t>(kCells * along / size);
  };
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
  keys.reserve(entries_.size());
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    const Box box = box_of(entries_[i].stroke);
    keys.emplace_back(drawing::near_order(cell(0.5 * (box.x0 + box.x1) - all.x0),
                                          cell(0.5 * (box.y0 + box.y1) - all.y0)),
                      i);
  }
  std::ranges::sort(keys);
  std::vector<Entry> sorted;
  sorted.reserve(entries_.size());
  for (const auto& [key, index] : keys) sorted.push_back(entries_[index]);
  entries_ = std::move(sorted);
}

Clearance::Nearest Clearance::nearest(const Place& place) const {
  if (entries_.empty()) return {.distance_mm = reach_mm_};
  const auto squared = [&place](const Box& box) { return squared_distance(box, place); };
  return nearest_from(tree_.descend(squared), place);
}

Clearance::Nearest Clearance::nearest(const Place& place, const Nearest& last) const {
  return last.stroke == nullptr ? nearest(place) : nearest_from(last.entry, place);
}

/// Searches for the nearest stroke. Measures stroke `first` before all others, so that the search
/// can leave out strokes that are farther away than this one.
Clearance::Nearest Clearance::nearest_from(std::uint32_t first, const Place& place) const {
  Nearest found{.distance_mm = reach_mm_};
  const auto look = [&](std::uint32_t index) {
    const double distance = distance_to(entries_[index].stroke, place);
    ++found.looks;
    const bool same = distance == found.distance_mm && entries_[index].owner < found.owner;
    if (distance < found.distance_mm || same) {
      found.distance_mm = distance;
      found.owner = entries_[index].owner;
      found.stroke = &entries_[index].stroke;
      found.entry = index;
    }
    return true;
  };
  static_cast<void>(look(first));
  const auto is_near = [&](const Box& box) {
    return squared_distance(box, place) <= found.distance_mm * found.distance_mm;
  };
  tree_.search_where(is_near, 0, look);
  return found;
}

std::vector<std::size_t> Clearance::owners_near(const Stroke& stroke, double mm) const {
  std::vector<std::size_t> owners;
  if (entries_.empty()) return owners;
  const Box box = box_of(stroke);
  tree_.search({box.x0 - mm, box.y0 - mm, box.x1 + mm, box.y1 + mm}, 0, [&](std::uint32_t index) {
    owners.push_back(entries_[index].owner);
    return true;
  });
  return owners;
}

bool Clearance::is_clear(const Stroke& stroke, double min_mm) const {
  if (entries_.empty()) return true;
  Box box = box_of(stroke);
  box = {box.x0 - min_mm, box.y0 - min_mm, box.x1 + min_mm, box.y1 + min_mm};
  bool is_clear = true;
  tree_.search(box, 0, [&](std::uint32_t index) {
    is_clear = distance_between(entries_[index].stroke, stroke) >= min_mm;
    return is_clear;
  });
  return is_clear;
}

}  // namespace sim::cut
