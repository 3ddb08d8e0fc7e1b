#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/machine.hpp"

namespace sim {

/// One `$N=value`, as on the wire, and where it was written.
struct SettingChange {
  std::uint16_t number = 0;
  float value = 0.0F;
  std::string place;  ///< `FILE:LINE` or `--set`, for messages.
};

/// Reads one `$N=value`. Throws std::invalid_argument saying what is wrong with it.
[[nodiscard]] SettingChange parse_setting(std::string_view text, std::string place);

/// Reads a file of them, one a line; blank lines and what follows `;` or `#` do
/// not count. Throws std::invalid_argument with the place, also for a file without any,
/// std::system_error when the file cannot be read.
[[nodiscard]] std::vector<SettingChange> read_settings_file(const std::string& file);

/// Gives them to a machine. Throws std::invalid_argument with the place of the
/// first that it refuses. @pre machine.idle()
void apply_settings(const std::vector<SettingChange>& changes, cnc::Machine& machine);

}  // namespace sim
