#pragma once

#include <termios.h>

#include <optional>

namespace sim {

/// Reads the keys of a terminal one by one, as long as this object exists. Without a terminal there
/// are no keys.
class Keys {
 public:
  Keys();
  ~Keys();
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;

  [[nodiscard]] bool any() const { return before_.has_value(); }
  /// Returns the next key that was pressed; nothing if no key was pressed.
  [[nodiscard]] std::optional<char> take();

 private:
  std::optional<termios> before_;
};

}  // namespace sim
