#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// Position of a cut in the order that the user requires, called its turn. All cuts of a lower turn
/// come before it. Turns are compared by rank, then by part, then by layer.
struct CutTurn {
  unsigned rank = 0;     ///< The rank of the cut's layer.
  std::size_t part = 0;  ///< Position of the cut's part in the order of parts, from the sheet file.
  /// Number of the layer if the cuts of each layer stay together, otherwise 0.
  std::size_t layer = 0;
  auto operator<=>(const CutTurn&) const = default;
};

/// Returns the turn that the user requires for a cut, without regard to Cut::after.
[[nodiscard]] CutTurn wished_turn(const UnbegunCut& cut, Grouping grouping);

/// Returns, for each cut, the number of different turns that come before its own turn.
[[nodiscard]] std::vector<std::size_t> numbered(const std::vector<CutTurn>& turns);

/// Returns the turns of all cuts. They are the turns that the user requires, with one exception: a
/// cut that must come after another cut has at least the turn of that cut.
/// @param cuts cuts whose `after` has no cycle
[[nodiscard]] std::vector<CutTurn> turns_of(const std::vector<UnbegunCut>& cuts, Grouping grouping);

}  // namespace sim::cut
