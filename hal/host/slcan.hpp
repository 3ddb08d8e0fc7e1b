#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <string_view>

#include "hal/host/slcan_text.hpp"
#include "hal/interface/can_port.hpp"

namespace hal::host {

/// The adapter's side of the serial-line protocol for CAN by Lawicel, which slcand and python-can
/// use. It is a node on a bus that consists of the adapter and the host.
///
/// `t12320A0B` CR is a frame with an identifier of 11 bits; `T` begins a frame with 29 bits. `r`
/// and `R` request such frames. `O` opens the channel and `C` closes it. `S0` to `S8` and `s` set a
/// bit rate, which has no effect here. `F` requests the state, `V` the version and `N` the serial
/// number. Each line is answered with CR, or with BEL if it was refused. While the channel is
/// closed, no frame passes in either direction.
class Slcan final : public CanPort {
 public:
  static constexpr std::size_t kFrames = 32;  ///< Capacity of the queue of received frames.

  // Functions of CanPort, for the program that uses the node.

  [[nodiscard]] bool receive(CanFrame& frame) override;
  [[nodiscard]] bool send(const CanFrame& frame) override;
  [[nodiscard]] std::size_t room() const override;
  [[nodiscard]] CanHealth health() const override { return counts_; }
  void hear_only(std::span<const std::uint32_t> /*heard*/, std::size_t /*urgent*/) override {}

  // Functions for the program that moves bytes to and from the serial line.

  /// Processes bytes from the host, which may be split at any byte. A frame for which there is no
  /// free space counts as lost.
  void hear(std::span<const std::byte> bytes);
  /// Returns whether there is free space for all frames that one read from the wire may contain.
  [[nodiscard]] bool can_hear() const { return received_.size() < kFrames / 2; }
  /// Returns the bytes that must be sent to the host.
  [[nodiscard]] std::string_view to_say() const { return to_say_; }
  /// Removes the first `count` bytes of to_say() after they have been sent.
  /// @pre count is at most to_say().size()
  void said(std::size_t count) { to_say_.erase(0, count); }

  [[nodiscard]] bool open() const { return open_; }
  /// Closes the channel after the host has disconnected, and drops all waiting lines and frames.
  void close();

 private:
  static constexpr std::size_t kMaxToSay = 2048;

  [[nodiscard]] bool obey(std::string_view line);
  [[nodiscard]] bool take_frame(std::string_view line);

  std::string line_;
  std::string to_say_;
  std::deque<CanFrame> received_;
  CanHealth counts_{};
  bool open_ = false;
};

}  // namespace hal::host
