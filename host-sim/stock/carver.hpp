#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/stock/swept_surface.hpp"

namespace sim::stock {

/// A straight piece of the tool's path.
///
/// The tool may be off it: at each of its poses the tip passes within a cylinder of radius
/// `side_slack_mm` and half height `up_slack_mm`, and it is nowhere else.
struct Stretch {
  Pose from;
  Pose to;
  double side_slack_mm = 0.0;
  double up_slack_mm = 0.0;
};

/// Removes the volume that a tool sweeps from a stock.
///
/// The upper bound of a cell falls only to where the whole cell is surely swept, at its four
/// corners, between which the swept surface is convex. The lower bound falls as soon as any point
/// of the cell can have been touched. The swept surface is that of a whole stretch at once, so its
/// cost grows with the area of the plan that it takes and not with a number of poses; parts of the
/// tool above the stock's top take none.
///
/// A stretch that begins where the last one ended lowers nothing behind its start, or, if it falls,
/// somewhat farther behind: the last one took that. Slack makes upper bounds greater and lower
/// bounds less, so each of them is left as it is only if the last slack made it no looser.
class Carver {
 public:
  /// Both must outlive this. @pre fault_of(cutter) is empty
  Carver(Stock& stock, const Cutter& cutter);

  /// Sweeps one stretch.
  /// Throws as Stock::row_of_tile() does.
  /// @param skin_mm material that is no thicker is not counted in the result
  /// @return a lower bound of the volume that it has removed, mm³
  double sweep(const Stretch& stretch, double skin_mm = 0.0);

 private:
  /// First and last of some cells or corners in a row; none where last < first.
  struct Range {
    int first = 0;
    int last = -1;
  };
  /// Cells of a row whose bounds the current stretch may lower.
  struct Row {
    Range upper;
    Range lower;
  };
  /// Upper bounds at corners of cells, along a line between two rows.
  struct Corners {
    std::vector<std::int32_t> nm;
    Range filled;
  };

  [[nodiscard]] Range touched_cells(const SweptSurface& surface, int row, bool ahead_only) const;
  void list_rows(const SweptSurface& surface, bool upper_ahead_only, bool lower_ahead_only);
  [[nodiscard]] Range upper_range_of(int row) const;
  void fill_corners(Corners& corners, const SweptSurface& surface, int line);
  template <typename Function>
  void for_each_cell(int row, Range range, Function function);
  void sink_upper_bounds(int row, Range range);
  void sink_lower_bounds(const SweptSurface& possible, int row, Range range);
  [[nodiscard]] std::int32_t upper_nm(double height_mm) const;
  [[nodiscard]] std::int32_t lower_nm(double height_mm) const;

  Stock& stock_;
  Profile profile_;
  double half_x_mm_;
  double half_y_mm_;
  int first_row_ = 0;
  std::vector<Row> rows_;  ///< From first_row_ on.
  Corners below_;
  Corners above_;
  std::int32_t lowest_nm_ = 0;  ///< Least of all lower bounds of the current stretch.
  std::int32_t skin_nm_ = 0;
  std::int64_t surely_removed_nm_ = 0;
  std::optional<Stretch> last_;
};

}  // namespace sim::stock
