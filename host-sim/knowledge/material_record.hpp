#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/knowledge/operation_record.hpp"
#include "planner/base/result.hpp"
#include "planner/kerf/kerf_lookup.hpp"

namespace sim {

/// Permissible speeds and measured kerfs of one power at one thickness.
struct PowerRecord {
  std::uint32_t power_mw = 0;
  cnc::kerf::Window speeds_um_min{};
  /// Measured kerfs over speed, used if the law does not hold.
  std::vector<cnc::kerf::Point> points{};
};

/// Law of the kerf at one thickness, with its uncertainty and the powers that were cut.
struct ThicknessRecord {
  std::uint32_t thickness_um = 0;
  bool measured = false;  ///< Whether lookups use the points of `powers` in place of the law.
  double slope = 0.0;     ///< λ1, mm per unit of Q.
  double intercept = 0.0;
  double correlation = 0.0;
  /// Standard deviation of the kerf of one cut from the law; if `measured`, from the mean kerf
  /// under its condition.
  double residual_sd_mm = 0.0;
  /// Greatest deviation from the law, over all conditions, of the mean kerf under a condition.
  double greatest_residual_mm = 0.0;
  std::size_t samples = 0;  ///< Number of cuts of the fit; 0 if not known.
  std::size_t degrees = 0;  ///< Degrees of freedom of residual_sd_mm; 0 if not known.
  double mean_heat = 0.0;
  double heat_squares = 0.0;  ///< Sum of (Q − mean)²; 0 if not known.
  std::vector<PowerRecord> powers{};
};

/// Known kerfs of one material under one laser.
struct MaterialRecord {
  std::string name{};
  std::string laser{};
  double gas_pressure_mpa = 0.0;
  cnc::kerf::HeatUnit unit = cnc::kerf::HeatUnit::kWattMinutesPerMillimetre;
  /// Whether the record was calibrated by test cuts; if not, the provenance states how reliable it
  /// is.
  bool calibrated = false;
  std::string provenance{};
  std::vector<ThicknessRecord> thicknesses{};
  /// Operations of the material; they do not depend on the unit of the record.
  std::vector<OperationRecord> operations{};

  /// Returns whether a law or points of the kerf are known.
  [[nodiscard]] bool has_kerf() const { return !thicknesses.empty(); }
};

/// Kerf table of a record, which owns its parts, for lookups in single or double precision.
template <typename Real>
struct OwnedKerfTable {
  std::string name;
  cnc::kerf::HeatUnit unit{};
  std::vector<cnc::kerf::Row<Real>> rows{};
  std::vector<cnc::kerf::Band> bands{};
  std::vector<cnc::kerf::Point> points{};

  [[nodiscard]] cnc::kerf::TableView<Real> view() const {
    return {name, unit, rows, bands, points};
  }
};

/// Returns the table of a record.
/// @pre at most 65,535 bands and points
template <typename Real>
[[nodiscard]] OwnedKerfTable<Real> table_of(const MaterialRecord& record);

struct KerfPrediction {
  double kerf_mm = 0.0;
  /// Half the width of the interval around the kerf that contains the kerfs of 95 % of single cuts;
  /// at least the measuring error.
  double half_interval_mm = 0.0;
  double heat = 0.0;  ///< Q, in the record's unit.
};

/// Error of measuring a kerf, mm. Source: Park and Ahn 2007, section 3.3.
inline constexpr double kMeasuringErrorMm = 0.01;

/// Returns the kerf under a condition with its uncertainty, or the refusal of the condition.
/// @pre the record's table is sound
[[nodiscard]] cnc::Result<KerfPrediction, cnc::kerf::Refusal> predict(
    const MaterialRecord& record, const cnc::kerf::Condition& condition);

/// Returns the meaning of a refusal, with the permissible values: `speed 6000 mm/min is …;
/// permissible are …`.
[[nodiscard]] std::string describe(const cnc::kerf::Refusal& refusal,
                                   const cnc::kerf::Condition& condition);

/// Checks that kerfs can be looked up in the record. Throws std::invalid_argument naming the wrong
/// thickness otherwise.
void require_sound(const MaterialRecord& record);

}  // namespace sim
