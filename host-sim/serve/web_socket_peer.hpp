#pragma once

#include <memory>
#include <string>
#include <thread>

#include "host-sim/serve/web_pipe.hpp"

struct mg_connection;

namespace sim {

/// The server's end of one WebSocket: a thread that sends what the loop puts
/// into the pipe, so that a slow reader makes nobody else wait.
class WebSocketPeer {
 public:
  enum class Role { kSender, kWatcher };

  /// Starts sending. The connection must outlive it. What a watcher sends is
  /// not for anybody.
  WebSocketPeer(mg_connection* connection, std::shared_ptr<WebPipe> pipe, Role role);
  WebSocketPeer(const WebSocketPeer&) = delete;
  WebSocketPeer& operator=(const WebSocketPeer&) = delete;
  ~WebSocketPeer();

  /// A frame has arrived. @returns whether the connection goes on.
  [[nodiscard]] bool on_frame(int opcode, std::span<const std::byte> bytes);

 private:
  void send_all();
  void send(const std::string& message);

  mg_connection* connection_;
  std::shared_ptr<WebPipe> pipe_;
  Role role_;
  std::thread sender_;  ///< The last member: it uses the others.
};

}  // namespace sim
