#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "firmware/machine/machine.hpp"

namespace sim {

/// A setting `$N=value`, as it is sent to a controller, and the place where the user wrote it.
struct SettingChange {
  std::uint16_t number = 0;
  float value = 0.0F;
  /// Place where the user wrote the setting, `FILE:LINE` or `--set`, for messages.
  std::string place;
};

/// Reads a setting `$N=value`. Throws std::invalid_argument if the text is not of this form.
[[nodiscard]] SettingChange parse_setting(std::string_view text, std::string place);

/// Reads a file of settings `$N=value`, one on each line. Ignores blank lines and text after `;` or
/// `#`. Throws std::invalid_argument with the place of a fault, or for a file without settings, and
/// std::system_error if the file cannot be read.
[[nodiscard]] std::vector<SettingChange> read_settings_file(const std::string& file);

/// Applies settings to a machine. Throws std::invalid_argument, with the place where the setting
/// was written, for the first setting that the machine refuses.
/// @pre machine.idle()
void apply_settings(const std::vector<SettingChange>& changes, cnc::Machine& machine);

}  // namespace sim
