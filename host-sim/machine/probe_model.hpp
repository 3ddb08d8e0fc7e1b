#pragma once

#include <array>
#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "host-sim/machine/machine_model.hpp"
#include "host-sim/machine/play_model.hpp"
#include "host-sim/machine/probe_surface.hpp"

namespace sim {

/// The probe circuit of the model machine. The tool closes the circuit while it touches, or is
/// inside of, the plate or the surface.
class ProbeModel {
 public:
  explicit ProbeModel(const MachineModel& model) : model_{model} {}

  /// Reads the steps per mm from the settings.
  void place(const cnc::Settings& settings);
  /// Returns whether the circuit is closed with the axes at `axes`, steps.
  [[nodiscard]] bool is_closed(const PlayModel::Steps& axes);
  /// Returns the number of steps that each motor may make from `axes` before the circuit can
  /// change.
  [[nodiscard]] std::uint64_t steps_undisturbed(const PlayModel::Steps& axes) const;

 private:
  [[nodiscard]] double tip_height(const PlayModel::Steps& axes);

  const MachineModel& model_;
  std::array<float, 3> steps_per_mm_{1.0F, 1.0F, 1.0F};
  // Whether height_mm_ is the height of the surface at x_step_ and y_step_. The height is kept
  // because only Z moves while a probe descends.
  bool has_height_ = false;
  std::int32_t x_step_ = 0;
  std::int32_t y_step_ = 0;
  double height_mm_ = 0.0;
  ProbeSurface::Hint hint_{};
};

}  // namespace sim
