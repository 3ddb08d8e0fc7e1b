#include "host-sim/serve/internet_address.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace sim {

bool is_ip_address(const std::string& host) {
  in_addr address{};
  return ::inet_pton(AF_INET, host.c_str(), &address) == 1;
}

InternetAddress parse_address(std::string_view text) {
  InternetAddress address;
  const std::size_t colon = text.rfind(':');
  if (colon != std::string_view::npos) address.host = text.substr(0, colon);
  if (address.host == "localhost") address.host = "127.0.0.1";
  const std::string_view port = colon == std::string_view::npos ? text : text.substr(colon + 1);
  const char* end = port.data() + port.size();
  const auto [stop, fault] = std::from_chars(port.data(), end, address.port);
  if (fault != std::errc{} || stop != end || !is_ip_address(address.host)) {
    throw std::invalid_argument(
        fmt::format("`{}` is not PORT or ADDRESS:PORT, such as 127.0.0.1:2323", text));
  }
  return address;
}

std::string to_string(const InternetAddress& address) {
  return fmt::format("{}:{}", address.host, address.port);
}

bool is_loopback(const InternetAddress& address) { return address.host.starts_with("127."); }

}  // namespace sim
