#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "host-sim/order/order_file.hpp"

namespace sim::order {

/// Reads the words of a problem file one after another. Keeps the number of the line.
class FileWords {
 public:
  FileWords(std::string_view text, std::string_view file) : rest_{text}, file_{file} {}

  /// Removes and returns the next word; empty at the end of the file. A colon is a separate word.
  std::string_view next();
  /// Returns the word that the following call of next() returns, without removing it.
  [[nodiscard]] std::string_view peek() const;
  /// Removes and returns the rest of the line, without blanks at its beginning and end.
  std::string_view rest_of_line();

  /// Reads the next word as a number. Throws OrderFileError if the word is no number.
  /// @param what name of the number in messages
  double number(std::string_view what);
  std::int64_t whole_number(std::string_view what, std::int64_t least, std::int64_t most);

  [[noreturn]] void fail(std::string_view reason) const;
  [[noreturn]] void fail_at(std::size_t line, std::string_view reason) const;
  [[nodiscard]] std::size_t line() const { return line_; }

 private:
  void skip_blanks();

  std::string_view rest_;
  std::string_view file_;
  std::size_t line_ = 1;
};

}  // namespace sim::order
