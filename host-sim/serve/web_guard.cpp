#include "host-sim/serve/web_guard.hpp"

#include <fmt/format.h>

#include <string>

namespace sim {
namespace {

constexpr std::string_view kScheme = "http://";
constexpr std::uint16_t kStandardPort = 80;

}  // namespace

bool is_our_host(std::string_view host, const InternetAddress& listening) {
  const std::string port = fmt::format(":{}", listening.port);
  if (host.ends_with(port)) {
    host.remove_suffix(port.size());
  } else if (listening.port != kStandardPort) {
    return false;
  }
  if (host == "localhost" || host == listening.host) return true;
  const std::string name{host};
  if (!is_ip_address(name)) return false;
  return name.starts_with("127.") || !is_loopback(listening);
}

bool is_our_origin(std::string_view origin, const InternetAddress& listening) {
  if (origin.empty()) return true;
  if (!origin.starts_with(kScheme)) return false;
  origin.remove_prefix(kScheme.size());
  return is_our_host(origin, listening);
}

}  // namespace sim
