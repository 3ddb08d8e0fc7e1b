#pragma once

#include <optional>

#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/fitting_approach.hpp"
#include "host-sim/pocket/stock_box.hpp"

namespace sim::pocket {

/// A way to a loop from a place at which the tool is beside the stock.
struct EntryBeside {
  cnc::WideVec2 from{0.0, 0.0};
  Approach approach;       ///< Exists unless the place is on the loop.
  double way_mm = 0.0;     ///< From the loop's start to the place, as the loop is driven.
  double length_mm = 0.0;  ///< Length of the line.
};

/// Looks for ways into what is around a stock.
class EntryBesideSearch {
 public:
  /// @param area with the tool's margin around the stock; outlives the search
  EntryBesideSearch(const OwnedArea& area, const StockBox& stock, double tool_radius_mm);

  /// Returns the shortest of some ways to a loop: from a place of its own beside the stock, or by a
  /// line through the stock and an arc. None where none of them fits.
  [[nodiscard]] std::optional<EntryBeside> find(const DrivenLoop& loop) const;

 private:
  const OwnedArea& area_;
  StockBox stock_;
  double radius_mm_;
  std::vector<cnc::WideVec2> places_;  ///< Beside the stock, where the tool comes down.
};

}  // namespace sim::pocket
