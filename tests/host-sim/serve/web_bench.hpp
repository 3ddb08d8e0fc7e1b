#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <array>
#include <chrono>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "host-sim/serve/web_transport.hpp"

namespace sim {

/// Answers every request, and keeps the last one.
class KeepingService final : public PageService {
 public:
  std::optional<WebReply> refusal(const HttpRequest&) const override { return {}; }
  Answer answer(HttpRequest request) override {
    last = std::move(request);
    return WebReply{.content = content};
  }

  HttpRequest last;
  std::string content = "fine";
};

/// A web server on loopback with clients' ends of its connections. Its clock stands still unless a
/// test moves it. Runs in one thread.
class WebBench {
 public:
  /// A client's end of a connection, and the bytes that it received.
  struct Client {
    hal::host::Descriptor link;
    std::string heard;
    bool closed = false;
  };

  [[nodiscard]] Client connect() const {
    using hal::host::checked;
    const InternetAddress address = parse_address(transport.address());
    Client client;
    client.link =
        hal::host::Descriptor{checked(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0), "socket")};
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(address.port);
    ::inet_pton(AF_INET, address.host.c_str(), &place.sin_addr);
    checked(::connect(client.link.number(), reinterpret_cast<sockaddr*>(&place), sizeof place),
            "connect");
    const int on = 1;
    ::setsockopt(client.link.number(), IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
    return client;
  }

  /// Sends a text, in which `{}` stands for the server's address.
  void send(Client& client, std::string text) const {
    const std::size_t at = text.find("{}");
    if (at != std::string::npos) text.replace(at, 2, transport.address());
    for (std::string_view rest = text; !rest.empty();) {
      const ssize_t count = ::send(client.link.number(), rest.data(), rest.size(), MSG_NOSIGNAL);
      if (count <= 0) return;  // The server has already closed the connection.
      rest.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  /// Runs one cycle of the server's loop.
  void turn() {
    while (auto connection = transport.accept()) senders.push_back(std::move(connection));
  }
  /// Runs several cycles, in which a server on loopback can do all its work.
  void turns() {
    for (int count = 0; count < 20; ++count) {
      turn();
      ::usleep(200);
    }
  }
  void pass(std::chrono::seconds time) {
    now_ += time;
    turns();
  }

  /// Reads until the words have come or the server closes; returns false after 5 s.
  bool hears(Client& client, std::string_view words) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds{5};
    while (client.heard.find(words) == std::string::npos && !client.closed) {
      if (std::chrono::steady_clock::now() > end) return false;
      turn();
      std::array<char, 65536> part{};
      const ssize_t count = ::recv(client.link.number(), part.data(), part.size(), MSG_DONTWAIT);
      if (count > 0) client.heard.append(part.data(), static_cast<std::size_t>(count));
      client.closed = count == 0 || (count < 0 && errno != EAGAIN);
      if (count < 0) ::usleep(100);
    }
    return client.heard.find(words) != std::string::npos;
  }
  bool sees_it_close(Client& client) {
    static_cast<void>(hears(client, "nothing of the kind comes"));
    return client.closed;
  }
  /// Reads the bytes that have come so far.
  void hear(Client& client) {
    turns();
    std::array<char, 4096> part{};
    const ssize_t count = ::recv(client.link.number(), part.data(), part.size(), MSG_DONTWAIT);
    if (count > 0) client.heard.append(part.data(), static_cast<std::size_t>(count));
    client.closed = client.closed || count == 0;
  }

  /// Returns all bytes with which a connection answers these bytes.
  std::string answer_to(std::string request) {
    Client client = connect();
    send(client, std::move(request));
    EXPECT_TRUE(sees_it_close(client));
    return client.heard;
  }

  [[nodiscard]] static std::string handshake(const std::string& path = "/") {
    return "GET " + path +
           " HTTP/1.1\r\nHost: {}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n\r\n";
  }
  /// Returns a client whose WebSocket is open; the handshake is removed from the bytes that it
  /// received.
  Client open_socket(const std::string& path = "/") {
    Client client = connect();
    send(client, handshake(path));
    EXPECT_TRUE(hears(client, "\r\n\r\n"));
    client.heard.erase(0, client.heard.find("\r\n\r\n") + 4);
    return client;
  }
  /// Returns the bytes that the first sender has sent.
  std::string sent() {
    turns();
    std::string text;
    std::array<std::byte, 1024> part{};
    while (const std::size_t count = senders.at(0)->read(part)) {
      text.append(reinterpret_cast<const char*>(part.data()), count);
    }
    return text;
  }

 private:
  WebTransport::Clock::time_point now_{std::chrono::hours{1}};

 public:
  KeepingService service;
  WebTransport transport{InternetAddress{}, service, [this] { return now_; }};
  std::vector<std::unique_ptr<Connection>> senders;  ///< Accepted connections.
};

}  // namespace sim
