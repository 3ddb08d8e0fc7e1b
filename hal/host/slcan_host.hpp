#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <string_view>

#include "hal/host/slcan_text.hpp"
#include "hal/interface/can_port.hpp"

namespace hal::host {

/// The host's side of the protocol of Slcan: a node on the bus to which a serial adapter is
/// connected. Opens the adapter's channel at 1 Mbit/s.
class SlcanHost final : public CanPort {
 public:
  static constexpr std::size_t kFrames = 512;  ///< Capacity of the queue of received frames.

  // Functions of CanPort, for the program that uses the node.

  [[nodiscard]] bool receive(CanFrame& frame) override;
  [[nodiscard]] bool send(const CanFrame& frame) override;
  [[nodiscard]] std::size_t room() const override;
  [[nodiscard]] CanHealth health() const override { return counts_; }
  void hear_only(std::span<const std::uint32_t> /*heard*/, std::size_t /*urgent*/) override {}

  // Functions for the program that moves bytes to and from the serial line.

  /// Processes bytes from the adapter, which may be split at any byte. A frame for which there is
  /// no free space counts as lost. A refusal by the adapter is ignored, because the adapter also
  /// refuses to close a channel that is already closed.
  void hear(std::span<const char> bytes);
  [[nodiscard]] std::string_view to_say() const { return to_say_; }
  /// Removes the first `count` bytes of to_say() after they have been sent.
  /// @pre count is at most to_say().size()
  void said(std::size_t count) { to_say_.erase(0, count); }
  /// Queues the command that closes the channel. It must be the last command.
  void close() { to_say_ += "C\r"; }

 private:
  static constexpr std::size_t kMaxToSay = 2048;

  void take_line();

  std::string line_;
  // Initial commands: they end a line that an earlier program may have left open, close the channel
  // and open it at 1 Mbit/s.
  std::string to_say_{"\rC\rS8\rO\r"};
  std::deque<CanFrame> received_;
  CanHealth counts_{};
};

}  // namespace hal::host
