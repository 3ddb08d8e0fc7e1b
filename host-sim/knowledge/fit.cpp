#include "host-sim/knowledge/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "host-sim/knowledge/regression.hpp"

namespace sim {
namespace {

namespace kerf = cnc::kerf;

/// All cuts under one condition.
struct Cell {
  std::vector<double> kerfs_mm;
  bool any_rejected = false;

  [[nodiscard]] bool permissible() const { return !any_rejected && !kerfs_mm.empty(); }
  [[nodiscard]] double mean() const {
    double sum = 0.0;
    for (const double kerf_mm : kerfs_mm) sum += kerf_mm;
    return sum / static_cast<double>(kerfs_mm.size());
  }
};

using Speeds = std::map<std::uint32_t, Cell>;
using Powers = std::map<std::uint32_t, Speeds>;

std::map<std::uint32_t, Powers> cells_of(std::span<const Experiment> cuts) {
  std::map<std::uint32_t, Powers> cells;
  for (const Experiment& cut : cuts) {
    const kerf::Condition& at = cut.condition;
    Cell& cell = cells[at.thickness_um][at.power_mw][at.speed_um_min];
    if (cut.accepted()) {
      cell.kerfs_mm.push_back(cut.kerf_mm());
    } else {
      cell.any_rejected = true;
    }
  }
  return cells;
}

/// Returns the longest run of tried speeds at which all cuts were accepted; of two equally long
/// runs, the run of the lower speeds.
Speeds longest_run(const Speeds& speeds) {
  Speeds best;
  Speeds run;
  for (const auto& [speed, cell] : speeds) {
    if (!cell.permissible()) {
      run.clear();
      continue;
    }
    run[speed] = cell;
    if (run.size() > best.size()) best = run;
  }
  return best;
}

Powers region_of(const Powers& powers) {
  Powers region;
  for (const auto& [power, speeds] : powers) {
    Speeds run = longest_run(speeds);
    if (!run.empty()) region[power] = std::move(run);
  }
  return region;
}

template <typename Visit>
void for_each_cell(const Powers& region, kerf::HeatUnit unit, Visit visit) {
  for (const auto& [power, speeds] : region) {
    for (const auto& [speed, cell] : speeds) {
      visit(kerf::heat_input<double>(unit, power, speed), cell);
    }
  }
}

/// Fits a line to all cuts, if there are enough cuts. Returns whether there are enough.
bool add_law(const Powers& region, kerf::HeatUnit unit, ThicknessRecord& row) {
  std::vector<Sample> samples;
  std::set<double> heats;
  for_each_cell(region, unit, [&](double heat, const Cell& cell) {
    heats.insert(heat);
    for (const double kerf_mm : cell.kerfs_mm) samples.push_back({heat, kerf_mm});
  });
  row.samples = samples.size();
  if (heats.size() < 3) return false;
  const Regression line = fit_line(samples);
  row.slope = line.slope;
  row.intercept = line.intercept;
  row.correlation = line.correlation;
  row.residual_sd_mm = line.residual_sd;
  row.degrees = line.samples - 2;
  row.mean_heat = line.mean_x;
  row.heat_squares = line.squares_x;
  for_each_cell(region, unit, [&](double heat, const Cell& cell) {
    row.greatest_residual_mm =
        std::max(row.greatest_residual_mm, std::abs(cell.mean() - line.at(heat)));
  });
  return true;
}

bool holds(const ThicknessRecord& row, const LawCriterion& criterion) {
  if (row.greatest_residual_mm <= criterion.close_mm) return true;
  return std::abs(row.correlation) >= criterion.min_correlation &&
         row.greatest_residual_mm <= criterion.far_mm;
}

/// Computes the deviation of cuts from the mean under their condition. Conditions with a single cut
/// contribute nothing.
void add_repeatability(const Powers& region, ThicknessRecord& row) {
  double squares = 0.0;
  std::size_t cells = 0;
  for_each_cell(region, {}, [&](double, const Cell& cell) {
    ++cells;
    const double mean = cell.mean();
    for (const double kerf_mm : cell.kerfs_mm) squares += (kerf_mm - mean) * (kerf_mm - mean);
  });
  row.degrees = row.samples - cells;
  row.residual_sd_mm =
      row.degrees > 0 ? std::sqrt(squares / static_cast<double>(row.degrees)) : 0.0;
}

void add_powers(const Powers& region, ThicknessRecord& row) {
  for (const auto& [power, speeds] : region) {
    PowerRecord record{power, {speeds.begin()->first, speeds.rbegin()->first}, {}};
    for (const auto& [speed, cell] : speeds) {
      if (!row.measured) break;
      constexpr double kNmPerMm = 1.0e6;
      record.points.push_back(
          {speed, static_cast<std::uint32_t>(std::lround(cell.mean() * kNmPerMm))});
    }
    row.powers.push_back(std::move(record));
  }
}

void require_one_of(const std::set<std::string>& found, const char* what) {
  if (found.size() <= 1) return;
  std::string names;
  for (const std::string& name : found) {
    names += (names.empty() ? "" : ", ") + (name.empty() ? "one without a name" : name);
  }
  throw std::invalid_argument(
      fmt::format("the cuts are of several {}: {}; choose one", what, names));
}

void require_one_kind(std::span<const Experiment> cuts) {
  std::set<std::string> materials;
  std::set<std::string> lasers;
  std::set<std::string> gases;
  for (const Experiment& cut : cuts) {
    materials.insert(cut.material);
    lasers.insert(cut.laser);
    gases.insert(fmt::format("{:g} MPa", cut.gas_pressure_mpa));
  }
  require_one_of(materials, "materials");
  require_one_of(lasers, "lasers");
  require_one_of(gases, "gas pressures");
}

/// Returns `, measured by NAME on DATE and …`; empty if no person is named.
std::string persons_of(std::span<const Experiment> cuts) {
  std::set<std::string> persons;
  for (const Experiment& cut : cuts) {
    if (cut.measured_by.empty() && cut.measured_on.empty()) continue;
    persons.insert(fmt::format("{}{}",
                               cut.measured_by.empty() ? "" : " by " + cut.measured_by,
                               cut.measured_on.empty() ? "" : " on " + cut.measured_on));
  }
  if (persons.empty()) return {};
  return fmt::format(", measured{}", fmt::join(persons, " and"));
}

}  // namespace

MaterialRecord fit_record(std::span<const Experiment> cuts, const FitOptions& options) {
  require_one_kind(cuts);
  MaterialRecord record{.name = cuts.empty() ? "" : cuts.front().material,
                        .laser = cuts.empty() ? "" : cuts.front().laser,
                        .gas_pressure_mpa = cuts.empty() ? 0.0 : cuts.front().gas_pressure_mpa,
                        .unit = options.unit,
                        .calibrated = true,
                        .provenance = ""};
  std::size_t used = 0;
  for (const auto& [thickness, powers] : cells_of(cuts)) {
    const Powers region = region_of(powers);
    if (region.empty()) continue;
    ThicknessRecord row{.thickness_um = thickness};
    row.measured = !add_law(region, options.unit, row) || !holds(row, options.criterion);
    if (row.measured) add_repeatability(region, row);
    add_powers(region, row);
    used += row.samples;
    record.thicknesses.push_back(std::move(row));
  }
  if (record.thicknesses.empty()) {
    throw std::invalid_argument(
        "no cut is accepted, so there is no fit; `kerfline kerf show --cuts` lists the reasons");
  }
  record.provenance =
      fmt::format("fitted to {} of {} test cuts{}", used, cuts.size(), persons_of(cuts));
  require_sound(record);
  return record;
}

}  // namespace sim
