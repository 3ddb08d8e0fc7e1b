#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Units of cuts, and the precedence between them. The cuts of a unit follow each other without
/// cuts of other units between them.
struct PartUnits {
  /// Cuts of each unit, in the order of their numbers.
  std::vector<std::vector<std::size_t>> cuts{};
  /// For each unit, the units that must come before it.
  std::vector<std::vector<std::size_t>> after{};
};

/// Makes one unit of the cuts of each part. Shared lines may require that each of two parts has
/// cuts that must come after cuts of the other part. Such parts become one unit, together with all
/// parts that must come after them.
/// @param members numbers of the cuts; a cut in their `after` that is not a member counts as done
/// @pre the `after` of the cuts has no cycle
[[nodiscard]] PartUnits units_of(const std::vector<UnbegunCut>& cuts,
                                 const std::vector<std::size_t>& members);

/// Brings the cuts of each unit together, in an order that keeps every precedence. The units are in
/// the order of their first cuts, as far as the precedence permits.
/// @param order all cuts of `units`, each once
void bring_together(std::vector<OrderedCut>& order, const PartUnits& units);

}  // namespace sim::cut
