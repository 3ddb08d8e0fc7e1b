#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace cnc {

/// Number of an error or alarm, as senders know it from Grbl and grblHAL, with its text.
struct CodeText {
  std::uint8_t number;
  /// Must not contain "ok" or "error", which only an acknowledgement may contain.
  const char* text;
};

/// Returns every number that can follow `error:`, in rising order (`$EE`). Grbl's 12 and 17 are
/// missing: no setting can require too many steps, and there is always a power output.
[[nodiscard]] std::span<const CodeText> error_texts();
/// Returns the text of an error number.
/// @pre error_texts() contains the number
[[nodiscard]] std::string_view error_text(std::uint8_t number);
/// Returns every number that can follow `ALARM:`, in rising order (`$EA`).
[[nodiscard]] std::span<const CodeText> alarm_texts();

/// Numbers of the errors of the protocol itself. The numbers for G-code are in gcode::ErrorCode.
/// Source: gnea/grbl, doc/csv/error_codes_en_US.csv; 79 is from grblHAL.
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
/// Kerfline's own number, above the numbers of grblHAL.
inline constexpr std::uint8_t kNotDone = 200;
}  // namespace error_number

}  // namespace cnc
