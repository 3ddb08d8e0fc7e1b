#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>

#include "host-sim/can/can_host.hpp"
#include "host-sim/can/can_wire.hpp"
#include "host-sim/send/port.hpp"

namespace sim {

/// A controller on a CAN bus, as its host has it: begins by starting the network's node, beats
/// while it lives, and says at the end that the host is done.
class CanNodePort final : public Port {
 public:
  CanNodePort(std::unique_ptr<CanWire> wire, std::uint8_t node);
  CanNodePort(const CanNodePort&) = delete;
  CanNodePort& operator=(const CanNodePort&) = delete;
  ~CanNodePort() override;

  [[nodiscard]] std::size_t read(std::span<char> into) override;
  [[nodiscard]] std::size_t write(std::string_view bytes) override;
  [[nodiscard]] std::size_t act(std::string_view bytes) override;
  [[nodiscard]] bool open() const override { return trouble_.empty(); }
  [[nodiscard]] std::string trouble() const override { return trouble_; }
  [[nodiscard]] std::string take_news() override;
  void add_to(std::vector<pollfd>& descriptors) const override { wire_->add_to(descriptors); }

 private:
  using Clock = std::chrono::steady_clock;

  void attend();
  void hear_news(Clock::time_point now);
  void look_for_trouble();

  std::unique_ptr<CanWire> wire_;
  std::uint8_t node_;
  CanHost host_;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point looked_ = begun_;
  Clock::duration silent_{};        ///< Of the node, while we listened.
  std::uint32_t frames_heard_ = 0;  ///< Of the node, as last seen.
  std::size_t emergencies_ = 0;     ///< Told.
  bool started_ = false;
  std::deque<std::string> news_;
  std::string trouble_;
};

/// Throws as hal::host::SocketCan.
[[nodiscard]] std::unique_ptr<Port> open_can_port(const std::string& interface, std::uint8_t node);

/// Behind an adapter of the serial kind (slcan), at 1 Mbit/s. Throws as open_serial_port().
[[nodiscard]] std::unique_ptr<Port> open_slcan_port(const std::string& device,
                                                    unsigned baud,
                                                    std::uint8_t node);

}  // namespace sim
