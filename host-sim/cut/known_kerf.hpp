#pragma once

#include <cstdint>
#include <string>

#include "host-sim/knowledge/material_record.hpp"

namespace sim::cut {

/// Greatest kerf that a call may give, mm.
inline constexpr double kMaxKnownKerfMm = 10.0;

/// Returns a record of a kerf that the user knows: the same width with every power and speed.
/// @param kerf_mm 0 to kMaxKnownKerfMm
/// @param material its name, for reports
/// @param thickness_um of the sheet; 0 where nothing is known of it
[[nodiscard]] MaterialRecord record_of_known_kerf(double kerf_mm,
                                                  const std::string& material,
                                                  std::uint32_t thickness_um);

}  // namespace sim::cut
