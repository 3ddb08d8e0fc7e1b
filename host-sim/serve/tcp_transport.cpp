#include "host-sim/serve/tcp_transport.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <cerrno>

namespace sim {
namespace {

using hal::host::checked;
using hal::host::Descriptor;

constexpr int kWaitingSenders = 4;

class TcpConnection final : public Connection {
 public:
  explicit TcpConnection(Descriptor socket) : socket_{std::move(socket)} {}

  std::size_t read(std::span<std::byte> into) override {
    const ssize_t count = ::recv(socket_.number(), into.data(), into.size(), 0);
    if (count > 0) return static_cast<std::size_t>(count);
    if (!into.empty() && (count == 0 || !is_only_slow())) open_ = false;
    return 0;
  }

  std::size_t write(std::span<const std::byte> from) override {
    const ssize_t count = ::send(socket_.number(), from.data(), from.size(), MSG_NOSIGNAL);
    if (count >= 0) return static_cast<std::size_t>(count);
    if (!is_only_slow()) open_ = false;
    return 0;
  }

  bool open() override { return open_; }
  void end() override { ::shutdown(socket_.number(), SHUT_WR); }

  void add_to(std::vector<pollfd>& descriptors, Wishes wishes) const override {
    const int events = (wishes.read ? POLLIN : 0) | (wishes.write ? POLLOUT : 0);
    descriptors.push_back({socket_.number(), static_cast<short>(events), 0});
  }

 private:
  static bool is_only_slow() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

  Descriptor socket_;
  bool open_ = true;
};

void switch_on(const Descriptor& socket, int level, int option) {
  const int on = 1;
  checked(::setsockopt(socket.number(), level, option, &on, sizeof on), "setsockopt");
}

// The socket interface takes every kind of address through this pointer.
sockaddr* generic(sockaddr_in& address) { return reinterpret_cast<sockaddr*>(&address); }

}  // namespace

TcpTransport::TcpTransport(const InternetAddress& address)
    : address_{address},
      listener_{checked(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0), "tcp")} {
  const std::string name = "tcp " + to_string(address);
  switch_on(listener_, SOL_SOCKET, SO_REUSEADDR);  // Else a restart has to wait a minute.
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(address.port);
  ::inet_pton(AF_INET, address.host.c_str(), &place.sin_addr);
  socklen_t size = sizeof place;
  checked(::bind(listener_.number(), generic(place), size), name);
  checked(::listen(listener_.number(), kWaitingSenders), name);
  checked(::getsockname(listener_.number(), generic(place), &size), name);
  address_.port = ntohs(place.sin_port);
}

std::unique_ptr<Connection> TcpTransport::accept() {
  Descriptor socket{::accept4(listener_.number(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC)};
  if (socket.number() < 0) return nullptr;  // Nobody, or gone again.
  switch_on(socket, IPPROTO_TCP, TCP_NODELAY);
  return std::make_unique<TcpConnection>(std::move(socket));
}

void TcpTransport::add_to(std::vector<pollfd>& descriptors) const {
  descriptors.push_back({listener_.number(), POLLIN, 0});
}

}  // namespace sim
