#pragma once

#include <poll.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// Events of a connection that wake the loop.
struct Wishes {
  bool read = false;
  bool write = false;
};

/// One sender's connection, over any transport. No call blocks. The destructor closes the
/// connection.
class Connection {
 public:
  Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  virtual ~Connection() = default;

  /// Copies the bytes that have arrived, and returns their number.
  [[nodiscard]] virtual std::size_t read(std::span<std::byte> into) = 0;
  /// Takes a realtime byte that arrived outside the stream, and returns whether there was one. Such
  /// a byte acts even in the middle of a line.
  [[nodiscard]] virtual bool take_realtime(std::byte& byte) {
    static_cast<void>(byte);
    return false;
  }
  /// Sends the bytes that fit, and returns their number.
  [[nodiscard]] virtual std::size_t write(std::span<const std::byte> from) = 0;
  /// Returns false once the sender has disconnected and all its bytes have been read.
  [[nodiscard]] virtual bool open() = 0;
  /// Closes the direction to the sender. Bytes that were already written still arrive.
  virtual void end() = 0;
  /// Adds the descriptors and events for which poll() is to wake up.
  virtual void add_to(std::vector<pollfd>& descriptors, Wishes wishes) const = 0;
  /// Returns the kind of this connection if the transport has more than one kind; otherwise an
  /// empty text.
  [[nodiscard]] virtual std::string_view kind() const { return {}; }
};

/// A kind of link over which senders connect.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  /// Returns the connection of the next sender; null if no sender waits.
  [[nodiscard]] virtual std::unique_ptr<Connection> accept() = 0;
  /// Returns true once after an emergency stop over this transport, whichever sender is connected.
  [[nodiscard]] virtual bool take_stop() { return false; }
  /// Adds the descriptors and events for which poll() is to wake up.
  virtual void add_to(std::vector<pollfd>& descriptors) const = 0;
  /// Returns `pty`, `tcp`, `ws`, `can` or `slcan`.
  [[nodiscard]] virtual std::string_view kind() const = 0;
  /// Returns the address at which senders find the transport, as text for users and scripts.
  [[nodiscard]] virtual std::string address() const = 0;
};

}  // namespace sim
