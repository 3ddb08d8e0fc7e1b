#pragma once

#include <optional>
#include <string>

#include "host-sim/machine/machine_model.hpp"

namespace CLI {
class App;
}

namespace sim {

/// Content of the file of a surface that the probe touches.
struct ProbeSurfaceFile {
  std::string bytes;
  double tip_mm = 0.0;  ///< Diameter of the ball that probes the surface.
};

/// Options for the plate and the surface at which the probe of the simulated machine triggers.
struct ProbeOptions {
  std::optional<double> plate_z_mm;
  std::string surface;  ///< File of the surface; empty for none.
  double tip_mm = 0.0;

  void add_to(CLI::App& command);

  /// Returns the height of the plate. If a surface is probed, there is no plate unless its height
  /// was given.
  [[nodiscard]] double plate_mm() const;
  /// Returns the bytes of the surface; empty without a surface. Throws std::system_error, and
  /// std::invalid_argument for a tip without a surface.
  [[nodiscard]] std::optional<ProbeSurfaceFile> read() const;
  /// Puts plate and surface into `machine`, and prints the notes of the surface's reader to
  /// standard error. Throws as read_surface() does.
  void apply(const std::optional<ProbeSurfaceFile>& file, MachineModel& machine) const;
};

}  // namespace sim
