#pragma once

#include <vector>

#include "host-sim/import/piece.hpp"
#include "host-sim/import/piece_sets.hpp"

namespace sim::drawing {

/// The closed pieces that may touch or cross themselves or other pieces, united into sets.
struct TouchingPieces {
  PieceSets sets;
  std::vector<bool> touches;  ///< For each piece, true if it may touch itself or another piece.
};

/// Finds closed pieces whose chords are so near to other chords, of the same piece or of another
/// one, that their curves may touch. Compares only pieces of the same part that are in one layer or
/// one group of layers. Reports a fault if the bound on work ended the comparison.
[[nodiscard]] TouchingPieces find_touching(Sketch& sketch, const std::vector<Piece>& pieces);

}  // namespace sim::drawing
