#pragma once

#include <optional>

#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/fitting_approach.hpp"
#include "host-sim/pocket/stock_box.hpp"

namespace sim::pocket {

/// A path to a loop from a point at which the tool is next to the stock.
struct EntryBeside {
  cnc::WideVec2 from{0.0, 0.0};
  Approach approach;  ///< Exists unless `from` is on the loop.
  /// Distance from the loop's start to the point of arrival, in the direction of driving.
  double way_mm = 0.0;
  double length_mm = 0.0;  ///< Length of the line.
};

/// Searches for paths into the surroundings of a stock.
class EntryBesideSearch {
 public:
  /// @param area contains the tool's margin around the stock; must outlive the search
  EntryBesideSearch(const OwnedArea& area, const StockBox& stock, double tool_radius_mm);

  /// Returns the shortest of several paths to a loop. A path begins at a point of the loop itself
  /// that is next to the stock, or it is a line through the stock and an arc. Returns none where no
  /// path fits.
  [[nodiscard]] std::optional<EntryBeside> find(const DrivenLoop& loop) const;

 private:
  const OwnedArea& area_;
  StockBox stock_;
  double radius_mm_;
  std::vector<cnc::WideVec2> places_;  ///< Points next to the stock where the tool may descend.
};

}  // namespace sim::pocket
