#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace sim {

/// Reports that a machine waits in a state that does not end by itself, for a sender program that
/// has no operator at its terminal.
class WaitWatch {
 public:
  using Time = std::chrono::milliseconds;
  /// Time after which the state of the machine counts as waiting. A machine that slows down, or
  /// restores its spindle, leaves its state within this time.
  static constexpr Time kPatience{1000};

  /// Returns a sentence once for each wait of the machine; otherwise an empty text.
  /// @param state state of a status report, such as `Hold:0`
  /// @param line line of the file that comes next; 0 for none
  [[nodiscard]] std::string attend(std::string_view state, std::size_t line, Time now);

 private:
  std::string waits_in_;  ///< State in which the machine waits; empty if the state ends by itself.
  Time since_{};
  bool told_ = false;
};

}  // namespace sim
