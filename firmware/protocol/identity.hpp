#pragma once

#include <string_view>

/// What the controller says about itself. Senders read the shape of each line,
/// so that it says Grbl where they look for Grbl, and its own name in `$I+`.
namespace cnc::identity {

inline constexpr std::string_view kBanner = "Grbl 1.1h ['$' for help]";
inline constexpr std::string_view kVersion = "1.1h.20261121";
/// Grbl's letters: variable spindle, line numbers, mist coolant, parking, homing
/// of single axes, safety door, axes with two motors.
inline constexpr std::string_view kOptions = "VNMPH+2";
/// grblHAL's names: `$ES` and its kin, realtime bytes also as 0x80…, homing.
inline constexpr std::string_view kNewOptions = "ENUMS,RT+,HOME";
inline constexpr std::string_view kFirmware = "Kerfline";

}  // namespace cnc::identity
