#pragma once

#include <cstddef>
#include <span>

#include "hal/interface/byte_stream.hpp"
#include "host-sim/serve/byte_queue.hpp"

namespace sim {

/// Hears what passes between a sender and the controller, as the controller
/// reads and writes it.
class LinkListener {
 public:
  virtual void on_read(std::span<const std::byte> bytes) = 0;
  virtual void on_write(std::span<const std::byte> bytes) = 0;
  /// The controller wanted to write more than there was room for.
  virtual void on_full() = 0;
  /// A realtime byte reaches the controller beside the link.
  virtual void on_beside(std::byte byte) = 0;
  /// An emergency stop comes beside the link.
  virtual void on_stop() = 0;

 protected:
  ~LinkListener() = default;
};

/// The controller's serial line with two queues between it and whoever is
/// connected. One thread. Nothing is dropped while a sender is connected: a
/// full queue makes its writer wait. Without a sender the controller talks to
/// nobody, as on a cable that is plugged in nowhere.
class LiveLink final : public hal::ByteStream {
 public:
  static constexpr std::size_t kIncoming = 4096;
  static constexpr std::size_t kOutgoing = 65536;

  // The controller's end.
  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;

  // The sender's end.

  /// Somebody listens from now on.
  void connect() { connected_ = true; }
  /// Forgets what was on its way in both directions.
  void disconnect();
  [[nodiscard]] std::size_t room() const { return incoming_.room(); }
  /// Bytes that the controller has not read.
  [[nodiscard]] std::size_t waiting() const { return kIncoming - incoming_.room(); }
  /// Forgets the lines that the controller has not read.
  void drop_incoming() { incoming_.clear(); }
  /// @pre bytes.size() is at most room()
  void receive(std::span<const std::byte> bytes);
  /// A byte that overtakes all others; at most kUrgent at a time, more are dropped.
  void interject(std::byte byte);
  /// A realtime byte reaches the controller beside the stream: those who listen are to know.
  void pass_by(std::byte byte) {
    if (listener_ != nullptr) listener_->on_beside(byte);
  }
  /// The controller is stopped beside the stream: those who listen are to know.
  void stop_passes_by() {
    if (listener_ != nullptr) listener_->on_stop();
  }
  /// Nothing waits for the controller.
  [[nodiscard]] bool heard_all() const { return incoming_.empty() && urgent_.empty(); }
  /// What the controller said and nobody has taken yet; as much as lies together.
  [[nodiscard]] std::span<const std::byte> outgoing() const { return outgoing_.front(); }
  /// @pre count is at most outgoing().size()
  void taken(std::size_t count) { outgoing_.pop(count); }

  /// Null for nobody; must outlive the link.
  void tell(LinkListener* listener) { listener_ = listener; }

 private:
  static constexpr std::size_t kUrgent = 16;

  ByteQueue<kUrgent> urgent_{};
  ByteQueue<kIncoming> incoming_{};
  ByteQueue<kOutgoing> outgoing_{};
  LinkListener* listener_ = nullptr;
  bool connected_ = false;
};

}  // namespace sim
