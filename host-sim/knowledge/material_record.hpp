#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host-sim/knowledge/operation_record.hpp"
#include "planner/base/result.hpp"
#include "planner/kerf/kerf_lookup.hpp"

namespace sim {

/// What a power cuts at one thickness.
struct PowerRecord {
  std::uint32_t power_mw = 0;
  cnc::kerf::Window speeds_um_min{};
  std::vector<cnc::kerf::Point> points{};  ///< Where the law does not hold.
};

/// What is known of one thickness, and how well.
struct ThicknessRecord {
  std::uint32_t thickness_um = 0;
  bool measured = false;  ///< The points count, not the law.
  double slope = 0.0;     ///< λ1, mm per unit of Q.
  double intercept = 0.0;
  double correlation = 0.0;
  double residual_sd_mm = 0.0;        ///< Of one cut; of a measured row, from its own mean.
  double greatest_residual_mm = 0.0;  ///< Of the mean of the cuts under one condition.
  std::size_t samples = 0;            ///< 0: not known.
  std::size_t degrees = 0;            ///< Of freedom of residual_sd_mm; 0: not known.
  double mean_heat = 0.0;
  double heat_squares = 0.0;  ///< Sum of (Q − mean)²; 0: not known.
  std::vector<PowerRecord> powers{};
};

/// The kerf of one material under one laser.
struct MaterialRecord {
  std::string name{};
  std::string laser{};
  double gas_pressure_mpa = 0.0;
  cnc::kerf::HeatUnit unit = cnc::kerf::HeatUnit::kWattMinutesPerMillimetre;
  bool calibrated = false;  ///< By test cuts; else the provenance says what it is worth.
  std::string provenance{};
  std::vector<ThicknessRecord> thicknesses{};
  std::vector<OperationRecord> operations{};  ///< Of the material, whatever the unit.

  /// Returns whether a law or points of the kerf are known.
  [[nodiscard]] bool has_kerf() const { return !thicknesses.empty(); }
};

/// A record as a table that owns its parts, for lookups in either precision.
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

/// @pre at most 65,535 bands and points
template <typename Real>
[[nodiscard]] OwnedKerfTable<Real> table_of(const MaterialRecord& record);

struct KerfPrediction {
  double kerf_mm = 0.0;
  /// 95 % of single cuts are within so much of it; never below the measuring error.
  double half_interval_mm = 0.0;
  double heat = 0.0;  ///< Q, in the record's unit.
};

/// Error of a kerf's measurement, mm. Source: Park and Ahn 2007, section 3.3.
inline constexpr double kMeasuringErrorMm = 0.01;

/// The kerf, and how sure it is. @pre the record's table is sound
[[nodiscard]] cnc::Result<KerfPrediction, cnc::kerf::Refusal> predict(
    const MaterialRecord& record, const cnc::kerf::Condition& condition);

/// What a refusal means, with what is permissible: `speed 6000 mm/min is …; permissible are …`.
[[nodiscard]] std::string describe(const cnc::kerf::Refusal& refusal,
                                   const cnc::kerf::Condition& condition);

/// Throws std::invalid_argument naming the thickness where the record cannot be looked up.
void require_sound(const MaterialRecord& record);

}  // namespace sim
