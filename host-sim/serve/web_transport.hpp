#pragma once

#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "hal/host/descriptor.hpp"
#include "host-sim/serve/internet_address.hpp"
#include "host-sim/serve/page_service.hpp"
#include "host-sim/serve/transport.hpp"
#include "host-sim/serve/web_pipe.hpp"
#include "host-sim/serve/web_socket_peer.hpp"

struct mg_context;

namespace sim {

/// The web server: the page, the byte stream of a sender as a WebSocket at `/`
/// (text or binary frames), and a WebSocket at `/observe` for any number who
/// only watch; a picture of the motion so far at `/picture.svg`; and at `/outline`,
/// for a program sent with POST, where it would go. Asked under a foreign name,
/// it answers 403 (see web_guard.hpp).
///
/// The server has threads of its own; they touch nothing but pipes and what the
/// service has copied for them.
class WebTransport final : public Transport {
 public:
  /// Port 0 is any free one; `service` must outlive it. Throws
  /// std::runtime_error naming the address.
  WebTransport(const InternetAddress& address, PageService& service);
  WebTransport(const WebTransport&) = delete;
  WebTransport& operator=(const WebTransport&) = delete;
  ~WebTransport() override;

  [[nodiscard]] std::unique_ptr<Connection> accept() override;
  void add_to(std::vector<pollfd>& descriptors) const override;
  [[nodiscard]] std::string_view kind() const override { return "ws"; }
  [[nodiscard]] std::string address() const override { return to_string(address_); }

  /// Those who watch; whoever is gone or too slow is left out.
  [[nodiscard]] std::vector<std::shared_ptr<WebPipe>> observers();

 private:
  struct Handlers;
  struct Stopper {
    void operator()(mg_context* server) const;
  };

  void wake() const;

  InternetAddress address_;
  PageService& service_;
  hal::host::Descriptor bell_;  ///< An eventfd: rung when a pipe has news.
  std::mutex mutex_;
  std::deque<std::shared_ptr<WebPipe>> waiting_;  ///< Senders not accepted yet.
  std::vector<std::shared_ptr<WebPipe>> observers_;
  std::map<const void*, std::unique_ptr<WebSocketPeer>> peers_;  ///< By connection.
  std::unique_ptr<mg_context, Stopper> server_;  ///< The last: stops before the others go.
};

}  // namespace sim
