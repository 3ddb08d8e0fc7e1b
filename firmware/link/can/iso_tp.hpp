#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cnc::iso_tp {

/// Messages of several bytes in frames of eight: ISO 15765-2:2016, classic CAN, normal addressing,
/// which common tools can decode.
///
/// There are two differences from the standard. If the receiver never allows the next block of a
/// message, the message is sent again from its beginning; no receiver can take it for a second
/// message. A message that was too long for the receiver is sent again as shorter ones. For text
/// the division into messages does not matter.

/// Upper half of a frame's first byte.
enum class FrameKind : std::uint8_t {
  kSingle = 0,       ///< Lower half: length, 1 to 7; then the message.
  kFirst = 1,        ///< Lower half and next byte: length, 8 to 4095; then six bytes.
  kConsecutive = 2,  ///< Lower half: number modulo 16, 1 after the first frame; then seven bytes.
  kFlowControl = 3,  ///< Lower half: FlowStatus; then block size and separation time.
};

enum class FlowStatus : std::uint8_t {
  kContinue = 0,  ///< Allows as many frames as the block size says; 0 means all.
  kWait = 1,      ///< Another flow control will come.
  kOverflow = 2,  ///< The message is longer than the receiver can ever take.
};

inline constexpr std::size_t kInSingle = 7;  ///< Bytes of a message in a single frame.
inline constexpr std::size_t kInFirst = 6;
inline constexpr std::size_t kInConsecutive = 7;
inline constexpr std::uint32_t kLongestMessage = 4095;

inline constexpr std::uint32_t kFlowTimeoutUs = 1'000'000;   ///< N_Bs of the standard.
inline constexpr std::uint32_t kFrameTimeoutUs = 1'000'000;  ///< N_Cr of the standard.

/// Content of a frame: up to eight bytes.
struct Payload {
  std::array<std::byte, 8> bytes{};
  std::uint8_t length = 0;

  [[nodiscard]] std::span<const std::byte> span() const { return std::span{bytes}.first(length); }
};

/// Flow control of a receiver that needs no time between frames.
struct FlowControl {
  FlowStatus status = FlowStatus::kContinue;
  std::uint8_t block_size = 0;
};

/// Returns a separation time (STmin) in microseconds. Reserved codes mean the longest time.
[[nodiscard]] constexpr std::uint32_t separation_us(std::uint8_t code) {
  constexpr std::uint32_t kLongestMs = 0x7F;
  if (code <= kLongestMs) return code * 1000U;
  return code >= 0xF1 && code <= 0xF9 ? (code - 0xF0U) * 100U : kLongestMs * 1000U;
}

/// Returns the kind of a frame; for an empty frame, a kind that does not exist.
[[nodiscard]] constexpr FrameKind kind_of(std::span<const std::byte> payload) {
  constexpr auto kNone = static_cast<FrameKind>(0xF);
  return payload.empty() ? kNone
                         : static_cast<FrameKind>(std::to_integer<std::uint8_t>(payload[0]) >> 4);
}

/// Returns the lower half of the first byte.
/// @pre the frame has a byte
[[nodiscard]] constexpr std::uint8_t low_half(std::span<const std::byte> payload) {
  return std::to_integer<std::uint8_t>(payload[0]) & 0xFU;
}

[[nodiscard]] constexpr std::byte first_byte(FrameKind kind, std::size_t low) {
  return static_cast<std::byte>(static_cast<std::size_t>(kind) << 4 | (low & 0xFU));
}

/// Returns a frame of flow control without a separation time.
[[nodiscard]] constexpr std::array<std::byte, 3> bytes_of(const FlowControl& flow) {
  return {first_byte(FrameKind::kFlowControl, static_cast<std::size_t>(flow.status)),
          static_cast<std::byte>(flow.block_size),
          std::byte{0}};
}

}  // namespace cnc::iso_tp
