#include "host-sim/report/report_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>

#include "firmware/protocol/identity.hpp"
#include "host-sim/report/stock_text.hpp"
#include "host-sim/report/utf8.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using Json = nlohmann::ordered_json;

/// Returns an object with one value for each axis from the axis `first` on.
template <typename Value>
Json per_axis(const Report& report, Value value_of, std::size_t first = 0) {
  Json object = Json::object();
  for (std::size_t axis = first; axis < cnc::kAxisCount; ++axis) {
    object[std::string{cnc::kAxisLetters[axis]}] = value_of(report.axes[axis]);
  }
  return object;
}

Json fault_json(const Fault& fault) {
  return {{"file", fault.file},
          {"line", fault.line},
          {"column", fault.column},
          {"number", fault.number},
          {"message", fault.message}};
}

Json faults_of(const Report& report) {
  Json faults = Json::array();
  for (const Fault& fault : report.faults) faults.push_back(fault_json(fault));
  return faults;
}

double speed_s(const AxisReport& axis) { return axis.max_speed_mm_s; }
double speed_min(const AxisReport& axis) { return 60.0 * axis.max_speed_mm_s; }
double acceleration(const AxisReport& axis) { return axis.max_acceleration_mm_s2; }
double jerk(const AxisReport& axis) { return axis.max_jerk_mm_s3; }
Json bounds(const AxisReport& axis) { return Json::array({axis.min_mm, axis.greatest_mm}); }

void add_axes(Json& json, const Report& report) {
  json["max_speed_mm_s"] = per_axis(report, speed_s);
  json["max_speed_mm_min"] = per_axis(report, speed_min);
  json["max_acceleration_mm_s2"] = per_axis(report, acceleration);
  json["max_jerk_mm_s3"] = per_axis(report, jerk);
  json["bounds_mm"] = per_axis(report, bounds);
  json["steps"] = per_axis(report, [](auto& axis) { return axis.steps; });
  constexpr std::size_t kFirstRotary = cnc::kLinearAxisCount;
  json["max_speed_deg_s"] = per_axis(report, speed_s, kFirstRotary);
  json["max_speed_deg_min"] = per_axis(report, speed_min, kFirstRotary);
  json["max_acceleration_deg_s2"] = per_axis(report, acceleration, kFirstRotary);
  json["max_jerk_deg_s3"] = per_axis(report, jerk, kFirstRotary);
  json["bounds_deg"] = per_axis(report, bounds, kFirstRotary);
  json["measuring_error"] = {
      {"max_speed", per_axis(report, [](auto& axis) { return axis.speed_error_mm_s; })},
      {"max_acceleration",
       per_axis(report, [](auto& axis) { return axis.acceleration_error_mm_s2; })},
      {"max_jerk", per_axis(report, [](auto& axis) { return axis.jerk_error_mm_s3; })},
      {"bounds", per_axis(report, [](auto& axis) { return axis.bounds_error_mm; })}};
}

/// Rounds all numbers to six decimals. These are a nanometre and a microsecond, far below the error
/// of any figure. A report has only a few nested levels. NOLINTNEXTLINE(misc-no-recursion)
void round_numbers(Json& json) {
  constexpr double kPerUnit = 1.0e6;
  constexpr double kMaxRounded = 1.0e9;  // Greater doubles have no decimals to round.
  if (json.is_number_float()) {
    const double value = json.get<double>();
    if (std::abs(value) < kMaxRounded) json = std::round(value * kPerUnit) / kPerUnit;
  } else if (json.is_structured()) {
    for (Json& element : json) round_numbers(element);
  }
}

/// Returns JSON without bytes that a terminal interprets as commands. The JSON library escapes
/// bytes below a blank, but not DEL and C1.
std::string without_controls(std::string_view json) {
  std::string text;
  while (!json.empty()) {
    const Utf8Character character = first_character(json);
    if (character.code_point >= 0x7F && character.code_point < 0xA0) {
      text += fmt::format("\\u{:04x}", static_cast<std::uint32_t>(character.code_point));
    } else {
      text += json.substr(0, character.bytes);
    }
    json.remove_prefix(character.bytes);
  }
  return text;
}

Json machine_json(const FiveAxisMachine& machine) {
  return {{"kind", machine.kind},
          {"tilting", std::string(1, machine.tilting)},
          {"turning", "C"},
          {"tilt_reversed", machine.tilt_reversed},
          {"turn_reversed", machine.turn_reversed},
          {"tilt_point_mm", machine.tilt_point_mm},
          {"turn_point_mm", machine.turn_point_mm},
          {"least_tilt_deg", machine.min_tilt_deg},
          {"greatest_tilt_deg", machine.greatest_tilt_deg}};
}

}  // namespace

Json to_json(const Report& report) {
  Json json;
  json["job"] = report.job;
  json["version"] = cnc::identity::version();
  json["job_time_s"] = report.job_time_s;
  json["path_length_mm"] = report.path_length_mm;
  json["cut_length_mm"] = report.cut_length_mm;
  json["lines"] = report.lines;
  json["refused_lines"] = report.refused_lines;
  json["blocks"] = report.blocks;
  add_axes(json, report);
  json["max_path_deviation_mm"] = report.max_path_deviation_mm;
  json["max_path_deviation_at_s"] = report.max_path_deviation_at_s;
  json["max_shaping_error_mm"] = report.max_shaping_error_mm;
  json["energy_per_mm_ratio"] = {{"least", report.min_energy_ratio},
                                 {"mean", report.mean_energy_ratio},
                                 {"greatest", report.greatest_energy_ratio}};
  if (report.tip) {
    json["tip"] = {{"least_mm", report.tip->min_mm},
                   {"greatest_mm", report.tip->greatest_mm},
                   {"greatest_tilt_deg", report.tip->greatest_tilt_deg},
                   {"tool_length_mm", report.tip->tool_length_mm},
                   {"machine", machine_json(report.tip->machine)}};
  }
  if (report.stock) json["stock"] = to_json(*report.stock);
  json["warnings"] = report.warnings;
  json["faults"] = faults_of(report);
  return json;
}

std::string dumped(Json json, int indent) {
  round_numbers(json);
  return without_controls(json.dump(indent, ' ', false, Json::error_handler_t::replace));
}

void write_json(const std::string& file, std::span<const Report> reports) {
  Json json = Json::array();
  for (const Report& report : reports) json.push_back(to_json(report));
  if (reports.size() == 1) json = Json(json.front());
  write_file(file, dumped(std::move(json)) + "\n");
}

}  // namespace sim
