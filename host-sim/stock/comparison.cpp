#include "host-sim/stock/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim::stock {
namespace {

/// Computes the lowest height that the tool can cut over each cell of a pocket while its tip is on
/// the floor.
///
/// The tool's axis must stay at least the tool's radius away from all walls. The profile never
/// falls outwards. So the lowest height over a point is the profile's height at the distance from
/// the point to the nearest permitted axis position.
class ToolRoom {
 public:
  ToolRoom(const PlanRegion& region, const Cutter& cutter, double depth_mm)
      : profile_{profile_of(cutter)},
        half_mm_{0.5 * std::hypot(region.grid().cell_x_mm, region.grid().cell_y_mm)} {
    profile_.radius_mm = radius_below(profile_, depth_mm);
    const std::vector<RegionPart>& parts = region.parts();
    std::vector<bool> walls(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) walls[i] = parts[i] != RegionPart::kInside;
    // Each point of a wall is at most half a diagonal away from the centre of its cell.
    const std::vector<double> to_wall = distances_to(walls, region.grid());
    std::vector<bool> sure(parts.size());
    std::vector<bool> possible(parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      sure[i] = to_wall[i] >= profile_.radius_mm + half_mm_;
      possible[i] = to_wall[i] >= profile_.radius_mm - 2.0 * half_mm_;
    }
    to_sure_ = distances_to(sure, region.grid());
    to_possible_ = distances_to(possible, region.grid());
  }

  /// Returns the height above the floor to which the tool can surely cut the complete cell;
  /// infinite if a part of the cell may be out of reach.
  [[nodiscard]] double max_left(std::size_t cell) const {
    const double distance = to_sure_[cell] + half_mm_;
    return distance <= profile_.radius_mm ? height_at(profile_, distance) : kOutOfReach;
  }
  /// Returns a lower bound, above the floor, of the height to which the tool can cut any point of
  /// the cell; infinite if the cell is out of reach.
  [[nodiscard]] double min_left(std::size_t cell) const {
    const double distance = std::max(0.0, to_possible_[cell] - 2.0 * half_mm_);
    return distance <= profile_.radius_mm ? height_at(profile_, distance) : kOutOfReach;
  }

 private:
  static constexpr double kOutOfReach = std::numeric_limits<double>::infinity();

  Profile profile_;  ///< Profile of the part of the tool that is in the stock.
  double half_mm_;   ///< Half a cell's diagonal.
  std::vector<double> to_sure_;
  std::vector<double> to_possible_;
};

/// Sums the differences between a stock and a pocket over all cells.
class Comparer {
 public:
  Comparer(const Stock& stock, const Cutter& cutter, const PocketTarget& target)
      : stock_{stock},
        region_{target.rings, stock},
        room_{region_, cutter, target.depth_mm},
        floor_mm_{-target.depth_mm} {}

  [[nodiscard]] PocketFigures figures() {
    for (int row = 0; row < stock_.rows(); ++row) {
      for (int tile = 0; tile < stock_.tile_columns(); ++tile) take_tile_row(tile, row);
    }
    return figures_;
  }

 private:
  void take_tile_row(int tile, int row) {
    const int first = tile * Stock::kTileCells;
    const int end = std::min(first + Stock::kTileCells, stock_.columns());
    const Cell* const cells = stock_.touched_row_of_tile(tile, row);
    for (int column = first; column < end; ++column) {
      const Cell cell = cells == nullptr ? Cell{} : cells[column - first];
      const RegionPart part = region_.part_of(column, row);
      if (cells == nullptr && part == RegionPart::kOutside) continue;
      take(cell, part, column, row);
    }
  }

  /// Adds the differences of a cell. Heights are relative to the stock's top, so they are negative
  /// below it.
  void take(const Cell& cell, RegionPart part, int column, int row) {
    const double lower = cell.lower_nm / kNmPerMm;
    const double upper = cell.upper_nm / kNmPerMm;
    const HeightPeak place{.x_mm = stock_.box().x_min + (column + 0.5) * stock_.cell_x_mm(),
                           .y_mm = stock_.box().y_min + (row + 0.5) * stock_.cell_y_mm()};
    const double min_due = part == RegionPart::kOutside ? 0.0 : floor_mm_;
    const double max_due = part == RegionPart::kInside ? floor_mm_ : 0.0;
    add(figures_.gouge, figures_.deepest_gouge, min_due - upper, max_due - lower, place);
    if (part == RegionPart::kOutside) return;
    const bool is_inside = part == RegionPart::kInside;
    const std::size_t index = region_.index_of(column, row);
    const double least = is_inside ? lower - (floor_mm_ + room_.max_left(index)) : 0.0;
    const double most = upper - (floor_mm_ + room_.min_left(index));
    add(figures_.rest, figures_.tallest_rest, least, most, place);
    if (is_inside && cell.upper_nm < 0) figures_.tallest_scallop.take(peak_of(least, most, place));
  }

  [[nodiscard]] static HeightPeak peak_of(double least, double most, HeightPeak place) {
    place.min_mm = std::max(0.0, least);
    place.max_mm = std::max(0.0, most);
    return place;
  }

  void add(VolumeBounds& volume,
           HeightPeak& peak,
           double least,
           double most,
           const HeightPeak& place) const {
    const HeightPeak here = peak_of(least, most, place);
    const double area = stock_.cell_x_mm() * stock_.cell_y_mm();
    volume.min_mm3 += here.min_mm * area;
    volume.max_mm3 += here.max_mm * area;
    peak.take(here);
  }

  const Stock& stock_;
  PlanRegion region_;
  ToolRoom room_;
  double floor_mm_;  ///< Height of the floor relative to the stock's top, < 0.
  PocketFigures figures_;
};

struct Extent {
  std::array<double, 2> low{kFarthestStockMm, kFarthestStockMm};
  std::array<double, 2> high{-kFarthestStockMm, -kFarthestStockMm};
};

/// Extends `extent` to include a ring. Returns the reason for a refusal if a point is too far from
/// the origin, else an empty text.
std::string include(const Ring& ring, Extent& extent) {
  for (const auto& point : ring) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      if (!(std::abs(point[axis]) <= kFarthestStockMm)) {
        return fmt::format(
            "the pocket reaches to {} mm; at most {} mm from the origin are possible",
            point[axis],
            kFarthestStockMm);
      }
      extent.low[axis] = std::min(extent.low[axis], point[axis]);
      extent.high[axis] = std::max(extent.high[axis], point[axis]);
    }
  }
  return {};
}

}  // namespace

std::string fault_of(const PocketTarget& target, double cell_mm) {
  if (!(target.depth_mm > 0.0 && target.depth_mm <= kDeepestStockMm)) {
    return fmt::format("the pocket is {} mm deep; the depth must be above 0 and at most {} mm",
                       target.depth_mm,
                       kDeepestStockMm);
  }
  Extent extent;
  for (const Ring& ring : target.rings) {
    if (std::string fault = include(ring, extent); !fault.empty()) return fault;
  }
  const auto& [low, high] = extent;
  if (low[0] > high[0]) return "there is no closed contour";
  const double cells =
      (high[0] - low[0] + 4.0 * cell_mm) * (high[1] - low[1] + 4.0 * cell_mm) / (cell_mm * cell_mm);
  if (cells <= kMaxTargetCells) return {};
  return fmt::format(
      "the pocket has {:.3g} cells of {} mm; at most {:.3g} are possible, so choose larger cells",
      cells,
      cell_mm,
      kMaxTargetCells);
}

void HeightPeak::take(const HeightPeak& other) {
  if (other.min_mm < min_mm) return;
  if (other.min_mm == min_mm && other.max_mm <= max_mm) return;
  *this = other;
}

PocketFigures compared(const Stock& stock, const Cutter& cutter, const PocketTarget& target) {
  return Comparer{stock, cutter, target}.figures();
}

}  // namespace sim::stock
