#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "host-sim/cut/loop_area.hpp"

namespace sim::cut {

/// Index of areas by their position in the plane. A search near a point or a segment measures only
/// few areas. Each area has a number, which the caller of add() chooses.
class FreedAreas {
 public:
  using Box = LoopArea::Box;

  /// Makes an index without areas.
  /// @param cell_mm size of the cells that divide the plane, above 0. Searches are fast if a cell
  /// is about as large as an area
  explicit FreedAreas(double cell_mm) : cell_mm_{cell_mm} {}

  void add(std::uint32_t number, std::shared_ptr<const LoopArea> area);
  void remove(std::uint32_t number);

  [[nodiscard]] bool has(std::uint32_t number) const { return areas_.contains(number); }
  /// Returns the area with this number.
  /// @pre has(number)
  [[nodiscard]] const LoopArea& area(std::uint32_t number) const { return *areas_.at(number); }

  /// Calls `visit(number, area)` once for each area whose box intersects `box`, until a call
  /// returns true. Returns whether a call returned true. The order of the calls is that of the
  /// cells along x and y.
  template <typename Visit>
  bool visit_near(const Box& box, Visit&& visit) const;

  /// Calls `visit(number, area)` once for each area whose box intersects the box around a segment,
  /// extended by `mm`. The order of the calls is approximately the order along the segment. The
  /// calls end when a call returns true. Returns whether a call returned true.
  template <typename Visit>
  bool visit_along(const Place& from, const Place& to, double mm, Visit&& visit) const;

 private:
  using Cell = std::vector<std::uint32_t>;
  /// Greatest number of cells that hold an area. Larger areas are in a list that every search reads
  /// completely.
  static constexpr double kMaxCells = 1024.0;

  [[nodiscard]] std::int64_t cell_of(double mm) const;
  [[nodiscard]] double cells_in(const Box& box) const;
  [[nodiscard]] static std::int64_t key_of(std::int64_t column, std::int64_t row) {
    return column * (std::int64_t{1} << 32) + row;
  }
  template <typename Act>
  void for_cells(const Box& box, Act&& act) const;
  template <typename Visit>
  bool visit_row(const Cell& row, const Box& box, Visit&& visit) const;
  template <typename Visit>
  bool visit_cell(std::int64_t column, std::int64_t row, const Box& box, Visit&& visit) const;
  void begin_search() const { ++search_; }

  double cell_mm_;
  std::unordered_map<std::uint32_t, std::shared_ptr<const LoopArea>> areas_;
  std::unordered_map<std::int64_t, Cell> cells_;
  Cell large_;
  /// For each area, by its number: the number of the last search that found it.
  mutable std::vector<std::uint64_t> met_;
  mutable std::uint64_t search_ = 0;
};

template <typename Act>
void FreedAreas::for_cells(const Box& box, Act&& act) const {
  for (std::int64_t column = cell_of(box.x0); column <= cell_of(box.x1); ++column) {
    for (std::int64_t row = cell_of(box.y0); row <= cell_of(box.y1); ++row) act(column, row);
  }
}

template <typename Visit>
bool FreedAreas::visit_row(const Cell& row, const Box& box, Visit&& visit) const {
  for (const std::uint32_t number : row) {
    if (met_[number] == search_) continue;
    met_[number] = search_;
    const LoopArea& found = *areas_.at(number);
    if (found.box().meets(box) && visit(number, found)) return true;
  }
  return false;
}

template <typename Visit>
bool FreedAreas::visit_cell(std::int64_t column,
                            std::int64_t row,
                            const Box& box,
                            Visit&& visit) const {
  const auto cell = cells_.find(key_of(column, row));
  return cell != cells_.end() && visit_row(cell->second, box, visit);
}

template <typename Visit>
bool FreedAreas::visit_near(const Box& box, Visit&& visit) const {
  begin_search();
  if (visit_row(large_, box, visit)) return true;
  bool done = false;
  for_cells(box, [&](std::int64_t column, std::int64_t row) {
    done = done || visit_cell(column, row, box, visit);
  });
  return done;
}

template <typename Visit>
bool FreedAreas::visit_along(const Place& from, const Place& to, double mm, Visit&& visit) const {
  begin_search();
  const Box all = grown(box_between(from, to), mm);
  if (visit_row(large_, all, visit)) return true;
  // Divides the segment into pieces no longer than a cell, and visits the cells of the box of each
  // piece.
  const double length = std::hypot(to.x() - from.x(), to.y() - from.y());
  const auto pieces = static_cast<std::int64_t>(length / cell_mm_) + 1;
  Place begin = from;
  for (std::int64_t i = 1; i <= pieces; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(pieces);
    const Place end = from + share * (to - from);
    const Box box = grown(box_between(begin, end), mm);
    bool done = false;
    for_cells(box, [&](std::int64_t column, std::int64_t row) {
      done = done || visit_cell(column, row, all, visit);
    });
    if (done) return true;
    begin = end;
  }
  return false;
}

}  // namespace sim::cut
