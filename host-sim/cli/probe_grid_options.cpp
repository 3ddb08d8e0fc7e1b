#include "host-sim/cli/probe_grid_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/surface/number_text.hpp"
#include "host-sim/surface/read_surface.hpp"

namespace sim {
namespace {

using surface::ProbeProgram;

struct Ends {
  double from_mm;
  double to_mm;
};

Ends ends_of(const char* option, const std::string& text) {
  const std::string_view all = text;
  const std::size_t colon = all.find(':');
  const auto from = surface::parsed_number(all.substr(0, colon));
  const auto to = colon == std::string_view::npos ? std::nullopt
                                                  : surface::parsed_number(all.substr(colon + 1));
  if (from && to) return {*from, *to};
  throw std::invalid_argument(
      text.empty() ? fmt::format("probe-grid: {} is missing; give FROM:TO, such as 0:60", option)
                   : fmt::format("{} {}: is not FROM:TO in mm, such as 0:60", option, text));
}

double required(const char* option, const std::optional<double>& value, const char* meaning) {
  if (value) return *value;
  throw std::invalid_argument(fmt::format("probe-grid: {} is missing; give {}", option, meaning));
}

void add_grid_options(CLI::App& command, ProbeGridOptions& options) {
  command
      .add_option("--x", options.x, "X of the first and the last column, mm in work coordinates")
      ->type_name("FROM:TO");
  command.add_option("--y", options.y, "Y of the first and the last row, mm in work coordinates")
      ->type_name("FROM:TO");
  CLI::Option* pitch =
      command
          .add_option("--pitch",
                      options.pitch_mm,
                      "Greatest distance between neighbours, mm; points are spread evenly")
          ->type_name("MM");
  command.add_option("--columns", options.columns, "Number of points along X, in place of --pitch")
      ->type_name("N")
      ->excludes(pitch);
  command.add_option("--rows", options.rows, "Number of points along Y, in place of --pitch")
      ->type_name("N")
      ->excludes(pitch);
}

void add_touch_options(CLI::App& command, ProbeGridOptions& options) {
  const auto add =
      [&](const char* name, std::optional<double>& value, const char* unit, const char* help) {
        command.add_option(name, value, help)->type_name(unit);
      };
  add("--safe", options.safe_mm, "Z", "Z of rapids, above all obstacles, mm");
  add("--depth", options.depth_mm, "Z", "Z down to which the probe searches a point, mm");
  add("--feed", options.feed, "F", "Feed of the touch that is measured, mm/min");
  add("--fast-feed",
      options.fast_feed,
      "F",
      "Feed of a first touch, mm/min, after which the probe rises by --retract; default: no first "
      "touch");
  command
      .add_option("--retract",
                  options.retract_mm,
                  "Height by which the probe rises between both touches, mm")
      ->type_name("MM")
      ->capture_default_str();
  add("--hop",
      options.hop_mm,
      "MM",
      "Height above each contact to which the probe rises, mm: it then moves on with the probe\n"
      "watched, so that a wall stops it; for gentle surfaces. Default: rapids at --safe");
  command.add_option("--travel-feed", options.travel_feed, "Feed of moves with --hop, mm/min")
      ->type_name("F")
      ->capture_default_str();
  add("--tip", options.tip_mm, "MM", "Diameter of the probe's ball, mm; default: 0, a point");
}

void add_read_options(CLI::App& command, ProbeGridOptions& options) {
  mark_file(command
                .add_option("--read",
                            options.read,
                            "Log of a sender with the answers [PRB:…]; - is standard input")
                ->type_name("FILE"),
            FileRole::kInput);
  mark_file(command
                .add_option("--program",
                            options.program,
                            "Program that was run; its heading contains the options of the grid")
                ->type_name("FILE"),
            FileRole::kInput);
  command
      .add_option("--offset",
                  options.offset,
                  "Work zero in machine coordinates, mm; default: as logged in WCO: or [G54:…]")
      ->type_name("X,Y,Z");
  command.add_flag("--inches", options.inches, "Read the log in inches ($13=1)");
  command.add_flag("--gaps",
                   options.gaps,
                   "Write the grid although points are missing, with nan as their height");
}

}  // namespace

void ProbeGridOptions::add_to(CLI::App& command) {
  add_grid_options(command, *this);
  add_touch_options(command, *this);
  add_read_options(command, *this);
  mark_file(
      command
          .add_option(
              "-o,--output", output, "File of the program or the grid; default: standard output")
          ->type_name("FILE"),
      FileRole::kOutput);
}

surface::ProbeGrid ProbeGridOptions::grid() const {
  const Ends along_x = ends_of("--x", x);
  const Ends along_y = ends_of("--y", y);
  surface::ProbeGrid grid;
  if (pitch_mm) {
    grid = {.x = surface::span_of_pitch(along_x.from_mm, along_x.to_mm, *pitch_mm),
            .y = surface::span_of_pitch(along_y.from_mm, along_y.to_mm, *pitch_mm)};
  } else if (columns && rows) {
    grid = {.x = {.from_mm = along_x.from_mm, .to_mm = along_x.to_mm, .count = *columns},
            .y = {.from_mm = along_y.from_mm, .to_mm = along_y.to_mm, .count = *rows}};
  } else {
    throw std::invalid_argument("probe-grid: give --pitch, or --columns and --rows");
  }
  surface::require_probe_grid(grid);
  return grid;
}

ProbeProgram ProbeGridOptions::probe_program() const {
  const ProbeProgram made{
      .grid = grid(),
      .safe_mm = required("--safe", safe_mm, "the height of rapids"),
      .depth_mm = required("--depth", depth_mm, "the height down to which points are searched"),
      .feed = required("--feed", feed, "the speed of the touch, mm/min"),
      .fast_feed = fast_feed.value_or(0.0),
      .retract_mm = retract_mm,
      .hop_mm = hop_mm.value_or(0.0),
      .travel_feed = travel_feed,
      .tip_mm = tip_mm.value_or(0.0)};
  surface::require_probe_program(made);
  return made;
}

std::optional<Eigen::Vector3d> ProbeGridOptions::work_zero() const {
  if (offset.empty()) return {};
  Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  std::string_view rest = offset;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const std::size_t comma = axis < 2 ? rest.find(',') : rest.size();
    const auto value = comma == std::string_view::npos
                           ? std::nullopt
                           : surface::parsed_number(rest.substr(0, comma));
    if (!value || !(std::abs(*value) <= surface::kFarthestMm)) {
      throw std::invalid_argument(fmt::format("--offset {}: is not X,Y,Z in mm", offset));
    }
    zero[axis] = *value;
    if (axis < 2) rest.remove_prefix(comma + 1);
  }
  return zero;
}

}  // namespace sim
