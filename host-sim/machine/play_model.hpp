#pragma once

#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "host-sim/machine/machine_model.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// Mechanical backlash: computes where each axis is, in steps, when its motor turns.
///
/// This is the play operator: an axis stays where it is until the motor has crossed the play and
/// takes it along. Plays are whole steps.
class PlayModel {
 public:
  using Steps = cnc::AxisArray<std::int32_t>;

  explicit PlayModel(const MachineModel& model) : model_{model} {}

  /// Sets the plays to those of the model, or of $160…$165. At power-up they lie as homing would
  /// leave them, or at the other end if the model says so; later calls leave each axis where it is.
  void place(const cnc::Settings& settings);

  /// Returns whether any axis has play. If so, each step of its motor has to be followed.
  [[nodiscard]] bool any() const { return any_; }
  /// Moves the axes along as the motors reach `motors`, and returns the positions of the axes.
  const Steps& follow(const Steps& motors);
  /// Returns where the axes would be with the motors at `motors`, and moves nothing.
  [[nodiscard]] Steps axes(const Steps& motors) const;

 private:
  MachineModel model_;
  Steps low_{};   ///< Least number of steps by which an axis is beyond its motor.
  Steps high_{};  ///< Greatest number of steps by which an axis is beyond its motor.
  Steps motors_{};
  Steps axes_{};
  bool any_ = false;  ///< Whether low_ differs from high_ on any axis.
};

}  // namespace sim
