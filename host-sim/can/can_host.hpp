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

/// The host's end of the CAN link to one controller: sends lines to the node and receives its text.
class CanHost final : public hal::ByteStream {
 public:
  static constexpr std::uint32_t kHeartbeatUs = 25'000;

  /// Emergency message of a node (CiA 301, 7.2.7.1).
  struct Emergency {
    std::uint16_t code = 0;
    std::uint8_t alarm = 0;
  };

  /// @param port must outlive this object
  CanHost(hal::CanPort& port, std::uint8_t node) : port_{port}, node_{node} {}

  CanHost(const CanHost&) = delete;
  CanHost& operator=(const CanHost&) = delete;
  ~CanHost() = default;

  /// Takes the frames that have arrived and sends the frames that are due. Must be called about
  /// every millisecond.
  /// @param now microseconds
  void attend(hal::TickCount now);

  /// Reads text that the node has sent. Answers of other nodes on the bus are ignored.
  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  /// Queues text for the node.
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;

  /// Sends at most eight realtime bytes in a separate frame. Returns whether the port had capacity
  /// for the frame.
  [[nodiscard]] bool act(std::span<const std::byte> bytes);
  /// Sends a network command to this node, or to all nodes. Returns whether the port had capacity
  /// for the frame.
  [[nodiscard]] bool order(cnc::can::NetworkCommand command, bool all = false);
  /// Sets whether a heartbeat is sent every kHeartbeatUs. Without any heartbeat in a session, the
  /// node waits for the host without a time limit.
  void beat(bool beats) { beats_ = beats; }

  /// Returns the state in the node's last heartbeat; empty before the first heartbeat.
  [[nodiscard]] std::optional<cnc::can::NodeState> state() const { return state_; }
  /// Returns the number of frames that have arrived from the node.
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
