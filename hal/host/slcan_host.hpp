#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <string_view>

#include "hal/host/slcan_text.hpp"
#include "hal/interface/can_port.hpp"

namespace hal::host {

/// The host's side of what Slcan is the adapter's side of: a node on the bus behind an adapter of
/// the serial kind. Opens its channel at 1 Mbit/s.
class SlcanHost final : public CanPort {
 public:
  static constexpr std::size_t kFrames = 512;  ///< Received, that wait.

  // The node's side.

  [[nodiscard]] bool receive(CanFrame& frame) override;
  [[nodiscard]] bool send(const CanFrame& frame) override;
  [[nodiscard]] std::size_t room() const override;
  [[nodiscard]] CanHealth health() const override { return counts_; }
  void hear_only(std::span<const std::uint32_t> /*heard*/, std::size_t /*urgent*/) override {}

  // The wire's side.

  /// Bytes of the adapter, in any pieces. A frame that there is no room for counts as lost. What
  /// the adapter refuses is passed over: it says so of a channel that was closed already, too.
  void hear(std::span<const char> bytes);
  [[nodiscard]] std::string_view to_say() const { return to_say_; }
  /// @pre count is at most to_say().size()
  void said(std::size_t count) { to_say_.erase(0, count); }
  /// The channel is to be closed; nothing else is said afterwards.
  void close() { to_say_ += "C\r"; }

 private:
  static constexpr std::size_t kMostToSay = 2048;

  void take_line();

  std::string line_;
  // Ends whatever the last program had begun, closes its channel and opens another.
  std::string to_say_{"\rC\rS8\rO\r"};
  std::deque<CanFrame> received_;
  CanHealth counts_{};
};

}  // namespace hal::host
