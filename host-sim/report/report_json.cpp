#include "host-sim/report/report_json.hpp"

#include <nlohmann/json.hpp>

#include "firmware/protocol/identity.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using Json = nlohmann::ordered_json;

/// An object with one value for each axis letter.
template <typename Value>
Json per_axis(const Report& report, Value value_of) {
  Json object = Json::object();
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    object[std::string{cnc::kAxisLetters[axis]}] = value_of(report.axes[axis]);
  }
  return object;
}

Json to_json(const Fault& fault) {
  return {{"file", fault.file},
          {"line", fault.line},
          {"column", fault.column},
          {"number", fault.number},
          {"message", fault.message}};
}

Json faults_of(const Report& report) {
  Json faults = Json::array();
  for (const Fault& fault : report.faults) faults.push_back(to_json(fault));
  return faults;
}

void add_axes(Json& json, const Report& report) {
  json["max_speed_mm_s"] = per_axis(report, [](auto& axis) { return axis.max_speed_mm_s; });
  json["max_speed_mm_min"] =
      per_axis(report, [](auto& axis) { return 60.0 * axis.max_speed_mm_s; });
  json["max_acceleration_mm_s2"] =
      per_axis(report, [](auto& axis) { return axis.max_acceleration_mm_s2; });
  json["max_jerk_mm_s3"] = per_axis(report, [](auto& axis) { return axis.max_jerk_mm_s3; });
  json["bounds_mm"] = per_axis(report, [](auto& axis) {
    return Json::array({axis.least_mm, axis.greatest_mm});
  });
  json["steps"] = per_axis(report, [](auto& axis) { return axis.steps; });
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
  json["energy_per_mm_ratio"] = {{"least", report.least_energy_ratio},
                                 {"mean", report.mean_energy_ratio},
                                 {"greatest", report.greatest_energy_ratio}};
  json["warnings"] = report.warnings;
  json["faults"] = faults_of(report);
  return json;
}

void write_json(const std::string& file, std::span<const Report> reports) {
  Json json = Json::array();
  for (const Report& report : reports) json.push_back(to_json(report));
  if (reports.size() == 1) json = Json(json.front());
  write_file(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace sim
