#include "host-sim/serve/web_socket.hpp"

#include <sys/socket.h>

#include <algorithm>
#include <array>

#include "host-sim/serve/listener.hpp"

namespace sim {
namespace {

constexpr std::size_t kSocketPart = std::size_t{1} << 16;
// Answers to pings of a client that reads nothing are dropped beyond this.
constexpr std::size_t kMostAnswers = std::size_t{1} << 16;

}  // namespace

WebSocket::WebSocket(hal::host::Descriptor socket, std::string_view early)
    : socket_{std::move(socket)} {
  take(early);
}

std::size_t WebSocket::read(std::span<std::byte> into) {
  if (incoming_.empty()) receive();
  const std::size_t count = std::min(into.size(), incoming_.size());
  const auto bytes = std::as_bytes(std::span{incoming_}).first(count);
  std::copy(bytes.begin(), bytes.end(), into.begin());
  incoming_.erase(0, count);
  return count;
}

std::size_t WebSocket::write(std::span<const std::byte> from) {
  if (gone_ || ended_ || outgoing_.size() >= kMostUnsent) return 0;
  const std::string_view text{reinterpret_cast<const char*>(from.data()),
                              std::min(from.size(), kMostUnsent - outgoing_.size())};
  if (text.empty()) return 0;
  const bool ascii = std::all_of(
      text.begin(), text.end(), [](char byte) { return static_cast<signed char>(byte) >= 0; });
  if (outgoing_.empty()) sent_at_ = Clock::now();
  outgoing_ += web_frame(ascii ? web_opcode::kText : web_opcode::kBinary, text);
  send();
  return text.size();
}

void WebSocket::end(std::uint16_t reason) {
  if (gone_ || ended_) return;
  outgoing_ += web_close_frame(reason);
  ended_ = true;
  sent_at_ = Clock::now();
  send();
}

void WebSocket::attend(Clock::time_point now) {
  if (!gone_) receive();
  if (!gone_) send();
  const bool waits = !outgoing_.empty();
  if ((waits && now - sent_at_ > kPatience) || (ended_ && now - sent_at_ > kFarewell)) gone_ = true;
}

void WebSocket::receive() {
  std::array<char, kSocketPart> part{};
  while (!gone_ && incoming_.size() < kIncoming) {
    const ssize_t count = ::recv(socket_.number(), part.data(), part.size(), 0);
    if (count > 0) {
      take({part.data(), static_cast<std::size_t>(count)});
    } else {
      if (count == 0 || !is_only_slow()) gone_ = true;
      return;
    }
  }
}

void WebSocket::take(std::string_view bytes) {
  std::string answers;
  frames_.take(bytes, incoming_, answers);
  if (ended_) incoming_.clear();
  if (outgoing_.size() < kMostAnswers) outgoing_ += answers;
  if (!frames_.closed()) return;
  if (!ended_) end(frames_.reason());
  gone_ = true;
}

void WebSocket::send() {
  while (!outgoing_.empty()) {
    const ssize_t count =
        ::send(socket_.number(), outgoing_.data(), outgoing_.size(), MSG_NOSIGNAL);
    if (count <= 0) {
      if (!is_only_slow()) gone_ = true;
      return;
    }
    outgoing_.erase(0, static_cast<std::size_t>(count));
    sent_at_ = Clock::now();
  }
  if (ended_) ::shutdown(socket_.number(), SHUT_WR);
}

void WebSocket::add_to(std::vector<pollfd>& descriptors) const {
  if (gone_) return;
  const int events =
      (incoming_.size() < kIncoming ? POLLIN : 0) | (outgoing_.empty() ? 0 : POLLOUT);
  descriptors.push_back({socket_.number(), static_cast<short>(events), 0});
}

}  // namespace sim
