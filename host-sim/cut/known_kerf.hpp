#pragma once

#include <cstdint>
#include <string>

#include "host-sim/knowledge/material_record.hpp"

namespace sim::cut {

/// Greatest kerf that a command line may give, mm.
inline constexpr double kMaxKnownKerfMm = 10.0;

/// Returns a record for a kerf that the user knows. It has this kerf at every power and speed.
/// @param kerf_mm 0 to kMaxKnownKerfMm
/// @param material name of the material, for reports
/// @param thickness_um thickness of the sheet; 0 if it is not known
[[nodiscard]] MaterialRecord record_of_known_kerf(double kerf_mm,
                                                  const std::string& material,
                                                  std::uint32_t thickness_um);

}  // namespace sim::cut
