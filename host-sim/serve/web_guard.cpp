#include "host-sim/serve/web_guard.hpp"

#include <fmt/format.h>

#include <string>

#include "host-sim/serve/http_request.hpp"

namespace sim {
namespace {

constexpr std::uint16_t kStandardPort = 80;

}  // namespace

bool is_our_host(std::string_view host, const InternetAddress& listening) {
  const std::string port = fmt::format(":{}", listening.port);
  std::string name = lower_case(host);
  if (name.ends_with(port)) {
    name.resize(name.size() - port.size());
  } else if (listening.port != kStandardPort) {
    return false;
  }
  if (name == "localhost" || name == listening.host) return true;
  if (!is_ip_address(name)) return false;
  return name.starts_with("127.") || !is_loopback(listening);
}

bool is_same_origin(std::string_view origin, std::string_view host) {
  return origin.empty() || lower_case(origin) == "http://" + lower_case(host);
}

}  // namespace sim
