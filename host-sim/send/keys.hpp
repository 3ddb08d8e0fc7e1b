#pragma once

#include <termios.h>

#include <optional>

namespace sim {

/// The keys of a terminal one by one while it lives; none without a terminal.
class Keys {
 public:
  Keys();
  ~Keys();
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;

  [[nodiscard]] bool any() const { return before_.has_value(); }
  /// The next one pressed; nothing when none was.
  [[nodiscard]] std::optional<char> take();

 private:
  std::optional<termios> before_;
};

}  // namespace sim
