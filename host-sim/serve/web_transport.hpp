#pragma once

#include <chrono>
#include <deque>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/internet_address.hpp"
#include "host-sim/serve/page_service.hpp"
#include "host-sim/serve/transport.hpp"
#include "host-sim/serve/web_client.hpp"
#include "host-sim/serve/web_socket.hpp"

namespace sim {

/// The web server: what the service answers over HTTP, the byte stream of a sender as a WebSocket
/// at `/` (text or binary frames), that of our page at `/operate`, and a WebSocket at `/observe`
/// for those who only watch. Asked under a foreign name, it answers 403 (see web_guard.hpp).
///
/// All of it runs in the loop, nothing blocks, and everything is bounded: a connection more than
/// kMostClients takes the place of the oldest one that has asked nothing yet, and a watcher more
/// than kMostWatchers is told so.
class WebTransport final : public Transport {
 public:
  static constexpr std::size_t kMostClients = 64;
  static constexpr std::size_t kMostWatchers = 16;

  /// Port 0 is any free one; `service` must outlive it. Throws std::system_error naming the
  /// address.
  WebTransport(const InternetAddress& address, PageService& service);
  WebTransport(const WebTransport&) = delete;
  WebTransport& operator=(const WebTransport&) = delete;
  ~WebTransport() override;

  [[nodiscard]] std::unique_ptr<Connection> accept() override;
  void add_to(std::vector<pollfd>& descriptors) const override;
  [[nodiscard]] std::string_view kind() const override { return "ws"; }
  [[nodiscard]] std::string address() const override { return to_string(address_); }

  /// Those who watch.
  [[nodiscard]] const std::vector<std::shared_ptr<WebSocket>>& watchers() const {
    return watchers_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  struct Arrival {
    std::shared_ptr<WebSocket> socket;
    std::string_view kind;
  };

  void attend(Clock::time_point now);
  void accept_clients(Clock::time_point now);
  void make_place();
  void attend_client(WebClient& client, Clock::time_point now);
  void judge(WebClient& client, Clock::time_point now);
  void open_socket(WebClient& client, Clock::time_point now);
  void add_watcher(std::shared_ptr<WebSocket> socket);
  void answer(WebClient& client, Clock::time_point now);
  void attend_sockets(Clock::time_point now);

  InternetAddress address_;
  PageService& service_;
  hal::host::Descriptor listener_;
  std::vector<std::unique_ptr<WebClient>> clients_;  ///< The oldest first.
  std::deque<Arrival> arrivals_;                     ///< Senders not accepted yet.
  std::vector<std::shared_ptr<WebSocket>> sockets_;  ///< All that are not gone.
  std::vector<std::shared_ptr<WebSocket>> watchers_;
};

}  // namespace sim
