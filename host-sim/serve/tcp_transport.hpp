#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/internet_address.hpp"
#include "host-sim/serve/transport.hpp"

namespace sim {

/// Raw TCP: bytes pass unchanged. There are no telnet commands, so 0xFF is a byte like any other.
/// Small answers are sent immediately (TCP_NODELAY).
class TcpTransport final : public Transport {
 public:
  /// Throws std::system_error naming the address.
  /// @param address address to listen at; port 0 stands for any free port
  explicit TcpTransport(const InternetAddress& address);

  [[nodiscard]] std::unique_ptr<Connection> accept() override;
  void add_to(std::vector<pollfd>& descriptors) const override;
  [[nodiscard]] std::string_view kind() const override { return "tcp"; }
  [[nodiscard]] std::string address() const override { return to_string(address_); }

 private:
  InternetAddress address_;
  hal::host::Descriptor listener_;
};

}  // namespace sim
