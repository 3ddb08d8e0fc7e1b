#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "firmware/link/can/can_identifiers.hpp"
#include "firmware/link/can/iso_tp_receiver.hpp"
#include "firmware/link/can/iso_tp_sender.hpp"
#include "firmware/link/can/lss_slave.hpp"
#include "hal/interface/can_port.hpp"
#include "hal/interface/session_stream.hpp"
#include "hal/interface/tick_count.hpp"

namespace cnc {

/// A controller's link to a CAN bus. Text is the same as on any link and travels in messages of ISO
/// 15765-2. Realtime bytes, emergency stop and heartbeats have separate frames, which never wait
/// for text.
///
/// A session begins with the first text or realtime frame to this node, or when a host starts the
/// network. It ends if a host resets the communication, frames were lost, or the host does not
/// accept the answers. It also ends if heartbeats of the host have been received and then stay away
/// for 80 ms. After a loss, no text is accepted until a host starts the network or resets the node,
/// so that no line is composed of incomplete text. Main loop; no call blocks.
class CanLink final : public hal::SessionStream {
 public:
  /// Silence of the host's heartbeat after which the host counts as gone, microseconds. A host that
  /// sends heartbeats must send one at least every 25 ms, so that two of three may be lost.
  static constexpr std::uint32_t kHostSilenceUs = 80'000;
  static constexpr std::uint32_t kHeartbeatUs = 500'000;

  /// Condition of the machine that heartbeats and emergency messages report.
  struct Condition {
    bool stopped = false;    ///< The machine has an alarm.
    std::uint8_t alarm = 0;  ///< Number of the alarm; 0 for none.

    bool operator==(const Condition&) const = default;
  };

  /// @param port outlives this object
  /// @param node node number, 1 to can::kLastNode, until want_node() sets another
  explicit CanLink(hal::CanPort& port,
                   std::uint8_t node = can::kUsualNode,
                   const LssSlave::Identity& identity = {})
      : port_{port}, node_{node}, numbering_{identity} {}

  CanLink(const CanLink&) = delete;
  CanLink& operator=(const CanLink&) = delete;
  ~CanLink() = default;

  /// Processes the frames that have arrived and sends the frames that are due. Called before each
  /// cycle.
  /// @param now microseconds
  void attend(hal::TickCount now);

  /// Returns true once after an emergency stop was received. The caller must then end all motion,
  /// switch the beam off and set an alarm.
  [[nodiscard]] bool take_stop() { return std::exchange(stop_, false); }
  /// Takes the oldest realtime byte. The byte acts even if a line of text is incomplete. Returns
  /// false if there is none.
  [[nodiscard]] bool take_realtime(std::byte& byte);

  /// Does not count `time` as silence of the host, because the controller could not receive frames
  /// during this time. Called before attend().
  /// @param time microseconds
  void excuse_host(std::uint32_t time) { host_heard_ = host_heard_.plus(time); }

  /// Sets the node number from the settings. It takes effect as soon as no host communicates with
  /// the node.
  /// @param node 1 to can::kLastNode
  void want_node(std::uint8_t node);
  /// Returns the number that a master on the bus has set and requests to store as the setting.
  /// Returns each such number once; 0 if there is none. The caller then reports the result with
  /// note_stored().
  [[nodiscard]] std::uint8_t take_node_to_store() {
    return numbering_.take_store_request() ? numbering_.set_node() : 0;
  }
  void note_stored(bool ok) { static_cast<void>(send(can::kLssFrom, LssSlave::stored(ok))); }

  /// Sets the condition of the machine that is sent to other nodes from the next attend() on.
  void tell(const Condition& condition) { condition_ = condition; }

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;
  [[nodiscard]] std::uint32_t session() const override { return session_; }

  [[nodiscard]] std::uint8_t node() const { return node_; }
  [[nodiscard]] const IsoTpReceiver::Counts& received() const { return receiver_.counts(); }
  [[nodiscard]] const IsoTpSender::Counts& sent() const { return sender_.counts(); }

 private:
  static constexpr std::size_t kFramesInATurn = 16;
  static constexpr std::size_t kRealtimeBytes = 32;
  static constexpr std::size_t kSaidBytes = 256;

  void take(const hal::CanFrame& frame, hal::TickCount now);
  void take_network(std::span<const std::byte> payload, hal::TickCount now);
  void take_realtime(std::span<const std::byte> payload);
  void follow_node();
  void begin_session();
  void end_session(std::uint16_t error);
  void look_for_loss(hal::TickCount now);
  void send_due(hal::TickCount now);
  [[nodiscard]] bool send(std::uint32_t id, std::span<const std::byte> payload);
  [[nodiscard]] bool send_emergency();
  [[nodiscard]] std::byte state() const;

  hal::CanPort& port_;
  std::uint8_t node_;
  LssSlave numbering_;
  IsoTpReceiver receiver_{};
  std::array<std::byte, kSaidBytes> said_{};
  IsoTpSender sender_{said_, kSaidBytes / 2};
  std::array<std::byte, kRealtimeBytes> acts_{};
  TextQueue realtime_{acts_};
  std::uint32_t session_ = 0;
  std::uint32_t sessions_ = 0;
  /// Number of lost frames, lost messages and abandoned answers, in total, at the last check.
  std::uint32_t lost_ = 0;
  std::uint16_t error_ = can::kNoError;  ///< Error of the link that has not been sent yet.
  bool stop_ = false;
  bool host_beats_ = false;
  bool failed_ = false;  ///< No session begins until a host starts the network or sends a reset.
  bool booting_ = true;
  std::uint8_t wanted_ = 0;  ///< Node number from the settings; 0: none.
  std::uint8_t next_ = 0;    ///< Node number to change to; 0: no change.
  std::uint8_t heard_ = 0;   ///< Node number for which the port filters frames.
  Condition condition_{};
  Condition told_{};
  hal::TickCount host_heard_{};
  hal::TickCount beaten_{};  ///< Time of the last heartbeat.
};

}  // namespace cnc
