#include "host-sim/knowledge/shipped_records.hpp"

#include <array>
#include <cmath>

#include "host-sim/knowledge/experiment.hpp"
#include "planner/kerf/csp_1n.hpp"

namespace sim {
namespace {

namespace kerf = cnc::kerf;

/// Correlations of Park and Ahn 2007, Table 3, last column.
constexpr std::array<double, 4> kCorrelations{0.93, 0.94, 0.91, 0.90};

/// Adds the residual that the paper implies. The paper prints neither the number of fitted cuts nor
/// their residuals. Its correlations and slopes over known heat inputs imply the residuals. The
/// heat inputs are those that Table 2 permits, each at every whole speed in m/min.
void add_implied_residual(ThicknessRecord& row, kerf::HeatUnit unit) {
  std::vector<double> heats;
  for (const PowerRecord& power : row.powers) {
    for (std::uint32_t speed = power.speeds_um_min.least; speed <= power.speeds_um_min.most;
         speed += kerf::csp_1n::kMetrePerMinute) {
      heats.push_back(kerf::heat_input<double>(unit, power.power_mw, speed));
    }
  }
  const auto count = static_cast<double>(heats.size());
  for (const double heat : heats) row.mean_heat += heat / count;
  double squares = 0.0;
  for (const double heat : heats) squares += (heat - row.mean_heat) * (heat - row.mean_heat);
  const double unexplained = 1.0 / (row.correlation * row.correlation) - 1.0;
  row.residual_sd_mm = row.slope * std::sqrt(squares * unexplained / (count - 2.0));
}

MaterialRecord csp_1n(kerf::HeatUnit unit) {
  const auto& table = kerf::kCsp1n<double>;
  MaterialRecord record{.name = std::string{table.name},
                        .laser = "CW Nd:YAG 2.8 kW, 1.06 um, spot 0.6 mm",
                        .gas_pressure_mpa = kCsp1nRange.gas_pressure_mpa,
                        .unit = unit,
                        .calibrated = false,
                        .provenance = "Park and Ahn 2007, Tables 1 to 3"};
  record.provenance += unit == kerf::HeatUnit::kJoulesPerMillimetre
                           ? "; Q in J/mm, which its figures and correlations require"
                           : "; Q as in its worked example";
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const auto& row = table.rows[i];
    ThicknessRecord thickness{.thickness_um = row.thickness_um,
                              .slope = row.law.slope,
                              .intercept = row.law.intercept,
                              .correlation = kCorrelations[i]};
    for (const kerf::Band& band : table.bands_of(row)) {
      thickness.powers.push_back({band.power_mw, {band.min_um_min, band.max_um_min}, {}});
    }
    add_implied_residual(thickness, unit);
    record.thicknesses.push_back(thickness);
  }
  return record;
}

PowerRecord example_power(double watts, double min_mm_min, double max_mm_min) {
  return {to_thousandths(watts), {to_thousandths(min_mm_min), to_thousandths(max_mm_min)}, {}};
}

/// Returns an example record without measurements, as a start of a calibration. Its round numbers
/// are similar to the values that makers of 40 to 80 W tubes give. They are a guess, so the
/// uncertainty is ± 0.1 mm.
MaterialRecord example_acrylic() {
  constexpr double kDoubtMm = 0.05;
  MaterialRecord record{
      .name = "acrylic",
      .laser = "CO2 tube 40 to 80 W, 10.6 um, 2 inch lens",
      .gas_pressure_mpa = 0.02,
      .unit = kerf::HeatUnit::kJoulesPerMillimetre,
      .calibrated = false,
      .provenance =
          "EXAMPLE: uncalibrated starting values, measured by nobody; calibrate before use"};
  record.thicknesses = {
      {.thickness_um = 3000, .slope = 0.01, .intercept = 0.16, .residual_sd_mm = kDoubtMm},
      {.thickness_um = 5000, .slope = 0.01, .intercept = 0.18, .residual_sd_mm = kDoubtMm}};
  record.thicknesses[0].powers = {
      example_power(40, 300, 720), example_power(60, 420, 1080), example_power(80, 600, 1440)};
  record.thicknesses[1].powers = {
      example_power(40, 180, 360), example_power(60, 270, 600), example_power(80, 360, 840)};
  return record;
}

}  // namespace

std::vector<MaterialRecord> shipped_records() {
  return {csp_1n(kerf::HeatUnit::kWattMinutesPerMillimetre),
          csp_1n(kerf::HeatUnit::kJoulesPerMillimetre),
          example_acrylic()};
}

}  // namespace sim
