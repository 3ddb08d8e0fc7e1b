#pragma once

#include <poll.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sim {

/// The sender's end of a link; no call blocks.
class Port {
 public:
  Port() = default;
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;
  virtual ~Port() = default;

  /// What has come; 0 when nothing has, or when the link is gone: see open().
  [[nodiscard]] virtual std::size_t read(std::span<char> into) = 0;
  /// Takes what leaves soon: lines that wait in an adapter cannot be called back.
  [[nodiscard]] virtual std::size_t write(std::string_view bytes) = 0;
  /// Takes realtime bytes beside the lines, as many as there is room for; 0 where the link has
  /// no such way, and they go between two lines.
  [[nodiscard]] virtual std::size_t act(std::string_view bytes) {
    static_cast<void>(bytes);
    return 0;
  }
  [[nodiscard]] virtual bool open() const = 0;
  /// Why it is not open any more.
  [[nodiscard]] virtual std::string trouble() const { return "the link is gone"; }
  /// What the link itself has to tell, for the log: a line at a time, empty for none.
  [[nodiscard]] virtual std::string take_news() { return {}; }
  /// Adds what to wake up for.
  virtual void add_to(std::vector<pollfd>& descriptors) const = 0;
};

/// A serial port, raw, 8N1, for this process alone. Throws std::system_error naming the device,
/// std::invalid_argument for a rate that no port has.
[[nodiscard]] std::unique_ptr<Port> open_serial_port(const std::string& device, unsigned baud);

/// Raw TCP, connected within five seconds. Throws std::system_error naming the address, or
/// std::invalid_argument.
[[nodiscard]] std::unique_ptr<Port> open_tcp_port(const std::string& address);

}  // namespace sim
