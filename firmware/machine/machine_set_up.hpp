#pragma once

#include <cstdint>

#include "firmware/machine/configuration.hpp"
#include "firmware/machine/settings.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc {

/// The settings, the power table of the beam, and the motion limits that are computed from both.
/// Other objects keep references to the settings and the limits.
class MachineSetUp {
 public:
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const motion::PowerTable& power_table() const { return power_table_; }
  /// Returns the limits that the last apply() computed.
  [[nodiscard]] const motion::Limits& limits() const { return limits_; }

  /// Changes a setting. Returns the stored value or an error. The limits do not change before
  /// apply().
  Result<float, SettingError> set(std::uint16_t number, float value) {
    return settings_.set(number, value);
  }
  /// Changes the power table. The limits do not change before apply().
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
