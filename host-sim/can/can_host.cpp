#include "host-sim/can/can_host.hpp"

#include <algorithm>
#include <array>

namespace sim {

namespace can = cnc::can;

void CanHost::attend(hal::TickCount now) {
  for (hal::CanFrame frame; port_.receive(frame);) take(frame, now);
  if (beats_ && now.reached(beaten_.plus(kHeartbeatUs))) {
    const std::array operational{static_cast<std::byte>(can::NodeState::kOperational)};
    if (send(can::kHostHeartbeat, operational)) beaten_ = now;
  }
  if (port_.room() == 0) return;
  if (const auto flow = receiver_.flow_due(now)) {
    const std::array payload = cnc::iso_tp::bytes_of(*flow);
    static_cast<void>(send(can::kTextTo + node_, payload));
  }
  while (port_.room() > 1) {
    const auto payload = sender_.next(now);
    if (!payload || !send(can::kTextTo + node_, payload->span())) return;
  }
}

void CanHost::take(const hal::CanFrame& frame, hal::TickCount now) {
  if (frame.extended || frame.remote) return;
  const std::array ours = can::heard_by_host(node_);
  if (std::find(ours.begin(), ours.end(), frame.id) != ours.end()) ++frames_;
  const std::span payload = std::span{frame.data}.first(frame.length);
  if (frame.id == can::kTextFrom + node_) {
    receiver_.take(payload, now);
    sender_.take(payload, now);
  } else if (frame.id == can::kHeartbeat + node_ && !payload.empty()) {
    state_ = static_cast<can::NodeState>(payload[0]);
  } else if (frame.id == can::kEmergency + node_ && payload.size() > 3) {
    const auto byte = [&](std::size_t at) { return std::to_integer<unsigned>(payload[at]); };
    emergencies_.push_back({.code = static_cast<std::uint16_t>(byte(1) << 8 | byte(0)),
                            .alarm = static_cast<std::uint8_t>(byte(3))});
  }
}

std::size_t CanHost::read(std::span<std::byte> into) { return receiver_.read(into); }

std::size_t CanHost::write(std::span<const std::byte> from) { return sender_.write(from); }

bool CanHost::act(std::span<const std::byte> bytes) {
  return bytes.size() <= 8 && send(can::kRealtime + node_, bytes);
}

bool CanHost::order(can::NetworkCommand command, bool all) {
  const std::array payload{static_cast<std::byte>(command),
                           all ? std::byte{0} : static_cast<std::byte>(node_)};
  return send(can::kNetwork, payload);
}

bool CanHost::send(std::uint32_t id, std::span<const std::byte> payload) {
  return port_.send(hal::can_frame(id, payload));
}

}  // namespace sim
