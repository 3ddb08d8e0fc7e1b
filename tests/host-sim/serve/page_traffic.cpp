#include "tests/host-sim/serve/page_traffic.hpp"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <string_view>
#include <utility>

#include "hal/host/descriptor.hpp"

namespace sim {
namespace {

using hal::host::Descriptor;

Descriptor linked_to(const InternetAddress& address) {
  Descriptor socket{::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)};
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(address.port);
  ::inet_pton(AF_INET, address.host.c_str(), &place.sin_addr);
  if (::connect(socket.number(), reinterpret_cast<sockaddr*>(&place), sizeof place) != 0) return {};
  return socket;
}

bool send_all(const Descriptor& link, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::send(link.number(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

/// Waits for bytes. Returns the number of bytes; 0 if none have come, negative at the end of the
/// connection.
ssize_t read_some(const Descriptor& link) {
  constexpr int kPatienceMs = 50;
  pollfd state{link.number(), POLLIN, 0};
  if (::poll(&state, 1, kPatienceMs) <= 0) return 0;
  std::array<char, 65536> part{};
  const ssize_t count = ::read(link.number(), part.data(), part.size());
  return count > 0 ? count : -1;
}

}  // namespace

PageTraffic::PageTraffic(InternetAddress address)
    : address_{std::move(address)}, asking_{[this] { ask(); }}, watching_{[this] { watch(); }} {}

PageTraffic::~PageTraffic() {
  ends_ = true;
  asking_.join();
  watching_.join();
}

void PageTraffic::ask() {
  std::string program = "G90 F6000\n";
  while (program.size() < std::size_t{1} << 20) program += "G1 X10 Y20\nG2 X20 I5\nG0 X0 Y0\n";
  const std::string host = to_string(address_);
  const auto get = [&host](std::string_view path) {
    return fmt::format("GET {} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", path, host);
  };
  const auto post = [&](std::string_view path) {
    return fmt::format(
        "POST {} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\nContent-Length: {}\r\n\r\n{}",
        path,
        host,
        program.size(),
        program);
  };
  const std::array requests{
      get("/"), post("/outline"), get("/picture.svg"), post("/job?name=a.nc"), get("/job")};
  for (std::size_t next = 0; !ends_; next = (next + 1) % requests.size()) {
    const Descriptor link = linked_to(address_);
    if (!send_all(link, requests[next])) continue;
    while (!ends_ && read_some(link) >= 0) {
    }
    ++answered_;
  }
}

void PageTraffic::watch() {
  const Descriptor link = linked_to(address_);
  send_all(link,
           fmt::format("GET /observe HTTP/1.1\r\nHost: {}\r\nUpgrade: websocket\r\n"
                       "Connection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
                       "Sec-WebSocket-Version: 13\r\n\r\n",
                       to_string(address_)));
  while (!ends_) {
    const ssize_t count = read_some(link);
    if (count > 0) news_ += static_cast<std::size_t>(count);
    if (count < 0) return;
  }
}

}  // namespace sim
