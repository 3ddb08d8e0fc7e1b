#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// When a cut is due by the user's will: all cuts of a lower turn come before it.
struct CutTurn {
  unsigned rank = 0;      ///< The rank of the cut's layer.
  std::size_t part = 0;   ///< Turn of its part in a sheet file.
  std::size_t layer = 0;  ///< Where layers are cut as a whole; else 0.
  auto operator<=>(const CutTurn&) const = default;
};

/// Returns the turn that is wished for a cut.
[[nodiscard]] CutTurn wished_turn(const UnbegunCut& cut, Grouping grouping);

/// Returns for each cut how many different turns are before its own.
[[nodiscard]] std::vector<std::size_t> numbered(const std::vector<CutTurn>& turns);

/// Returns the turns of all cuts: as wished, but for cuts that must come after one of a later turn,
/// which get that.
/// @param cuts their `after` has no cycle
[[nodiscard]] std::vector<CutTurn> turns_of(const std::vector<UnbegunCut>& cuts, Grouping grouping);

}  // namespace sim::cut
