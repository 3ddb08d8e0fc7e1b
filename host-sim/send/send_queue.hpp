#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>

namespace sim {

/// Lines and realtime bytes that wait to be written to a link.
class SendQueue {
 public:
  /// Appends a line. `line` has no line end.
  void put_line(std::string_view line);
  /// Appends a realtime byte. It is sent before all lines of which no byte was written.
  void put_realtime(char byte) { realtime_ += byte; }
  [[nodiscard]] bool has_lines() const { return !lines_.empty(); }
  /// Drops all lines, except the rest of a line that was written in part.
  void drop_lines();

  /// Returns the realtime bytes, for a link that sends them separately from lines.
  [[nodiscard]] std::string_view realtime() const { return realtime_; }
  /// Drops `count` bytes of realtime(), which the link has sent.
  void drop_realtime(std::size_t count) { realtime_.erase(0, count); }

  /// Returns the next bytes to be written, at most the rest of one line; empty if there are none.
  /// Realtime bytes are returned only between two lines, so that they do not corrupt a line.
  ///
  /// On a link that may damage bytes, a single realtime byte may be the result of damage. A
  /// controller with checked lines therefore expects each realtime byte twice. A line end precedes
  /// the pair, because the last line may have lost its own end, and the pair does not act within a
  /// line. The status request `?` is harmless, so it is sent as a single byte.
  /// @param checked whether the controller accepts only checked lines; realtime bytes are then sent
  /// in pairs
  [[nodiscard]] std::string_view next(bool checked);
  /// Drops `count` bytes of next(), which were written.
  void wrote(std::size_t count);

 private:
  std::deque<std::string> lines_;
  std::size_t written_ = 0;   ///< Number of bytes of the first line that were written.
  std::string realtime_;      ///< Realtime bytes to be sent.
  std::string realtime_out_;  ///< Realtime bytes in the form in which they are sent between lines.
};

}  // namespace sim
