#pragma once

#include <vector>

#include "host-sim/pocket/stock_box.hpp"
#include "host-sim/pocket/stock_parts.hpp"

namespace sim::pocket {

/// Returns where a tool may mill: in the pockets, and all around the stock up to a margin. Pockets
/// that reach the edge of the stock, or go beyond it, are open there: one area with what is around.
/// Throws NoPocketPath where an edge of a pocket runs along that of the stock so closely that they
/// do not cross in clear places.
/// @param pockets closed contours with the pockets on their left, which enclose something
/// @param margin_mm above 0
[[nodiscard]] Contour with_surroundings(const Contour& pockets,
                                        const StockBox& stock,
                                        double margin_mm);

/// Whether an area, of with_surroundings(), is the one around the stock.
[[nodiscard]] bool is_around(const cnc::contour::ContourView<double>& area, const StockBox& stock);

/// Returns the margin around the stock that open pockets need: room for the tool and its arcs, and
/// as much again as a pocket may be wide, so that passes lead out of it in place of around its
/// middle.
[[nodiscard]] double margin_around(const StockBox& stock, double tool_radius_mm);

/// Returns whether the tool meets stock anywhere on a loop.
[[nodiscard]] bool meets_stock(const cnc::contour::ContourView<double>& loops,
                               std::size_t loop,
                               const StockBox& stock,
                               double tool_radius_mm);

/// Loops by how much of them is where the tool meets stock.
struct LoopsInStock {
  Contour whole;   ///< All of it, or nearly.
  Contour partly;  ///< Some of it.
};

/// Returns the loops of a pass on which the tool meets stock.
[[nodiscard]] LoopsInStock loops_in_stock(const Contour& pass,
                                          const StockBox& stock,
                                          double tool_radius_mm);

/// Returns the parts of passes at which the tool meets stock; they begin and end beside the stock
/// where they can. Throws as parts_in_stock() does, and NoOffset.
/// @param area around the stock, with the tool's margin
/// @param passes that clear the area with the tool, each after the one around it
[[nodiscard]] StockParts open_path(const cnc::contour::ContourView<double>& area,
                                   const StockBox& stock,
                                   const std::vector<Contour>& passes,
                                   const PartOptions& options);

/// Returns the same for an area that is given as the one where the tool's centre may be.
[[nodiscard]] StockParts open_path_within(const cnc::contour::ContourView<double>& locus,
                                          const StockBox& stock,
                                          const std::vector<Contour>& passes,
                                          const PartOptions& options);

}  // namespace sim::pocket
