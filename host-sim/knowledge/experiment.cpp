#include "host-sim/knowledge/experiment.hpp"

#include <fmt/format.h>

#include <cmath>

namespace sim {

std::string rejection_of(const Experiment& cut, const AcceptanceLimits& limits) {
  std::string reasons;
  const auto add = [&reasons](const std::string& reason) {
    reasons += (reasons.empty() ? "" : "; ") + reason;
  };
  if (cut.kerf_top_mm <= 0.0 || cut.kerf_bottom_mm <= 0.0) add("not cut through: a kerf is 0");
  if (cut.dross_area_mm2 && *cut.dross_area_mm2 > limits.dross_area_mm2) {
    add(fmt::format(
        "dross area {:g} mm2 is above {:g} mm2", *cut.dross_area_mm2, limits.dross_area_mm2));
  }
  if (cut.straightness_mm && *cut.straightness_mm > limits.straightness_mm) {
    add(fmt::format(
        "straightness {:g} mm is above {:g} mm", *cut.straightness_mm, limits.straightness_mm));
  }
  return reasons;
}

std::uint32_t to_thousandths(double value) {
  return static_cast<std::uint32_t>(std::llround(value * 1000.0));
}

const char* name_of(cnc::kerf::HeatUnit unit) {
  return unit == cnc::kerf::HeatUnit::kJoulesPerMillimetre ? "J/mm" : "W/(mm/min)";
}

}  // namespace sim
