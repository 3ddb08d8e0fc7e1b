#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hal {

/// A frame of CAN 2.0, as SocketCAN's can_frame has it.
struct CanFrame {
  std::uint32_t id = 0;  ///< 11 bits, or 29 of an extended one.
  bool extended = false;
  bool remote = false;      ///< Asks for `length` bytes and has none.
  std::uint8_t length = 0;  ///< 0 to 8 bytes.
  std::array<std::byte, 8> data{};

  bool operator==(const CanFrame&) const = default;
};

/// A frame of 11 bits with these bytes, of which there are at most eight.
[[nodiscard]] constexpr CanFrame can_frame(std::uint32_t id, std::span<const std::byte> bytes) {
  CanFrame frame{.id = id, .length = static_cast<std::uint8_t>(bytes.size())};
  std::size_t at = 0;
  for (const std::byte byte : bytes) frame.data[at++] = byte;
  return frame;
}

/// What a node's error counters make of it (ISO 11898-1, 12.1.4).
enum class CanState : std::uint8_t { kActive, kWarning, kPassive, kBusOff };

struct CanHealth {
  CanState state = CanState::kActive;
  std::uint8_t transmit_errors = 0;
  std::uint8_t receive_errors = 0;
  std::uint32_t bus_offs = 0;     ///< Since start-up; each is left by itself.
  std::uint32_t lost_frames = 0;  ///< Received, and no room for them.
};

/// A place on a CAN bus. Main loop context; no call blocks.
class CanPort {
 public:
  /// The oldest frame that has arrived; false when there is none.
  [[nodiscard]] virtual bool receive(CanFrame& frame) = 0;
  /// Queues a frame; it goes out after those before it, and is repeated until another
  /// node has it. False when there is no room.
  [[nodiscard]] virtual bool send(const CanFrame& frame) = 0;
  /// Frames that can be queued now.
  [[nodiscard]] virtual std::size_t room() const = 0;
  [[nodiscard]] virtual CanHealth health() const = 0;
  /// From now on no frames but those of these identifiers of 11 bits are of use, the first
  /// `urgent` of which no others keep waiting. A port that cannot tell them apart passes all.
  virtual void hear_only(std::span<const std::uint32_t> identifiers, std::size_t urgent) = 0;

 protected:
  ~CanPort() = default;
};

}  // namespace hal
