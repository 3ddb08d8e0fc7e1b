#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace cnc::iso_tp {

/// Transfers messages of several bytes in frames of eight bytes: ISO 15765-2:2016, classic CAN,
/// normal addressing, which common tools can decode.
///
/// The transfer differs from the standard in two points. If the receiver never allows the next
/// block of a message, the sender restarts the message; no receiver can mistake the repetition for
/// a second message. If a message was too long for the receiver, the sender sends its bytes again
/// in shorter messages. This is possible because the division of text into messages has no meaning.

/// Kind of a frame, the upper half of its first byte.
enum class FrameKind : std::uint8_t {
  kSingle = 0,       ///< Lower half: length, 1 to 7. The message follows.
  kFirst = 1,        ///< Lower half and next byte: length, 8 to 4095. Six bytes follow.
  kConsecutive = 2,  ///< Lower half: frame number modulo 16, from 1 on. Seven bytes follow.
  kFlowControl = 3,  ///< Lower half: FlowStatus. Block size and separation time follow.
};

enum class FlowStatus : std::uint8_t {
  kContinue = 0,  ///< Allows as many frames as the block size states; 0 means all.
  kWait = 1,      ///< The receiver will send another flow control.
  kOverflow = 2,  ///< The message is longer than the receiver's memory.
};

inline constexpr std::size_t kInSingle = 7;  ///< Number of message bytes in a single frame.
inline constexpr std::size_t kInFirst = 6;
inline constexpr std::size_t kInConsecutive = 7;
inline constexpr std::uint32_t kLongestMessage = 4095;

/// Longest wait of the sender for flow control (N_Bs of the standard).
inline constexpr std::uint32_t kFlowTimeoutUs = 1'000'000;
/// Longest wait for the next frame of a message (N_Cr of the standard).
inline constexpr std::uint32_t kFrameTimeoutUs = 1'000'000;

/// Content of a frame: up to eight bytes.
struct Payload {
  std::array<std::byte, 8> bytes{};
  std::uint8_t length = 0;

  [[nodiscard]] std::span<const std::byte> span() const { return std::span{bytes}.first(length); }
};

/// Flow control from a receiver that needs no separation time between frames.
struct FlowControl {
  FlowStatus status = FlowStatus::kContinue;
  std::uint8_t block_size = 0;
};

/// Returns the separation time (STmin) of a code, microseconds. A reserved code means the longest
/// time that the standard allows.
[[nodiscard]] constexpr std::uint32_t separation_us(std::uint8_t code) {
  constexpr std::uint32_t kLongestMs = 0x7F;
  if (code <= kLongestMs) return code * 1000U;
  return code >= 0xF1 && code <= 0xF9 ? (code - 0xF0U) * 100U : kLongestMs * 1000U;
}

/// Returns the kind of a frame; for an empty frame, a kind that the standard does not define.
[[nodiscard]] constexpr FrameKind kind_of(std::span<const std::byte> payload) {
  constexpr auto kNone = static_cast<FrameKind>(0xF);
  return payload.empty() ? kNone
                         : static_cast<FrameKind>(std::to_integer<std::uint8_t>(payload[0]) >> 4);
}

/// Returns the lower half of the frame's first byte.
/// @pre the frame has at least one byte
[[nodiscard]] constexpr std::uint8_t low_half(std::span<const std::byte> payload) {
  return std::to_integer<std::uint8_t>(payload[0]) & 0xFU;
}

[[nodiscard]] constexpr std::byte first_byte(FrameKind kind, std::size_t low) {
  return static_cast<std::byte>(static_cast<std::size_t>(kind) << 4 | (low & 0xFU));
}

/// Returns the bytes of a flow control frame without separation time.
[[nodiscard]] constexpr std::array<std::byte, 3> bytes_of(const FlowControl& flow) {
  return {first_byte(FrameKind::kFlowControl, static_cast<std::size_t>(flow.status)),
          static_cast<std::byte>(flow.block_size),
          std::byte{0}};
}

}  // namespace cnc::iso_tp
