#pragma once

#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "host-sim/machine/machine_model.hpp"
#include "planner/base/axes.hpp"

namespace sim {

/// Mechanical backlash: where each axis is, in steps, when its motor turns.
///
/// The play operator: an axis stays where it is until the motor has crossed the play
/// and takes it along. Plays are whole steps.
class PlayModel {
 public:
  using Steps = cnc::AxisArray<std::int32_t>;

  explicit PlayModel(const MachineModel& model) : model_{model} {}

  /// Makes the plays those of the model, or of $160…$165. At power-up they lie as homing
  /// would leave them, or the other way round if the model says so; later each axis
  /// stays where it is.
  void place(const cnc::Settings& settings);

  /// Whether any axis has play: then each step of its motor has to be followed.
  [[nodiscard]] bool any() const { return any_; }
  /// Where the axes are now that the motors have come here.
  const Steps& follow(const Steps& motors);
  /// Where they would be.
  [[nodiscard]] Steps axes(const Steps& motors) const;

 private:
  MachineModel model_;
  Steps low_{};   ///< An axis is at least so many steps beyond its motor, …
  Steps high_{};  ///< … and at most so many.
  Steps motors_{};
  Steps axes_{};
  bool any_ = false;  ///< A low_ differs from its high_.
};

}  // namespace sim
