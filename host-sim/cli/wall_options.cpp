#include "host-sim/cli/wall_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <stdexcept>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/wall/carve/taper.hpp"

namespace sim {
namespace {

/// Adds an option for a number within a range.
CLI::Option* add_number(CLI::App& command,
                        const char* name,
                        double& value,
                        const CLI::Validator& range,
                        const char* type,
                        const char* help) {
  return command.add_option(name, value, help)->check(range)->type_name(type);
}

void add_beam_options(CLI::App& command, WallOptions& options) {
  add_number(command,
             "--half-angle",
             options.half_angle_deg,
             in_range(0.5, 80.0, "degrees"),
             "DEG",
             "Angle between the axis and the side of the beam, degrees");
  add_number(command,
             "--margin-angle",
             options.margin_deg,
             in_range(0.0, 45.0, "degrees"),
             "DEG",
             "Angle beyond the side of the beam that stays clear of the part, degrees")
      ->capture_default_str();
  add_number(command,
             "--taper-gain",
             options.taper_gain,
             in_range(0.0, wall::kMaxTaperGain, ""),
             "GAIN",
             "Additional lean of the beam against the lean of walls by heat, in half angles; see "
             "`wall taper`")
      ->capture_default_str();
  add_number(command,
             "--max-tilt",
             options.max_tilt_deg,
             in_range(0.0, 89.0, "degrees"),
             "DEG",
             "Greatest tilt that the machine permits, degrees")
      ->capture_default_str();
}

void add_layer_options(CLI::App& command, WallJobOptions& job) {
  const CLI::Validator length = in_range(1.0e-4, 1.0e3, "mm");
  const CLI::Validator margin = in_range(0.0, 1.0e3, "mm");
  add_number(command,
             "--layer",
             job.layers.layer_mm,
             length,
             "MM",
             "Depth of a layer, mm; with this option the program that cuts the part from a stock "
             "is written");
  add_number(command,
             "--depth",
             job.layers.depth_mm,
             length,
             "MM",
             "Depth of the last layer below the top of the stock, mm; default: that of the part");
  add_number(command,
             "--stock-margin",
             job.layers.margin_mm,
             margin,
             "MM",
             "Distance by which the stock extends beyond the part on every side, mm")
      ->capture_default_str();
  command
      .add_option(
          "--stock-top", job.stock_top_mm, "Z of the stock's top, mm; default: that of the part")
      ->check(in_range(-1.0e4, 1.0e4, "mm"))
      ->type_name("Z");
  add_number(command,
             "--hatch",
             job.strokes.hatch_mm,
             length,
             "MM",
             "Distance between hatch lines, mm; default: only walls are cut");
  add_number(command,
             "--hatch-angle",
             job.strokes.angle_deg,
             in_range(-360.0, 360.0, "degrees"),
             "DEG",
             "Direction of the first layer's lines from X, degrees")
      ->capture_default_str();
  add_number(command,
             "--hatch-turn",
             job.strokes.turn_deg,
             in_range(-360.0, 360.0, "degrees"),
             "DEG",
             "Angle by which the lines rotate from layer to layer, degrees")
      ->capture_default_str();
  command.add_flag("--no-contour", job.without_contour, "Omit the lines along walls");
  add_number(command,
             "--waist",
             job.strokes.waist_mm,
             in_range(0.0, 10.0, "mm"),
             "MM",
             "Radius of the beam at its tip, mm; the tip keeps this distance from walls")
      ->capture_default_str();
}

void add_turn_options(CLI::App& command, WallJobOptions& job) {
  static const std::map<std::string, wall::RotaryAxes> kAxes{{"AC", wall::RotaryAxes::kAC},
                                                             {"BC", wall::RotaryAxes::kBC}};
  static const std::map<std::string, bool> kAvoid{{"all", true}, {"none", false}};
  command.add_option("--axes", job.axes, "Rotary axes of the machine")
      ->transform(CLI::CheckedTransformer(kAxes))
      ->option_text("AC|BC [AC]");
  command
      .add_option("--avoid",
                  job.avoids,
                  "Walls that beams avoid; with none all beams are upright and burn walls")
      ->transform(CLI::CheckedTransformer(kAvoid))
      ->option_text("all|none [all]");
  command.add_flag("--allow-lean",
                   job.allows_lean,
                   "Burn tips that are out of reach, with the beam that enters the part least");
  add_number(command,
             "--turn-rate",
             job.turn_rate_deg_per_mm,
             in_range(0.1, 1.0e5, "degrees/mm"),
             "DEG/MM",
             "Greatest rotation of the beam's axis along the path of the tip, degrees/mm")
      ->capture_default_str();
  add_number(command,
             "--swing",
             job.swing_deg,
             in_range(0.0, 180.0, "degrees"),
             "DEG",
             "Greatest jump of the beam's axis at a corner where the beam stays on and the axis "
             "turns before\nand after the corner, degrees; at a greater jump the axis swings with "
             "the beam off")
      ->capture_default_str();
  add_number(command,
             "--step",
             job.step_mm,
             in_range(0.005, 100.0, "mm"),
             "MM",
             "Greatest distance between tips along a wall, mm")
      ->capture_default_str();
}

void add_burn_options(CLI::App& command, WallJobOptions& job) {
  const CLI::Validator watts = in_range(0.001, 1.0e5, "W");
  add_number(command, "--power", job.power_w, watts, "W", "Power of the beam, W");
  add_number(command,
             "--full-power",
             job.full_power_w,
             watts,
             "W",
             "Power of the laser at S1000, W; default: that of --power");
  add_number(command,
             "--feed",
             job.feed_mm_min,
             in_range(0.1, 1.0e6, "mm/min"),
             "MM/MIN",
             "Feed of the tip over the part, mm/min");
  command.add_flag("--constant-power",
                   job.constant_power,
                   "Use M3 instead of M4: power does not follow the speed");
  mark_file(command
                .add_option("--record",
                            job.record,
                            "File of measured depths of passes, JSON: a layer is as deep as a pass "
                            "with this power\nand feed")
                ->type_name("FILE"),
            FileRole::kInput);
  add_number(command,
             "--safe",
             job.safe_above_mm,
             in_range(0.0, 1.0e3, "mm"),
             "MM",
             "Height above the stock at begin and end of the program, mm")
      ->capture_default_str();
  command.add_option("--decimals", job.decimals, "Decimals of X, Y and Z")
      ->check(in_whole_range(3, 6))
      ->capture_default_str();
  mark_file(
      command.add_option("--beams", job.beams, "Write `x y z i j k` of all beams in order, mm")
          ->type_name("FILE"),
      FileRole::kOutput);
  mark_file(command.add_option("--report", job.report, "Write the figures of the program as JSON")
                ->type_name("FILE"),
            FileRole::kOutput);
}

/// Checks the options of a program. Throws std::invalid_argument if one is missing.
void check_job_options(const WallOptions& options) {
  const WallJobOptions& job = options.job;
  if (!options.at.empty()) {
    throw std::invalid_argument(
        "--at: gives the tips and excludes --layer and --record; leave one out");
  }
  if (job.layers.layer_mm > 0.0 && !job.record.empty()) {
    throw std::invalid_argument(
        "--record: the depth of a layer is given by --layer already; leave one out");
  }
  if (job.power_w == 0.0) throw std::invalid_argument("--power is missing; give it in W");
  if (job.feed_mm_min == 0.0) throw std::invalid_argument("--feed is missing; give it in mm/min");
  if (job.full_power_w > 0.0 && job.power_w > job.full_power_w) {
    throw std::invalid_argument(fmt::format(
        "--power: {:g} W exceeds the {:g} W of --full-power", job.power_w, job.full_power_w));
  }
  if (job.strokes.hatch_mm == 0.0 && job.without_contour) {
    throw std::invalid_argument("--no-contour: without --hatch nothing is cut; add --hatch");
  }
  if (job.avoids && options.max_tilt_deg < options.clear_deg()) {
    throw std::invalid_argument(
        fmt::format("--max-tilt: {:g} degrees do not clear an upright wall, which requires {:g}; "
                    "increase it or use --avoid none",
                    options.max_tilt_deg,
                    options.clear_deg()));
  }
}

}  // namespace

void add_wall_options(CLI::App& command, WallOptions& options) {
  mark_file(command.add_option("FILE", options.file, "A closed mesh; - is standard input"),
            FileRole::kInput);
  command
      .add_option(
          "--unit", options.reading.unit_mm, "Length of the file's unit, mm: 25.4 is inches")
      ->check(in_range(1.0e-6, 1.0e6, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  add_beam_options(command, options);
  add_layer_options(command, options.job);
  add_turn_options(command, options.job);
  add_burn_options(command, options.job);
  mark_file(command
                .add_option("--at",
                            options.at,
                            "File of tips, `X Y Z` in mm on each line: write `x y z i j k`, the "
                            "tip and the axis of\nits beam")
                ->type_name("FILE"),
            FileRole::kInput);
  mark_file(command
                .add_option("--cones",
                            options.cones,
                            "File of beams and triangles, `ox oy oz ax ay az cos2 h` and nine "
                            "coordinates on each\nline: write `hit clearance_mm` in place of beams")
                ->type_name("FILE"),
            FileRole::kInput);
  mark_file(
      command
          .add_option("-o,--output", options.output, "File of the result; default: standard output")
          ->type_name("FILE"),
      FileRole::kOutput);
}

void check_wall_options(const WallOptions& options) {
  if (options.file.empty())
    throw std::invalid_argument("wall: FILE is missing; give a closed mesh");
  if (options.at.empty() && !options.job.wants_layers()) {
    throw std::invalid_argument(
        "--at is missing; give the tips of the beam, or --layer for a program");
  }
  if (options.half_angle_deg == 0.0) {
    throw std::invalid_argument("--half-angle is missing; give it in degrees");
  }
  if (options.clear_deg() > 85.0) {
    throw std::invalid_argument(fmt::format(
        "--margin-angle: {:g} degrees with a half angle of {:g} leave no beam; choose less",
        options.clear_deg() - options.half_angle_deg,
        options.half_angle_deg));
  }
  if (options.job.wants_layers()) {
    check_job_options(options);
  } else if (!options.job.beams.empty() || !options.job.report.empty()) {
    throw std::invalid_argument(
        "--beams and --report: describe the program of layers; add --layer");
  }
}

}  // namespace sim
