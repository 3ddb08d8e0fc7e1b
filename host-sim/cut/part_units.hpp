#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Cuts that follow each other without others between them, and which of these units must come
/// before which.
struct PartUnits {
  std::vector<std::vector<std::size_t>> cuts{};   ///< By unit, in the order of their numbers.
  std::vector<std::vector<std::size_t>> after{};  ///< By unit: those that must come before it.
};

/// Makes a unit of the cuts of each part. Parts of which each has cuts that must come after cuts of
/// the other, as shared lines may ask for, are one unit, together with the parts after them.
/// @param members numbers of the cuts; what they must come after and is not among them is done
/// @pre their `after` has no cycle
[[nodiscard]] PartUnits units_of(const std::vector<UnbegunCut>& cuts,
                                 const std::vector<std::size_t>& members);

/// Brings together the cuts of each unit in an order that keeps what must come before what: units
/// in the order of their first cuts as far as that may be.
/// @param order all cuts of `units`, each once
void bring_together(std::vector<OrderedCut>& order, const PartUnits& units);

}  // namespace sim::cut
