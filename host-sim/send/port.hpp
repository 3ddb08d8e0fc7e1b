#pragma once

#include <poll.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// The sender's end of a link. No call blocks.
class Port {
 public:
  Port() = default;
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;
  virtual ~Port() = default;

  /// Reads the bytes that have arrived. Returns 0 if no byte has arrived, but also if the link is
  /// lost; see open().
  [[nodiscard]] virtual std::size_t read(std::span<char> into) = 0;
  /// Takes the bytes that can be sent soon, and returns their number. More bytes are not taken,
  /// because lines that wait in an adapter cannot be withdrawn.
  [[nodiscard]] virtual std::size_t write(std::string_view bytes) = 0;
  /// Takes realtime bytes to send them separately from the lines, and returns the number of taken
  /// bytes. Returns 0 if the link cannot do this. The caller then sends the bytes between two
  /// lines.
  [[nodiscard]] virtual std::size_t act(std::string_view bytes) {
    static_cast<void>(bytes);
    return 0;
  }
  [[nodiscard]] virtual bool open() const = 0;
  /// Returns the reason why the link is not open any more.
  [[nodiscard]] virtual std::string trouble() const { return "the link is gone"; }
  /// Returns the next line of news about the link itself, for the log; empty if there is none.
  [[nodiscard]] virtual std::string take_news() { return {}; }
  /// Adds the descriptors and events for which poll() is to wake up.
  virtual void add_to(std::vector<pollfd>& descriptors) const = 0;
};

/// Opens a serial port: raw, 8N1, for this process alone. Throws std::system_error naming the
/// device, or std::invalid_argument for a baud rate that no port has.
[[nodiscard]] std::unique_ptr<Port> open_serial_port(const std::string& device, unsigned baud);

/// Opens a raw TCP connection within five seconds. Throws std::system_error naming the address, or
/// std::invalid_argument.
[[nodiscard]] std::unique_ptr<Port> open_tcp_port(const std::string& address);

}  // namespace sim
