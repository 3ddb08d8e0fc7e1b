#include "host-sim/serve/web_client.hpp"

#include <fmt/format.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <exception>

#include "host-sim/serve/http_status.hpp"
#include "host-sim/serve/listener.hpp"
#include "host-sim/serve/web_accept_key.hpp"

namespace sim {
namespace {

constexpr std::size_t kRequestPart = std::size_t{64} << 10;

WebReply reply_of(const WebWork& make) {
  try {
    return make();
  } catch (const std::exception& fault) {
    return web_refusal(http_status::kInternalFault, fault.what());
  }
}

}  // namespace

void WebClient::attend(Clock::time_point now) {
  if (stage_ == Stage::kHead || stage_ == Stage::kBody) receive(now);
  if (stage_ == Stage::kWorking &&
      work_.wait_for(Clock::duration::zero()) == std::future_status::ready) {
    answer(work_.get(), now);
  }
  if (stage_ == Stage::kAnswering) send(now);
  if (now < until_ || stage_ == Stage::kWorking || stage_ == Stage::kOver) return;
  if (stage_ == Stage::kBody) {
    return answer(web_refusal(http_status::kTimeout, "The program did not come in time."), now);
  }
  stage_ = Stage::kOver;
}

void WebClient::receive(Clock::time_point now) {
  std::array<char, kRequestPart> part{};
  for (std::size_t parts = 0; parts < 16; ++parts) {  // The machine's time goes on meanwhile.
    const ssize_t count = ::recv(socket_.number(), part.data(), part.size(), 0);
    if (count <= 0) {
      if (count == 0 || !is_only_slow()) stage_ = Stage::kOver;
      return;
    }
    received_.append(part.data(), static_cast<std::size_t>(count));
    if (stage_ == Stage::kHead) return read_head(now);
    until_ = now + kPatience;
    if (received_.size() >= body_bytes_) return end_body();
  }
}

void WebClient::read_head(Clock::time_point now) {
  const std::size_t end = received_.find("\r\n\r\n");
  if (std::min(end, received_.size()) > kMostHead) {
    return answer(web_refusal(http_status::kHeadTooLarge, "The request is too long."), now);
  }
  if (end == std::string::npos) return;
  auto request = parse_http_head(std::string_view{received_}.substr(0, end));
  if (!request)
    return answer(web_refusal(http_status::kBadRequest, "The request is malformed."), now);
  request_ = std::move(*request);
  only_head_ = request_.method == "HEAD";
  received_.erase(0, end + 4);
  stage_ = Stage::kHasHead;
}

void WebClient::want_body(Clock::time_point now) {
  body_bytes_ = request_.content_length().value_or(0);
  until_ = now + kPatience;
  stage_ = Stage::kBody;
  if (received_.size() >= body_bytes_) end_body();
}

void WebClient::end_body() {
  received_.resize(body_bytes_);
  request_.body = std::move(received_);
  received_ = {};
  stage_ = Stage::kHasAll;
}

void WebClient::answer(const WebReply& reply, Clock::time_point now) {
  to_send_ = web_answer(reply, only_head_);
  until_ = now + kPatience;
  stage_ = Stage::kAnswering;
  send(now);
}

void WebClient::work(WebWork make) {
  stage_ = Stage::kWorking;
  work_ = std::async(std::launch::async, [make = std::move(make)] { return reply_of(make); });
}

WebSocket WebClient::become_socket() {
  const std::string accepted = fmt::format(
      "HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\n"
      "Connection: Upgrade\r\nSec-WebSocket-Accept: {}\r\n\r\n",
      web_accept_key(request_.header("sec-websocket-key")));
  // The first bytes on a new connection always fit.
  static_cast<void>(::send(socket_.number(), accepted.data(), accepted.size(), MSG_NOSIGNAL));
  stage_ = Stage::kOver;
  return {std::move(socket_), received_};
}

/// A body that nobody wants is read meanwhile: closing over unread bytes would throw the answer
/// away with a reset.
void WebClient::send(Clock::time_point now) {
  std::array<char, kRequestPart> unwanted{};
  const ssize_t heard = ::recv(socket_.number(), unwanted.data(), unwanted.size(), 0);
  const bool left = heard == 0 || (heard < 0 && !is_only_slow());
  while (!to_send_.empty()) {
    const ssize_t count = ::send(socket_.number(), to_send_.data(), to_send_.size(), MSG_NOSIGNAL);
    if (count <= 0) {
      if (!is_only_slow()) stage_ = Stage::kOver;
      return;
    }
    to_send_.erase(0, static_cast<std::size_t>(count));
    until_ = now + kPatience;
    if (to_send_.empty()) ::shutdown(socket_.number(), SHUT_WR);
  }
  if (left) stage_ = Stage::kOver;
}

void WebClient::add_to(std::vector<pollfd>& descriptors) const {
  if (stage_ == Stage::kOver || stage_ == Stage::kWorking) return;
  const int events = POLLIN | (to_send_.empty() ? 0 : POLLOUT);
  descriptors.push_back({socket_.number(), static_cast<short>(events), 0});
}

}  // namespace sim
