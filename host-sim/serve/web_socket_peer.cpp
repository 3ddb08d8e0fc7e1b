#include "host-sim/serve/web_socket_peer.hpp"

#include <civetweb.h>

#include <algorithm>
#include <array>

namespace sim {
namespace {

constexpr int kOpcode = 0x0F;
// Close status 1013, "try again later", in network order.
constexpr std::array<char, 2> kTryAgainLater{0x03, static_cast<char>(0xF5)};

}  // namespace

WebSocketPeer::WebSocketPeer(mg_connection* connection, std::shared_ptr<WebPipe> pipe, Role role)
    : connection_{connection}, pipe_{std::move(pipe)}, role_{role}, sender_{[this] {
        send_all();
      }} {}

WebSocketPeer::~WebSocketPeer() {
  pipe_->leave();
  sender_.join();
}

bool WebSocketPeer::on_frame(int opcode, std::span<const std::byte> bytes) {
  switch (opcode & kOpcode) {
    case MG_WEBSOCKET_OPCODE_CONTINUATION:
    case MG_WEBSOCKET_OPCODE_TEXT:
    case MG_WEBSOCKET_OPCODE_BINARY:
      return role_ == Role::kWatcher || pipe_->put(bytes);
    case MG_WEBSOCKET_OPCODE_CONNECTION_CLOSE:
      return false;
    default:
      return true;  // Ping and pong.
  }
}

void WebSocketPeer::send_all() {
  while (const auto message = pipe_->take()) send(*message);
  mg_websocket_write(connection_,
                     MG_WEBSOCKET_OPCODE_CONNECTION_CLOSE,
                     kTryAgainLater.data(),
                     kTryAgainLater.size());
}

/// As text where every part of it is valid UTF-8, which a browser insists on.
void WebSocketPeer::send(const std::string& message) {
  const bool ascii = std::all_of(message.begin(), message.end(), [](char byte) {
    return static_cast<signed char>(byte) >= 0;
  });
  const int opcode = ascii ? MG_WEBSOCKET_OPCODE_TEXT : MG_WEBSOCKET_OPCODE_BINARY;
  mg_websocket_write(connection_, opcode, message.data(), message.size());
}

}  // namespace sim
