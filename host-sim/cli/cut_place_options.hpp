#pragma once

#include <string>

#include "host-sim/cut/placing.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Options of `kerfline cut` for the machine and for the position of the drawing on it.
struct CutPlaceOptions {
  std::string machine;  ///< File, or name of a shipped profile; empty for none.
  std::string place;    ///< `corner`, `centre` or `X,Y`; empty for the position as drawn.
  std::string move;     ///< Displacement `DX,DY`; empty for none.
  double turn_deg = 0.0;
  std::string mirror;  ///< Direction of mirroring, `x` or `y`; empty for none.
  double scale = 1.0;
  std::string copies;  ///< Columns and rows of copies, `NxM`; empty for none.
  double gap_mm = 2.0;
  double margin_mm = 5.0;
};

/// Adds `--machine`, `--place`, `--place-margin` and `--move`.
void add_machine_options(CLI::App& command, CutPlaceOptions& options);

/// Adds `--machine`, `--place`, `--place-margin`, `--move`, `--turn`, `--mirror`, `--scale`,
/// `--copies` and `--copy-gap`.
void add_cut_place_options(CLI::App& command, CutPlaceOptions& options);

/// Returns the position, rotation and copies that a call requires. Throws std::invalid_argument
/// that names the option.
[[nodiscard]] cut::PlaceWishes place_wishes_of(const CutPlaceOptions& options);

}  // namespace sim
