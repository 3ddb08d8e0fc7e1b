#pragma once

#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "host-sim/machine/machine_model.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// Model of mechanical backlash: computes the position of each axis from the position of its motor,
/// in steps.
///
/// This is the play operator: an axis stays at its position until the motor has crossed the play
/// and moves the axis. Plays are full steps.
class PlayModel {
 public:
  using Steps = cnc::AxisArray<std::int32_t>;

  explicit PlayModel(const MachineModel& model) : model_{model} {}

  /// Sets the plays to those of the model, or of $160…$165. At power-up, the plays are at the end
  /// at which homing leaves them, or at the opposite end if the model requires it. Later calls keep
  /// the positions of the axes.
  void place(const cnc::Settings& settings);

  /// Returns whether any axis has play. If so, follow() must be called for each step of a motor.
  [[nodiscard]] bool any() const { return any_; }
  /// Moves the axes to the positions that result when the motors reach `motors`. Returns the
  /// positions of the axes.
  const Steps& follow(const Steps& motors);
  /// Returns the positions of the axes for the motors at `motors`, without moving the axes.
  [[nodiscard]] Steps axes(const Steps& motors) const;

 private:
  MachineModel model_;
  Steps low_{};   ///< Least position of an axis relative to its motor, steps.
  Steps high_{};  ///< Greatest position of an axis relative to its motor, steps.
  Steps motors_{};
  Steps axes_{};
  bool any_ = false;  ///< Whether low_ differs from high_ on any axis.
};

}  // namespace sim
