#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/refine_beginnings.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Length and time of all rapids of a job, from its start to its end.
struct RapidSum {
  double length_mm = 0.0;
  double time_s = 0.0;
  double own_s = 0.0;  ///< Time of the cuts beyond that with their cheapest beginnings.
};

/// @param order of all the cuts
[[nodiscard]] RapidSum rapids_of(const std::vector<OrderedCut>& order,
                                 const std::vector<UnbegunCut>& cuts,
                                 const OrderWish& wish);

/// An order of all cuts that keeps what must come before what.
struct ChosenOrder {
  std::vector<OrderedCut> cuts;
  RapidSum listed{};  ///< The rapids of the first order, in which all beginnings are listed ones.
  bool is_proven = false;  ///< No order with the listed beginnings is cheaper.
};

/// Chooses order and beginnings by the wished method: then, but for orders that are there for
/// comparison (nearest, anneal), the best beginnings along the order, and the best points between
/// them.
/// @param cuts their `after` has no cycle
/// @param edges all drawn edges, of which leads keep clear
/// Throws std::invalid_argument where the cuts are too many for the proof that is wished.
[[nodiscard]] ChosenOrder choose_order(const std::vector<UnbegunCut>& cuts,
                                       const OrderWish& wish,
                                       const Clearance& edges);

/// Orders all cuts, each with its first beginning, by a method that takes no search: as the drawing
/// lists them (kFile) or always the nearest next (kNearest). For comparison.
[[nodiscard]] std::vector<OrderedCut> usual_order(const std::vector<UnbegunCut>& cuts,
                                                  const OrderWish& wish,
                                                  order::OrderMethod method);

}  // namespace sim::cut
