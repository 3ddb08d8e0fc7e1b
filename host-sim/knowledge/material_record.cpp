#include "host-sim/knowledge/material_record.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host-sim/knowledge/experiment.hpp"
#include "host-sim/knowledge/regression.hpp"
#include "planner/kerf/table_check.hpp"

namespace sim {
namespace {

namespace kerf = cnc::kerf;

/// Returns half the width, mm, of the interval around the computed kerf that contains the kerfs of
/// 95 % of single cuts.
double half_interval(const ThicknessRecord& row, double heat) {
  // Variance, in units of residual_sd_mm²: 1 for the scatter of a single cut, plus 1 for the error
  // of a measured mean, because the mean may be that of only one cut.
  double variance = 2.0;
  if (!row.measured) {
    variance = 1.0;
    if (row.samples > 0) variance += 1.0 / static_cast<double>(row.samples);
    const double off = heat - row.mean_heat;
    if (row.heat_squares > 0.0) variance += off * off / row.heat_squares;
  }
  const double half = student_t95(row.degrees) * row.residual_sd_mm * std::sqrt(variance);
  return std::max(half, kMeasuringErrorMm);
}

}  // namespace

template <typename Real>
OwnedKerfTable<Real> table_of(const MaterialRecord& record) {
  OwnedKerfTable<Real> table{record.name, record.unit, {}, {}, {}};
  for (const ThicknessRecord& row : record.thicknesses) {
    table.rows.push_back({row.thickness_um,
                          {static_cast<Real>(row.measured ? 0.0 : row.slope),
                           static_cast<Real>(row.measured ? 0.0 : row.intercept)},
                          row.measured,
                          static_cast<std::uint16_t>(table.bands.size()),
                          static_cast<std::uint16_t>(row.powers.size())});
    for (const PowerRecord& power : row.powers) {
      table.bands.push_back({power.power_mw,
                             power.speeds_um_min.least,
                             power.speeds_um_min.most,
                             static_cast<std::uint16_t>(table.points.size()),
                             static_cast<std::uint16_t>(power.points.size())});
      table.points.insert(table.points.end(), power.points.begin(), power.points.end());
    }
  }
  return table;
}

template OwnedKerfTable<float> table_of(const MaterialRecord&);
template OwnedKerfTable<double> table_of(const MaterialRecord&);

cnc::Result<KerfPrediction, kerf::Refusal> predict(const MaterialRecord& record,
                                                   const kerf::Condition& condition) {
  const OwnedKerfTable<double> table = table_of<double>(record);
  const auto width = kerf::kerf_width(table.view(), condition);
  if (!width.ok()) return width.error();
  KerfPrediction prediction{.kerf_mm = width.value()};
  prediction.heat =
      kerf::heat_input<double>(record.unit, condition.power_mw, condition.speed_um_min);
  const auto around = kerf::detail::neighbours(
      table.view().rows, &kerf::Row<double>::thickness_um, condition.thickness_um);
  for (const std::size_t row : {around.low, around.high}) {
    prediction.half_interval_mm = std::max(prediction.half_interval_mm,
                                           half_interval(record.thicknesses[row], prediction.heat));
  }
  return prediction;
}

std::string describe(const kerf::Refusal& refusal, const kerf::Condition& condition) {
  const auto say = [&refusal](const char* what, std::uint32_t value, const char* unit) {
    return fmt::format("{} {:g} {} is outside of the test cuts; permissible are {:g} to {:g} {}",
                       what,
                       from_thousandths(value),
                       unit,
                       from_thousandths(refusal.least),
                       from_thousandths(refusal.most),
                       unit);
  };
  switch (refusal.reason) {
    case kerf::RefusalReason::kThickness:
      return say("thickness", condition.thickness_um, "mm");
    case kerf::RefusalReason::kPower:
      return say("power", condition.power_mw, "W");
    case kerf::RefusalReason::kSpeed:
      return say("speed", condition.speed_um_min, "mm/min");
    case kerf::RefusalReason::kNoSpeed:
      break;
  }
  return fmt::format("no speed at {:g} mm and {:g} W is permissible by all neighbouring test cuts",
                     from_thousandths(condition.thickness_um),
                     from_thousandths(condition.power_mw));
}

void require_sound(const MaterialRecord& record) {
  const OwnedKerfTable<double> table = table_of<double>(record);
  const auto fault = kerf::find_fault(table.view());
  if (!fault) return;
  const std::string thickness =
      fault->row < table.rows.size()
          ? fmt::format(" at {:g} mm", from_thousandths(table.rows[fault->row].thickness_um))
          : "";
  throw std::invalid_argument(
      fmt::format("{}{}: {}", record.name, thickness, kerf::describe(fault->error)));
}

}  // namespace sim
