#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sim {

/// An address to listen at: an IPv4 address in digits, and a port.
struct InternetAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;
};

/// Reads `PORT` (on this machine only) or `ADDRESS:PORT`; `localhost` is 127.0.0.1. Throws
/// std::invalid_argument with the fault of the text.
[[nodiscard]] InternetAddress parse_address(std::string_view text);

[[nodiscard]] std::string to_string(const InternetAddress& address);

/// Returns whether `host` is an IPv4 address in digits.
[[nodiscard]] bool is_ip_address(const std::string& host);

/// Returns whether only programs on this machine can reach the address.
[[nodiscard]] bool is_loopback(const InternetAddress& address);

}  // namespace sim
