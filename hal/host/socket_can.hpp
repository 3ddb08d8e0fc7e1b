#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>

#include "hal/host/descriptor.hpp"
#include "hal/interface/can_port.hpp"

namespace hal::host {

/// A CAN interface of the kernel (SocketCAN), such as `can0` or `vcan0`, as a node on its bus.
///
/// Frames wait in a queue while the interface has no free space. If the interface goes down, the
/// waiting frames are dropped. They count as one lost frame, so that the user of the port detects
/// the gap.
class SocketCan final : public CanPort {
 public:
  static constexpr std::size_t kFrames = 32;  ///< Capacity of the queue of frames to send.

  /// Opens the interface. Throws std::runtime_error, whose text names the interface and the remedy.
  /// @param heard identifiers of 11 bits to receive; the kernel drops all other frames, extended
  ///     frames and remote requests
  SocketCan(const std::string& interface, std::span<const std::uint32_t> heard);

  [[nodiscard]] bool receive(CanFrame& frame) override;
  [[nodiscard]] bool send(const CanFrame& frame) override;
  [[nodiscard]] std::size_t room() const override { return kFrames - to_send_.size(); }
  /// Returns the state of the node. The interface reports the error counts; a virtual interface
  /// reports none.
  [[nodiscard]] CanHealth health() const override { return health_; }
  void hear_only(std::span<const std::uint32_t> heard, std::size_t urgent) override;

  /// Sends waiting frames while the interface accepts them. Must be called from time to time,
  /// because no descriptor reports that the interface accepts frames again.
  void flush();
  /// Returns whether the interface is up. The result is false after the interface has gone down or
  /// disappeared, until a frame has been sent again.
  [[nodiscard]] bool up() const { return up_; }
  /// Returns the descriptor to poll for received frames.
  [[nodiscard]] int number() const { return socket_.number(); }

 private:
  void take_fault(int fault);
  void take_error(std::uint32_t kinds, std::span<const std::uint8_t> details);
  void count_drops(std::uint32_t drops);

  Descriptor socket_;
  std::deque<CanFrame> to_send_;
  CanHealth health_{};
  /// Kernel's running count of frames that it dropped for lack of space.
  std::uint32_t drops_ = 0;
  bool up_ = true;
};

}  // namespace hal::host
