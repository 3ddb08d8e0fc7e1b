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

/// A controller on a CAN bus: the same text as on any link, in messages of ISO 15765-2; realtime
/// bytes, emergency stop and heartbeats in frames of their own, which no text keeps waiting.
///
/// Somebody is there from the first frame to this node on, until the network is told to reset
/// its communication, the host's heartbeat, once heard, is silent for 80 ms, frames were lost, or
/// nobody takes what is said. After what was lost, text counts again only after the network was
/// started or the node reset: no line is put together from what is left. Main loop; no call blocks.
class CanLink final : public hal::SessionStream {
 public:
  /// A host that sends heartbeats sends one at least every 25 ms, or every third may be lost.
  static constexpr std::uint32_t kHostSilenceUs = 80'000;
  static constexpr std::uint32_t kHeartbeatUs = 500'000;

  /// What the machine is like, for heartbeats and emergency messages.
  struct Condition {
    bool stopped = false;    ///< An alarm.
    std::uint8_t alarm = 0;  ///< Its number, else 0.

    bool operator==(const Condition&) const = default;
  };

  /// @param port outlives this
  /// @param node 1 to can::kLastNode, until another is wanted
  explicit CanLink(hal::CanPort& port,
                   std::uint8_t node = can::kUsualNode,
                   const LssSlave::Identity& identity = {})
      : port_{port}, node_{node}, numbering_{identity} {}

  CanLink(const CanLink&) = delete;
  CanLink& operator=(const CanLink&) = delete;
  ~CanLink() = default;

  /// Before each turn: takes the frames that have come, sends those that are due.
  /// @param now microseconds
  void attend(hal::TickCount now);

  /// True once after an emergency stop: ends all motion, dark, and leaves an alarm.
  [[nodiscard]] bool take_stop() { return std::exchange(stop_, false); }
  /// Realtime bytes in the order in which they came; they act whatever the text is in the middle
  /// of.
  [[nodiscard]] bool take_realtime(std::byte& byte);

  /// Before attend(): of the time since then so much is no silence of the host's, because nobody
  /// could have heard it. Microseconds.
  void excuse_host(std::uint32_t time) { host_heard_ = host_heard_.plus(time); }

  /// The setting of this node's number, which it takes on as soon as nobody talks to it.
  /// @param node 1 to can::kLastNode
  void want_node(std::uint8_t node);
  /// The number that a master on the bus has set, once, when it is to be stored as the setting;
  /// note_stored() says whether it was. 0: nothing is.
  [[nodiscard]] std::uint8_t take_node_to_store() {
    return numbering_.take_store_request() ? numbering_.set_node() : 0;
  }
  void note_stored(bool ok) { static_cast<void>(send(can::kLssFrom, LssSlave::stored(ok))); }

  /// What is told to others from the next turn on.
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
  std::uint32_t lost_ = 0;  ///< Frames, messages and answers lost so far, as last seen.
  std::uint16_t error_ = can::kNoError;  ///< Of the link, not told yet.
  bool stop_ = false;
  bool host_beats_ = false;
  bool failed_ = false;  ///< Nobody is there until the network is started, or a reset comes.
  bool booting_ = true;
  std::uint8_t wanted_ = 0;  ///< The setting; 0: none.
  std::uint8_t next_ = 0;    ///< What this node's number is to become; 0: what it is.
  std::uint8_t heard_ = 0;   ///< The number that the port was told of.
  Condition condition_{};
  Condition told_{};
  hal::TickCount host_heard_{};
  hal::TickCount beaten_{};  ///< The last heartbeat.
};

}  // namespace cnc
