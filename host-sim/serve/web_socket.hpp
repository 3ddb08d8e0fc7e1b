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
  /// Bytes that wait to be sent at most; what does not fit is not taken.
  static constexpr std::size_t kMostUnsent = std::size_t{1} << 20;
  /// A client that does not take a message in this time is gone.
  static constexpr std::chrono::seconds kPatience{30};
  /// For the client's part in closing.
  static constexpr std::chrono::seconds kFarewell{2};

  WebSocket() = default;
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;
  virtual ~WebSocket() = default;

  /// Copies the payload of messages that have arrived, one after the other; returns how many
  /// bytes.
  [[nodiscard]] virtual std::size_t read(std::span<std::byte> into) = 0;
  /// Queues what fits as a message: text where every byte is ASCII, which a browser may read as
  /// such, else binary. Returns how many bytes.
  virtual std::size_t write(std::span<const std::byte> from) = 0;
  std::size_t write(std::string_view text) { return write(std::as_bytes(std::span{text})); }
  /// Nothing more in either direction, once what was written has been sent: the client may try
  /// again later.
  virtual void end() = 0;
  /// The client is there, or something that it sent is unread.
  [[nodiscard]] virtual bool open() const = 0;
  /// The connection is closed.
  [[nodiscard]] virtual bool gone() const = 0;
  /// Bytes that wait to be sent.
  [[nodiscard]] virtual std::size_t unsent() const = 0;

  /// Hangs up on a client whose time is over.
  virtual void attend(Clock::time_point now) = 0;
  virtual void add_to(std::vector<pollfd>& descriptors) = 0;
};

}  // namespace sim
