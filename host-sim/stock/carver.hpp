#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/stock/swept_surface.hpp"

namespace sim::stock {

/// A straight piece of the tool's path, with bounds of the tool's deviation from it.
///
/// The tip stays within an upright cylinder of radius `side_slack_mm` and half height `up_slack_mm`
/// around the poses of the stretch. The tip passes through the cylinder around each pose.
struct Stretch {
  Pose from;
  Pose to;
  double side_slack_mm = 0.0;
  double up_slack_mm = 0.0;
};

/// Removes the volume that a tool sweeps from a stock.
///
/// The upper bound of a cell is lowered only where the complete cell is surely swept. The heights
/// at its four corners prove this, because the swept surface is convex. The lower bound is lowered
/// where the tool may have touched any point of the cell. One swept surface represents the complete
/// stretch. So the computing time is proportional to the stretch's area in plan and does not depend
/// on a number of sampled poses. Parts of the tool above the stock's top take no time.
///
/// If a stretch begins at the end of the previous stretch, cells behind its start are skipped,
/// because the previous stretch covered them. If the path falls, the skipped area begins slightly
/// farther behind the start. More slack gives higher upper bounds and lower lower bounds. So upper
/// bounds are skipped only if the previous slack was at most the present slack. Lower bounds are
/// skipped only if the previous slack was at least the present slack.
class Carver {
 public:
  /// Prepares to carve `stock` with `cutter`. @pre fault_of(cutter) is empty; `stock` outlives this
  /// object
  Carver(Stock& stock, const Cutter& cutter);

  /// Removes the volume that the tool sweeps along one stretch.
  /// Throws the exceptions of Stock::row_of_tile().
  /// @param skin_mm thickness up to which removed material is not counted in the result
  /// @return a lower bound of the removed volume, mm³
  double sweep(const Stretch& stretch, double skin_mm = 0.0);

 private:
  /// Indices of the first and the last cell or corner in a row; empty if last < first.
  struct Range {
    int first = 0;
    int last = -1;
  };
  /// Cells of a row whose upper or lower bounds the current stretch may lower.
  struct Row {
    Range upper;
    Range lower;
  };
  /// Upper bounds at the corners of cells, along the line between two rows.
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
  std::vector<Row> rows_;  ///< Rows that the stretch may change, beginning with row first_row_.
  Corners below_;
  Corners above_;
  /// Lowest value that the current stretch can give to a lower bound.
  std::int32_t lowest_nm_ = 0;
  std::int32_t skin_nm_ = 0;
  std::int64_t surely_removed_nm_ = 0;
  std::optional<Stretch> last_;
};

}  // namespace sim::stock
