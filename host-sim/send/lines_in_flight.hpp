#pragma once

#include <cstddef>
#include <deque>

namespace sim {

/// Counts the lines of a job that were sent and the lines that were answered. Lines are numbered
/// from 0 and are answered in their order.
class LinesInFlight {
 public:
  /// Returns the index of the next line to be sent.
  [[nodiscard]] std::size_t next() const { return next_; }
  /// Returns the number of answered lines: all lines before this index were answered.
  [[nodiscard]] std::size_t answered() const { return answered_; }
  /// Returns the number of lines that were sent and are not answered.
  [[nodiscard]] std::size_t count() const { return sizes_.size(); }
  /// Returns the total size of the lines that were sent and are not answered, bytes.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  /// Returns whether all lines before `line` were sent at least once.
  [[nodiscard]] bool were_sent_until(std::size_t line) const { return line <= furthest_; }
  /// Returns the number of lines that go_back() took back.
  [[nodiscard]] std::size_t resent() const { return resent_; }

  /// Counts the next line as sent.
  /// @param bytes size of the line with its end
  void send(std::size_t bytes);
  /// Counts all lines before `line` as answered. Lines that go_back() took back count, too.
  void answer_until(std::size_t line);
  /// Takes back the lines from `line` on: they are to be sent again.
  /// @pre answered() <= line <= next()
  void go_back(std::size_t line);

 private:
  std::size_t next_ = 0;
  std::size_t furthest_ = 0;  ///< Greatest value of next_ so far.
  std::size_t answered_ = 0;
  std::deque<std::size_t> sizes_;  ///< Bytes of each line from answered_ to next_.
  std::size_t bytes_ = 0;          ///< Sum of sizes_, bytes.
  std::size_t resent_ = 0;
};

}  // namespace sim
