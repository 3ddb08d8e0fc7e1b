#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>

namespace sim {

/// Lines and realtime bytes that wait to be written to a link.
class SendQueue {
 public:
  /// Appends a line, without its end.
  void put_line(std::string_view line);
  /// Appends a realtime byte. Realtime bytes go out before all lines that are not begun.
  void put_realtime(char byte) { realtime_ += byte; }
  [[nodiscard]] bool has_lines() const { return !lines_.empty(); }
  /// Drops all lines, but for the rest of a line that was written in part.
  void drop_lines();

  /// Returns the realtime bytes, for a link that carries them apart from lines.
  [[nodiscard]] std::string_view realtime() const { return realtime_; }
  /// Drops `count` bytes of realtime(), which the link has sent.
  void drop_realtime(std::size_t count) { realtime_.erase(0, count); }

  /// Returns the next bytes to be written, at most the rest of one line; empty if there are none.
  /// Realtime bytes are returned only between two lines, so that they spoil no line.
  ///
  /// Where bytes may be damaged, a single realtime byte may be a damaged one, so each is sent
  /// twice. A line end precedes the pair, because the last line may have lost its own end, and no
  /// byte acts within a line. A question does no harm, so it is sent as a single byte.
  /// @param checked whether the controller takes checked lines only, so that this applies
  [[nodiscard]] std::string_view next(bool checked);
  /// Drops `count` bytes of next(), which were written.
  void wrote(std::size_t count);

 private:
  std::deque<std::string> lines_;
  std::size_t written_ = 0;   ///< Bytes of the first line that were written.
  std::string realtime_;      ///< Realtime bytes to be sent.
  std::string realtime_out_;  ///< Realtime bytes in the form in which they are sent between lines.
};

}  // namespace sim
