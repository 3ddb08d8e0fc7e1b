#include "tests/host-sim/serve/far_sender.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "tests/host-sim/serve/client_frame.hpp"

namespace sim {

using hal::host::checked;
using hal::host::Descriptor;

namespace {

Descriptor connected(const InternetAddress& address) {
  Descriptor socket{checked(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0), "socket")};
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(address.port);
  ::inet_pton(AF_INET, address.host.c_str(), &place.sin_addr);
  checked(::connect(socket.number(), reinterpret_cast<sockaddr*>(&place), sizeof place), "connect");
  const int on = 1;
  ::setsockopt(socket.number(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return socket;
}

void make_patient(const Descriptor& link) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): that is how fcntl is declared.
  checked(::fcntl(link.number(), F_SETFL, O_NONBLOCK), "fcntl");
}

}  // namespace

FarSender FarSender::over_tcp(const InternetAddress& address) {
  FarSender sender{connected(address), false};
  make_patient(sender.link_);
  return sender;
}

FarSender FarSender::over_pty(const std::string& device) {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-vararg): that is how open is declared.
  return {Descriptor{checked(::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK), device)},
          false};
}

FarSender FarSender::over_web_socket(const InternetAddress& address) {
  FarSender sender{connected(address), true};
  make_patient(sender.link_);
  sender.put(
      fmt::format("GET / HTTP/1.1\r\nHost: {}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                  "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
                  "\r\n",
                  to_string(address)));
  return sender;
}

void FarSender::send(std::string_view bytes) {
  constexpr std::size_t kFrame = std::size_t{1} << 16;
  if (!frames_) return put(bytes);
  for (; !bytes.empty(); bytes.remove_prefix(std::min(bytes.size(), kFrame))) {
    put(client_frame(0x82, bytes.substr(0, kFrame)));
  }
}

void FarSender::put(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(link_.number(), bytes.data(), bytes.size());
    if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    read();
    if (count > 0) continue;
    pollfd state{link_.number(), POLLIN | POLLOUT, 0};
    ::poll(&state, 1, 1);
  }
}

void FarSender::read() {
  std::array<char, 4096> part{};
  for (;;) {
    const ssize_t count = ::read(link_.number(), part.data(), part.size());
    if (count <= 0) return;
    heard_.append(part.data(), static_cast<std::size_t>(count));
  }
}

bool FarSender::hears(std::string_view words) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::seconds{20};
  for (read(); heard_.find(words) == std::string::npos; read()) {
    if (Clock::now() > end) return false;
    pollfd state{link_.number(), POLLIN, 0};
    ::poll(&state, 1, 1);
  }
  return true;
}

void FarSender::leave(End how) {
  const linger at_once{.l_onoff = 1, .l_linger = 0};
  if (how == End::kReset) {
    ::setsockopt(link_.number(), SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  }
  link_ = Descriptor{};
}

}  // namespace sim
