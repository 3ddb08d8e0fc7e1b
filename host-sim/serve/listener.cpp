#include "host-sim/serve/listener.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>
#include <string>

namespace sim {
namespace {

using hal::host::checked;
using hal::host::Descriptor;

constexpr int kWaitingSenders = 64;

/// Sets an option of a socket. Errors are ignored, because a connection works without the option,
/// too.
void set_option(const Descriptor& socket, int level, int option, int value) {
  static_cast<void>(::setsockopt(socket.number(), level, option, &value, sizeof value));
}

// Returns the pointer to `address`, converted to the general type that the socket interface
// requires.
sockaddr* generic_address(sockaddr_in& address) { return reinterpret_cast<sockaddr*>(&address); }

}  // namespace

Descriptor listen_at(InternetAddress& address, std::string_view way) {
  const std::string name = std::string{way} + " " + to_string(address);
  Descriptor listener{
      checked(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0), name)};
  // Receive buffer that every connection inherits from the listener. It is small, because a hold
  // acts only after the bytes that wait in the kernel.
  constexpr int kUnreadBytes = 64 * 1024;
  set_option(listener, SOL_SOCKET, SO_RCVBUF, kUnreadBytes);
  // Without this option a restart would have to wait a minute for the port.
  set_option(listener, SOL_SOCKET, SO_REUSEADDR, 1);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(address.port);
  ::inet_pton(AF_INET, address.host.c_str(), &place.sin_addr);
  socklen_t size = sizeof place;
  checked(::bind(listener.number(), generic_address(place), size), name);
  checked(::listen(listener.number(), kWaitingSenders), name);
  checked(::getsockname(listener.number(), generic_address(place), &size), name);
  address.port = ntohs(place.sin_port);
  return listener;
}

std::optional<Descriptor> accept_at(const Descriptor& listener) {
  Descriptor socket{::accept4(listener.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)};
  if (socket.number() < 0) return {};  // No connection waits, or it was closed already.
  constexpr int kSilenceSeconds = 4;
  constexpr int kQuestions = 3;
  set_option(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, kSilenceSeconds);
  set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, 2);
  set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, kQuestions);
  return socket;
}

bool is_only_slow() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace sim
