#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "planner/kerf/kerf_table.hpp"

namespace sim {

/// One test cut with its measurements. The reader has checked their ranges.
struct Experiment {
  std::string material{};
  std::string laser{};
  double gas_pressure_mpa = 0.0;
  cnc::kerf::Condition condition{};
  double kerf_top_mm = 0.0;
  double kerf_bottom_mm = 0.0;
  /// Mean dross area of the cut's faces at the bottom; empty if it was not measured. The cut is
  /// then accepted or rejected without it.
  std::optional<double> dross_area_mm2{};
  /// Straightness at the bottom; empty if it was not measured. The cut is then accepted or rejected
  /// without it.
  std::optional<double> straightness_mm{};
  std::string file{};
  std::size_t line = 0;
  std::string measured_by{};  ///< Name of the person who measured; empty if not known.
  std::string measured_on{};  ///< Day of the measurement, YYYY-MM-DD; empty if not known.
  std::string rejection{};    ///< Reason why the cut is rejected; empty if it is accepted.

  /// Returns the kerf: the mean of its widths at top and bottom.
  [[nodiscard]] double kerf_mm() const { return 0.5 * (kerf_top_mm + kerf_bottom_mm); }
  [[nodiscard]] bool accepted() const { return rejection.empty(); }
};

/// Limits of an accepted cut. Source: Park and Ahn 2007, section 3.2.
struct AcceptanceLimits {
  double dross_area_mm2 = 0.5;
  double straightness_mm = 0.01;
};

/// Returns the reason why a cut is rejected, with the measured value and the limit; empty if it is
/// accepted.
[[nodiscard]] std::string rejection_of(const Experiment& cut, const AcceptanceLimits& limits);

// Convert between the units of files and of tables; to_thousandths() rounds to the nearest µm, mW
// and µm/min.
// @pre 0 ≤ value ≤ 4e6
[[nodiscard]] std::uint32_t to_thousandths(double value);
[[nodiscard]] constexpr double from_thousandths(std::uint32_t value) { return value / 1000.0; }

/// Returns `W/(mm/min)` or `J/mm`.
[[nodiscard]] const char* name_of(cnc::kerf::HeatUnit unit);

}  // namespace sim
