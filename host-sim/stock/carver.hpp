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
/// The tool may deviate from the stretch: at each of its poses, the tip passes within a cylinder of
/// radius `side_slack_mm` and half height `up_slack_mm`, and it is nowhere else.
struct Stretch {
  Pose from;
  Pose to;
  double side_slack_mm = 0.0;
  double up_slack_mm = 0.0;
};

/// Removes the volume that a tool sweeps from a stock.
///
/// The upper bound of a cell is lowered only where the whole cell is surely swept. Its four corners
/// show that, as the swept surface is convex between them. The lower bound is lowered as soon as
/// any point of the cell may have been touched. The swept surface is that of a whole stretch at
/// once. So the cost of a stretch grows with the area that it covers in plan, and not with a number
/// of poses. Parts of the tool above the stock's top cost nothing.
///
/// A stretch that begins at the end of the last stretch changes no cell behind its start, or, if it
/// falls, no cell slightly farther behind: the last stretch covered these cells. Slack makes upper
/// bounds greater and lower bounds less. So the upper bounds behind the start are skipped only if
/// the last slack was at most the present slack, and the lower bounds only if it was at least the
/// present slack.
class Carver {
 public:
  /// Stock and profile of the cutter. @pre fault_of(cutter) is empty; `stock` outlives this object
  Carver(Stock& stock, const Cutter& cutter);

  /// Sweeps one stretch.
  /// Throws the exceptions of Stock::row_of_tile().
  /// @param skin_mm material that is at most this thick is not counted in the result
  /// @return a lower bound of the removed volume, mm³
  double sweep(const Stretch& stretch, double skin_mm = 0.0);

 private:
  /// The first and the last of several cells or corners in a row; none where last < first.
  struct Range {
    int first = 0;
    int last = -1;
  };
  /// The cells of a row whose bounds the current stretch may lower.
  struct Row {
    Range upper;
    Range lower;
  };
  /// Upper bounds at corners of cells, along the line between two rows.
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
  std::vector<Row> rows_;  ///< Rows from first_row_ on.
  Corners below_;
  Corners above_;
  std::int32_t lowest_nm_ = 0;  ///< The least lower bound that the current stretch can cause.
  std::int32_t skin_nm_ = 0;
  std::int64_t surely_removed_nm_ = 0;
  std::optional<Stretch> last_;
};

}  // namespace sim::stock
