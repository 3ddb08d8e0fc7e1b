#pragma once

#include <cstddef>
#include <span>

namespace hal {

/// The board on which the program runs: the facts that it reports, and the way into its boot
/// loader. Main loop context.
class ControlBoard {
 public:
  /// Writes a line about the board, `NAME:text` such as `BOARD:BTT SKR 2`, and returns its length;
  /// returns 0 for rows after the last. Text that does not fit is cut off.
  [[nodiscard]] virtual std::size_t describe(std::size_t row, std::span<char> into) = 0;
  /// Writes a sentence about a fault that was found since the last start or caused it: a watchdog
  /// reset, a processor fault, a missing clock. Returns its length; 0 if there is no fault.
  [[nodiscard]] virtual std::size_t describe_trouble(std::span<char> into) = 0;
  /// Leaves the program for the chip's boot loader as soon as all queued text is on the wire.
  /// @pre nothing moves
  virtual void enter_boot_loader() = 0;

 protected:
  ~ControlBoard() = default;
};

}  // namespace hal
