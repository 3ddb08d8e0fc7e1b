#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host-sim/knowledge/experiment.hpp"

namespace sim {

/// The header of a file of test cuts, units in the names. Columns may be in any order.
inline constexpr std::string_view kExperimentHeader =
    "material,laser,gas_pressure_mpa,thickness_mm,power_w,speed_mm_min,"
    "kerf_top_mm,kerf_bottom_mm,dross_area_mm2,straightness_mm";

/// Reads a CSV file of test cuts: the header, then one line each; fields may be quoted, lines
/// that are blank or begin with # do not count. Throws std::invalid_argument saying
/// `FILE:LINE: column NAME: reason` for the first thing that is wrong.
[[nodiscard]] std::vector<Experiment> read_experiments(std::string_view text,
                                                       const std::string& file);

}  // namespace sim
