#pragma once

#include <cstdint>
#include <cstdio>
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "tests/target/machine/options.hpp"
#include "tests/target/machine/qemu.hpp"
#include "tests/target/machine/virtual_clock.hpp"

namespace machine {

/// The other end of a serial line: a file to send and a file to write, or a character device. With
/// a window it is a sender that counts characters: it sends a line when the line and all lines
/// without an answer (`ok…` or `error:…`) fit into the window. A banner (`Grbl …`) means that
/// earlier lines are never answered. With times it sends the given numbers of bytes no sooner than
/// at these times.
class SerialPeer {
 public:
  /// Ends the emulator with a message if a file or a device does not exist.
  explicit SerialPeer(const SerialOptions& options);
  SerialPeer(const SerialPeer&) = delete;
  SerialPeer& operator=(const SerialPeer&) = delete;
  ~SerialPeer();

  /// Sets the function that is called when a byte may be available again.
  void on_more(std::function<void()> action) { more_ = std::move(action); }
  /// Returns the next byte, if one may be sent now.
  [[nodiscard]] std::optional<std::uint8_t> send();
  [[nodiscard]] bool has_byte();
  void hear(std::uint8_t byte);
  void flush() const;

 private:
  // Greatest number of bytes that are read from a device in advance.
  static constexpr std::size_t kAhead = 64;

  void connect(const std::string& device);
  void open_files(const SerialOptions& options);
  void hear_answer(char character);
  void forget_lines();
  void read_times(const std::string& file);
  [[nodiscard]] bool line_fits();
  [[nodiscard]] bool time_has_come();

  struct Burst {
    std::int64_t at_ns = 0;
    std::size_t bytes = 0;
  };

  std::uint32_t window_;
  bool timed_ = false;
  std::deque<Burst> bursts_;
  Alarm alarm_{[this] {
    if (more_) more_();
  }};
  std::deque<std::uint8_t> to_send_;
  std::FILE* output_ = nullptr;
  bool in_line_ = false;
  std::size_t unanswered_ = 0;
  std::deque<std::size_t> lines_;  // Lengths of the lines without an answer.
  std::string answer_;
  std::function<void()> more_;
  bool has_device_ = false;
  qemu::CharBackend device_{};
};

}  // namespace machine
