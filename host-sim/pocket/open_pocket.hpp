#pragma once

#include <vector>

#include "host-sim/pocket/stock_box.hpp"
#include "host-sim/pocket/stock_parts.hpp"

namespace sim::pocket {

/// Returns the area in which a tool may mill: the pockets, and the surroundings of the stock up to
/// a margin. A pocket that reaches or crosses the edge of the stock is open there: it forms one
/// area with the surroundings. Throws NoPocketPath if an edge of a pocket runs so close along an
/// edge of the stock that their crossings have no clear points.
/// @param pockets closed contours with the pockets on their left; they must enclose an area
/// @param margin_mm width of the margin, above 0
[[nodiscard]] Contour with_surroundings(const Contour& pockets,
                                        const StockBox& stock,
                                        double margin_mm);

/// Returns whether `area`, a result of with_surroundings(), is the area around the stock.
[[nodiscard]] bool is_around(const cnc::contour::ContourView<double>& area, const StockBox& stock);

/// Returns the margin around the stock that open pockets require: the space for the tool and its
/// arcs, plus half the shorter side of the stock, because a pocket is at most as wide as this side.
/// With this margin, passes lead out of the pocket instead of around its middle.
[[nodiscard]] double margin_around(const StockBox& stock, double tool_radius_mm);

/// Returns whether the tool touches stock anywhere along a loop.
[[nodiscard]] bool meets_stock(const cnc::contour::ContourView<double>& loops,
                               std::size_t loop,
                               const StockBox& stock,
                               double tool_radius_mm);

/// The loops of a pass on which the tool touches stock, in two groups.
struct LoopsInStock {
  /// Loops on which the tool touches stock along all or nearly all of their length.
  Contour whole;
  Contour partly;  ///< Loops on which the tool touches stock along a part of their length.
};

/// Returns the loops of a pass on which the tool touches stock.
[[nodiscard]] LoopsInStock loops_in_stock(const Contour& pass,
                                          const StockBox& stock,
                                          double tool_radius_mm);

/// Returns the parts of passes on which the tool touches stock. Where possible, the parts begin and
/// end next to the stock. Throws the exceptions of parts_in_stock(), and NoOffset.
/// @param area the surroundings of the stock, including the margin for the tool
/// @param passes passes that clear the area with the tool; each follows the pass around it
[[nodiscard]] StockParts open_path(const cnc::contour::ContourView<double>& area,
                                   const StockBox& stock,
                                   const std::vector<Contour>& passes,
                                   const PartOptions& options);

/// Returns the same parts as open_path(), but takes the locus of the tool's centre instead of the
/// area.
[[nodiscard]] StockParts open_path_within(const cnc::contour::ContourView<double>& locus,
                                          const StockBox& stock,
                                          const std::vector<Contour>& passes,
                                          const PartOptions& options);

}  // namespace sim::pocket
