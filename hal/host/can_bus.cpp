#include "hal/host/can_bus.hpp"

#include <algorithm>
#include <stdexcept>

namespace hal::host {
namespace {

constexpr unsigned kAfterTheData =
    1 + 1 + 1 + 7 + 3;  ///< Bits of CRC delimiter, acknowledgement, its delimiter, end, silence.
constexpr unsigned kErrorBits = 6 + 8 + 3;  ///< Bits of error flag, error delimiter, silence.
constexpr unsigned kErrorOfSender = 8;
constexpr unsigned kPassive = 128;
constexpr unsigned kWarning = 96;
constexpr unsigned kBusOff = 256;
constexpr double kBitsOfSilence = 128.0 * 11.0;

/// Counts the bits of a frame on the wire. After five equal bits the sender inserts (stuffs) one
/// bit of the opposite value.
class StuffedBits {
 public:
  void add(unsigned value, unsigned width) {
    for (unsigned at = width; at-- > 0;) add((value >> at & 1U) != 0);
  }
  void add_checksum() { add(crc_, 15); }
  [[nodiscard]] unsigned count() const { return count_; }

 private:
  void add(bool bit) {
    check(bit);
    ++count_;
    alike_ = count_ > 1 && bit == last_ ? alike_ + 1 : 1;
    last_ = bit;
    if (alike_ < 5) return;
    ++count_;
    last_ = !bit;
    alike_ = 1;
  }
  void check(bool bit) {
    const bool turns = bit != ((crc_ >> 14 & 1U) != 0);
    crc_ = crc_ << 1 & 0x7FFFU;
    if (turns) crc_ ^= 0x4599U;
  }

  unsigned count_ = 0;
  unsigned alike_ = 0;
  unsigned crc_ = 0;
  bool last_ = false;
};

}  // namespace

unsigned can_bits(const CanFrame& frame) {
  if (frame.extended) throw std::invalid_argument("CanBus: only identifiers of 11 bits");
  StuffedBits bits;
  bits.add(0, 1);
  bits.add(frame.id, 11);
  bits.add(frame.remote ? 4 : 0, 3);
  bits.add(frame.length, 4);
  for (std::size_t at = 0; at < frame.length && !frame.remote; ++at) {
    bits.add(std::to_integer<unsigned>(frame.data[at]), 8);
  }
  bits.add_checksum();
  return bits.count() + kAfterTheData;
}

bool CanBus::Node::receive(CanFrame& frame) {
  if (received_.empty()) return false;
  frame = received_.front();
  received_.pop_front();
  return true;
}

bool CanBus::Node::send(const CanFrame& frame) {
  if (frame.length > frame.data.size() || room() == 0) return false;
  to_send_.push_back(frame);
  return true;
}

std::size_t CanBus::Node::room() const { return kFrames - to_send_.size(); }

CanHealth CanBus::Node::health() const {
  CanHealth health = counts_;
  const unsigned errors = std::max(transmit_errors_, receive_errors_);
  health.state = off_                 ? CanState::kBusOff
                 : errors >= kPassive ? CanState::kPassive
                 : errors >= kWarning ? CanState::kWarning
                                      : CanState::kActive;
  health.transmit_errors = static_cast<std::uint8_t>(std::min(transmit_errors_, 255U));
  health.receive_errors = static_cast<std::uint8_t>(std::min(receive_errors_, 255U));
  return health;
}

void CanBus::Node::hear(const CanFrame& frame) {
  if (receive_errors_ > 0) --receive_errors_;
  if (received_.size() == kFrames) {
    ++counts_.lost_frames;
  } else {
    received_.push_back(frame);
  }
}

void CanBus::Node::be_disturbed(unsigned errors, bool transmits) {
  unsigned& counter = transmits ? transmit_errors_ : receive_errors_;
  counter += errors;
  if (!transmits) counter = std::min(counter, kPassive + 7);
  if (transmit_errors_ < kBusOff) return;
  off_ = true;
  ++counts_.bus_offs;
  off_until_ns_ = static_cast<std::uint64_t>(bus_.now_ns_ + kBitsOfSilence * bus_.bit_ns_);
}

CanBus::Node& CanBus::join() {
  nodes_.push_back(std::make_unique<Node>(*this));
  return *nodes_.back();
}

void CanBus::advance_to(std::uint64_t now_ns) {
  const auto end_ns = static_cast<double>(now_ns);
  while (now_ns_ < end_ns) {
    come_back();
    Node* const sender = winner();
    if (sender == nullptr) {
      // No node is ready to send: time advances until the next node returns from bus-off, or to the
      // end of this call.
      double next_ns = end_ns;
      for (const auto& node : nodes_) {
        if (node->off_) next_ns = std::min(next_ns, static_cast<double>(node->off_until_ns_));
      }
      now_ns_ = std::max(next_ns, now_ns_ + bit_ns_);
      continue;
    }
    const bool acknowledged = anybody_else(*sender);
    if (acknowledged && chance() >= disturbed_share_) {
      pass(*sender);
    } else {
      fail(*sender, acknowledged);
    }
  }
}

void CanBus::come_back() {
  for (const auto& node : nodes_) {
    if (!node->off_ || now_ns_ < static_cast<double>(node->off_until_ns_)) continue;
    node->off_ = false;
    node->transmit_errors_ = node->receive_errors_ = 0;
  }
}

/// Returns the node that sends next: its frame has the smallest identifier of all waiting frames.
/// Returns null if no frame waits.
CanBus::Node* CanBus::winner() {
  Node* best = nullptr;
  for (const auto& node : nodes_) {
    if (node->off_ || !node->plugged_ || node->to_send_.empty()) continue;
    if (best == nullptr || node->to_send_.front().id < best->to_send_.front().id) {
      best = node.get();
    }
  }
  return best;
}

bool CanBus::anybody_else(const Node& sender) const {
  return std::any_of(nodes_.begin(), nodes_.end(), [&](const auto& node) {
    return node.get() != &sender && !node->off_ && node->plugged_;
  });
}

void CanBus::pass(Node& sender) {
  const CanFrame frame = sender.to_send_.front();
  sender.to_send_.pop_front();
  spend(can_bits(frame));
  if (sender.transmit_errors_ > 0) --sender.transmit_errors_;
  ++frames_;
  for (const auto& node : nodes_) {
    if (node.get() != &sender && !node->off_ && node->plugged_) node->hear(frame);
  }
}

void CanBus::fail(Node& sender, bool acknowledged) {
  spend(chance() * can_bits(sender.to_send_.front()) + kErrorBits);
  ++disturbed_;
  // If no other node acknowledges, the sender's error count rises only until the node is error
  // passive (ISO 11898-1, 12.1.4.2).
  if (acknowledged || sender.transmit_errors_ < kPassive) {
    sender.be_disturbed(kErrorOfSender, true);
  }
  for (const auto& node : nodes_) {
    if (node.get() != &sender && !node->off_ && node->plugged_) node->be_disturbed(1, false);
  }
}

}  // namespace hal::host
