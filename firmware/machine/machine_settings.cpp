#include "firmware/machine/machine.hpp"

namespace cnc {

Result<float, SettingError> Machine::change_setting(std::uint16_t number, float value) {
  CNC_ASSERT(idle());
  memory_.check_settings();
  const bool other_scale =
      number >= setting::kStepsPerMm && number < setting::kStepsPerMm + kAxisCount;
  const float before = other_scale ? settings().get(number) : 0.0F;
  const bool is_rotary = number >= setting::kRotaryAxes && number <= setting::kMaxTilt;
  if (tool_centre_.active() && (is_rotary || other_scale)) return SettingError::kInUse;
  const auto stored = set_up_.set(number, value);
  if (!stored.ok()) return stored;
  if (number == setting::kBlockDelete) switches_.block_delete_turned = false;
  if (other_scale && !place_fits()) {
    static_cast<void>(set_up_.set(number, before));
    return SettingError::kPlaceLost;
  }
  apply_settings();
  if (other_scale) {
    // The motors do not move, but their step counts now correspond to another position.
    const std::size_t axis = number - setting::kStepsPerMm;
    set_homed(static_cast<std::uint8_t>(homed() & ~(1U << axis)));
    progress_.forget();
    motion_.drop_rest();
    interpreter_.set_position(motion_.target());
  }
  return stored;
}

/// Computes the tool's present position from its step counts and the stored resolutions. Returns
/// whether this position is within the range of each axis. All axes are checked, because the
/// resolution of one linear axis limits the range of all linear axes.
bool Machine::place_fits() const {
  const Position reach = gcode_options_from(settings()).reach;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const AxisScale scale{settings().get(setting::kStepsPerMm, axis)};
    const Coordinate place = scale.place_of(motion_.tool_steps()[axis]);
    if (place < -reach[axis] || place > reach[axis]) return false;
  }
  return true;
}

void Machine::set_power_table(const motion::PowerTable& table) {
  CNC_ASSERT(idle());
  memory_.check_settings();
  set_up_.set_power_table(table);
  apply_settings();
}

/// Recomputes all values that follow from the settings. If a bit of a setting has flipped before,
/// the new checksum of the memory includes the flipped bit and cannot show it. So the settings are
/// also checked by their own checksum (Settings::sound()).
void Machine::apply_settings() {
  set_up_.apply();
  travel_.configure(settings());
  apply_motor_settings();
  apply_language_settings();
  drive_.set_second_motors(static_cast<std::uint8_t>(settings().get(setting::kSquaredAxes)));
  tool_.configure({.max_speed = settings().get(setting::kMaxSpindleSpeed),
                   .min_speed = settings().get(setting::kMinSpindleSpeed),
                   .laser = settings().get(setting::kLaserMode) != 0.0F});
  rest_light_.configure(rest_light_from(settings()));
  memory_.trust_settings(settings().sound());
}

void Machine::apply_motor_settings() {
  motion_.configure(motor_stage_from(settings()));
  drive_.set_timing(step_timing_from(settings()));
  drive_.set_beam_timing(beam_timing_from(settings()));
}

void Machine::apply_language_settings() {
  gcode::Options options = gcode_options_from(settings());
  options.block_delete =
      (settings().get(setting::kBlockDelete) != 0.0F) != switches_.block_delete_turned;
  options.kerf = &compensated_.kerf();
  options.full_power_speed = settings().get(setting::kMaxSpindleSpeed);
  const auto points = power_table().points();
  if (!points.empty()) options.greatest_power_mw = points.back().milliwatts;
  interpreter_.set_options(options);
}

}  // namespace cnc
