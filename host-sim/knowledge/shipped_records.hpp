#pragma once

#include <vector>

#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// What was tried: least and greatest of each quantity.
struct ExperimentRange {
  double least_power_w, most_power_w;
  double least_speed_mm_min, most_speed_mm_min;
  double least_thickness_mm, most_thickness_mm;
  double gas_pressure_mpa;
};

/// Park and Ahn 2007, Table 1.
inline constexpr ExperimentRange kCsp1nRange{1200, 1800, 2000, 10'000, 0.5, 2.0, 0.1};

/// What a new data base begins with: CSP 1N with both units of Q, as printed first, and an
/// acrylic of which nothing was measured.
[[nodiscard]] std::vector<MaterialRecord> shipped_records();

}  // namespace sim
