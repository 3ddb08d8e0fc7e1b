#include "host-sim/serve/web_transport.hpp"

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <utility>

#include "host-sim/serve/http_status.hpp"
#include "host-sim/serve/listener.hpp"
#include "host-sim/serve/reception.hpp"
#include "host-sim/serve/web_client.hpp"
#include "host-sim/serve/web_guard.hpp"

namespace sim {
namespace {

constexpr std::ptrdiff_t kMaxAtWork = 2;
// Greatest duration of one call that runs handlers. It is short because the cycles of the machine
// wait meanwhile.
constexpr std::chrono::milliseconds kLongestRun{5};
// Greatest number of handlers that one call runs to read a part. A part requires only a few
// handlers, but handlers of other connections may run between them.
constexpr int kHandlersForAPart = 64;
constexpr std::string_view kTooManyWatch =
    R"({"refused":"Sixteen pages watch this machine already. Close one of them, and reload."})";

/// Connection of a sender. The transport keeps the socket until the socket is closed.
class WebConnection final : public Connection {
 public:
  WebConnection(boost::asio::io_context& context,
                std::shared_ptr<WebSocket> socket,
                std::string_view kind)
      : context_{context}, socket_{std::move(socket)}, kind_{kind} {}
  WebConnection(const WebConnection&) = delete;
  WebConnection& operator=(const WebConnection&) = delete;
  ~WebConnection() override { end(); }

  /// Reads all arrived bytes, part by part, so that none of them waits for the next cycle.
  std::size_t read(std::span<std::byte> into) override {
    context_.restart();  // The context stops when it has no work.
    for (int left = kHandlersForAPart; left > 0; --left) {
      if (const std::size_t count = socket_->read(into); count > 0) return count;
      if (context_.poll_one() == 0) return 0;
    }
    return 0;
  }
  std::size_t write(std::span<const std::byte> from) override { return socket_->write(from); }
  bool open() override { return socket_->open(); }
  void end() override { socket_->end(); }
  // WebTransport::add_to() adds the socket.
  void add_to(std::vector<pollfd>&, Wishes) const override {}
  [[nodiscard]] std::string_view kind() const override { return kind_; }

 private:
  boost::asio::io_context& context_;
  std::shared_ptr<WebSocket> socket_;
  std::string_view kind_;
};

}  // namespace

WebTransport::WebTransport(const InternetAddress& address, PageService& service, Now now)
    : address_{address},
      service_{service},
      now_{std::move(now)},
      listener_{listen_at(address_, "ws")},
      context_{std::make_unique<boost::asio::io_context>(1)} {}

WebTransport::~WebTransport() = default;

std::unique_ptr<Connection> WebTransport::accept() {
  if (arrivals_.empty()) attend();
  if (arrivals_.empty()) return nullptr;
  const Arrival arrival = std::move(arrivals_.front());
  arrivals_.pop_front();
  return std::make_unique<WebConnection>(*context_, arrival.socket, arrival.kind);
}

void WebTransport::attend() {
  accept_clients();
  run_handlers();
  const Clock::time_point now = now_();
  for (const auto& client : clients_) attend_client(*client, now);
  std::erase_if(clients_,
                [](const auto& client) { return client->stage() == WebClient::Stage::kOver; });
  attend_sockets(now);
}

void WebTransport::accept_clients() {
  constexpr int kMaxInATurn = 16;
  for (int count = 0; count < kMaxInATurn; ++count) {
    auto accepted = accept_at(listener_);
    if (!accepted) return;
    meet(std::move(*accepted));
  }
}

void WebTransport::meet(hal::host::Descriptor socket) {
  if (clients_.size() >= kMaxClients) make_place();
  clients_.push_back(std::make_shared<WebClient>(*context_, std::move(socket), now_()));
  clients_.back()->begin();
}

/// Disconnects a client to make space for a new one. This is the oldest client whose request has
/// not been read, because it does not wait for an answer yet. If there is none, it is the oldest
/// client for which no thread works.
void WebTransport::make_place() {
  const auto oldest = [this](auto&& may_go) {
    return std::find_if(clients_.begin(), clients_.end(), [&](const auto& client) {
      return may_go(client->stage());
    });
  };
  auto goes = oldest([](WebClient::Stage stage) { return stage == WebClient::Stage::kHead; });
  if (goes == clients_.end()) {
    goes = oldest([](WebClient::Stage stage) { return stage != WebClient::Stage::kWorking; });
  }
  (*goes)->hang_up();
  clients_.erase(goes);
}

void WebTransport::run_handlers() {
  const auto until = std::chrono::steady_clock::now() + kLongestRun;
  context_->restart();
  while (context_->poll_one() > 0 && std::chrono::steady_clock::now() < until) {
  }
}

void WebTransport::attend_client(WebClient& client, Clock::time_point now) {
  client.attend(now);
  if (client.stage() == WebClient::Stage::kHasHead) judge(client);
  if (client.stage() == WebClient::Stage::kHasAll) answer(client);
}

void WebTransport::judge(WebClient& client) {
  const HttpRequest& request = client.request();
  if (!is_our_host(request.host, address_)) {
    return client.answer(web_refusal(http_status::kForbidden,
                                     "This server does not have the name in the Host line."));
  }
  if (!is_same_origin(request.origin, request.host)) {
    return client.answer(
        web_refusal(http_status::kForbidden, "A page of another server must not request this."));
  }
  if (request.wants_web_socket) return open_socket(client);
  if (const auto refused = service_.refusal(request)) return client.answer(*refused);
  client.want_body();
}

void WebTransport::open_socket(WebClient& client) {
  std::shared_ptr<WebSocket> socket = client.become_socket();
  if (!socket) return;
  const std::string& path = client.request().path;
  sockets_.push_back(socket);
  if (path == "/observe") return add_watcher(std::move(socket));
  arrivals_.push_back(
      {std::move(socket), path == "/operate" ? Reception::kPage : std::string_view{}});
}

void WebTransport::add_watcher(std::shared_ptr<WebSocket> socket) {
  if (watchers_.size() < kMaxWatchers) {
    watchers_.push_back(std::move(socket));
    return;
  }
  socket->write(kTooManyWatch);
  socket->end();
}

/// Answers a request. At most kMaxAtWork answers are made at a time; other requests wait.
void WebTransport::answer(WebClient& client) {
  const auto at_work = std::count_if(clients_.begin(), clients_.end(), [](const auto& one) {
    return one->stage() == WebClient::Stage::kWorking;
  });
  if (at_work >= kMaxAtWork) return;
  PageService::Answer answer = service_.answer(std::move(client.request()));
  if (auto* work = std::get_if<WebWork>(&answer)) return client.work(std::move(*work));
  client.answer(std::get<WebReply>(answer));
}

void WebTransport::attend_sockets(Clock::time_point now) {
  std::array<std::byte, 1024> unheard{};
  for (const auto& watcher : watchers_) {
    while (watcher->read(unheard) == unheard.size()) {
    }
  }
  for (const auto& socket : sockets_) socket->attend(now);
  std::erase_if(sockets_, [](const auto& socket) { return socket->gone(); });
  std::erase_if(watchers_, [](const auto& socket) { return !socket->open(); });
}

void WebTransport::add_to(std::vector<pollfd>& descriptors) const {
  descriptors.push_back({listener_.number(), POLLIN, 0});
  for (const auto& client : clients_) client->add_to(descriptors);
  for (const auto& socket : sockets_) socket->add_to(descriptors);
}

}  // namespace sim
