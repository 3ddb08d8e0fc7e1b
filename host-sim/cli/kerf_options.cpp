#include "host-sim/cli/kerf_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/job/setting_line.hpp"
#include "host-sim/knowledge/experiment_csv.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/report/text_table.hpp"
#include "host-sim/trace/input_file.hpp"

namespace sim {
namespace {

constexpr const char* kPrinted = "printed";
constexpr const char* kJoules = "J/mm";

constexpr double kMaxThicknessMm = from_thousandths(cnc::kerf::kMaxThicknessUm);
constexpr double kMaxPowerW = from_thousandths(cnc::kerf::kMaxPowerMw);
constexpr double kMaxSpeedMmMin = from_thousandths(cnc::kerf::kMaxSpeedUmMin);

std::string law_text(const ThicknessRecord& row) {
  if (row.measured) return "measured";
  return fmt::format("{:.6g} Q + {:.4f}", row.slope, row.intercept);
}

/// Checks that the cuts name their laser, because a record without it could be of any machine.
void require_named_laser(const std::vector<Experiment>& cuts, const std::string& file) {
  for (const Experiment& cut : cuts) {
    if (!cut.laser.empty()) continue;
    throw std::invalid_argument(
        fmt::format("{}:{}: column laser is empty; name the laser of these cuts with --laser NAME",
                    file,
                    cut.line));
  }
}

}  // namespace

void add_unit_option(CLI::App& command, std::string& unit) {
  command
      .add_option(
          "--unit",
          unit,
          "Unit of the heat input Q = P / V: `printed`, W/(mm/min), or `J/mm`; default: printed")
      ->check(CLI::IsMember({kPrinted, kJoules}));
}

std::optional<cnc::kerf::HeatUnit> unit_of(const std::string& option) {
  if (option.empty()) return std::nullopt;
  return option == kJoules ? cnc::kerf::HeatUnit::kJoulesPerMillimetre
                           : cnc::kerf::HeatUnit::kWattMinutesPerMillimetre;
}

void RecordOptions::add_to(CLI::App& command) {
  mark_file(
      command
          .add_option("--db", data_base, "Data base of kerf records; default: the shipped records")
          ->type_name("FILE"),
      FileRole::kKept);
  command
      .add_option(
          "--material", material, "Name of the material in the data base, such as \"CSP 1N\"")
      ->type_name("NAME");
  add_unit_option(command, unit);
}

KnowledgeBase RecordOptions::open(SqlFile::Mode mode) const {
  if (data_base.empty()) return KnowledgeBase::shipped();
  return {data_base, mode};
}

std::optional<cnc::kerf::HeatUnit> RecordOptions::heat_unit() const { return unit_of(unit); }

CLI::Validator day_of_calendar() {
  return {[](const std::string& text) {
            return is_date(text) ? "" : fmt::format("`{}` is no day; write it as 2026-11-30", text);
          },
          ""};
}

void PersonOptions::add_to(CLI::App& command) {
  command.add_option("--by", by, "Name of the person who measured")->type_name("NAME");
  command.add_option("--on", on, "Day of the measurement")
      ->check(day_of_calendar())
      ->type_name("YYYY-MM-DD");
}

void CutOptions::add_to(CLI::App& command) {
  mark_file(
      command
          .add_option(
              "--db", data_base, "Data base of kerf records; it is created if it does not exist")
          ->required()
          ->type_name("FILE"),
      FileRole::kKept);
  command
      .add_option(
          "--max-dross", limits.dross_area_mm2, "Greatest mean dross area of an accepted cut, mm2")
      ->check(in_range(0.0, 1.0e6, "mm2"))
      ->capture_default_str();
  command
      .add_option("--max-straightness",
                  limits.straightness_mm,
                  "Greatest straightness error of an accepted cut, mm")
      ->check(in_range(0.0, 1000.0, "mm"))
      ->capture_default_str();
  command.add_option("--laser", laser, "Name of the laser for cuts whose file does not name one")
      ->type_name("NAME");
  person.add_to(command);
}

std::vector<Experiment> add_cuts(const std::string& file, const CutOptions& options) {
  const std::string text = read_text(file);
  ExperimentFile found = read_experiment_file(text, name_of_input(file), options.laser);
  std::vector<Experiment>& cuts = found.cuts;
  for (Experiment& cut : cuts) {
    cut.rejection = rejection_of(cut, options.limits);
    cut.measured_by = options.person.by;
    cut.measured_on = options.person.on;
  }
  if (options.asks_for_laser) require_named_laser(cuts, name_of_input(file));
  KnowledgeBase base{options.data_base, SqlFile::Mode::kCreate};
  base.add(cuts, file, text);
  const auto accepted =
      std::count_if(cuts.begin(), cuts.end(), [](const Experiment& cut) { return cut.accepted(); });
  terminal::print("{}: {} cuts, {} accepted{}\n",
                  file,
                  cuts.size(),
                  accepted,
                  found.unmeasured == 0
                      ? ""
                      : fmt::format(", {} lines without a measurement left out", found.unmeasured));
  for (const Experiment& cut : cuts) {
    if (!cut.accepted())
      terminal::print("{}:{}: rejected: {}\n", cut.file, cut.line, cut.rejection);
  }
  return std::move(cuts);
}

std::uint32_t thousandths_of(const char* option, double value, double most, const char* unit) {
  if (!std::isfinite(value)) {
    throw std::invalid_argument(
        fmt::format("{} {}: not a number; 0 to {:g} {}", option, value, most, unit));
  }
  if (value < 0.0 || value > most) {
    throw std::invalid_argument(
        fmt::format("{} {:g}: out of range, 0 to {:g} {}", option, value, most, unit));
  }
  return to_thousandths(value);
}

CLI::Validator thickness_range() { return in_range(0.0, kMaxThicknessMm, "mm"); }
CLI::Validator power_range() { return in_range(0.0, kMaxPowerW, "W"); }
CLI::Validator speed_range() { return in_range(0.0, kMaxSpeedMmMin, "mm/min"); }

std::uint32_t thickness_option(double mm) {
  return thousandths_of("--thickness", mm, kMaxThicknessMm, "mm");
}
std::uint32_t power_option(double watts) {
  return thousandths_of("--power", watts, kMaxPowerW, "W");
}
std::uint32_t speed_option(double mm_min) {
  return thousandths_of("--speed", mm_min, kMaxSpeedMmMin, "mm/min");
}

namespace {

void print_operations(const MaterialRecord& record) {
  TextTable table{
      {{"T mm"}, {"kind"}, {"power %"}, {"mm/min"}, {"passes"}, {"kerf mm"}, {"entry"}}};
  const auto known = [](const auto& value) {
    return value ? fmt::format("{:g}", 1.0 * *value) : "?";
  };
  for (const OperationRecord& one : record.operations) {
    std::optional<double> thickness;
    std::optional<double> speed;
    if (one.thickness_um) thickness = from_thousandths(*one.thickness_um);
    if (one.speed_um_min) speed = from_thousandths(*one.speed_um_min);
    table.add_row(
        {known(thickness),
         one.kind,
         known(one.power_percent),
         known(speed),
         known(one.passes),
         known(one.kerf_mm),
         fmt::format(
             "{}{}{}", one.description, one.description.empty() ? "" : "; ", text_of(one.origin))});
  }
  terminal::print_lines(stdout, table.text(2));
}

}  // namespace

void print_record(const MaterialRecord& record) {
  if (!record.has_kerf()) {
    terminal::print("{}: no law of its kerf\n", record.name);
    return print_operations(record);
  }
  terminal::print("{}: {}, gas {:g} MPa, Q in {}\n  {}{}\n",
                  record.name,
                  record.laser.empty() ? "no laser named" : record.laser,
                  record.gas_pressure_mpa,
                  name_of(record.unit),
                  record.calibrated ? "" : "not calibrated on this machine; ",
                  record.provenance);
  TextTable laws{{{"T mm"}, {"kerf mm"}, {"r"}, {"residual mm"}, {"greatest mm"}, {"cuts"}}};
  TextTable region{{{"T mm"}, {"P W"}, {"V least mm/min"}, {"greatest"}, {"kerf mm"}, {"to mm"}}};
  for (const ThicknessRecord& row : record.thicknesses) {
    const std::string thickness = fmt::format("{:g}", from_thousandths(row.thickness_um));
    laws.add_row({thickness,
                  law_text(row),
                  fmt::format("{:.2f}", row.correlation),
                  fmt::format("{:.4f}", row.residual_sd_mm),
                  fmt::format("{:.4f}", row.greatest_residual_mm),
                  row.samples == 0 ? "?" : fmt::format("{}", row.samples)});
    for (const PowerRecord& power : row.powers) {
      const auto kerf_at = [&](std::uint32_t speed) {
        const auto found = predict(record, {row.thickness_um, power.power_mw, speed});
        return fmt::format("{:.4f}", found.value().kerf_mm);
      };
      region.add_row({thickness,
                      fmt::format("{:g}", from_thousandths(power.power_mw)),
                      fmt::format("{:g}", from_thousandths(power.speeds_um_min.least)),
                      fmt::format("{:g}", from_thousandths(power.speeds_um_min.most)),
                      kerf_at(power.speeds_um_min.least),
                      kerf_at(power.speeds_um_min.most)});
    }
  }
  terminal::print_lines(stdout, laws.text(2) + region.text(2));
  if (!record.operations.empty()) print_operations(record);
}

}  // namespace sim
