#pragma once

#include <optional>

#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/fitting_approach.hpp"
#include "host-sim/pocket/stock_box.hpp"

namespace sim::pocket {

/// A path that leads to a loop from a point where the tool is next to the stock.
struct EntryBeside {
  cnc::WideVec2 from{0.0, 0.0};
  /// Line and arc from `from` to the loop; exists unless `from` is on the loop.
  Approach approach;
  /// Distance from the loop's start to the point where the path reaches the loop, mm, in the
  /// direction of driving.
  double way_mm = 0.0;
  double length_mm = 0.0;  ///< Length of the line, mm.
};

/// Searches for paths from the surroundings of a stock to a loop.
class EntryBesideSearch {
 public:
  /// @param area area that includes the margin for the tool around the stock; must outlive the
  /// search
  EntryBesideSearch(const OwnedArea& area, const StockBox& stock, double tool_radius_mm);

  /// Returns the shortest of several candidate paths to a loop. A candidate either begins at a
  /// point of the loop that is next to the stock, or consists of a line through the stock and an
  /// arc. Returns none where no candidate fits.
  [[nodiscard]] std::optional<EntryBeside> find(const DrivenLoop& loop) const;

 private:
  const OwnedArea& area_;
  StockBox stock_;
  double radius_mm_;
  std::vector<cnc::WideVec2> places_;  ///< Points next to the stock where the tool may descend.
};

}  // namespace sim::pocket
