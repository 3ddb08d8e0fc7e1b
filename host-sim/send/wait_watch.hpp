#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace sim {

/// Reports to a sender program without an operator at its terminal that a machine waits in a state
/// that does not end by itself.
class WaitWatch {
 public:
  using Time = std::chrono::milliseconds;
  /// A machine that slows down, or restores its spindle, leaves its state within this time.
  static constexpr Time kPatience{1000};

  /// Returns one sentence for each time that the machine waits; otherwise an empty text.
  /// @param state state of a status report, such as `Hold:0`
  /// @param line line of the file that comes next; 0 for none
  [[nodiscard]] std::string attend(std::string_view state, std::size_t line, Time now);

 private:
  std::string waits_in_;  ///< The state in which the machine waits; empty if the state ends by
                          ///< itself.
  Time since_{};
  bool told_ = false;
};

}  // namespace sim
