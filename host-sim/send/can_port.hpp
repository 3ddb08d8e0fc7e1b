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

/// A controller on a CAN bus, as seen by its host. The port starts the node, sends heartbeats as
/// long as the port exists, and resets the node's communication at the end.
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
  Clock::duration silent_{};  ///< Time without a frame while this host listened.
  /// Number of frames of the node at the last call of hear_news().
  std::uint32_t frames_heard_ = 0;
  std::size_t emergencies_ = 0;  ///< Number of emergency messages already reported.
  bool started_ = false;
  std::deque<std::string> news_;
  std::string trouble_;
};

/// Opens a CAN interface of the kernel. Throws as the constructor of hal::host::SocketCan does.
[[nodiscard]] std::unique_ptr<Port> open_can_port(const std::string& interface, std::uint8_t node);

/// Opens a CAN bus at 1 Mbit/s through an adapter on a serial port (slcan). Throws as
/// open_serial_port() does.
[[nodiscard]] std::unique_ptr<Port> open_slcan_port(const std::string& device,
                                                    unsigned baud,
                                                    std::uint8_t node);

}  // namespace sim
