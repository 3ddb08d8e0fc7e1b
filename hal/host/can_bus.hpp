#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "hal/interface/can_port.hpp"

namespace hal::host {

/// Bits of a frame on the wire as the standard stuffs it, from its start to the silence after it
/// (ISO 11898-1). @pre the frame is one of 11 bits
[[nodiscard]] unsigned can_bits(const CanFrame& frame);

/// A CAN bus in virtual time: the smallest identifier wins, a frame that is disturbed is repeated,
/// whoever disturbs too much leaves the bus and comes back. Without anybody else on the bus nothing
/// is acknowledged and the first frame is repeated for ever.
class CanBus {
 public:
  /// A node's place. As the controller's driver: sends in order, 32 frames each way.
  class Node final : public CanPort {
   public:
    explicit Node(CanBus& bus) : bus_{bus} {}

    [[nodiscard]] bool receive(CanFrame& frame) override;
    [[nodiscard]] bool send(const CanFrame& frame) override;
    [[nodiscard]] std::size_t room() const override;
    [[nodiscard]] CanHealth health() const override;
    void hear_only(std::span<const std::uint32_t> /*heard*/, std::size_t /*urgent*/) override {}

    /// Pulled out, or plugged in again: neither hears nor speaks.
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
    std::uint64_t off_until_ns_ = 0;  ///< Bus-off.
    bool off_ = false;
    bool plugged_ = true;
    CanHealth counts_{};
  };

  CanBus(std::uint32_t bit_rate, std::uint64_t seed) : bit_ns_{1e9 / bit_rate}, random_{seed} {}

  /// Another node; it stays as long as the bus.
  [[nodiscard]] Node& join();
  /// Of the frames from now on this share is disturbed, anywhere within.
  void disturb(double share) { disturbed_share_ = share; }
  /// What the nodes have to send passes, up to this time; a frame that has begun ends.
  void advance_to(std::uint64_t now_ns);

  [[nodiscard]] std::uint64_t frames() const { return frames_; }        ///< Passed.
  [[nodiscard]] std::uint64_t disturbed() const { return disturbed_; }  ///< Not passed.

 private:
  void come_back();
  [[nodiscard]] Node* winner();
  [[nodiscard]] bool anybody_else(const Node& sender) const;
  void pass(Node& sender);
  void fail(Node& sender, bool acknowledged);
  /// In [0, 1), the same with every library.
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
