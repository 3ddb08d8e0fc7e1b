#pragma once

#include <poll.h>

#include <chrono>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace sim {

/// The server's end of a WebSocket. No call blocks.
class WebSocket {
 public:
  using Clock = std::chrono::steady_clock;
  /// Greatest number of bytes that wait to be sent. write() takes no bytes beyond this number.
  static constexpr std::size_t kMaxUnsent = std::size_t{1} << 20;
  /// A client that does not take a message within this time is disconnected.
  static constexpr std::chrono::seconds kPatience{30};
  /// Time that the client has to close its direction.
  static constexpr std::chrono::seconds kFarewell{2};

  WebSocket() = default;
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;
  virtual ~WebSocket() = default;

  /// Copies the payloads of arrived messages into `into`, without boundaries between them, and
  /// returns the number of bytes.
  [[nodiscard]] virtual std::size_t read(std::span<std::byte> into) = 0;
  /// Queues the bytes that fit as one message, and returns their number. The message is text if
  /// every byte is ASCII, as a browser can read that as text; otherwise it is binary.
  virtual std::size_t write(std::span<const std::byte> from) = 0;
  std::size_t write(std::string_view text) { return write(std::as_bytes(std::span{text})); }
  /// Closes both directions once all queued bytes have been sent. The close code tells the client
  /// to try again later.
  virtual void end() = 0;
  /// Returns whether the client is connected or bytes from it are unread.
  [[nodiscard]] virtual bool open() const = 0;
  /// Returns whether the connection is closed.
  [[nodiscard]] virtual bool gone() const = 0;
  /// Returns the number of bytes that wait to be sent.
  [[nodiscard]] virtual std::size_t unsent() const = 0;

  /// Disconnects a client whose time limit has passed.
  virtual void attend(Clock::time_point now) = 0;
  virtual void add_to(std::vector<pollfd>& descriptors) = 0;
};

}  // namespace sim
