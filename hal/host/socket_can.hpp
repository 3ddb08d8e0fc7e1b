#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <string>

#include "hal/host/descriptor.hpp"
#include "hal/interface/can_port.hpp"

namespace hal::host {

/// A CAN interface of the kernel (SocketCAN), `can0` or `vcan0`: a node among others.
///
/// What is to be sent waits here while the interface has no room. An interface that goes down
/// loses that, and counts as one lost frame: whoever listens must not go on as if nothing
/// had been missed.
class SocketCan final : public CanPort {
 public:
  static constexpr std::size_t kFrames = 32;  ///< That wait to be sent.

  /// @param heard identifiers of 11 bits that are taken; the kernel keeps all others, extended
  /// frames and requests away. Throws std::runtime_error, which names the interface and says what
  /// there is to be done.
  SocketCan(const std::string& interface, std::span<const std::uint32_t> heard);

  [[nodiscard]] bool receive(CanFrame& frame) override;
  [[nodiscard]] bool send(const CanFrame& frame) override;
  [[nodiscard]] std::size_t room() const override { return kFrames - to_send_.size(); }
  /// Of the errors, what the interface reports; a virtual one has none.
  [[nodiscard]] CanHealth health() const override { return health_; }
  void hear_only(std::span<const std::uint32_t> heard, std::size_t urgent) override;

  /// Sends what waits, as far as the interface takes it. No descriptor says when it takes more, so
  /// this is for now and then.
  void flush();
  /// False from where the interface went down, or away, until a frame goes out again.
  [[nodiscard]] bool up() const { return up_; }
  /// To poll for frames.
  [[nodiscard]] int number() const { return socket_.number(); }

 private:
  void take_fault(int fault);
  void take_error(std::uint32_t kinds, std::span<const std::uint8_t> details);
  void count_drops(std::uint32_t drops);

  Descriptor socket_;
  std::deque<CanFrame> to_send_;
  CanHealth health_{};
  std::uint32_t drops_ = 0;  ///< Frames that the kernel had no room for, as it counts.
  bool up_ = true;
};

}  // namespace hal::host
