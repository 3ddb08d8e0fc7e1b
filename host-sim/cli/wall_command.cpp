#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/input_files.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/cli/wall_carving.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/surface/read_surface.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"
#include "host-sim/wall/beam_text.hpp"
#include "host-sim/wall/carve/taper.hpp"
#include "host-sim/wall/solid_check.hpp"

namespace sim {
namespace {

constexpr const char* kWallFooter =
    "FILE is a closed STL or PLY mesh. A focused beam is a cone: beside an upright wall it has to\n"
    "lean away by its half angle, or it burns the wall above. --at lists tips of the beam, and\n"
    "each gets the axis of least tilt on which the cone clears the whole part; a tip within 1 um\n"
    "of a face touches it, and a tip deeper in the part is out of reach.\n"
    "\n"
    "Example:\n"
    "  kerfline wall part.stl --half-angle 7 --max-tilt 30 --at tips.txt -o beams.txt\n"
    "\n"
    "Exit status: 0 fine, 1 a tip is out of reach, 2 the call or FILE is wrong.";

struct WallOptions {
  std::string file;
  surface::ReadOptions reading;
  double half_angle_deg = 0.0;
  double margin_deg = 0.0;
  double taper_gain = 0.0;
  double max_tilt_deg = 45.0;

  /// Returns the half angle of the cone that is kept clear.
  [[nodiscard]] double clear_deg() const {
    return half_angle_deg * (1.0 + taper_gain) + margin_deg;
  }
  std::string at;
  std::string cones;
  std::string output;
};

void add_wall_options(CLI::App& command, WallOptions& options) {
  mark_file(command.add_option("FILE", options.file, "A closed mesh; - is standard input"),
            FileRole::kInput);
  command
      .add_option(
          "--unit", options.reading.unit_mm, "Length of the file's unit, mm: 25.4 is inches")
      ->check(in_range(1.0e-6, 1.0e6, "mm"))
      ->type_name("MM")
      ->capture_default_str();
  command
      .add_option("--half-angle",
                  options.half_angle_deg,
                  "Between the axis and the side of the beam, degrees")
      ->check(in_range(0.5, 80.0, "degrees"))
      ->type_name("DEG");
  command
      .add_option("--margin-angle",
                  options.margin_deg,
                  "By which the beam stays clear beyond its side, degrees")
      ->check(in_range(0.0, 45.0, "degrees"))
      ->type_name("DEG")
      ->capture_default_str();
  command
      .add_option("--taper-gain",
                  options.taper_gain,
                  "Half angles by which the beam leans more, against the lean by heat: see `wall "
                  "taper`")
      ->check(in_range(0.0, wall::kMostTaperGain, ""))
      ->type_name("GAIN")
      ->capture_default_str();
  command.add_option("--max-tilt", options.max_tilt_deg, "Greatest tilt of the machine, degrees")
      ->check(in_range(0.0, 89.0, "degrees"))
      ->type_name("DEG")
      ->capture_default_str();
  mark_file(command
                .add_option("--at",
                            options.at,
                            "Tips, `X Y Z` in mm on each line: write `x y z i j k`, the tip and "
                            "the axis of its\nbeam")
                ->type_name("FILE"),
            FileRole::kInput);
  mark_file(command
                .add_option("--cones",
                            options.cones,
                            "Beams and triangles, `ox oy oz ax ay az cos2 h` and nine coordinates "
                            "on each line:\nwrite `hit clearance_mm` in place of beams")
                ->type_name("FILE"),
            FileRole::kInput);
  mark_file(
      command.add_option("-o,--output", options.output, "Where to write; else standard output")
          ->type_name("FILE"),
      FileRole::kOutput);
}

void write_text(const WallOptions& options, const std::string& text) {
  if (options.output.empty()) {
    terminal::write_data(text);
  } else {
    write_file(options.output, text);
  }
}

void check_wall_options(const WallOptions& options) {
  if (options.file.empty()) throw std::invalid_argument("wall: needs a FILE, a closed mesh");
  if (options.at.empty()) throw std::invalid_argument("--at: is needed, the tips of the beam");
  if (options.half_angle_deg == 0.0) {
    throw std::invalid_argument("--half-angle: is needed, degrees");
  }
  if (options.clear_deg() > 85.0) {
    throw std::invalid_argument(
        fmt::format("--margin-angle: {:g} degrees beside a half angle of {:g} leave no beam",
                    options.clear_deg() - options.half_angle_deg,
                    options.half_angle_deg));
  }
}

ExitStatus write_beams(const WallOptions& options) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  const surface::SurfaceInput part =
      surface::read_surface(read_bytes(options.file), options.file, options.reading);
  for (const std::string& note : part.notes) terminal::print(stderr, "{}\n", note);
  wall::require_solid(part.mesh, options.file);
  const wall::Obstacles obstacles{part.mesh};
  const wall::BeamList beams = wall::leaning_beams(
      obstacles,
      {.half_angle_rad = options.clear_deg() * kDegree, .most_rad = options.max_tilt_deg * kDegree},
      InputFiles::read(options.at),
      options.at);
  write_text(options, beams.text);
  terminal::print(stderr,
                  "{}: {} facets, greatest tilt {:.3f} degrees, {} tips out of reach\n",
                  options.file,
                  obstacles.count(),
                  beams.most_tilt_rad / kDegree,
                  beams.out_of_reach);
  return beams.out_of_reach == 0 ? ExitStatus::kFine : ExitStatus::kFaults;
}

ExitStatus run_wall(const WallOptions& options) {
  if (options.cones.empty()) {
    check_wall_options(options);
    return write_beams(options);
  }
  if (!options.file.empty() || !options.at.empty()) {
    throw std::invalid_argument("--cones: has triangles of its own, without FILE and --at");
  }
  write_text(options, wall::cone_answers(InputFiles::read(options.cones), options.cones));
  return ExitStatus::kFine;
}

}  // namespace

void add_wall_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command =
      app.add_subcommand("wall", "Lean a laser's beam so that upright walls stay upright.");
  command->footer(kWallFooter);
  const auto options = std::make_shared<WallOptions>();
  add_wall_options(*command, *options);
  add_wall_carving_commands(*command, status);
  command->callback([options, command, &status] {
    if (command->get_subcommands().empty()) status = run_wall(*options);
  });
}

}  // namespace sim
