#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>

#include "hal/host/descriptor.hpp"
#include "hal/interface/can_port.hpp"

namespace hal::host {

/// A CAN interface of the kernel (SocketCAN), such as `can0` or `vcan0`: one node among others.
///
/// Frames to be sent wait here while the interface has no free space. If the interface goes down,
/// the waiting frames are lost and count as one lost frame, so that a receiver does not continue as
/// if no frame were missing.
class SocketCan final : public CanPort {
 public:
  static constexpr std::size_t kFrames = 32;  ///< Frames that can wait to be sent.

  /// Opens the interface. Throws std::runtime_error, which names the interface and says what to do.
  /// @param heard identifiers of 11 bits that are received; the kernel drops all other frames,
  ///   extended frames and remote requests
  SocketCan(const std::string& interface, std::span<const std::uint32_t> heard);

  [[nodiscard]] bool receive(CanFrame& frame) override;
  [[nodiscard]] bool send(const CanFrame& frame) override;
  [[nodiscard]] std::size_t room() const override { return kFrames - to_send_.size(); }
  /// Returns the state of the node. Its error counts are those that the interface reports; a
  /// virtual interface reports none.
  [[nodiscard]] CanHealth health() const override { return health_; }
  void hear_only(std::span<const std::uint32_t> heard, std::size_t urgent) override;

  /// Sends waiting frames as long as the interface accepts them. To be called now and then, because
  /// no descriptor reports when the interface accepts frames again.
  void flush();
  /// Returns whether the interface is up. It is false from the moment it goes down or disappears
  /// until a frame has been sent again.
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
  std::uint32_t drops_ = 0;  ///< Kernel's running count of frames dropped for lack of space.
  bool up_ = true;
};

}  // namespace hal::host
