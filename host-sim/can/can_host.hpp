#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "firmware/link/can/can_identifiers.hpp"
#include "firmware/link/can/iso_tp_receiver.hpp"
#include "firmware/link/can/iso_tp_sender.hpp"
#include "hal/interface/byte_stream.hpp"
#include "hal/interface/can_port.hpp"

namespace sim {

/// The other end of a controller's CAN link: somebody who sends it lines, and hears it.
class CanHost final : public hal::ByteStream {
 public:
  static constexpr std::uint32_t kHeartbeatUs = 25'000;

  /// What a node said of a fault (CiA 301, 7.2.7.1).
  struct Emergency {
    std::uint16_t code = 0;
    std::uint8_t alarm = 0;
  };

  /// @param port outlives this
  CanHost(hal::CanPort& port, std::uint8_t node) : port_{port}, node_{node} {}

  CanHost(const CanHost&) = delete;
  CanHost& operator=(const CanHost&) = delete;
  ~CanHost() = default;

  /// Takes the frames that have come, sends those that are due; every millisecond or so.
  /// @param now microseconds
  void attend(hal::TickCount now);

  /// Text of the node; answers of others on the bus are passed over.
  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  /// Text to the node.
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;

  /// Realtime bytes, at most eight, beside the text. False: no room now.
  [[nodiscard]] bool act(std::span<const std::byte> bytes);
  /// To this node, or to all.
  [[nodiscard]] bool order(cnc::can::NetworkCommand command, bool all = false);
  /// No heartbeat, or one every kHeartbeatUs: without it the node waits for ever.
  void beat(bool beats) { beats_ = beats; }

  /// The last state that the node told; none before the first.
  [[nodiscard]] std::optional<cnc::can::NodeState> state() const { return state_; }
  /// So many frames of the node have come.
  [[nodiscard]] std::uint32_t frames() const { return frames_; }
  [[nodiscard]] const std::vector<Emergency>& emergencies() const { return emergencies_; }
  [[nodiscard]] const cnc::IsoTpReceiver::Counts& received() const { return receiver_.counts(); }
  [[nodiscard]] const cnc::IsoTpSender::Counts& sent() const { return sender_.counts(); }

 private:
  void take(const hal::CanFrame& frame, hal::TickCount now);
  [[nodiscard]] bool send(std::uint32_t id, std::span<const std::byte> payload);

  hal::CanPort& port_;
  std::uint8_t node_;
  cnc::IsoTpReceiver receiver_{};
  std::array<std::byte, 1024> said_{};
  cnc::IsoTpSender sender_{said_, cnc::IsoTpReceiver::kLongest};
  std::optional<cnc::can::NodeState> state_;
  std::vector<Emergency> emergencies_;
  std::uint32_t frames_ = 0;
  bool beats_ = true;
  hal::TickCount beaten_{};
};

}  // namespace sim
