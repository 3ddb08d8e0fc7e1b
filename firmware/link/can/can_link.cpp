#include "firmware/link/can/can_link.hpp"

#include <algorithm>

#include "firmware/link/realtime_byte.hpp"

namespace cnc {

void CanLink::attend(hal::TickCount now) {
  follow_node();
  hal::CanFrame frame;
  for (std::size_t n = 0; n < kFramesInATurn && port_.receive(frame); ++n) take(frame, now);
  look_for_loss(now);
  send_due(now);
}

void CanLink::want_node(std::uint8_t node) {
  if (node == wanted_) return;
  wanted_ = node;
  next_ = node;
}

/// Changes to the node number `next_`. Waits while a host communicates with the node or a master is
/// setting a number.
void CanLink::follow_node() {
  if (next_ != 0 && session_ == 0 && !numbering_.configured_now()) {
    booting_ = booting_ || next_ != node_;
    node_ = std::exchange(next_, std::uint8_t{0});
  }
  if (heard_ == node_) return;
  heard_ = node_;
  port_.hear_only(can::heard_by_node(node_), can::kUrgent);
}

void CanLink::take(const hal::CanFrame& frame, hal::TickCount now) {
  if (frame.extended || frame.remote) return;
  const std::span payload = std::span{frame.data}.first(frame.length);
  if (frame.id == can::kFailSafe) {
    stop_ = true;
  } else if (frame.id == can::kNetwork) {
    take_network(payload, now);
  } else if (frame.id == can::kRealtime + node_) {
    take_realtime(payload);
    if (!failed_) begin_session();
  } else if (frame.id == can::kTextTo + node_) {
    if (failed_) return;
    begin_session();
    receiver_.take(payload, now);
    sender_.take(payload, now);
  } else if (frame.id == can::kHostHeartbeat) {
    host_beats_ = true;
    host_heard_ = now;
  } else if (frame.id == can::kLssTo) {
    if (const auto reply = numbering_.take(payload, node_)) {
      // A failure is ignored, because the master repeats requests without an answer.
      static_cast<void>(send(can::kLssFrom, *reply));
    }
  }
}

void CanLink::take_network(std::span<const std::byte> payload, hal::TickCount now) {
  if (payload.size() < 2) return;
  const auto addressed = std::to_integer<std::uint8_t>(payload[1]);
  if (addressed != 0 && addressed != node_) return;
  switch (static_cast<can::NetworkCommand>(payload[0])) {
    case can::NetworkCommand::kStart:
      host_heard_ = now;
      failed_ = false;
      return begin_session();
    case can::NetworkCommand::kStop:
      stop_ = true;
      return;
    case can::NetworkCommand::kResetNode: {
      const std::array reset{static_cast<std::byte>(RealtimeByte::kReset)};
      return take_realtime(reset);
    }
    case can::NetworkCommand::kResetCommunication:
      numbering_.end_configuration();
      if (numbering_.set_node() != 0) next_ = numbering_.set_node();
      return end_session(can::kNoError);
  }
}

/// Queues realtime bytes. A reset empties the queue first, so a reset always has free space.
void CanLink::take_realtime(std::span<const std::byte> payload) {
  for (const std::byte byte : payload) {
    if (static_cast<RealtimeByte>(byte) == RealtimeByte::kReset) {
      realtime_.clear();
      receiver_.clear();  // Drops all text that arrived before the reset.
      failed_ = false;
    }
    if (realtime_.room() == 0) return end_session(can::kFramesLost);
    realtime_.add({&byte, 1});
  }
  realtime_.settle();
}

bool CanLink::take_realtime(std::byte& byte) {
  if (realtime_.settled() == 0) return false;
  byte = realtime_.at(0);
  realtime_.drop(1);
  return true;
}

void CanLink::begin_session() {
  if (session_ != 0) return;
  receiver_.clear();
  sender_.clear();
  ++sessions_;
  if (sessions_ == 0) sessions_ = 1;  // Number 0 means that no host is connected.
  session_ = sessions_;
}

void CanLink::end_session(std::uint16_t error) {
  if (error != can::kNoError) error_ = error;
  failed_ = error != can::kNoError;
  session_ = 0;
  host_beats_ = false;
  realtime_.clear();
}

/// Ends the session if text was lost, because incomplete text must not be used. Also ends the
/// session if the host is silent.
void CanLink::look_for_loss(hal::TickCount now) {
  const std::uint32_t lost =
      port_.health().lost_frames + receiver_.counts().lost + sender_.counts().given_up;
  if (lost != lost_ && session_ != 0) end_session(can::kFramesLost);
  lost_ = lost;
  if (session_ != 0 && host_beats_ && now.reached(host_heard_.plus(kHostSilenceUs))) {
    end_session(can::kHostSilent);
  }
}

void CanLink::send_due(hal::TickCount now) {
  if (!send_emergency()) return;
  if (booting_ || now.reached(beaten_.plus(kHeartbeatUs))) {
    const std::array beat{state()};
    if (!send(can::kHeartbeat + node_, beat)) return;
    booting_ = false;
    beaten_ = now;
  }
  if (session_ == 0) return;
  if (port_.room() == 0) return;
  if (const auto flow = receiver_.flow_due(now)) {
    const std::array payload = iso_tp::bytes_of(*flow);
    // This cannot fail, because room() is above 0.
    static_cast<void>(send(can::kTextFrom + node_, payload));
  }
  for (std::size_t n = 0; n < kFramesInATurn && port_.room() > 1; ++n) {
    const auto payload = sender_.next(now);
    if (!payload || !send(can::kTextFrom + node_, payload->span())) return;
  }
}

bool CanLink::send(std::uint32_t id, std::span<const std::byte> payload) {
  return port_.send(hal::can_frame(id, payload));
}

/// Sends an emergency message if the link has failed, or if an alarm begins or ends. Returns true
/// if no emergency message remains to be sent.
bool CanLink::send_emergency() {
  if (error_ == can::kNoError && told_ == condition_) return true;
  const bool alarm = error_ == can::kNoError && condition_.stopped;
  const std::uint16_t code = alarm ? can::kDeviceSpecific : error_;
  constexpr std::byte kGeneric{0x01};
  constexpr std::byte kCommunication{0x11};
  const std::byte kind = alarm ? kGeneric : code != can::kNoError ? kCommunication : std::byte{0};
  const std::array<std::byte, 8> payload{static_cast<std::byte>(code & 0xFFU),
                                         static_cast<std::byte>(code >> 8),
                                         kind,
                                         static_cast<std::byte>(condition_.alarm)};
  if (!send(can::kEmergency + node_, payload)) return false;
  if (error_ == can::kNoError) told_ = condition_;
  error_ = can::kNoError;
  return true;
}

std::byte CanLink::state() const {
  if (booting_) return static_cast<std::byte>(can::NodeState::kBooting);
  if (condition_.stopped) return static_cast<std::byte>(can::NodeState::kStopped);
  return static_cast<std::byte>(session_ != 0 ? can::NodeState::kOperational
                                              : can::NodeState::kPreOperational);
}

std::size_t CanLink::read(std::span<std::byte> into) {
  return session_ != 0 ? receiver_.read(into) : 0;
}

std::size_t CanLink::write(std::span<const std::byte> from) {
  return session_ != 0 ? sender_.write(from) : 0;
}

}  // namespace cnc
