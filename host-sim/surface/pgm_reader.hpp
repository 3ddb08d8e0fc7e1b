#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

/// Reads the first picture of a PGM file, as text (P2) or bytes (P5), with up to 16 bits for a
/// pixel. Throws std::invalid_argument.
[[nodiscard]] GridDraft read_pgm(std::string_view bytes,
                                 const std::string& name,
                                 const ReadOptions& options);

}  // namespace sim::surface
