#pragma once

#include <cstdint>

#include "firmware/machine/settings.hpp"
#include "hal/interface/auxiliary_outputs.hpp"

namespace cnc {

/// The current in the motors: it flows from before the first step until $1 after the last one, and
/// always in the motors of $37. Main loop context.
class MotorEnable {
 public:
  enum class Need : std::uint8_t {
    kMotion,  ///< Something moves, or is about to.
    kRest,
    kSleep,
  };

  /// @param outputs @param settings outlive this object.
  MotorEnable(hal::AuxiliaryOutputs& outputs, const Settings& settings)
      : outputs_{outputs}, settings_{settings} {}

  /// Switches the current as the machine needs it. Once in each turn, before motion is handed over.
  void attend(Need need, std::int32_t elapsed_us);

  /// Checks that the current has flowed for $884 where it was switched on: before that no motion
  /// may be handed over.
  [[nodiscard]] bool ready() const { return wait_us_ <= 0; }

 private:
  static constexpr std::uint8_t kAllAxes = 0b11'1111;

  hal::AuxiliaryOutputs& outputs_;
  const Settings& settings_;
  std::int32_t idle_us_ = 0;  ///< Since the last motion, while the current flows.
  std::int32_t wait_us_ = 0;  ///< Until drivers that were off are ready.
  bool active_ = false;       ///< Since the last motion $1 has not passed.
  std::uint8_t enabled_ = 0;  ///< Axes whose motors have current.
};

}  // namespace cnc
