#pragma once

#include <memory>
#include <string>
#include <vector>

#include "hal/host/slcan.hpp"
#include "host-sim/can/can_wire.hpp"
#include "host-sim/serve/tcp_transport.hpp"

namespace sim {

/// A serial CAN adapter (slcan) at a TCP port, for python-can's `socket://` and socat. It serves
/// one host at a time; a host that connects meanwhile waits.
class TcpSlcanWire final : public CanWire {
 public:
  /// Throws as the constructor of TcpTransport does.
  explicit TcpSlcanWire(const InternetAddress& address) : listener_{address} {}

  [[nodiscard]] hal::CanPort& port() override { return slcan_; }
  void carry() override;
  void add_to(std::vector<pollfd>& descriptors) const override;
  [[nodiscard]] std::string_view kind() const override { return "slcan"; }
  [[nodiscard]] std::string address() const override { return "tcp:" + listener_.address(); }

 private:
  TcpTransport listener_;
  std::unique_ptr<Connection> host_;
  hal::host::Slcan slcan_{};
};

}  // namespace sim
