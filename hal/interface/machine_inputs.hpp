#pragma once

#include <cstdint>

namespace hal {

/// The states of the machine's switches at one moment, with their polarity already corrected: true
/// means "limit reached", "button pressed" or "door open".
struct InputState {
  /// Bit i is 1 if a limit switch of axis i is reached, at either end of the axis.
  std::uint8_t limits = 0;
  /// Bit i is 1 if the switch of the second motor of axis i is reached.
  std::uint8_t second_limits = 0;
  bool probe = false;
  bool door = false;
  bool hold = false;
  bool start = false;
  bool reset = false;
  bool emergency_stop = false;

  constexpr bool operator==(const InputState&) const = default;
};

/// Reads all switches at the same time, without debouncing. Main loop context; never blocks.
class MachineInputs {
 public:
  [[nodiscard]] virtual InputState read_inputs() = 0;

 protected:
  ~MachineInputs() = default;
};

}  // namespace hal
