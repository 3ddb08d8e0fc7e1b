#pragma once

#include <cstddef>
#include <span>

#include "hal/interface/byte_stream.hpp"
#include "host-sim/serve/byte_queue.hpp"

namespace sim {

/// Receives the bytes that pass between a sender and the controller, at the time at which the
/// controller reads or writes them.
class LinkListener {
 public:
  virtual void on_read(std::span<const std::byte> bytes) = 0;
  virtual void on_write(std::span<const std::byte> bytes) = 0;
  /// Reports that the controller had more bytes to write than the link had capacity for.
  virtual void on_full() = 0;
  /// Reports a realtime byte that reaches the controller outside the link.
  virtual void on_beside(std::byte byte) = 0;
  /// Reports an emergency stop that reaches the controller outside the link.
  virtual void on_stop() = 0;

 protected:
  ~LinkListener() = default;
};

/// The controller's serial line, with one queue in each direction between the controller and the
/// connected sender. All calls must come from one thread. Nothing is dropped while a sender is
/// connected: a full queue makes its writer wait. Without a sender all output of the controller is
/// lost, as on a disconnected cable.
class LiveLink final : public hal::ByteStream {
 public:
  static constexpr std::size_t kIncoming = 4096;
  static constexpr std::size_t kOutgoing = 65536;

  // Controller's end of the line.
  [[nodiscard]] std::size_t read(std::span<std::byte> into) override;
  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override;

  // Sender's end of the line.

  /// Starts to keep the controller's output for a sender.
  void connect() { connected_ = true; }
  /// Drops the queued bytes of both directions.
  void disconnect();
  [[nodiscard]] std::size_t room() const { return incoming_.room(); }
  /// Returns the number of bytes that the controller has not read.
  [[nodiscard]] std::size_t waiting() const { return kIncoming - incoming_.room(); }
  /// Forgets the lines that the controller has not read.
  void drop_incoming() { incoming_.clear(); }
  /// @pre bytes.size() is at most room()
  void receive(std::span<const std::byte> bytes);
  /// Queues a byte that overtakes all normal bytes. At most kUrgent such bytes can wait; more are
  /// dropped.
  void interject(std::byte byte);
  /// Reports to the listener that a realtime byte reaches the controller outside the stream.
  void pass_by(std::byte byte) {
    if (listener_ != nullptr) listener_->on_beside(byte);
  }
  /// Reports to the listener that an emergency stop reaches the controller outside the stream.
  void stop_passes_by() {
    if (listener_ != nullptr) listener_->on_stop();
  }
  /// Returns whether no byte waits for the controller.
  [[nodiscard]] bool heard_all() const { return incoming_.empty() && urgent_.empty(); }
  /// Returns the oldest bytes that the controller wrote and the sender has not taken. Bytes that
  /// are not contiguous with these in memory follow in a later call.
  [[nodiscard]] std::span<const std::byte> outgoing() const { return outgoing_.front(); }
  /// @pre count is at most outgoing().size()
  void taken(std::size_t count) { outgoing_.pop(count); }

  /// Sets the listener; null for none. The listener must outlive the link.
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
