#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace hal {

/// A frame of CAN 2.0, with the content of SocketCAN's can_frame.
struct CanFrame {
  std::uint32_t id = 0;  ///< Identifier of 11 bits; of 29 bits in an extended frame.
  bool extended = false;
  /// Whether this is a remote request: it requests a frame of `length` bytes and has no data.
  bool remote = false;
  std::uint8_t length = 0;  ///< Number of data bytes, 0 to 8.
  std::array<std::byte, 8> data{};

  bool operator==(const CanFrame&) const = default;
};

/// Returns a frame with an identifier of 11 bits.
/// @pre `bytes` has at most eight bytes
[[nodiscard]] constexpr CanFrame can_frame(std::uint32_t id, std::span<const std::byte> bytes) {
  CanFrame frame{.id = id, .length = static_cast<std::uint8_t>(bytes.size())};
  std::size_t at = 0;
  for (const std::byte byte : bytes) frame.data[at++] = byte;
  return frame;
}

/// State of a node, which its error counters determine (ISO 11898-1, 12.1.4).
enum class CanState : std::uint8_t { kActive, kWarning, kPassive, kBusOff };

struct CanHealth {
  CanState state = CanState::kActive;
  std::uint8_t transmit_errors = 0;
  std::uint8_t receive_errors = 0;
  /// Number of bus-offs since start-up; the node recovers from each.
  std::uint32_t bus_offs = 0;
  std::uint32_t lost_frames = 0;  ///< Number of received frames for which there was no free space.
};

/// A node on a CAN bus. Main loop context; no call blocks.
class CanPort {
 public:
  /// Takes the oldest received frame. Returns false if there is none.
  [[nodiscard]] virtual bool receive(CanFrame& frame) = 0;
  /// Queues a frame. Frames are sent in the order of the calls. Each is repeated until another node
  /// has acknowledged it. Returns false if there is no free space.
  [[nodiscard]] virtual bool send(const CanFrame& frame) = 0;
  /// Returns the number of frames that can be queued now.
  [[nodiscard]] virtual std::size_t room() const = 0;
  [[nodiscard]] virtual CanHealth health() const = 0;
  /// Restricts reception to frames with these identifiers of 11 bits. Frames with the first
  /// `urgent` identifiers are never delayed by any other frames. A port that cannot filter passes
  /// all frames.
  virtual void hear_only(std::span<const std::uint32_t> identifiers, std::size_t urgent) = 0;

 protected:
  ~CanPort() = default;
};

}  // namespace hal
