#include "firmware/machine/tool_output.hpp"

#include <algorithm>

namespace cnc {

std::uint16_t to_full_scale(float share) {
  const float legal = share < 0.0F ? 0.0F : (share > 1.0F ? 1.0F : share);
  return static_cast<std::uint16_t>(legal * motion::kFullOutput + 0.5F);
}

void ToolOutput::configure(const ToolSettings& settings) {
  settings_ = settings;
  if (!settings_.laser) dark_at_rest_.store(false, std::memory_order_relaxed);
  apply();
  if (settings_.laser) dark_at_rest_.store(true, std::memory_order_relaxed);
}

void ToolOutput::set_mode(gcode::SpindleMode mode) {
  mode_ = mode;
  apply();
}

void ToolOutput::suspend(bool suspended) {
  suspended_ = suspended;
  apply();
}

void ToolOutput::reset() {
  speed_ = 0.0F;
  suspended_ = false;
  off();
}

void ToolOutput::set_speed(float speed) {
  speed_ = speed;
  apply();
}

void ToolOutput::set_override(float factor) {
  override_ = factor;
  apply();
}

/// Returns the share of full output without the override, 0…1: S divided by $30. If S is above 0
/// but below $31, $31 is used instead of S. Returns 0 if the tool is off.
float ToolOutput::duty() const {
  if (mode_ == gcode::SpindleMode::kOff || speed_ <= 0.0F) return 0.0F;
  return std::clamp(speed_, min_speed(), settings_.max_speed) / settings_.max_speed;
}

float ToolOutput::share_now() const { return std::min(1.0F, duty() * override_); }

void ToolOutput::light_at_rest(std::uint16_t duty) {
  if (duty == light_at_rest_) return;
  light_at_rest_ = duty;
  apply();
}

void ToolOutput::apply() {
  const bool enabled = mode_now() != gcode::SpindleMode::kOff;
  const bool reversed = !settings_.laser && mode_ == gcode::SpindleMode::kDynamic;
  outputs_.set_spindle(enabled, reversed);
  drive_.block_power(suspended_ && settings_.laser);
  const std::uint16_t lit = settings_.laser ? light_at_rest_ : to_full_scale(share_now());
  drive_.set_rest_power(enabled ? lit : std::uint16_t{0});
}

motion::BeamCommand ToolOutput::command_for(bool rapid) const {
  if (!settings_.laser) return {.duty = duty(), .follows_speed = false};
  if (rapid) return {};
  return {.duty = duty(), .follows_speed = mode_ == gcode::SpindleMode::kDynamic};
}

}  // namespace cnc
