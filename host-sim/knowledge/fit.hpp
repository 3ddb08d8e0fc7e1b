#pragma once

#include <span>
#include <string>
#include <vector>

#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// Criterion by which the linear law holds for a thickness. Means are over the cuts under one
/// condition.
struct LawCriterion {
  /// Distance of the means from the law, mm. If no mean is farther away, the law holds. The
  /// distance is twice the measuring error.
  double close_mm = 2.0 * kMeasuringErrorMm;
  /// Least correlation. With at least this correlation, the law also holds if no mean is farther
  /// from it than far_mm. It is the least correlation that the paper calls strong.
  double min_correlation = 0.9;
  /// Greatest distance of a mean from a law with this correlation. It is the least processing
  /// tolerance of the paper.
  double far_mm = 0.05;
};

struct FitOptions {
  cnc::kerf::HeatUnit unit = cnc::kerf::HeatUnit::kWattMinutesPerMillimetre;
  LawCriterion criterion{};
};

/// Returns the record of one material, made from all its cuts, including rejected ones. For each
/// thickness and power the record contains the permissible speeds: the longest run of tried speeds
/// at which every cut was accepted. For each thickness it contains a line over Q through the cuts
/// of these runs. If the line does not hold, or if fewer than three values of Q were cut, it
/// contains the means of the cuts as points instead.
///
/// Throws std::invalid_argument if the cuts are of several materials, lasers or gas pressures, or
/// if none was accepted.
[[nodiscard]] MaterialRecord fit_record(std::span<const Experiment> cuts,
                                        const FitOptions& options);

}  // namespace sim
