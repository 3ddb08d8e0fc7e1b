#pragma once

#include <array>
#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "host-sim/machine/machine_model.hpp"
#include "host-sim/machine/play_model.hpp"
#include "host-sim/machine/probe_surface.hpp"

namespace sim {

/// The probe circuit of the model machine, which the plate and the surface close: the tool touches
/// them, or is inside.
class ProbeModel {
 public:
  explicit ProbeModel(const MachineModel& model) : model_{model} {}

  /// Takes the steps per mm of the machine of these settings.
  void place(const cnc::Settings& settings);
  /// Returns whether the circuit is closed with the axes there, in steps.
  [[nodiscard]] bool is_closed(const PlayModel::Steps& axes);
  /// Returns how many steps each motor may go from there before the circuit can change.
  [[nodiscard]] std::uint64_t steps_undisturbed(const PlayModel::Steps& axes) const;

 private:
  [[nodiscard]] double tip_height(const PlayModel::Steps& axes);

  const MachineModel& model_;
  std::array<float, 3> steps_per_mm_{1.0F, 1.0F, 1.0F};
  // The height of the surface where the axes were last: Z moves alone while a probe comes down.
  bool has_height_ = false;
  std::int32_t x_step_ = 0;
  std::int32_t y_step_ = 0;
  double height_mm_ = 0.0;
  ProbeSurface::Hint hint_{};
};

}  // namespace sim
