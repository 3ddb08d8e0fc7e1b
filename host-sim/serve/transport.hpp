#pragma once

#include <poll.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// What a connection would like to be woken for.
struct Wishes {
  bool read = false;
  bool write = false;
};

/// One sender's connection, whichever way it came. No call blocks; destroying
/// it hangs up.
class Connection {
 public:
  Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  virtual ~Connection() = default;

  /// Copies what has arrived; returns how many bytes.
  [[nodiscard]] virtual std::size_t read(std::span<std::byte> into) = 0;
  /// A realtime byte that came beside the stream, and acts whatever the text is in the middle of.
  [[nodiscard]] virtual bool take_realtime(std::byte& byte) {
    static_cast<void>(byte);
    return false;
  }
  /// Sends what fits; returns how many bytes.
  [[nodiscard]] virtual std::size_t write(std::span<const std::byte> from) = 0;
  /// False once the sender has gone and all that it sent has been read.
  [[nodiscard]] virtual bool open() = 0;
  /// Sends nothing more; what was written still arrives.
  virtual void end() = 0;
  /// Adds what to wake up for.
  virtual void add_to(std::vector<pollfd>& descriptors, Wishes wishes) const = 0;
  /// What it is, where the transport has more than one kind; else empty.
  [[nodiscard]] virtual std::string_view kind() const { return {}; }
};

/// A way in for senders.
class Transport {
 public:
  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  /// The next sender who wants to talk; null when there is none now.
  [[nodiscard]] virtual std::unique_ptr<Connection> accept() = 0;
  /// True once after an emergency stop from there, whoever is the sender.
  [[nodiscard]] virtual bool take_stop() { return false; }
  /// Adds what to wake up for.
  virtual void add_to(std::vector<pollfd>& descriptors) const = 0;
  /// `pty`, `tcp`, `ws`, `can` or `slcan`.
  [[nodiscard]] virtual std::string_view kind() const = 0;
  /// Where senders find it, for people and scripts.
  [[nodiscard]] virtual std::string address() const = 0;
};

}  // namespace sim
