#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/import/loose_ends.hpp"
#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// A gap, mm, that would close most of the open ends.
struct WiderGap {
  double gap_mm;
  std::size_t open;     ///< Number of ends that have no other end within the present gap.
  std::size_t closing;  ///< Number of open ends that have another end within the wider gap.
};

/// Returns the smallest of the gaps 0.02, 0.05, 0.1, 0.2 and 0.5 mm that closes more than half of
/// the open ends, and at least nine tenths of the ends that the widest gap closes. Returns nothing
/// if there is no such gap. Also returns nothing if any chain is no longer than the gap, because
/// both ends of this chain would be joined and the chain lost.
[[nodiscard]] std::optional<WiderGap> wider_gap(const std::vector<Piece>& chains, double gap_mm);

}  // namespace sim::drawing
