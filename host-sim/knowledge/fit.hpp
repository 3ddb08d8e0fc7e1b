#pragma once

#include <span>
#include <string>
#include <vector>

#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/knowledge/material_record.hpp"

namespace sim {

/// When the linear law holds for a thickness. Means are of the cuts under one condition.
struct LawCriterion {
  /// No mean is farther from the law: twice the measuring error. Enough by itself…
  double close_mm = 2.0 * kMeasuringErrorMm;
  /// …else the correlation is at least the least that the paper calls strong, and…
  double least_correlation = 0.9;
  /// …no mean is farther from the law than its least processing tolerance.
  double far_mm = 0.05;
};

struct FitOptions {
  cnc::kerf::HeatUnit unit = cnc::kerf::HeatUnit::kWattMinutesPerMillimetre;
  LawCriterion criterion{};
};

/// Makes the record of one material from its cuts, those that were rejected included: per
/// thickness and power the permissible speeds, which are the longest run of tried ones at which
/// every cut was accepted, and of the cuts in it a line over Q; or their means as points,
/// where the line does not hold or fewer than three values of Q were cut.
///
/// Throws std::invalid_argument where the cuts are of several materials, lasers or gas pressures,
/// or none was accepted.
[[nodiscard]] MaterialRecord fit_record(std::span<const Experiment> cuts,
                                        const FitOptions& options);

}  // namespace sim
