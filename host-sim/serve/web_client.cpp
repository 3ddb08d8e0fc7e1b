#include "host-sim/serve/web_client.hpp"

#include <algorithm>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/rfc7230.hpp>
#include <boost/beast/http/write.hpp>
#include <exception>
#include <utility>

#include "host-sim/serve/http_status.hpp"
#include "host-sim/serve/web_stream.hpp"

namespace sim {
namespace {

namespace http = boost::beast::http;

constexpr std::size_t kRequestPart = std::size_t{64} << 10;
// The page may load nothing from other servers, run no inline scripts, and be in no frame of
// another page.
constexpr const char* kPolicy =
    "default-src 'self'; img-src 'self' blob: data:; object-src 'none'; base-uri 'none'; "
    "frame-ancestors 'none'";

WebReply reply_of(const WebWork& make) {
  try {
    return make();
  } catch (const std::exception& fault) {
    return web_refusal(http_status::kInternalFault, fault.what());
  }
}

/// Returns the request; nothing if it is malformed. A request with a duplicate header is malformed,
/// because two programs that read it could use different values.
std::optional<HttpRequest> request_of(const http::request_parser<http::string_body>& parser) {
  const auto& head = parser.get();
  for (const auto& field : head) {
    if (head.count(field.name_string()) != 1) return {};
  }
  HttpRequest request;
  request.method = head.method_string();
  request.host = head[http::field::host];
  request.origin = head[http::field::origin];
  // Least version of HTTP for which a server follows a request to upgrade. The server ignores such
  // requests of HTTP 1.0 (RFC 9110, 7.8).
  constexpr unsigned kFirstWithUpgrades = 11;
  request.wants_web_socket = head.version() >= kFirstWithUpgrades &&
                             http::token_list{head[http::field::upgrade]}.exists("websocket");
  const auto length = parser.content_length();
  if (length && head.count(http::field::transfer_encoding) == 0) request.length = *length;
  if (!read_target(head.target(), request)) return {};
  return request;
}

http::response<http::string_body> response_of(const WebReply& reply) {
  http::response<http::string_body> response;
  response.result(static_cast<unsigned>(reply.status));
  response.set(http::field::content_type, reply.type);
  response.set(http::field::cache_control, "no-cache");
  response.set("X-Content-Type-Options", "nosniff");
  response.set("Content-Security-Policy", kPolicy);
  if (reply.status == http_status::kWrongMethod) {
    response.set(http::field::allow, "GET, HEAD, POST");
  }
  response.keep_alive(false);
  response.body() = reply.content;
  response.prepare_payload();
  return response;
}

}  // namespace

WebClient::WebClient(boost::asio::io_context& context,
                     hal::host::Descriptor socket,
                     Clock::time_point now)
    : socket_{context, boost::asio::ip::tcp::v4(), socket.release()},
      buffer_{kRequestPart},
      until_{now + kPatience} {
  parser_.header_limit(kMaxHead);
  parser_.body_limit(kMaxBody);
}

WebClient::Handler WebClient::then(void (WebClient::*next)(Fault)) {
  return
      [self = shared_from_this(), next](Fault fault, std::size_t) { (self.get()->*next)(fault); };
}

void WebClient::begin() {
  http::async_read_header(socket_, buffer_, parser_, then(&WebClient::end_head));
}

void WebClient::attend(Clock::time_point now) {
  if (stage_ == Stage::kWorking &&
      work_.wait_for(Clock::duration::zero()) == std::future_status::ready) {
    answer(work_.get());
  }
  if (std::exchange(progressed_, false)) until_ = now + kPatience;
  if (now < until_ || stage_ == Stage::kWorking || stage_ == Stage::kOver) return;
  if (stage_ != Stage::kBody) return hang_up();
  Fault ignored;
  // This makes the read of the body fail, and the handler of the read answers the request.
  socket_.cancel(ignored);
}

void WebClient::end_head(Fault fault) {
  if (stage_ == Stage::kOver) return;
  if (fault) return refuse(fault);
  auto request = request_of(parser_);
  if (!request) return answer(web_refusal(http_status::kBadRequest, "The request is malformed."));
  request_ = std::move(*request);
  stage_ = Stage::kHasHead;
}

void WebClient::want_body() {
  stage_ = Stage::kBody;
  buffer_.reserve(kRequestPart);  // Greatest size of a part that one call reads.
  read_body({});
}

void WebClient::read_body(Fault fault) {
  if (stage_ == Stage::kOver) return;
  if (fault) return refuse(fault);
  progressed_ = true;
  if (parser_.is_done()) {
    request_.body = std::move(parser_.get().body());
    stage_ = Stage::kHasAll;
    return;
  }
  http::async_read_some(socket_, buffer_, parser_, then(&WebClient::read_body));
}

/// Answers a request that could not be read. A client that has disconnected gets no answer.
void WebClient::refuse(Fault fault) {
  if (fault == boost::asio::error::operation_aborted) {
    return answer(web_refusal(http_status::kTimeout, "The request did not arrive in time."));
  }
  if (fault == http::error::header_limit) {
    return answer(web_refusal(http_status::kHeadTooLarge, "The request is too long."));
  }
  if (fault == http::error::body_limit) {
    return answer(web_refusal(http_status::kTooLarge, "The request is longer than 64 MiB."));
  }
  const bool unfinished =
      fault == http::error::end_of_stream || fault == http::error::partial_message;
  if (unfinished || fault.category() != make_error_code(http::error::bad_method).category()) {
    return hang_up();
  }
  answer(web_refusal(http_status::kBadRequest, "The request is malformed."));
}

void WebClient::answer(const WebReply& reply) {
  stage_ = Stage::kAnswering;
  progressed_ = true;
  response_ = response_of(reply);
  sender_.emplace(response_);
  buffer_.clear();
  drop_the_rest();
  send();
}

void WebClient::work(WebWork make) {
  stage_ = Stage::kWorking;
  work_ = std::async(std::launch::async, [make = std::move(make)] { return reply_of(make); });
}

std::shared_ptr<WebSocket> WebClient::become_socket() {
  if (!parser_.is_done() || buffer_.size() > 0) {
    answer(web_refusal(http_status::kBadRequest,
                       "A WebSocket must wait for the answer to its handshake before it sends."));
    return nullptr;
  }
  stage_ = Stage::kOver;
  return open_web_socket(std::move(socket_), parser_.get());
}

void WebClient::send() {
  if (parser_.get().method() == http::verb::head) {
    http::async_write_header(socket_, *sender_, then(&WebClient::sent));
  } else {
    http::async_write_some(socket_, *sender_, then(&WebClient::sent));
  }
}

void WebClient::sent(Fault fault) {
  if (stage_ == Stage::kOver) return;
  if (fault) return hang_up();
  progressed_ = true;
  const bool only_head = parser_.get().method() == http::verb::head;
  if (!only_head && !sender_->is_done()) return send();
  sent_all_ = true;
  Fault ignored;
  socket_.shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  if (left_) hang_up();
}

/// Reads and drops the rest of the body while the answer is sent. If the connection were closed
/// with unread bytes, a reset would discard the answer.
void WebClient::drop_the_rest() {
  socket_.async_read_some(buffer_.prepare(kRequestPart), then(&WebClient::dropped));
}

void WebClient::dropped(Fault fault) {
  if (stage_ == Stage::kOver) return;
  if (!fault) return drop_the_rest();
  left_ = true;
  if (sent_all_) hang_up();
}

void WebClient::hang_up() {
  stage_ = Stage::kOver;
  Fault ignored;
  socket_.close(ignored);
}

void WebClient::add_to(std::vector<pollfd>& descriptors) {
  if (stage_ == Stage::kOver || stage_ == Stage::kWorking) return;
  const bool sends = stage_ == Stage::kAnswering && !sent_all_;
  const int events = (left_ ? 0 : POLLIN) | (sends ? POLLOUT : 0);
  descriptors.push_back({socket_.native_handle(), static_cast<short>(events), 0});
}

}  // namespace sim
