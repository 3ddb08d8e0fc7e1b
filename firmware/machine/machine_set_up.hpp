#pragma once

#include <cstdint>

#include "firmware/machine/configuration.hpp"
#include "firmware/machine/settings.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc {

/// The settings, the light that the beam gives at each duty, and the limits of the motion that
/// follow from both. Other parts keep references to the settings and the limits.
class MachineSetUp {
 public:
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const motion::PowerTable& power_table() const { return power_table_; }
  /// Returns the limits since the last apply().
  [[nodiscard]] const motion::Limits& limits() const { return limits_; }

  /// Changes a setting. Returns the stored value or an error. The limits follow by apply().
  Result<float, SettingError> set(std::uint16_t number, float value) {
    return settings_.set(number, value);
  }
  /// Changes the power table. The limits follow by apply().
  void set_power_table(const motion::PowerTable& table) { power_table_ = table; }
  /// Recomputes the limits.
  /// @pre nothing moves
  void apply() {
    limits_ = limits_from(settings_);
    limits_.beam = beam_response_from(settings_, power_table_);
  }

 private:
  Settings settings_{};
  motion::PowerTable power_table_{};
  motion::Limits limits_{};
};

}  // namespace cnc
