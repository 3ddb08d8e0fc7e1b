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

/// Who is at the other end of a serial line: a file to send and one to write, or a character
/// device. With a window it is a sender that counts characters: a line goes out when it and all
/// lines without an answer (`ok…` or `error:…`) fit the window. A banner (`Grbl …`) says that the
/// lines before it are never answered. With times it sends so many bytes no sooner than then.
class SerialPeer {
 public:
  /// Ends the emulator with a message where a file or a device is not there.
  explicit SerialPeer(const SerialOptions& options);
  SerialPeer(const SerialPeer&) = delete;
  SerialPeer& operator=(const SerialPeer&) = delete;
  ~SerialPeer();

  /// Called when there may be something to send again.
  void on_more(std::function<void()> action) { more_ = std::move(action); }
  /// The next byte, where one may go out now.
  [[nodiscard]] std::optional<std::uint8_t> send();
  [[nodiscard]] bool has_byte();
  void hear(std::uint8_t byte);
  void flush() const;

 private:
  static constexpr std::size_t kAhead = 64;  // Bytes taken from a device before their time.

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
  std::deque<std::size_t> lines_;  // Lengths of those without an answer.
  std::string answer_;
  std::function<void()> more_;
  bool has_device_ = false;
  qemu::CharBackend device_{};
};

}  // namespace machine
