#pragma once

#include <cstddef>
#include <span>

namespace hal {

/// The board on which the program runs. Reports facts about the board and enters its boot loader.
/// Main loop context.
class ControlBoard {
 public:
  /// Writes a line about the board, `NAME:text` such as `BOARD:BTT SKR 2`, and returns its length.
  /// Returns 0 if there is no such row. Text that does not fit is cut off.
  [[nodiscard]] virtual std::size_t describe(std::size_t row, std::span<char> into) = 0;
  /// Writes a sentence about a fault that caused the last restart or was found since: a watchdog
  /// reset, a processor fault or a missing clock. Returns its length; 0 if there is no fault.
  [[nodiscard]] virtual std::size_t describe_trouble(std::span<char> into) = 0;
  /// Leaves the program for the chip's boot loader after all queued text has been sent.
  /// @pre nothing moves
  virtual void enter_boot_loader() = 0;

 protected:
  ~ControlBoard() = default;
};

}  // namespace hal
