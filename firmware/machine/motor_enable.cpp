#include "firmware/machine/motor_enable.hpp"

namespace cnc {

void MotorEnable::attend(Need need, std::int32_t elapsed_us) {
  constexpr float kForEver = 255.0F;
  constexpr float kUsPerMs = 1000.0F;
  if (need == Need::kMotion) {
    active_ = true;
    idle_us_ = 0;
  } else if (need == Need::kSleep) {
    active_ = false;
  } else if (const float idle_ms = settings_.get(setting::kIdleDelay);
             active_ && idle_ms != kForEver) {
    idle_us_ += elapsed_us;
    active_ = idle_us_ < static_cast<std::int32_t>(idle_ms * kUsPerMs);
  }
  if (wait_us_ > 0) wait_us_ -= elapsed_us;
  const auto kept = static_cast<std::uint8_t>(settings_.get(setting::kKeptMotors));
  const std::uint8_t wanted = active_ ? kAllAxes : kept;
  if (wanted == enabled_) return;
  if ((wanted & ~enabled_) != 0) {
    wait_us_ = static_cast<std::int32_t>(settings_.get(setting::kEnableDelay) * kUsPerMs);
  }
  enabled_ = wanted;
  outputs_.set_motors_enabled(wanted);
}

}  // namespace cnc
