#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/import/loose_ends.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// A gap that would close most of the ends that are open.
struct WiderGap {
  double gap_mm;
  std::size_t open;     ///< Ends that meet no other one within the present gap.
  std::size_t closing;  ///< Ends of them that meet one within the wider gap.
};

/// Returns the least of 0.02, 0.05, 0.1, 0.2 and 0.5 mm that closes more than half of the open
/// ends, and nine tenths of those that the widest closes. Nothing where there is none, and where
/// a chain is no longer than it: that would be lost.
[[nodiscard]] std::optional<WiderGap> wider_gap(const std::vector<Piece>& chains, double gap_mm);

}  // namespace sim::drawing
