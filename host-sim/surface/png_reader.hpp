#pragma once

#include <string>
#include <string_view>

#include "host-sim/surface/grid_draft.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim::surface {

inline constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1A\n";

/// Reads a grey PNG picture of 8 or 16 bits without interlacing. An opacity channel is ignored.
/// Throws std::invalid_argument.
/// @pre bytes start with kPngSignature
[[nodiscard]] GridDraft read_png(std::string_view bytes,
                                 const std::string& name,
                                 const ReadOptions& options);

}  // namespace sim::surface
