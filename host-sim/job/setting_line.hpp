#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/machine.hpp"

namespace sim {

/// One `$N=value`, as on the wire, and the place where it was written.
struct SettingChange {
  std::uint16_t number = 0;
  float value = 0.0F;
  /// Place where the setting was written, `FILE:LINE` or `--set`, for messages.
  std::string place;
};

/// Reads one `$N=value`. Throws std::invalid_argument with the fault of the text.
[[nodiscard]] SettingChange parse_setting(std::string_view text, std::string place);

/// Reads a file of `$N=value`, one on each line. Blank lines and text after `;` or `#` do not
/// count. Throws std::invalid_argument with the place of a fault, also for a file without any
/// setting, and std::system_error when the file cannot be read.
[[nodiscard]] std::vector<SettingChange> read_settings_file(const std::string& file);

/// Applies the changes to a machine. Throws std::invalid_argument with the place of the first
/// change that the machine refuses.
/// @pre machine.idle()
void apply_settings(const std::vector<SettingChange>& changes, cnc::Machine& machine);

}  // namespace sim
