#pragma once

#include <vector>

#include "host-sim/pocket/stock_box.hpp"
#include "host-sim/pocket/stock_parts.hpp"

namespace sim::pocket {

/// Returns the area in which a tool may mill: the pockets, and the surroundings of the stock up to
/// a margin. A pocket that reaches the edge of the stock, or crosses it, is open there: it forms
/// one area with the surroundings. Throws NoPocketPath where an edge of a pocket runs so close
/// along an edge of the stock that their crossings are not clear points.
/// @param pockets closed contours with the pockets on their left; they must enclose something
/// @param margin_mm above 0
[[nodiscard]] Contour with_surroundings(const Contour& pockets,
                                        const StockBox& stock,
                                        double margin_mm);

/// Returns whether an area from with_surroundings() is the one around the stock.
[[nodiscard]] bool is_around(const cnc::contour::ContourView<double>& area, const StockBox& stock);

/// Returns the margin around the stock that open pockets need: the space for the tool and its arcs,
/// and in addition the greatest width of a pocket. So passes lead out of the pocket instead of
/// around its middle.
[[nodiscard]] double margin_around(const StockBox& stock, double tool_radius_mm);

/// Returns whether the tool touches stock anywhere on a loop.
[[nodiscard]] bool meets_stock(const cnc::contour::ContourView<double>& loops,
                               std::size_t loop,
                               const StockBox& stock,
                               double tool_radius_mm);

/// Loops of a pass, by the share of their length on which the tool touches stock.
struct LoopsInStock {
  Contour whole;   ///< Loops with stock along all of their length, or nearly all.
  Contour partly;  ///< Loops with stock along a part of their length.
};

/// Returns the loops of a pass on which the tool touches stock.
[[nodiscard]] LoopsInStock loops_in_stock(const Contour& pass,
                                          const StockBox& stock,
                                          double tool_radius_mm);

/// Returns the parts of passes at which the tool touches stock. Where possible, they begin and end
/// next to the stock. Throws the exceptions of parts_in_stock(), and NoOffset.
/// @param area the surroundings of the stock, with the tool's margin
/// @param passes passes that clear the area with the tool, each after the pass around it
[[nodiscard]] StockParts open_path(const cnc::contour::ContourView<double>& area,
                                   const StockBox& stock,
                                   const std::vector<Contour>& passes,
                                   const PartOptions& options);

/// Returns the same parts as open_path(), for an area that is given as the locus of the tool's
/// centre.
[[nodiscard]] StockParts open_path_within(const cnc::contour::ContourView<double>& locus,
                                          const StockBox& stock,
                                          const std::vector<Contour>& passes,
                                          const PartOptions& options);

}  // namespace sim::pocket
