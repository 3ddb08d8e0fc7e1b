#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Units of cuts, and the precedence between units. The cuts of a unit follow each other without
/// other cuts between them.
struct PartUnits {
  std::vector<std::vector<std::size_t>> cuts{};   ///< Cuts by unit, in the order of their numbers.
  std::vector<std::vector<std::size_t>> after{};  ///< Units that must come before each unit.
};

/// Makes one unit of the cuts of each part. Shared lines may require that two parts each have cuts
/// that must come after cuts of the other. Such parts become one unit, together with the parts
/// after them.
/// @param members numbers of the cuts; a cut in their `after` that is not a member counts as done
/// @pre the `after` of the cuts has no cycle
[[nodiscard]] PartUnits units_of(const std::vector<UnbegunCut>& cuts,
                                 const std::vector<std::size_t>& members);

/// Brings together the cuts of each unit in an order that keeps every precedence. The units follow
/// the order of their first cuts as far as the precedence permits.
/// @param order all cuts of `units`, each once
void bring_together(std::vector<OrderedCut>& order, const PartUnits& units);

}  // namespace sim::cut
