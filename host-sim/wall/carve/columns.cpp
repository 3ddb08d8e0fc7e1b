#include "host-sim/wall/carve/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace sim::wall {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// Returns the number of equal cells, no longer than `cell_mm`, into which a side is divided.
/// @pre both lengths are above 0
double cells_along(double side_mm, double cell_mm) {
  constexpr double kRounding = 1.0e-9;
  return std::max(1.0, std::ceil(side_mm / cell_mm - kRounding));
}

}  // namespace

std::string Columns::fault_of(const stock::StockBox& box, double cell_mm) {
  const double width = box.x_max - box.x_min;
  const double depth = box.y_max - box.y_min;
  if (!(width > 0.0 && depth > 0.0 && box.top > box.bottom)) {
    return fmt::format(
        "the stock of {:g} by {:g} by {:g} mm has no volume; give it more with --around",
        width,
        depth,
        box.top - box.bottom);
  }
  const double bytes = cells_along(width, cell_mm) * cells_along(depth, cell_mm) * sizeof(Span);
  if (bytes <= static_cast<double>(kMaxColumnBytes)) return {};
  return fmt::format(
      "cells of {:g} mm on {:g} by {:g} mm take {:.0f} MB, and the maximum is {}; give larger "
      "cells",
      cell_mm,
      width,
      depth,
      bytes / (1 << 20),
      kMaxColumnBytes >> 20);
}

Columns::Columns(const stock::StockBox& box, double cell_mm)
    : box_{box},
      columns_{static_cast<int>(cells_along(box.x_max - box.x_min, cell_mm))},
      rows_{static_cast<int>(cells_along(box.y_max - box.y_min, cell_mm))},
      cell_x_mm_{(box.x_max - box.x_min) / columns_},
      cell_y_mm_{(box.y_max - box.y_min) / rows_},
      spans_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
             Span{box.bottom, box.top, kNone}) {}

bool Columns::has(int column, int row, double z) const {
  bool is_left = false;
  each_range(column, row, [&is_left, z](const HeightRange& range) {
    is_left = is_left || (z >= range.low && z <= range.high);
  });
  return is_left;
}

Columns::Index Columns::add(const Span& span) {
  if (!free_.empty()) {
    const Index at = free_.back();
    free_.pop_back();
    spans_[at] = span;
    return at;
  }
  if ((spans_.size() + 1) * sizeof(Span) > kMaxColumnBytes) {
    throw std::length_error(
        fmt::format("the columns of the stock have so many hollows that they take more than {} MB; "
                    "give larger cells",
                    kMaxColumnBytes >> 20));
  }
  spans_.push_back(span);
  return static_cast<Index>(spans_.size() - 1);
}

/// Removes a range inside a span. Keeps the parts of the span above and below the range.
void Columns::split(std::size_t at, const HeightRange& range) {
  const Index below = add({spans_[at].low, range.low, spans_[at].below});
  spans_[at].low = range.high;
  spans_[at].below = below;
}

/// Removes a span from its column. If there is a span below, it is copied into the removed span's
/// entry. Otherwise the span above becomes the last span of the column.
void Columns::erase(std::size_t at, std::size_t above) {
  const Index below = spans_[at].below;
  if (below != kNone) {
    spans_[at] = spans_[below];
    free_.push_back(below);
  } else if (at == above) {
    spans_[at] = {0.0, kNothing, kNone};
  } else {
    spans_[above].below = kNone;
    free_.push_back(static_cast<Index>(at));
  }
}

void Columns::remove(int column, int row, const HeightRange& range) {
  if (!(range.low < range.high)) return;
  std::size_t at = index_of(column, row);
  std::size_t above = at;
  while (true) {
    Span& span = spans_[at];
    if (span.high <= range.low) return;
    if (span.low < range.low) {
      if (span.high > range.high) {
        split(at, range);
      } else {
        span.high = range.low;
      }
      return;
    }
    if (span.low >= range.high || span.high > range.high) {
      span.low = std::max(span.low, range.high);
      if (span.below == kNone) return;
      above = at;
      at = span.below;
      continue;
    }
    const bool is_last = span.below == kNone;
    erase(at, above);
    if (is_last) return;
  }
}

}  // namespace sim::wall
