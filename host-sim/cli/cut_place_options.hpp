#pragma once

#include <string>

#include "host-sim/cut/placing.hpp"

namespace CLI {
class App;
}

namespace sim {

/// The machine of a call of `kerfline cut`, and where the drawing is put on it.
struct CutPlaceOptions {
  std::string machine;  ///< File, or name of a shipped profile; empty: none.
  std::string place;    ///< `corner`, `centre` or `X,Y`; empty: as drawn.
  std::string move;     ///< `DX,DY`.
  double turn_deg = 0.0;
  std::string mirror;  ///< `x` or `y`.
  double scale = 1.0;
  std::string copies;  ///< `NxM`.
  double gap_mm = 2.0;
  double margin_mm = 5.0;
};

/// Adds `--machine`, `--place`, `--place-margin` and `--move`.
void add_machine_options(CLI::App& command, CutPlaceOptions& options);

/// Adds these, and `--turn`, `--mirror`, `--scale`, `--copies` and `--copy-gap`.
void add_cut_place_options(CLI::App& command, CutPlaceOptions& options);

/// Returns the wishes of a call. Throws std::invalid_argument that names the option.
[[nodiscard]] cut::PlaceWishes place_wishes_of(const CutPlaceOptions& options);

}  // namespace sim
