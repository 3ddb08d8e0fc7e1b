#include "host-sim/serve/web_guard.hpp"

#include <fmt/format.h>

#include <boost/beast/core/string.hpp>
#include <string>

namespace sim {
namespace {

using boost::beast::iequals;

constexpr std::uint16_t kStandardPort = 80;

}  // namespace

bool is_our_host(std::string_view host, const InternetAddress& listening) {
  const std::string port = fmt::format(":{}", listening.port);
  if (host.ends_with(port)) {
    host.remove_suffix(port.size());
  } else if (listening.port != kStandardPort) {
    return false;
  }
  if (iequals(host, "localhost") || host == listening.host) return true;
  const std::string number{host};
  if (!is_ip_address(number)) return false;
  return number.starts_with("127.") || !is_loopback(listening);
}

bool is_same_origin(std::string_view origin, std::string_view host) {
  return origin.empty() || iequals(origin, fmt::format("http://{}", host));
}

}  // namespace sim
