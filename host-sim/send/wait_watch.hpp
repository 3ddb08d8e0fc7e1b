#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace sim {

/// Reports for what a machine waits that does not go on by itself, for a sender program without an
/// operator at its terminal.
class WaitWatch {
 public:
  using Time = std::chrono::milliseconds;
  /// A machine that slows down, or restores its spindle, goes on by itself.
  static constexpr Time kPatience{1000};

  /// Returns a sentence once for each time that it waits; else empty.
  /// @param state as in a status report, such as `Hold:0`
  /// @param line of the file that comes next; 0 for none
  [[nodiscard]] std::string attend(std::string_view state, std::size_t line, Time now);

 private:
  std::string waits_in_;  ///< The state; empty for one that goes on by itself.
  Time since_{};
  bool told_ = false;
};

}  // namespace sim
