#pragma once

#include <span>
#include <string>

#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// Kerf over speed for each power, and over power for each of some speeds, at one thickness, as far
/// as permissible; accepted cuts of it as dots, the interval of 95 % of cuts as bands. An SVG
/// document. Source: Park and Ahn 2007, Fig. 7. Throws std::invalid_argument where the thickness is
/// not permissible.
[[nodiscard]] std::string draw_kerf_over_speed(const MaterialRecord& record,
                                               std::uint32_t thickness_um,
                                               std::span<const Experiment> cuts);

/// Kerf over effective heat input for each thickness, in the record's unit. As above, Fig. 8.
[[nodiscard]] std::string draw_kerf_over_heat(const MaterialRecord& record,
                                              std::span<const Experiment> cuts);

}  // namespace sim
