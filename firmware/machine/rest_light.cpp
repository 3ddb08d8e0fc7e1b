#include "firmware/machine/rest_light.hpp"

namespace cnc {

void RestLight::configure(const Allowance& allowance) {
  allowance_ = allowance;
  renew();
}

void RestLight::ask(Wish wish) {
  wish_ = wish;
  waiting_us_ = 0;
}

void RestLight::renew() {
  end();
  left_us_ = allowance_.longest_us;
}

std::uint16_t RestLight::pass(std::int32_t elapsed_us, std::uint16_t duty) {
  if (lit_) left_us_ -= elapsed_us;
  lit_ = false;
  if (wish_ == Wish::kNone || duty == 0) return 0;
  const std::int32_t delay_us = wish_ == Wish::kDot ? kDotDelayUs : 0;
  if (waiting_us_ < delay_us) {
    waiting_us_ += elapsed_us;
    return 0;
  }
  lit_ = duty <= allowance_.greatest_duty && left_us_ > 0;
  if (!lit_ && refusal_ == Refusal::kNone) refusal_ = Refusal::kUntold;
  return lit_ ? duty : std::uint16_t{0};
}

/// Starts the count of the watch. While the light is on, further calls do not restart the count.
void RestLight::arm() {
  if (periods_.load(std::memory_order_relaxed) != 0) return;
  const auto left_ms = static_cast<std::uint32_t>(left_us_) / 1000;
  periods_.store(left_ms * kPeriodsPerMs + kLatePeriods, std::memory_order_release);
}

bool RestLight::take_refusal() {
  if (refusal_ != Refusal::kUntold) return false;
  refusal_ = Refusal::kTold;
  return true;
}

std::uint16_t RestLight::allowed() noexcept {
  const std::uint32_t left = periods_.load(std::memory_order_relaxed);
  if (left == 0) return 0;
  periods_.store(left - 1, std::memory_order_relaxed);
  return allowance_.greatest_duty;
}

}  // namespace cnc
