#pragma once

#include <cstdint>

namespace cnc {

/// Bytes that act immediately when they arrive outside a comment, even within a line. Grbl 1.1 and
/// grblHAL define the values.
enum class RealtimeByte : std::uint8_t {
  kReset = 0x18,
  kStop = 0x19,  ///< grblHAL's stop; here the same as a reset.
  kCycleStart = '~',
  kFeedHold = '!',
  kStatus = '?',
  /// grblHAL's form of `?` that is not an ASCII character; the forms of `~` and `!` follow.
  kStatusRaw = 0x80,
  kCycleStartRaw = 0x81,
  kFeedHoldRaw = 0x82,
  kParserState = 0x83,
  kSafetyDoor = 0x84,
  kJogCancel = 0x85,
  kFullStatus = 0x87,
  kOptionalStop = 0x88,
  kSingleBlock = 0x89,
  kAutoReport = 0x8C,  ///< Switches automatic reports on or off ($481).
  kFeedReset = 0x90,
  kFeedUp10 = 0x91,
  kFeedDown10 = 0x92,
  kFeedUp1 = 0x93,
  kFeedDown1 = 0x94,
  kRapidFull = 0x95,
  kRapidHalf = 0x96,
  kRapidQuarter = 0x97,
  kPowerReset = 0x99,
  kPowerUp10 = 0x9A,
  kPowerDown10 = 0x9B,
  kPowerUp1 = 0x9C,
  kPowerDown1 = 0x9D,
  kSpindleStop = 0x9E,
  kFlood = 0xA0,
  kMist = 0xA1,
  kToolAcknowledge = 0xA3,
};

/// Returns whether a realtime byte is an ASCII character. All other realtime bytes have values that
/// also occur within multi-byte characters of UTF-8.
[[nodiscard]] constexpr bool is_ascii_realtime(std::uint8_t byte) {
  switch (static_cast<RealtimeByte>(byte)) {
    case RealtimeByte::kReset:
    case RealtimeByte::kStop:
    case RealtimeByte::kCycleStart:
    case RealtimeByte::kFeedHold:
    case RealtimeByte::kStatus:
      return true;
    default:
      return false;
  }
}

}  // namespace cnc
