#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <string>
#include <string_view>

#include "hal/host/slcan_text.hpp"
#include "hal/interface/can_port.hpp"

namespace hal::host {

/// The adapter's side of the serial-line protocol for CAN (Lawicel's, as slcand and python-can
/// speak it): a node on a bus that consists of it and the host.
///
/// `t12320A0B` CR is a frame of 11 bits, `T` one of 29, `r` and `R` ask for one; `O` opens the
/// channel, `C` closes it, `S0`…`S8` and `s` set a rate, which means nothing here, `F` asks for
/// the state and `V` and `N` for version and number. Each line is answered: CR, or BEL where it
/// was refused. Before `O` no frame passes, either way.
class Slcan final : public CanPort {
 public:
  static constexpr std::size_t kFrames = 32;  ///< That wait for either side.

  // The node's side.

  [[nodiscard]] bool receive(CanFrame& frame) override;
  [[nodiscard]] bool send(const CanFrame& frame) override;
  [[nodiscard]] std::size_t room() const override;
  [[nodiscard]] CanHealth health() const override { return counts_; }
  void hear_only(std::span<const std::uint32_t> /*heard*/, std::size_t /*urgent*/) override {}

  // The wire's side.

  /// Bytes of the host, in any pieces. A frame that there is no room for is counted as lost.
  void hear(std::span<const std::byte> bytes);
  /// There is room for what a read of the wire may bring: those frames that have come wait.
  [[nodiscard]] bool can_hear() const { return received_.size() < kFrames / 2; }
  /// What the host is to be told.
  [[nodiscard]] std::string_view to_say() const { return to_say_; }
  /// @pre count is at most to_say().size()
  void said(std::size_t count) { to_say_.erase(0, count); }

  [[nodiscard]] bool open() const { return open_; }
  /// The host is gone: the channel is closed, and all there is forgotten.
  void close();

 private:
  static constexpr std::size_t kMostToSay = 2048;

  [[nodiscard]] bool obey(std::string_view line);
  [[nodiscard]] bool take_frame(std::string_view line);

  std::string line_;
  std::string to_say_;
  std::deque<CanFrame> received_;
  CanHealth counts_{};
  bool open_ = false;
};

}  // namespace hal::host
