#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/internet_address.hpp"
#include "host-sim/serve/page_service.hpp"
#include "host-sim/serve/transport.hpp"
#include "host-sim/serve/web_socket.hpp"

namespace boost::asio {
class io_context;
}

namespace sim {

class WebClient;

/// The web server. It serves the resources of the page service over HTTP, a sender's byte stream as
/// a WebSocket at `/` (text or binary frames), the byte stream of the server's own page at
/// `/operate`, and a WebSocket at `/observe` for watchers. A request that names a foreign host is
/// answered with 403 (see web_guard.hpp).
///
/// HTTP and WebSocket are those of Boost.Beast, on an `io_context` of Boost.Asio whose handlers run
/// in the loop: the loop polls the sockets' descriptors, and accept() runs the handlers that are
/// ready. No call blocks, and all queues are bounded. A client beyond kMaxClients replaces the
/// oldest client that has sent no request yet. A watcher beyond kMaxWatchers is refused with a
/// message.
class WebTransport final : public Transport {
 public:
  static constexpr std::size_t kMaxClients = 64;
  static constexpr std::size_t kMaxWatchers = 16;
  using Clock = std::chrono::steady_clock;
  using Now = std::function<Clock::time_point()>;

  /// Throws std::system_error naming the address.
  /// @param address address to listen at; port 0 stands for any free port
  /// @param service must outlive this object
  /// @param now clock by which the clients' time limits pass
  WebTransport(const InternetAddress& address, PageService& service, Now now = &Clock::now);
  WebTransport(const WebTransport&) = delete;
  WebTransport& operator=(const WebTransport&) = delete;
  ~WebTransport() override;

  [[nodiscard]] std::unique_ptr<Connection> accept() override;
  void add_to(std::vector<pollfd>& descriptors) const override;
  [[nodiscard]] std::string_view kind() const override { return "ws"; }
  [[nodiscard]] std::string address() const override { return to_string(address_); }

  /// Adds a connected client, which comes from the listener or from a test.
  void meet(hal::host::Descriptor socket);
  /// Returns the connections that only watch.
  [[nodiscard]] const std::vector<std::shared_ptr<WebSocket>>& watchers() const {
    return watchers_;
  }

 private:
  struct Arrival {
    std::shared_ptr<WebSocket> socket;
    std::string_view kind;
  };

  void attend();
  void accept_clients();
  void make_place();
  void run_handlers();
  void attend_client(WebClient& client, Clock::time_point now);
  void judge(WebClient& client);
  void open_socket(WebClient& client);
  void add_watcher(std::shared_ptr<WebSocket> socket);
  void answer(WebClient& client);
  void attend_sockets(Clock::time_point now);

  InternetAddress address_;
  PageService& service_;
  Now now_;
  hal::host::Descriptor listener_;
  /// Must outlive the sockets, so it is declared first.
  std::unique_ptr<boost::asio::io_context> context_;
  std::vector<std::shared_ptr<WebClient>> clients_;  ///< Connected clients, the oldest first.
  std::deque<Arrival> arrivals_;                     ///< Senders that are not accepted yet.
  std::vector<std::shared_ptr<WebSocket>> sockets_;  ///< All sockets that are not closed.
  std::vector<std::shared_ptr<WebSocket>> watchers_;
};

}  // namespace sim
