#pragma once

#include "hal/host/socket_can.hpp"
#include "host-sim/can/can_wire.hpp"

namespace sim {

/// A CAN interface of the kernel (SocketCAN).
class SocketCanWire final : public CanWire {
 public:
  /// Throws as the constructor of hal::host::SocketCan does.
  SocketCanWire(const std::string& interface, std::span<const std::uint32_t> heard)
      : interface_{interface}, socket_{interface, heard} {}

  [[nodiscard]] hal::CanPort& port() override { return socket_; }
  void carry() override { socket_.flush(); }
  void add_to(std::vector<pollfd>& descriptors) const override {
    descriptors.push_back({socket_.number(), POLLIN, 0});
  }
  [[nodiscard]] bool up() const override { return socket_.up(); }
  [[nodiscard]] std::string_view kind() const override { return "can"; }
  [[nodiscard]] std::string address() const override { return interface_; }

 private:
  std::string interface_;
  hal::host::SocketCan socket_;
};

}  // namespace sim
