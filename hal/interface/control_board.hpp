#pragma once

#include <cstddef>
#include <span>

namespace hal {

/// The board under the program: what it tells about itself, and the way out.
/// Main loop context.
class ControlBoard {
 public:
  /// Writes a line about the board, `NAME:text` such as `BOARD:BTT SKR 2`, and
  /// returns its length; 0 for rows after the last. What does not fit is cut off.
  [[nodiscard]] virtual std::size_t describe(std::size_t row, std::span<char> into) = 0;
  /// Likewise a sentence about what is wrong since the last start, or made it
  /// necessary: a watchdog, a fault, a clock that is missing. 0 when nothing is.
  [[nodiscard]] virtual std::size_t describe_trouble(std::span<char> into) = 0;
  /// Leaves the program for the chip's boot loader, as soon as what was said is
  /// on the wire. @pre nothing moves
  virtual void enter_boot_loader() = 0;

 protected:
  ~ControlBoard() = default;
};

}  // namespace hal
