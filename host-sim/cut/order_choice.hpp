#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/refine_beginnings.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Sums over all rapids of a job, from its start to its end.
struct RapidSum {
  double length_mm = 0.0;
  double time_s = 0.0;
  double own_s = 0.0;  ///< Time of the cuts, minus their time with the cheapest beginnings.
};

/// Returns length and time of all rapids, as if all of them were straight.
/// @param order all cuts in order
[[nodiscard]] RapidSum rapids_of(const std::vector<OrderedCut>& order,
                                 const std::vector<UnbegunCut>& cuts,
                                 const OrderWish& wish);

/// An order of all cuts that keeps every precedence between cuts.
struct ChosenOrder {
  std::vector<OrderedCut> cuts;
  /// Rapids of the order before refinement, when all beginnings are from the lists.
  RapidSum listed{};
  /// Whether it is proven that no order with listed beginnings is cheaper.
  bool is_proven = false;
};

/// Chooses the order by the required method. Then it chooses the best listed beginnings along this
/// order, and the best points between the listed beginnings. The methods for comparison (nearest,
/// anneal) do not have these two steps. Throws std::invalid_argument if there are too many cuts for
/// the required proof.
/// @param cuts cuts whose `after` has no cycle
/// @param edges all drawn edges, from which leads keep clear
[[nodiscard]] ChosenOrder choose_order(const std::vector<UnbegunCut>& cuts,
                                       const OrderWish& wish,
                                       const Clearance& edges);

/// Orders all cuts for comparison, each with its first beginning, by a method without a search: in
/// the order of the drawing (kFile), or always the nearest cut next (kNearest).
[[nodiscard]] std::vector<OrderedCut> usual_order(const std::vector<UnbegunCut>& cuts,
                                                  const OrderWish& wish,
                                                  order::OrderMethod method);

}  // namespace sim::cut
