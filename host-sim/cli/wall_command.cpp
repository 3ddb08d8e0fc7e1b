#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/cli/commands.hpp"
#include "host-sim/cli/input_files.hpp"
#include "host-sim/cli/wall_carving.hpp"
#include "host-sim/cli/wall_job.hpp"
#include "host-sim/cli/wall_joints.hpp"
#include "host-sim/cli/wall_options.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/surface/read_surface.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"
#include "host-sim/wall/beam_text.hpp"
#include "host-sim/wall/solid_check.hpp"

namespace sim {
namespace {

constexpr const char* kWallFooter =
    "FILE is a closed STL or PLY mesh. A focused beam is a cone: near an upright wall it has to\n"
    "lean away by its half angle, or it burns the wall above the tip. --at lists tips of the "
    "beam.\n"
    "For each tip, the axis of least tilt is found on which the cone clears the part. A tip "
    "within\n"
    "1 um of a face touches the face, and a tip deeper in the part is out of reach.\n"
    "\n"
    "--layer cuts the part from a stock, which is the part's box, layer by layer from the top:\n"
    "hatch lines over the area that the part leaves free as seen from above, then a line along "
    "its\n"
    "walls. The program contains tips and rotary axes under G43.4, and the beam's axis rotates at\n"
    "most by --turn-rate.\n"
    "\n"
    "Examples:\n"
    "  kerfline wall part.stl --half-angle 7 --layer 0.01 --hatch 0.02 --hatch-turn 67 --power 20 "
    "\\\n"
    "    --feed 900 -o part.nc\n"
    "  kerfline wall part.stl --half-angle 7 --max-tilt 30 --at tips.txt -o beams.txt\n"
    "\n"
    "Exit status: 0 fine, 1 a tip is out of reach, 2 the call or FILE is wrong.";

void write_text(const WallOptions& options, const std::string& text) {
  if (options.output.empty()) {
    terminal::write_data(text);
  } else {
    write_file(options.output, text);
  }
}

ExitStatus write_beams(const WallOptions& options, const surface::Mesh& part) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  const wall::Obstacles obstacles{part};
  const wall::BeamList beams = wall::leaning_beams(
      obstacles,
      {.half_angle_rad = options.clear_deg() * kDegree, .max_rad = options.max_tilt_deg * kDegree},
      InputFiles::read(options.at),
      options.at);
  write_text(options, beams.text);
  terminal::print(stderr,
                  "{}: {} facets, greatest tilt {:.3f} degrees, {} tips out of reach\n",
                  options.file,
                  obstacles.count(),
                  beams.max_tilt_rad / kDegree,
                  beams.out_of_reach);
  return beams.out_of_reach == 0 ? ExitStatus::kFine : ExitStatus::kFaults;
}

ExitStatus run_part(const WallOptions& options) {
  InputFiles inputs{options.output};
  const std::string bytes = read_bytes(options.file);
  inputs.add("part", options.file, bytes);
  const surface::SurfaceInput part = surface::read_surface(bytes, options.file, options.reading);
  for (const std::string& note : part.notes) terminal::print(stderr, "{}\n", note);
  wall::require_solid(part.mesh, options.file);
  return options.job.wants_layers() ? write_wall_job(options, part.mesh, inputs)
                                    : write_beams(options, part.mesh);
}

ExitStatus run_wall(const WallOptions& options) {
  if (options.cones.empty()) {
    check_wall_options(options);
    return run_part(options);
  }
  if (!options.file.empty() || !options.at.empty()) {
    throw std::invalid_argument(
        "--cones: gives its own triangles and excludes FILE and --at; leave them out");
  }
  write_text(options, wall::cone_answers(InputFiles::read(options.cones), options.cones));
  return ExitStatus::kFine;
}

}  // namespace

void add_wall_command(CLI::App& app, ExitStatus& status) {
  CLI::App* command =
      app.add_subcommand("wall", "Lean a laser's beam so that it cuts upright walls.");
  command->footer(kWallFooter);
  const auto options = std::make_shared<WallOptions>();
  add_wall_options(*command, *options);
  add_wall_carving_commands(*command, status);
  add_wall_joints_command(*command, status);
  command->callback([options, command, &status] {
    if (command->get_subcommands().empty()) status = run_wall(*options);
  });
}

}  // namespace sim
