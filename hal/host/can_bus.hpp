#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "hal/interface/can_port.hpp"

namespace hal::host {

/// Returns the number of bits of a standard frame on the wire, including stuffed bits. The count
/// extends from the start of the frame to the end of the silence after it (ISO 11898-1).
/// @pre `frame` has an identifier of 11 bits
[[nodiscard]] unsigned can_bits(const CanFrame& frame);

/// A CAN bus in virtual time. The frame with the smallest identifier is sent first. A disturbed
/// frame is repeated. A node with too many errors leaves the bus (bus-off) and returns later. If a
/// node is alone on the bus, no other node acknowledges its frames, and it repeats its first frame
/// forever.
class CanBus {
 public:
  /// A node on the bus. It behaves like the controller's driver: it sends frames in the order of
  /// the calls and queues up to 32 frames in each direction.
  class Node final : public CanPort {
   public:
    explicit Node(CanBus& bus) : bus_{bus} {}

    [[nodiscard]] bool receive(CanFrame& frame) override;
    [[nodiscard]] bool send(const CanFrame& frame) override;
    [[nodiscard]] std::size_t room() const override;
    [[nodiscard]] CanHealth health() const override;
    void hear_only(std::span<const std::uint32_t> /*heard*/, std::size_t /*urgent*/) override {}

    /// Connects the node to the bus, or disconnects it. A disconnected node neither receives nor
    /// sends.
    void plug(bool in) { plugged_ = in; }

   private:
    friend CanBus;
    static constexpr std::size_t kFrames = 32;

    void hear(const CanFrame& frame);
    void be_disturbed(unsigned errors, bool transmits);

    CanBus& bus_;
    std::deque<CanFrame> to_send_;
    std::deque<CanFrame> received_;
    unsigned transmit_errors_ = 0;
    unsigned receive_errors_ = 0;
    std::uint64_t off_until_ns_ = 0;  ///< Time at which bus-off ends, nanoseconds.
    bool off_ = false;
    bool plugged_ = true;
    CanHealth counts_{};
  };

  CanBus(std::uint32_t bit_rate, std::uint64_t seed) : bit_ns_{1e9 / bit_rate}, random_{seed} {}

  /// Adds a node. The node exists until the bus is destroyed.
  [[nodiscard]] Node& join();
  /// Sets the share of future frames that are disturbed, 0 to 1. Each is disturbed at a random bit.
  void disturb(double share) { disturbed_share_ = share; }
  /// Transfers the frames that the nodes have queued, until the time `now_ns`. A frame that has
  /// begun by that time is completed.
  void advance_to(std::uint64_t now_ns);

  /// Returns the number of frames that were transferred without disturbance.
  [[nodiscard]] std::uint64_t frames() const { return frames_; }
  /// Returns the number of frames that were disturbed.
  [[nodiscard]] std::uint64_t disturbed() const { return disturbed_; }

 private:
  void come_back();
  [[nodiscard]] Node* winner();
  [[nodiscard]] bool anybody_else(const Node& sender) const;
  void pass(Node& sender);
  void fail(Node& sender, bool acknowledged);
  /// Returns a random number in [0, 1). The sequence is the same with every standard library.
  [[nodiscard]] double chance() { return static_cast<double>(random_() >> 11) * 0x1.0p-53; }
  void spend(double bits) { now_ns_ += bits * bit_ns_; }

  double bit_ns_;
  double now_ns_ = 0.0;
  double disturbed_share_ = 0.0;
  std::mt19937_64 random_;
  std::uint64_t frames_ = 0;
  std::uint64_t disturbed_ = 0;
  std::vector<std::unique_ptr<Node>> nodes_;
};

}  // namespace hal::host
