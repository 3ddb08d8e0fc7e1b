#pragma once

#include <vector>

#include "host-sim/import/piece.hpp"
#include "host-sim/import/piece_sets.hpp"

namespace sim::drawing {

/// Closed pieces that may touch or cross themselves or others.
struct TouchingPieces {
  PieceSets sets;
  std::vector<bool> touches;  ///< By piece.
};

/// Finds the closed pieces of each layer or group of layers, and of each part, whose chords come so
/// near to each other or to themselves that their curves may touch; reports where it had to give
/// up.
[[nodiscard]] TouchingPieces find_touching(Sketch& sketch, const std::vector<Piece>& pieces);

}  // namespace sim::drawing
