#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace cnc {

/// A number that senders know, and its text.
struct CodeText {
  std::uint8_t number;
  const char* text;  ///< Has neither "ok" nor "error", which only an acknowledgement may hold.
};

/// Returns every number after `error:`, in order (`$EE`). Grbl's 12 and 17 are missing: no value of
/// a setting can require too many steps, and there is always a power output.
[[nodiscard]] std::span<const CodeText> error_texts();
/// Returns the text of an error number.
/// @pre the number is in the table
[[nodiscard]] std::string_view error_text(std::uint8_t number);
/// Returns every number after `ALARM:`, in order (`$EA`).
[[nodiscard]] std::span<const CodeText> alarm_texts();

/// Errors of the protocol itself; those of G-code are gcode::ErrorCode. Source: gnea/grbl,
/// doc/csv/error_codes_en_US.csv, and grblHAL's 79.
namespace error_number {
inline constexpr std::uint8_t kWrongCheck = 1;
inline constexpr std::uint8_t kBadNumber = 2;
inline constexpr std::uint8_t kNoSuchStatement = 3;
inline constexpr std::uint8_t kNegativeValue = 4;
inline constexpr std::uint8_t kHomingDisabled = 5;
inline constexpr std::uint8_t kPulseTooShort = 6;
inline constexpr std::uint8_t kStoreFailed = 7;
inline constexpr std::uint8_t kNotIdle = 8;
inline constexpr std::uint8_t kLocked = 9;
inline constexpr std::uint8_t kLineTooLong = 11;
inline constexpr std::uint8_t kDoorOpen = 13;
inline constexpr std::uint8_t kTextTooLong = 14;
inline constexpr std::uint8_t kJogBeyondTravel = 15;
inline constexpr std::uint8_t kNotAJog = 16;
inline constexpr std::uint8_t kEmergencyStop = 79;
inline constexpr std::uint8_t kNotDone = 200;  ///< Our own number, beyond those of grblHAL.
}  // namespace error_number

}  // namespace cnc
