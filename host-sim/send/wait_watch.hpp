#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace sim {

/// Says for what a machine waits that will not go on by itself, for a sender program at which
/// nobody sits.
class WaitWatch {
 public:
  using Time = std::chrono::milliseconds;
  /// A machine that slows down, or restores its spindle, waits for nobody.
  static constexpr Time kPatience{1000};

  /// A sentence once for each time that it waits; else empty.
  /// @param state as in a status report, such as `Hold:0`
  /// @param line of the file that comes next; 0 for none
  [[nodiscard]] std::string attend(std::string_view state, std::size_t line, Time now);

 private:
  std::string waits_in_;  ///< The state; empty for one that goes on by itself.
  Time since_{};
  bool told_ = false;
};

}  // namespace sim
