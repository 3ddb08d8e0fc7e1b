#include "host-sim/surface/path/slot_finder.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/cut/stroke.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;

/// Lengths relative to the tool's radius: cell, step along the path, and offset of the checked
/// points to both sides.
constexpr double kCell = 0.125;
constexpr double kStep = 0.25;
constexpr double kBeside = 0.75;
/// Number of steps by which the removal of stock lags behind the tool.
constexpr std::size_t kStepsBehind = 4;
/// Maximum number of cells. It limits the memory: a larger area has larger cells.
constexpr double kMaxCells = 4.0e7;

double cell_for(const pocket::StockBox& box, double radius_mm) {
  const double area = (box.x1 - box.x0) * (box.y1 - box.y0);
  return std::max(kCell * radius_mm, std::sqrt(area / kMaxCells));
}

std::size_t cells_along(double length_mm, double cell_mm) {
  return static_cast<std::size_t>(std::ceil(length_mm / cell_mm)) + 1;
}

}  // namespace

SlotFinder::SlotFinder(const pocket::StockBox& box, double radius_mm)
    : box_{box},
      radius_mm_{radius_mm},
      cell_mm_{cell_for(box, radius_mm)},
      columns_{cells_along(box.x1 - box.x0, cell_mm_)},
      rows_{cells_along(box.y1 - box.y0, cell_mm_)},
      is_taken_(columns_ * rows_, false) {}

StretchUse SlotFinder::use_of(const ContourVertex& from, const ContourVertex& to) {
  const cut::Stroke stroke{.from = {from.x, from.y}, .to = {to.x, to.y}, .bulge = from.bulge};
  const double steps = std::ceil(cut::length_of(stroke) / (kStep * radius_mm_));
  bool is_slot = false;
  for (double step = 1.0; step <= steps; step += 1.0) {
    const double share = step / steps;
    const Vector2d place = cut::place_at(stroke, share);
    const Vector2d beside = kBeside * radius_mm_ * cut::right_of(cut::tangent_at(stroke, share));
    is_slot = is_slot || (is_stock(place + beside) && is_stock(place - beside));
    last_.push_back(place);
    if (last_.size() <= kStepsBehind) continue;
    take(last_.front());
    last_.pop_front();
  }
  return is_slot ? StretchUse::kSlot : StretchUse::kRow;
}

void SlotFinder::end_run() {
  for (const Vector2d& place : last_) take(place);
  last_.clear();
}

bool SlotFinder::is_stock(const Vector2d& place) const {
  const double column = std::floor((place.x() - box_.x0) / cell_mm_);
  const double row = std::floor((place.y() - box_.y0) / cell_mm_);
  const bool is_beside = column < 0.0 || row < 0.0 || column >= static_cast<double>(columns_) ||
                         row >= static_cast<double>(rows_);
  if (is_beside) return false;
  return !is_taken_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
}

void SlotFinder::take(const Vector2d& place) {
  const auto index = [this](double way, std::size_t count) {
    const double cell = std::clamp(way / cell_mm_, 0.0, static_cast<double>(count));
    return static_cast<std::size_t>(cell);
  };
  const std::size_t last_row = index(place.y() + radius_mm_ - box_.y0, rows_ - 1);
  const std::size_t last_column = index(place.x() + radius_mm_ - box_.x0, columns_ - 1);
  for (std::size_t row = index(place.y() - radius_mm_ - box_.y0, rows_ - 1); row <= last_row;
       ++row) {
    const double y = box_.y0 + (static_cast<double>(row) + 0.5) * cell_mm_ - place.y();
    for (std::size_t column = index(place.x() - radius_mm_ - box_.x0, columns_ - 1);
         column <= last_column;
         ++column) {
      const double x = box_.x0 + (static_cast<double>(column) + 0.5) * cell_mm_ - place.x();
      if (x * x + y * y <= radius_mm_ * radius_mm_) is_taken_[row * columns_ + column] = true;
    }
  }
}

}  // namespace sim::surface
