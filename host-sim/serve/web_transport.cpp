#include "host-sim/serve/web_transport.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>

#include "host-sim/serve/http_status.hpp"
#include "host-sim/serve/listener.hpp"
#include "host-sim/serve/reception.hpp"
#include "host-sim/serve/web_guard.hpp"

namespace sim {
namespace {

constexpr std::size_t kKeyCharacters = 24;  ///< Of 16 bytes in Base64.
constexpr std::ptrdiff_t kMostAtWork = 2;
constexpr std::string_view kTooManyWatch =
    R"({"refused":"Sixteen pages watch this machine already. Close one of them, and reload."})";

/// Of a sender; the transport keeps the socket until it is gone.
class WebConnection final : public Connection {
 public:
  WebConnection(std::shared_ptr<WebSocket> socket, std::string_view kind)
      : socket_{std::move(socket)}, kind_{kind} {}
  WebConnection(const WebConnection&) = delete;
  WebConnection& operator=(const WebConnection&) = delete;
  ~WebConnection() override { end(); }

  std::size_t read(std::span<std::byte> into) override { return socket_->read(into); }
  std::size_t write(std::span<const std::byte> from) override { return socket_->write(from); }
  bool open() override { return socket_->open(); }
  void end() override { socket_->end(web_close::kTryAgainLater); }
  void add_to(std::vector<pollfd>&, Wishes) const override {}  // The transport adds it.
  [[nodiscard]] std::string_view kind() const override { return kind_; }

 private:
  std::shared_ptr<WebSocket> socket_;
  std::string_view kind_;
};

/// What is wrong with a handshake (RFC 6455, 4.2.1); nothing when it is sound.
std::optional<WebReply> handshake_fault(const HttpRequest& request) {
  if (request.header("sec-websocket-version") != "13") {
    return web_refusal(http_status::kUpgradeRequired,
                       "Only version 13 of WebSocket is spoken here.");
  }
  const bool sound = request.method == "GET" && request.lists("connection", "upgrade") &&
                     request.header("sec-websocket-key").size() == kKeyCharacters;
  if (sound) return {};
  return web_refusal(http_status::kBadRequest, "The handshake of the WebSocket is malformed.");
}

}  // namespace

WebTransport::WebTransport(const InternetAddress& address, PageService& service)
    : address_{address}, service_{service}, listener_{listen_at(address_, "ws")} {}

WebTransport::~WebTransport() = default;

std::unique_ptr<Connection> WebTransport::accept() {
  if (arrivals_.empty()) attend(Clock::now());
  if (arrivals_.empty()) return nullptr;
  const Arrival arrival = std::move(arrivals_.front());
  arrivals_.pop_front();
  return std::make_unique<WebConnection>(arrival.socket, arrival.kind);
}

void WebTransport::attend(Clock::time_point now) {
  accept_clients(now);
  for (const auto& client : clients_) attend_client(*client, now);
  std::erase_if(clients_,
                [](const auto& client) { return client->stage() == WebClient::Stage::kOver; });
  attend_sockets(now);
}

void WebTransport::accept_clients(Clock::time_point now) {
  constexpr int kMostAtOnce = 16;
  for (int count = 0; count < kMostAtOnce; ++count) {
    auto socket = accept_at(listener_);
    if (!socket) return;
    if (clients_.size() >= kMostClients) make_place();
    clients_.push_back(std::make_unique<WebClient>(std::move(*socket), now));
  }
}

/// Whoever has asked nothing yet waits for nothing.
void WebTransport::make_place() {
  const auto silent =
      std::find_if(clients_.begin(), clients_.end(), [](const auto& c) { return c->silent(); });
  const bool works = clients_.front()->stage() == WebClient::Stage::kWorking;
  if (silent != clients_.end()) {
    clients_.erase(silent);
  } else if (!works) {
    clients_.erase(clients_.begin());
  }
}

void WebTransport::attend_client(WebClient& client, Clock::time_point now) {
  client.attend(now);
  if (client.stage() == WebClient::Stage::kHasHead) judge(client, now);
  if (client.stage() == WebClient::Stage::kHasAll) answer(client, now);
}

void WebTransport::judge(WebClient& client, Clock::time_point now) {
  const HttpRequest& request = client.request();
  const std::string_view host = request.header("host");
  if (!is_our_host(host, address_)) {
    return client.answer(web_refusal(http_status::kForbidden, "This machine has no such name."),
                         now);
  }
  if (!is_same_origin(request.header("origin"), host)) {
    return client.answer(
        web_refusal(http_status::kForbidden, "Another page must not ask for this."), now);
  }
  if (request.wants_web_socket()) return open_socket(client, now);
  if (const auto refused = service_.refusal(request)) return client.answer(*refused, now);
  client.want_body(now);
}

void WebTransport::open_socket(WebClient& client, Clock::time_point now) {
  if (const auto fault = handshake_fault(client.request())) return client.answer(*fault, now);
  const std::string path = client.request().path;
  auto socket = std::make_shared<WebSocket>(client.become_socket());
  sockets_.push_back(socket);
  if (path == "/observe") return add_watcher(std::move(socket));
  arrivals_.push_back(
      {std::move(socket), path == "/operate" ? Reception::kPage : std::string_view{}});
}

void WebTransport::add_watcher(std::shared_ptr<WebSocket> socket) {
  if (watchers_.size() < kMostWatchers) {
    watchers_.push_back(std::move(socket));
    return;
  }
  socket->write(kTooManyWatch);
  socket->end(web_close::kTryAgainLater);
}

/// Two answers are being made at a time; others wait.
void WebTransport::answer(WebClient& client, Clock::time_point now) {
  const auto at_work = std::count_if(clients_.begin(), clients_.end(), [](const auto& one) {
    return one->stage() == WebClient::Stage::kWorking;
  });
  if (at_work >= kMostAtWork) return;
  PageService::Answer answer = service_.answer(std::move(client.request()));
  if (auto* work = std::get_if<WebWork>(&answer)) return client.work(std::move(*work));
  client.answer(std::get<WebReply>(answer), now);
}

void WebTransport::attend_sockets(Clock::time_point now) {
  std::array<std::byte, 1024> unheard{};
  for (const auto& watcher : watchers_) {
    while (watcher->read(unheard) == unheard.size()) {
    }
  }
  for (const auto& socket : sockets_) socket->attend(now);
  const auto gone = [](const auto& socket) { return socket->gone(); };
  std::erase_if(sockets_, gone);
  std::erase_if(watchers_, gone);
}

void WebTransport::add_to(std::vector<pollfd>& descriptors) const {
  descriptors.push_back({listener_.number(), POLLIN, 0});
  for (const auto& client : clients_) client->add_to(descriptors);
  for (const auto& socket : sockets_) socket->add_to(descriptors);
}

}  // namespace sim
