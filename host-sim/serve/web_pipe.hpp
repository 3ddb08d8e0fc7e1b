#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>

namespace sim {

/// The two queues between a WebSocket's threads and the loop: all that they
/// share. The WebSocket's side blocks while there is no room or nothing to
/// send; the loop's side never does.
class WebPipe {
 public:
  static constexpr std::size_t kIncoming = 8192;
  static constexpr std::size_t kOutgoing = 1 << 20;

  /// @param wake called, without the lock, when there is news for the loop
  explicit WebPipe(std::function<void()> wake) : wake_{std::move(wake)} {}

  // The WebSocket's side.

  /// Waits until all is taken; false when the loop has ended it.
  [[nodiscard]] bool put(std::span<const std::byte> bytes);
  /// Waits for something to send, one message; nothing when no more will come.
  [[nodiscard]] std::optional<std::string> take();
  /// The other end has gone; what it sent can still be read.
  void leave();

  // The loop's side.

  [[nodiscard]] std::size_t read(std::span<std::byte> into);
  /// Queues what fits, as a message of its own; returns how many bytes.
  std::size_t write(std::span<const std::byte> from);
  /// Nothing more in either direction, once what was written has been sent.
  void end();
  /// The other end is there, or something that it sent is still unread.
  [[nodiscard]] bool open() const;
  /// Bytes that nobody has taken yet.
  [[nodiscard]] std::size_t unsent() const;

 private:
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> wake_;
  std::string incoming_;
  std::deque<std::string> outgoing_;
  std::size_t outgoing_bytes_ = 0;
  bool left_ = false;
  bool ended_ = false;
};

}  // namespace sim
