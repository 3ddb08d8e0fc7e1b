#pragma once

#include <vector>

#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// Least and greatest tried value of each quantity.
struct ExperimentRange {
  double min_power_w, max_power_w;
  double min_speed_mm_min, max_speed_mm_min;
  double min_thickness_mm, max_thickness_mm;
  double gas_pressure_mpa;
};

/// The ranges of Park and Ahn 2007, Table 1.
inline constexpr ExperimentRange kCsp1nRange{1200, 1800, 2000, 10'000, 0.5, 2.0, 0.1};

/// Returns the records of a new data base: CSP 1N with both units of Q, the printed unit first, and
/// an acrylic without any measurement.
[[nodiscard]] std::vector<MaterialRecord> shipped_records();

}  // namespace sim
