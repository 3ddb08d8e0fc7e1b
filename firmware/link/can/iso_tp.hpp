#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cnc::iso_tp {

/// Messages of several bytes in frames of eight: ISO 15765-2:2016, classic CAN, normal
/// addressing, which is what tools of the trade decode.
///
/// What differs from the standard: a message for which nobody allowed the next block is sent
/// again from its beginning, which no receiver can take for a second one; and one that was too
/// long for the other side comes again in shorter ones. Text does not care where it is divided.

/// In the upper half of a frame's first byte.
enum class FrameKind : std::uint8_t {
  kSingle = 0,       ///< Lower half: length, 1 to 7; then the message.
  kFirst = 1,        ///< Lower half and next byte: length, 8 to 4095; then six bytes of it.
  kConsecutive = 2,  ///< Lower half: number, 1 after the first frame, modulo 16; seven bytes.
  kFlowControl = 3,  ///< Lower half: FlowStatus; then block size and separation.
};

enum class FlowStatus : std::uint8_t {
  kContinue = 0,  ///< As many frames as the block size says; 0: all.
  kWait = 1,      ///< Another flow control will come.
  kOverflow = 2,  ///< Longer than the receiver has room for, ever.
};

inline constexpr std::size_t kInSingle = 7;  ///< Bytes of a message.
inline constexpr std::size_t kInFirst = 6;
inline constexpr std::size_t kInConsecutive = 7;
inline constexpr std::uint32_t kLongestMessage = 4095;

inline constexpr std::uint32_t kFlowTimeoutUs = 1'000'000;   ///< N_Bs, from the standard.
inline constexpr std::uint32_t kFrameTimeoutUs = 1'000'000;  ///< N_Cr.

/// What a frame carries: up to eight bytes.
struct Payload {
  std::array<std::byte, 8> bytes{};
  std::uint8_t length = 0;

  [[nodiscard]] std::span<const std::byte> span() const { return std::span{bytes}.first(length); }
};

/// What a receiver that needs no time between frames asks for.
struct FlowControl {
  FlowStatus status = FlowStatus::kContinue;
  std::uint8_t block_size = 0;
};

/// Microseconds of a separation time (STmin); what is reserved means the longest.
[[nodiscard]] constexpr std::uint32_t separation_us(std::uint8_t code) {
  constexpr std::uint32_t kLongestMs = 0x7F;
  if (code <= kLongestMs) return code * 1000U;
  return code >= 0xF1 && code <= 0xF9 ? (code - 0xF0U) * 100U : kLongestMs * 1000U;
}

/// The kind of frame that this is; of an empty one, none that exists.
[[nodiscard]] constexpr FrameKind kind_of(std::span<const std::byte> payload) {
  constexpr auto kNone = static_cast<FrameKind>(0xF);
  return payload.empty() ? kNone
                         : static_cast<FrameKind>(std::to_integer<std::uint8_t>(payload[0]) >> 4);
}

/// The lower half of the first byte. @pre the frame has one
[[nodiscard]] constexpr std::uint8_t low_half(std::span<const std::byte> payload) {
  return std::to_integer<std::uint8_t>(payload[0]) & 0xFU;
}

[[nodiscard]] constexpr std::byte first_byte(FrameKind kind, std::size_t low) {
  return static_cast<std::byte>(static_cast<std::size_t>(kind) << 4 | (low & 0xFU));
}

/// A frame of flow control without a separation time.
[[nodiscard]] constexpr std::array<std::byte, 3> bytes_of(const FlowControl& flow) {
  return {first_byte(FrameKind::kFlowControl, static_cast<std::size_t>(flow.status)),
          static_cast<std::byte>(flow.block_size),
          std::byte{0}};
}

}  // namespace cnc::iso_tp
