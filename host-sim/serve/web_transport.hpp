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

/// The web server: what the service answers over HTTP, the byte stream of a sender as a WebSocket
/// at `/` (text or binary frames), that of our page at `/operate`, and a WebSocket at `/observe`
/// for those who only watch. Asked under a foreign name, it answers 403 (see web_guard.hpp).
///
/// HTTP and WebSocket are Boost.Beast's, on an `io_context` of Boost.Asio whose handlers run in the
/// loop: it polls the sockets' descriptors, and accept() runs what is ready. Nothing blocks, and
/// everything is bounded: a connection more than kMostClients takes the place of the oldest one
/// that has asked nothing yet, and a watcher more than kMostWatchers is told so.
class WebTransport final : public Transport {
 public:
  static constexpr std::size_t kMostClients = 64;
  static constexpr std::size_t kMostWatchers = 16;
  using Clock = std::chrono::steady_clock;
  using Now = std::function<Clock::time_point()>;

  /// Port 0 is any free one; `service` must outlive it; clients' time is over by `now`. Throws
  /// std::system_error naming the address.
  WebTransport(const InternetAddress& address, PageService& service, Now now = &Clock::now);
  WebTransport(const WebTransport&) = delete;
  WebTransport& operator=(const WebTransport&) = delete;
  ~WebTransport() override;

  [[nodiscard]] std::unique_ptr<Connection> accept() override;
  void add_to(std::vector<pollfd>& descriptors) const override;
  [[nodiscard]] std::string_view kind() const override { return "ws"; }
  [[nodiscard]] std::string address() const override { return to_string(address_); }

  /// Takes in a client that is connected: those who come to the address, and a test's.
  void meet(hal::host::Descriptor socket);
  /// Those who watch.
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
  std::unique_ptr<boost::asio::io_context> context_;  ///< Outlives the sockets.
  std::vector<std::shared_ptr<WebClient>> clients_;   ///< The oldest first.
  std::deque<Arrival> arrivals_;                      ///< Senders not accepted yet.
  std::vector<std::shared_ptr<WebSocket>> sockets_;   ///< All that are not gone.
  std::vector<std::shared_ptr<WebSocket>> watchers_;
};

}  // namespace sim
