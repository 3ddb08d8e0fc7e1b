#pragma once

#include <string_view>

/// Texts with which the controller identifies itself. Senders recognise each line by its form: the
/// banner and `[VER:` name Grbl; `[FIRMWARE:` in `$I+` and `[KERFLINE:` name the controller.
namespace cnc::identity {

inline constexpr std::string_view kBanner = "Grbl 1.1h ['$' for help]";
inline constexpr std::string_view kVersion = "1.1h.20261121";
/// Grbl's option letters, in this order: variable spindle, line numbers, mist coolant, parking,
/// homing of single axes, safety door, axes with two motors.
inline constexpr std::string_view kOptions = "VNMPH+2";
/// grblHAL's options: `$ES` and related statements (ENUMS), the forms of realtime bytes from 0x80
/// on (RT+), and homing (HOME).
inline constexpr std::string_view kNewOptions = "ENUMS,RT+,HOME";
inline constexpr std::string_view kFirmware = "Kerfline";

/// Returns the project's version and the commit of the build, such as `0.2.0+9fa115e`. The text
/// ends with `-dirty` if the work tree was modified, and has no commit if the sources were not in a
/// git work tree. toolchain/write_version.cmake writes the source file that defines this function.
[[nodiscard]] std::string_view version();

}  // namespace cnc::identity
