#include "host-sim/serve/web_transport.hpp"

#include <civetweb.h>
#include <fmt/format.h>
#include <sys/eventfd.h>

#include <array>
#include <stdexcept>

#include "host-sim/page/page_file.hpp"
#include "host-sim/serve/outline_request.hpp"
#include "host-sim/serve/web_answer.hpp"
#include "host-sim/serve/web_guard.hpp"

namespace sim {
namespace {

using hal::host::checked;

constexpr int kForbidden = 403;
constexpr int kNotFound = 404;

class WebConnection final : public Connection {
 public:
  explicit WebConnection(std::shared_ptr<WebPipe> pipe) : pipe_{std::move(pipe)} {}
  WebConnection(const WebConnection&) = delete;
  WebConnection& operator=(const WebConnection&) = delete;
  ~WebConnection() override { pipe_->end(); }

  std::size_t read(std::span<std::byte> into) override { return pipe_->read(into); }
  std::size_t write(std::span<const std::byte> from) override { return pipe_->write(from); }
  bool open() override { return pipe_->open(); }
  void end() override { pipe_->end(); }
  void add_to(std::vector<pollfd>&, Wishes) const override {}  // The transport's bell rings.

 private:
  std::shared_ptr<WebPipe> pipe_;
};

std::string_view header(const mg_connection* connection, const char* name) {
  const char* value = mg_get_header(connection, name);
  return value == nullptr ? std::string_view{} : value;
}

std::string_view type_of(std::string_view path) {
  if (path.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (path.ends_with(".css")) return "text/css; charset=utf-8";
  if (path.ends_with(".svg")) return "image/svg+xml";
  return "text/html; charset=utf-8";
}

}  // namespace

/// What the server calls, in its own threads.
struct WebTransport::Handlers {
  static WebTransport& self(void* data) { return *static_cast<WebTransport*>(data); }

  /// Before anything else, WebSockets included. @returns 0 to go on
  static int on_begin(mg_connection* connection) {
    const WebTransport& transport = self(mg_get_request_info(connection)->user_data);
    const bool ours = is_our_host(header(connection, "Host"), transport.address_) &&
                      is_our_origin(header(connection, "Origin"), transport.address_);
    return ours ? 0 : send_refusal(connection, kForbidden, "This machine has no such name.");
  }

  static int on_request(mg_connection* connection, void* data) {
    WebTransport& transport = self(data);
    const std::string_view path = mg_get_request_info(connection)->local_uri;
    for (const PageFile& file : page_files()) {
      if (file.path == path) return send_document(connection, type_of(path), file.content);
    }
    if (path == "/picture.svg") {
      const PageService::Document picture = transport.service_.picture();
      return send_document(connection, picture.type, picture.content);
    }
    if (path == "/outline") return answer_outline(connection, transport.service_);
    return send_refusal(connection, kNotFound, "There is nothing of that name here.");
  }

  static void on_ready(mg_connection* connection, void* data) {
    WebTransport& transport = self(data);
    const bool observes =
        std::string_view{mg_get_request_info(connection)->local_uri} == "/observe";
    auto pipe = std::make_shared<WebPipe>([&transport] { transport.wake(); });
    {
      const std::lock_guard lock{transport.mutex_};
      if (observes) {
        transport.observers_.push_back(pipe);
      } else {
        transport.waiting_.push_back(pipe);
      }
      transport.peers_[connection] = std::make_unique<WebSocketPeer>(
          connection,
          pipe,
          observes ? WebSocketPeer::Role::kWatcher : WebSocketPeer::Role::kSender);
    }
    transport.wake();
  }

  static int on_data(
      mg_connection* connection, int opcode, char* bytes, std::size_t count, void* data) {
    WebTransport& transport = self(data);
    WebSocketPeer* peer = nullptr;
    {
      const std::lock_guard lock{transport.mutex_};
      peer = transport.peers_.at(connection).get();
    }
    // Only this thread removes it.
    return peer->on_frame(opcode, std::as_bytes(std::span{bytes, count})) ? 1 : 0;
  }

  static void on_close(const mg_connection* connection, void* data) {
    WebTransport& transport = self(data);
    std::unique_ptr<WebSocketPeer> peer;
    {
      const std::lock_guard lock{transport.mutex_};
      const auto found = transport.peers_.find(connection);
      if (found == transport.peers_.end()) return;
      peer = std::move(found->second);
      transport.peers_.erase(found);
    }
  }
};

void WebTransport::Stopper::operator()(mg_context* server) const { mg_stop(server); }

WebTransport::WebTransport(const InternetAddress& address, PageService& service)
    : address_{address},
      service_{service},
      bell_{checked(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK), "eventfd")} {
  const std::string ports = to_string(address);
  std::array<const char*, 11> options{"listening_ports",
                                      ports.c_str(),
                                      "num_threads",
                                      "24",
                                      "tcp_nodelay",
                                      "1",
                                      "enable_websocket_ping_pong",
                                      "yes",
                                      "request_timeout_ms",
                                      "10000",
                                      nullptr};
  mg_callbacks callbacks{};
  callbacks.begin_request = Handlers::on_begin;
  server_.reset(mg_start(&callbacks, this, options.data()));
  mg_server_port port{};
  if (!server_ || mg_get_server_ports(server_.get(), 1, &port) != 1) {
    throw std::runtime_error(fmt::format("ws {}: cannot listen there; is the port in use?", ports));
  }
  address_.port = static_cast<std::uint16_t>(port.port);
  mg_set_request_handler(server_.get(), "/", Handlers::on_request, this);
  mg_set_websocket_handler(server_.get(),
                           "/",
                           nullptr,  // on_begin has looked at it.
                           Handlers::on_ready,
                           Handlers::on_data,
                           Handlers::on_close,
                           this);
}

WebTransport::~WebTransport() {
  const std::lock_guard lock{mutex_};
  for (const auto& pipe : waiting_) pipe->end();
  for (const auto& pipe : observers_) pipe->end();
}

void WebTransport::wake() const { ::eventfd_write(bell_.number(), 1); }

std::unique_ptr<Connection> WebTransport::accept() {
  eventfd_t rung = 0;
  ::eventfd_read(bell_.number(), &rung);
  const std::lock_guard lock{mutex_};
  if (waiting_.empty()) return nullptr;
  auto connection = std::make_unique<WebConnection>(std::move(waiting_.front()));
  waiting_.pop_front();
  return connection;
}

void WebTransport::add_to(std::vector<pollfd>& descriptors) const {
  descriptors.push_back({bell_.number(), POLLIN, 0});
}

std::vector<std::shared_ptr<WebPipe>> WebTransport::observers() {
  const std::lock_guard lock{mutex_};
  std::erase_if(observers_, [](const auto& pipe) { return !pipe->open(); });
  return observers_;
}

}  // namespace sim
