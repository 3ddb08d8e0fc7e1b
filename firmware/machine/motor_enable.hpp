#pragma once

#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "hal/interface/auxiliary_outputs.hpp"

namespace cnc {

/// Switches the current of the motors. The current goes on before the first step, and goes off when
/// the time $1 has passed after the last step. The motors of $37 always have current. Main loop
/// context.
class MotorEnable {
 public:
  enum class Need : std::uint8_t {
    kMotion,  ///< The machine moves, or is about to.
    kRest,
    kSleep,
  };

  /// @pre `outputs` and `settings` outlive this object
  MotorEnable(hal::AuxiliaryOutputs& outputs, const Settings& settings)
      : outputs_{outputs}, settings_{settings} {}

  /// Switches the current on or off, as `need` requires. To be called once in each cycle, before
  /// motion is handed over.
  void attend(Need need, std::int32_t elapsed_us);

  /// Returns whether motion may be handed to the drive: the current has been on for at least the
  /// time $884.
  [[nodiscard]] bool ready() const { return wait_us_ <= 0; }

 private:
  static constexpr std::uint8_t kAllAxes = 0b11'1111;

  hal::AuxiliaryOutputs& outputs_;
  const Settings& settings_;
  /// Time since the last motion, µs; counted until the current goes off.
  std::int32_t idle_us_ = 0;
  std::int32_t wait_us_ = 0;  ///< Time until the drivers that were switched on are ready, µs.
  bool active_ = false;       ///< Whether the time $1 has not passed since the last motion.
  std::uint8_t enabled_ = 0;  ///< Axes whose motors have current.
};

}  // namespace cnc
