#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sim {

/// Where to listen: an IPv4 address in digits and a port.
struct InternetAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;
};

/// Reads `PORT` (on this machine only) or `ADDRESS:PORT`; `localhost` is
/// 127.0.0.1. Throws std::invalid_argument saying what is wrong with it.
[[nodiscard]] InternetAddress parse_address(std::string_view text);

[[nodiscard]] std::string to_string(const InternetAddress& address);

/// Whether it is an IPv4 address in digits.
[[nodiscard]] bool is_ip_address(const std::string& host);

/// Whether only programs on this machine can reach it.
[[nodiscard]] bool is_loopback(const InternetAddress& address);

}  // namespace sim
