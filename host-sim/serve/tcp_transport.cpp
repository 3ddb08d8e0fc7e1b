#include "host-sim/serve/tcp_transport.hpp"

#include <sys/socket.h>

#include "host-sim/serve/listener.hpp"

namespace sim {
namespace {

using hal::host::Descriptor;

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

  /// Returns whether the connection is open. It peeks at the stream, so that the end of a sender
  /// that left without a byte is noticed before a read.
  bool open() override {
    std::byte first{};
    if (open_ && ::recv(socket_.number(), &first, 1, MSG_PEEK | MSG_DONTWAIT) == 0) open_ = false;
    return open_;
  }
  void end() override { ::shutdown(socket_.number(), SHUT_WR); }

  void add_to(std::vector<pollfd>& descriptors, Wishes wishes) const override {
    const int events = (wishes.read ? POLLIN : 0) | (wishes.write ? POLLOUT : 0);
    descriptors.push_back({socket_.number(), static_cast<short>(events), 0});
  }

 private:
  Descriptor socket_;
  bool open_ = true;
};

}  // namespace

TcpTransport::TcpTransport(const InternetAddress& address)
    : address_{address}, listener_{listen_at(address_, "tcp")} {}

std::unique_ptr<Connection> TcpTransport::accept() {
  auto socket = accept_at(listener_);
  return socket ? std::make_unique<TcpConnection>(std::move(*socket)) : nullptr;
}

void TcpTransport::add_to(std::vector<pollfd>& descriptors) const {
  descriptors.push_back({listener_.number(), POLLIN, 0});
}

}  // namespace sim
