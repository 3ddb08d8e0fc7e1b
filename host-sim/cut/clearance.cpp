#include "host-sim/cut/clearance.hpp"

#include <algorithm>
#include <cmath>

namespace sim::cut {
namespace {

constexpr double kMostCellsAside = 512.0;
constexpr double kLookEvery = 0.02;  ///< mm.

}  // namespace

/// With the height of the arc all round, which is more than it needs.
Clearance::Box Clearance::box_of(const Stroke& stroke) {
  const Place chord = stroke.to - stroke.from;
  const double size = std::abs(stroke.bulge);
  const double aside = 0.5 * std::max(size, size * size) * std::hypot(chord.x(), chord.y());
  const Place margin{aside, aside};
  return {stroke.from.cwiseMin(stroke.to) - margin, stroke.from.cwiseMax(stroke.to) + margin};
}

void Clearance::add(const Stroke& stroke, std::size_t owner) {
  entries_.push_back({stroke, owner});
}

void Clearance::prepare() {
  cells_.clear();
  if (entries_.empty()) return;
  Box all = box_of(entries_.front().stroke);
  for (const Entry& entry : entries_) {
    const Box box = box_of(entry.stroke);
    all.least = all.least.cwiseMin(box.least);
    all.most = all.most.cwiseMax(box.most);
  }
  const Place reach{reach_mm_, reach_mm_};
  origin_ = all.least - reach;
  const Place size = all.most + reach - origin_;
  cell_mm_ = std::max(reach_mm_, std::max(size.x(), size.y()) / kMostCellsAside);
  columns_ = static_cast<std::size_t>(size.x() / cell_mm_) + 1;
  rows_ = static_cast<std::size_t>(size.y() / cell_mm_) + 1;
  cells_.resize(columns_ * rows_);
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const Box box = box_of(entries_[i].stroke);
    const std::size_t last_row = row(box.most.y() + reach_mm_);
    const std::size_t last_column = column(box.most.x() + reach_mm_);
    for (std::size_t r = row(box.least.y() - reach_mm_); r <= last_row; ++r) {
      for (std::size_t c = column(box.least.x() - reach_mm_); c <= last_column; ++c) {
        cells_[r * columns_ + c].push_back(static_cast<std::uint32_t>(i));
      }
    }
  }
}

std::size_t Clearance::column(double x) const {
  const double cell = std::max(0.0, (x - origin_.x()) / cell_mm_);
  return std::min(static_cast<std::size_t>(cell), columns_ - 1);
}

std::size_t Clearance::row(double y) const {
  const double cell = std::max(0.0, (y - origin_.y()) / cell_mm_);
  return std::min(static_cast<std::size_t>(cell), rows_ - 1);
}

Clearance::Nearest Clearance::nearest(const Place& place) const {
  Nearest found{reach_mm_, 0};
  if (cells_.empty()) return found;
  for (const std::uint32_t index : cells_[row(place.y()) * columns_ + column(place.x())]) {
    const double distance = distance_to(entries_[index].stroke, place);
    if (distance < found.distance_mm) found = {distance, entries_[index].owner};
  }
  return found;
}

bool Clearance::is_clear(const Stroke& stroke, double least_mm) const {
  const auto looks = static_cast<int>(std::ceil(length_of(stroke) / kLookEvery));
  for (int i = 0; i <= looks; ++i) {
    const double share = looks == 0 ? 0.0 : static_cast<double>(i) / looks;
    if (nearest(place_at(stroke, share)).distance_mm < least_mm) return false;
  }
  return true;
}

}  // namespace sim::cut
