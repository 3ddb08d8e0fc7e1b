#include "host-sim/knowledge/knowledge_base.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <span>
#include <stdexcept>

#include "host-sim/knowledge/schema.hpp"
#include "host-sim/knowledge/shipped_records.hpp"
#include "host-sim/report/nearest_name.hpp"
#include "planner/base/crc32.hpp"

namespace sim {
namespace {

namespace kerf = cnc::kerf;

kerf::HeatUnit unit_named(const std::string& name) {
  return name == name_of(kerf::HeatUnit::kJoulesPerMillimetre)
             ? kerf::HeatUnit::kJoulesPerMillimetre
             : kerf::HeatUnit::kWattMinutesPerMillimetre;
}

/// Value in a column for a quantity that was not measured.
constexpr double kNotMeasured = -1.0;

std::optional<double> measured(double value) {
  return value < 0.0 ? std::nullopt : std::optional{value};
}

std::uint32_t crc_of_text(std::string_view text) {
  cnc::Crc32 crc;
  crc.add(std::as_bytes(std::span{text.data(), text.size()}));
  return crc.value();
}

const std::string& existing(const std::string& file, SqlFile::Mode mode) {
  std::error_code is_none;
  const bool exists = std::filesystem::exists(file, is_none);
  if (std::filesystem::is_directory(file, is_none)) {
    throw std::runtime_error(fmt::format("{}: Is a directory", file));
  }
  if (mode == SqlFile::Mode::kCreate || exists) return file;
  throw std::runtime_error(fmt::format(
      "{}: no such data base; `kerfline kerf add CUTS.csv --db {}` makes one", file, file));
}

}  // namespace

KnowledgeBase::KnowledgeBase(const std::string& file, SqlFile::Mode mode)
    : is_new_{!std::filesystem::exists(file)}, file_{existing(file, mode), mode} {
  try {
    prepare_file(mode);
  } catch (...) {
    // Removes a new file that could not be completed, for instance on a full disk, because it is no
    // data base.
    if (is_new_ && mode == SqlFile::Mode::kCreate) std::remove(file.c_str());
    throw;
  }
}

void KnowledgeBase::prepare_file(SqlFile::Mode mode) {
  SqlStatement version = file_.prepare("PRAGMA user_version");
  static_cast<void>(version.next());
  const std::int64_t found = version.whole(0);
  if (found == kSchemaVersion) return;
  if (found == 1) {
    if (mode != SqlFile::Mode::kRead) return upgrade();
    knows_origins_ = false;
    return;
  }
  SqlStatement tables = file_.prepare("SELECT count(*) FROM sqlite_master");
  static_cast<void>(tables.next());
  if (found != 0 || tables.whole(0) != 0 || mode != SqlFile::Mode::kCreate) {
    throw std::runtime_error(fmt::format(
        "{}: not a data base of kerf knowledge, version {}", file_.name(), kSchemaVersion));
  }
  create();
}

void KnowledgeBase::create() {
  const SqlFile& file = file_;
  SqlTransaction transaction{file};
  file.run(kSchema);
  file.run(kOperationSchema);
  for (const MaterialRecord& record : shipped_records()) insert(record);
  transaction.commit();
}

void KnowledgeBase::upgrade() {
  const SqlFile& file = file_;
  SqlTransaction transaction{file};
  file.run(kImportOfVersion2);
  file.run(kOperationSchema);
  transaction.commit();
}

void KnowledgeBase::add(const std::vector<Experiment>& cuts,
                        const std::string& file,
                        std::string_view text) {
  SqlTransaction transaction{file_};
  const std::uint32_t crc = crc_of_text(text);
  SqlStatement same = file_.prepare("SELECT file FROM import WHERE crc32 = ? AND bytes = ?");
  if (same.bind(crc).bind(text.size()).next()) {
    throw std::invalid_argument(
        fmt::format("{}: {} has its cuts already, from {}", file, file_.name(), same.text(0)));
  }
  const Experiment first = cuts.empty() ? Experiment{} : cuts.front();
  file_
      .prepare(
          "INSERT INTO import (file, crc32, bytes, measured_by, measured_on) VALUES (?, ?, ?, ?, "
          "?)")
      .bind(file)
      .bind(crc)
      .bind(text.size())
      .bind(first.measured_by)
      .bind(first.measured_on)
      .run();
  const std::int64_t import = file_.last_row();
  for (const Experiment& cut : cuts) {
    file_
        .prepare(
            "INSERT INTO cut (import, line, material, laser, gas_pressure_mpa, thickness_um, "
            "power_mw, speed_um_min, kerf_top_mm, kerf_bottom_mm, dross_area_mm2, "
            "straightness_mm, rejection) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
        .bind(import)
        .bind(cut.line)
        .bind(cut.material)
        .bind(cut.laser)
        .bind(cut.gas_pressure_mpa)
        .bind(cut.condition.thickness_um)
        .bind(cut.condition.power_mw)
        .bind(cut.condition.speed_um_min)
        .bind(cut.kerf_top_mm)
        .bind(cut.kerf_bottom_mm)
        .bind(cut.dross_area_mm2.value_or(kNotMeasured))
        .bind(cut.straightness_mm.value_or(kNotMeasured))
        .bind(cut.rejection)
        .run();
  }
  transaction.commit();
}

std::vector<Experiment> KnowledgeBase::cuts_of(std::string_view material) const {
  SqlStatement rows = file_.prepare(fmt::format(
      "SELECT laser, gas_pressure_mpa, thickness_um, power_mw, speed_um_min, kerf_top_mm, "
      "kerf_bottom_mm, dross_area_mm2, straightness_mm, file, line, rejection, {} "
      "FROM cut JOIN import ON import.id = cut.import WHERE material = ? ORDER BY cut.id",
      knows_origins_ ? "measured_by, measured_on" : "'', ''"));
  rows.bind(material);
  std::vector<Experiment> cuts;
  while (rows.next()) {
    cuts.push_back({.material = std::string{material},
                    .laser = rows.text(0),
                    .gas_pressure_mpa = rows.real(1),
                    .condition = {rows.small(2), rows.small(3), rows.small(4)},
                    .kerf_top_mm = rows.real(5),
                    .kerf_bottom_mm = rows.real(6),
                    .dross_area_mm2 = measured(rows.real(7)),
                    .straightness_mm = measured(rows.real(8)),
                    .file = rows.text(9),
                    .line = static_cast<std::size_t>(rows.whole(10)),
                    .measured_by = rows.text(12),
                    .measured_on = rows.text(13),
                    .rejection = rows.text(11)});
  }
  return cuts;
}

void KnowledgeBase::save(const MaterialRecord& record) {
  SqlTransaction transaction{file_};
  insert(record);
  transaction.commit();
}

void KnowledgeBase::insert(const MaterialRecord& record) {
  file_.prepare("DELETE FROM record WHERE material = ? AND heat_unit = ?")
      .bind(record.name)
      .bind(name_of(record.unit))
      .run();
  file_
      .prepare("DELETE FROM record WHERE material = ? AND id NOT IN (SELECT record FROM thickness)")
      .bind(record.name)
      .run();
  file_
      .prepare(
          "INSERT INTO record (material, heat_unit, laser, gas_pressure_mpa, calibrated, "
          "provenance) VALUES (?, ?, ?, ?, ?, ?)")
      .bind(record.name)
      .bind(name_of(record.unit))
      .bind(record.laser)
      .bind(record.gas_pressure_mpa)
      .bind(record.calibrated ? 1U : 0U)
      .bind(record.provenance)
      .run();
  const std::int64_t id = file_.last_row();
  for (const ThicknessRecord& row : record.thicknesses) insert_thickness(id, row);
}

void KnowledgeBase::insert_thickness(std::int64_t record, const ThicknessRecord& row) {
  file_
      .prepare(
          "INSERT INTO thickness (record, thickness_um, measured, slope, intercept_mm, "
          "correlation, residual_sd_mm, greatest_residual_mm, samples, degrees, mean_heat, "
          "heat_squares) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)")
      .bind(record)
      .bind(row.thickness_um)
      .bind(row.measured ? 1U : 0U)
      .bind(row.slope)
      .bind(row.intercept)
      .bind(row.correlation)
      .bind(row.residual_sd_mm)
      .bind(row.greatest_residual_mm)
      .bind(row.samples)
      .bind(row.degrees)
      .bind(row.mean_heat)
      .bind(row.heat_squares)
      .run();
  const std::int64_t thickness = file_.last_row();
  for (const PowerRecord& power : row.powers) {
    file_
        .prepare(
            "INSERT INTO power (thickness, power_mw, least_speed_um_min, most_speed_um_min) VALUES "
            "(?, ?, ?, ?)")
        .bind(thickness)
        .bind(power.power_mw)
        .bind(power.speeds_um_min.least)
        .bind(power.speeds_um_min.most)
        .run();
    const std::int64_t id = file_.last_row();
    for (const kerf::Point& point : power.points) {
      file_.prepare("INSERT INTO point (power, speed_um_min, kerf_nm) VALUES (?, ?, ?)")
          .bind(id)
          .bind(point.speed_um_min)
          .bind(point.kerf_nm)
          .run();
    }
  }
}

std::vector<MaterialRecord> KnowledgeBase::records() const {
  SqlStatement rows = file_.prepare(
      "SELECT id, material, heat_unit, laser, gas_pressure_mpa, calibrated, provenance FROM record "
      "ORDER BY id");
  std::vector<MaterialRecord> records;
  while (rows.next()) {
    records.push_back({.name = rows.text(1),
                       .laser = rows.text(3),
                       .gas_pressure_mpa = rows.real(4),
                       .unit = unit_named(rows.text(2)),
                       .calibrated = rows.whole(5) != 0,
                       .provenance = rows.text(6),
                       .thicknesses = thicknesses_of(rows.whole(0)),
                       .operations = operations_of(rows.text(1))});
    MaterialRecord& record = records.back();
    if (!record.has_kerf() && !record.operations.empty()) {
      record.provenance = origins_of(record.operations);
      continue;
    }
    // Reports, before any lookup, the faults of a file that was edited by hand.
    require_sound(record);
  }
  return records;
}

std::vector<ThicknessRecord> KnowledgeBase::thicknesses_of(std::int64_t record) const {
  SqlStatement rows = file_.prepare(
      "SELECT id, thickness_um, measured, slope, intercept_mm, correlation, residual_sd_mm, "
      "greatest_residual_mm, samples, degrees, mean_heat, heat_squares FROM thickness "
      "WHERE record = ? ORDER BY thickness_um");
  rows.bind(record);
  std::vector<ThicknessRecord> thicknesses;
  while (rows.next()) {
    thicknesses.push_back({.thickness_um = rows.small(1),
                           .measured = rows.whole(2) != 0,
                           .slope = rows.real(3),
                           .intercept = rows.real(4),
                           .correlation = rows.real(5),
                           .residual_sd_mm = rows.real(6),
                           .greatest_residual_mm = rows.real(7),
                           .samples = static_cast<std::size_t>(rows.whole(8)),
                           .degrees = static_cast<std::size_t>(rows.whole(9)),
                           .mean_heat = rows.real(10),
                           .heat_squares = rows.real(11),
                           .powers = powers_of(rows.whole(0))});
  }
  return thicknesses;
}

std::vector<PowerRecord> KnowledgeBase::powers_of(std::int64_t thickness) const {
  SqlStatement rows = file_.prepare(
      "SELECT id, power_mw, least_speed_um_min, most_speed_um_min FROM power "
      "WHERE thickness = ? ORDER BY power_mw");
  rows.bind(thickness);
  std::vector<PowerRecord> powers;
  while (rows.next()) {
    powers.push_back({rows.small(1), {rows.small(2), rows.small(3)}, points_of(rows.whole(0))});
  }
  return powers;
}

std::vector<kerf::Point> KnowledgeBase::points_of(std::int64_t power) const {
  SqlStatement rows = file_.prepare(
      "SELECT speed_um_min, kerf_nm FROM point WHERE power = ? ORDER BY speed_um_min");
  rows.bind(power);
  std::vector<kerf::Point> points;
  while (rows.next()) points.push_back({rows.small(0), rows.small(1)});
  return points;
}

MaterialRecord KnowledgeBase::record_of(std::string_view material,
                                        std::optional<kerf::HeatUnit> unit) const {
  std::string names;
  std::vector<std::string> materials;
  for (const MaterialRecord& record : records()) {
    if (record.name == material && (!unit || record.unit == *unit)) return record;
    if (record.name != material) materials.push_back(record.name);
    names += fmt::format("{}{} ({})", names.empty() ? "" : ", ", record.name, name_of(record.unit));
  }
  throw std::invalid_argument(
      fmt::format("{}: no record of `{}`{}; there are {}{}",
                  file_.name() == ":memory:" ? "shipped records" : file_.name(),
                  material,
                  unit ? fmt::format(" with Q in {}", name_of(*unit)) : "",
                  names,
                  did_you_mean(std::string{material}, materials)));
}

}  // namespace sim
