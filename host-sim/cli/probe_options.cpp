#include "host-sim/cli/probe_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <memory>
#include <stdexcept>

#include "host-sim/cli/file_options.hpp"
#include "host-sim/cli/value_range.hpp"
#include "host-sim/machine/probe_surface.hpp"
#include "host-sim/report/terminal.hpp"
#include "host-sim/surface/read_surface.hpp"
#include "host-sim/trace/input_file.hpp"

namespace sim {
namespace {

constexpr double kMaxTipMm = 100.0;

}  // namespace

void ProbeOptions::add_to(CLI::App& command) {
  command
      .add_option("--probe-plate",
                  plate_z_mm,
                  "Height of the simulated probe plate, mm in machine coordinates")
      ->check(in_range(-10'000.0, 10'000.0, "mm"))
      ->type_name("Z")
      ->default_str(fmt::format("{}", MachineModel{}.probe_plate_z_mm));
  mark_file(
      command
          .add_option(
              "--probe-surface",
              surface,
              "Surface that the probe touches: a grid or a mesh as kerfline\nsurface reads them, "
              "mm in machine coordinates. If\n--probe-plate is not given, there is no plate")
          ->type_name("FILE"),
      FileRole::kInput);
  command
      .add_option(
          "--probe-tip",
          tip_mm,
          "Diameter of the probe's ball, mm; its lowest point is the tool position; 0 is a\n"
          "point")
      ->check(in_range(0.0, kMaxTipMm, "mm"))
      ->type_name("MM")
      ->capture_default_str();
}

double ProbeOptions::plate_mm() const {
  const double none = -std::numeric_limits<double>::infinity();
  return plate_z_mm.value_or(surface.empty() ? MachineModel{}.probe_plate_z_mm : none);
}

std::optional<ProbeSurfaceFile> ProbeOptions::read() const {
  if (!surface.empty()) return ProbeSurfaceFile{.bytes = read_bytes(surface), .tip_mm = tip_mm};
  if (tip_mm > 0.0) {
    throw std::invalid_argument(
        "--probe-tip: there is no surface for the ball; give --probe-surface");
  }
  return {};
}

void ProbeOptions::apply(const std::optional<ProbeSurfaceFile>& file, MachineModel& machine) const {
  machine.probe_plate_z_mm = plate_mm();
  if (!file) return;
  const surface::SurfaceInput read = surface::read_surface(file->bytes, name_of_input(surface), {});
  for (const std::string& note : read.notes) terminal::print(stderr, "{}\n", note);
  machine.probe_surface = std::make_shared<const ProbeSurface>(read.mesh, file->tip_mm);
}

}  // namespace sim
