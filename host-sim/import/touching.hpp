#pragma once

#include <vector>

#include "host-sim/import/piece.hpp"
#include "host-sim/import/piece_sets.hpp"

namespace sim::drawing {

/// Closed pieces that may touch or cross themselves or others, united to sets.
struct TouchingPieces {
  PieceSets sets;
  std::vector<bool> touches;  ///< For each piece, whether it may touch itself or another piece.
};

/// Finds closed pieces whose chords come so near to each other, or to themselves, that their curves
/// may touch. Compares pieces of one part within each layer or group of layers. Reports if it had
/// to stop before all were compared.
[[nodiscard]] TouchingPieces find_touching(Sketch& sketch, const std::vector<Piece>& pieces);

}  // namespace sim::drawing
