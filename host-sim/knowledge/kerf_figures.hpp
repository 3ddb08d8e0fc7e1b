#pragma once

#include <span>
#include <string>

#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// Returns an SVG document of the kerf at one thickness: over speed for each power, and over power
/// for some speeds, within the permissible region. Accepted cuts are dots, and the interval of 95 %
/// of cuts is a band. Source: Park and Ahn 2007, Fig. 7. Throws std::invalid_argument if the
/// thickness is not permissible.
[[nodiscard]] std::string draw_kerf_over_speed(const MaterialRecord& record,
                                               std::uint32_t thickness_um,
                                               std::span<const Experiment> cuts);

/// Returns an SVG document of the kerf over effective heat input for each thickness, in the
/// record's unit, with dots and bands as in draw_kerf_over_speed(). Source: Park and Ahn 2007, Fig.
/// 8.
[[nodiscard]] std::string draw_kerf_over_heat(const MaterialRecord& record,
                                              std::span<const Experiment> cuts);

}  // namespace sim
