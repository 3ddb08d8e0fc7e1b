#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/probe_grid_options.hpp"
#include "host-sim/cli/surface_commands.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/surface/probe_log.hpp"
#include "host-sim/surface/probe_program.hpp"
#include "host-sim/surface/probe_rows.hpp"
#include "host-sim/surface/probe_tip.hpp"
#include "host-sim/surface/probed_points.hpp"
#include "host-sim/trace/input_file.hpp"
#include "host-sim/trace/output_file.hpp"

namespace sim {
namespace {

using surface::ProbedPoints;
using surface::ProbeHeading;
using surface::ProbeLog;

constexpr double kInchMm = 25.4;
constexpr std::size_t kMaxListed = 20;

constexpr const char* kProbeGridFooter =
    "Examples:\n"
    "  kerfline surface probe-grid --x 0:60 --y 0:40 --pitch 2 --safe 5 --depth -8 --feed 60 "
    "--fast-feed 300 --tip 2 -o probe.nc\n"
    "  kerfline surface probe-grid --read sender.log --program probe.nc -o grid.xyz\n"
    "  kerfline sim probe.nc --probe-surface part.stl --probe-tip 2 --answers sender.log\n"
    "\n"
    "The program probes each point by G38.3: a point without contact is reported, and the program\n"
    "continues. The rows run along X as a serpentine from the least X and Y. Before running the\n"
    "program, set the work zero with the lowest point of the tip as the tool.\n"
    "\n"
    "The grid contains the points of touch: the position of the ball's lowest point, moved along\n"
    "the ball by the normal that neighbours give. No point is below the surface by more than a\n"
    "step; points are above it where the surface bends much within a pitch. With --tip 0 the grid\n"
    "contains the heights of the tip.\n"
    "\n"
    "Exit status: 0 fine, 1 points are missing, and nothing is written without --gaps, 2 the call\n"
    "is wrong.";

/// Prints the first kMaxListed lines, and the number of lines after these.
void list(const std::vector<std::string>& lines) {
  for (std::size_t i = 0; i < std::min(lines.size(), kMaxListed); ++i) {
    terminal::print(stderr, "{}\n", lines[i]);
  }
  if (lines.size() > kMaxListed) {
    terminal::print(stderr, "and {} more\n", lines.size() - kMaxListed);
  }
}

void write(const std::string& output, const std::string& text) {
  if (output.empty()) return terminal::write_data(text);
  write_file(output, text);
}

ExitStatus write_program(const ProbeGridOptions& options) {
  if (!options.program.empty() || !options.offset.empty() || options.inches || options.gaps) {
    throw std::invalid_argument(
        "probe-grid: --program, --offset, --inches and --gaps require --read; give it");
  }
  const surface::ProbeProgram program = options.probe_program();
  list(surface::warnings_of(program));
  write(options.output, surface::text_of_probe_program(program));
  terminal::print(stderr,
                  "{} points in {} rows of {}, {:g} mm apart in X and {:g} mm in Y\n",
                  program.grid.size(),
                  program.grid.y.count,
                  program.grid.x.count,
                  program.grid.x.pitch_mm(),
                  program.grid.y.pitch_mm());
  return ExitStatus::kFine;
}

/// Returns the plan of the probing from the program's heading or the options, and sets the tip.
surface::ProbePlan plan_of(const ProbeGridOptions& options, double& tip_mm) {
  if (options.program.empty()) {
    tip_mm = options.tip_mm.value_or(0.0);
    return {.grid = options.grid(),
            .depth_mm = options.depth_mm,
            .touches = options.fast_feed.value_or(0.0) > 0.0 ? 2U : 1U,
            .has_guards = options.hop_mm.value_or(0.0) > 0.0};
  }
  const bool has_grid = !options.x.empty() || !options.y.empty() || options.pitch_mm ||
                        options.columns || options.rows || options.depth_mm || options.fast_feed ||
                        options.hop_mm;
  if (has_grid) {
    throw std::invalid_argument(
        "probe-grid: the grid is given by --program; leave out the options of the grid");
  }
  const ProbeHeading heading =
      surface::read_probe_heading(read_text(options.program), name_of_input(options.program));
  tip_mm = options.tip_mm.value_or(heading.tip_mm);
  return {.grid = heading.grid,
          .depth_mm = heading.depth_mm,
          .touches = heading.touches,
          .has_guards = heading.has_guards};
}

Eigen::Vector3d zero_of(const ProbeGridOptions& options, const ProbeLog& log) {
  if (const auto zero = options.work_zero()) return *zero;
  const std::string name = name_of_input(options.read);
  if (log.changed_line > 0) {
    throw std::invalid_argument(fmt::format(
        "{}:{}: the work offset changes among the answers; give the valid one with --offset",
        name,
        log.changed_line));
  }
  if (log.offset) return *log.offset;
  terminal::print(stderr,
                  "{}: has no work offset; X, Y and Z are read as machine coordinates unless "
                  "--offset is given\n",
                  name);
  return Eigen::Vector3d::Zero();
}

std::vector<std::string> heading_of(const surface::ProbePlan& plan, double tip_mm) {
  const std::string points = tip_mm > 0.0
                                 ? fmt::format("points of touch of a ball of {:g} mm", tip_mm)
                                 : std::string{"heights of the tip"};
  return {fmt::format("kerfline surface probe-grid: {} rows of {} points",
                      plan.grid.y.count,
                      plan.grid.x.count),
          fmt::format("{}, mm in work coordinates", points),
          fmt::format("work zero in machine coordinates: {:.4f} {:.4f} {:.4f}",
                      plan.offset.x(),
                      plan.offset.y(),
                      plan.offset.z())};
}

/// Prints the number of points, and their heights.
void print_summary(const std::vector<Eigen::Vector3d>& points, std::size_t faults) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const Eigen::Vector3d& point : points) {
    if (std::isnan(point.z())) continue;
    least = std::min(least, point.z());
    most = std::max(most, point.z());
  }
  terminal::print(stderr,
                  "{} of {} points, Z {:.3f} to {:.3f}\n",
                  points.size() - faults,
                  points.size(),
                  least,
                  most);
}

ExitStatus read_answers(const ProbeGridOptions& options) {
  double tip_mm = 0.0;
  surface::ProbePlan plan = plan_of(options, tip_mm);
  if (!(tip_mm >= 0.0 && std::isfinite(tip_mm))) {
    throw std::invalid_argument(fmt::format("--tip {:g}: must be at least 0 mm", tip_mm));
  }
  const ProbeLog log =
      surface::read_probe_log(read_text(options.read), options.inches ? kInchMm : 1.0);
  plan.offset = zero_of(options, log);
  const ProbedPoints probed = surface::probed_points(log, plan, name_of_input(options.read));
  list(probed.notes);
  list(probed.faults);
  const bool has_any = probed.faults.size() < probed.points.size();
  if (!probed.faults.empty() && !(options.gaps && has_any)) {
    terminal::print(
        stderr,
        "{} of {} points are missing, and nothing is written{}; probe them, or add --gaps\n",
        probed.faults.size(),
        probed.points.size(),
        stale_note(options.output));
    return ExitStatus::kFaults;
  }
  const auto points = surface::touched_points(plan.grid, probed.points, tip_mm);
  print_summary(points, probed.faults.size());
  write(options.output, surface::text_of_probe_rows(plan.grid, points, heading_of(plan, tip_mm)));
  return ExitStatus::kFine;
}

}  // namespace

void add_probe_grid_command(CLI::App& surface_command, ExitStatus& status) {
  CLI::App* command = surface_command.add_subcommand(
      "probe-grid",
      "Write the program that probes a grid of points, or read its answers into a grid.");
  command->footer(kProbeGridFooter);
  const auto options = std::make_shared<ProbeGridOptions>();
  options->add_to(*command);
  command->callback([options, &status] {
    status = options->read.empty() ? write_program(*options) : read_answers(*options);
  });
}

}  // namespace sim
