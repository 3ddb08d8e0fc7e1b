// Prints docs/boards.md from the boards of hal/stm32f405/boards; toolchain/boards.py compiles and
// runs it.

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

#include "hal/stm32f405/boards/btt_skr_2.hpp"
#include "hal/stm32f405/boards/btt_skr_pro_1_2.hpp"
#include "hal/stm32f405/boards/generic.hpp"
#include "hal/stm32f405/boards/mks_robin_nano_v3.hpp"

using namespace hal::stm32f405;

namespace {

constexpr std::array<const char*, kAxes> kAxisNames{"X", "Y", "Z", "A", "B", "C"};

std::string name_of(Pin pin) {
  return std::string{"P"} + static_cast<char>('A' + pin.port) + std::to_string(pin.number);
}

/// Table rows of one board, each `| connector | function | pin |`.
class Rows {
 public:
  explicit Rows(const BoardSheet& sheet) : sheet_{sheet} {}

  void add(Pin pin, const std::string& function) const {
    if (!pin.exists()) return;
    const char* const connector = connector_of(sheet_, pin);
    row(connector != nullptr ? connector : "header", function, name_of(pin));
  }

  void add(const std::array<Motor, kAxes>& motors) const {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      const Motor& motor = motors[axis];
      if (!motor.step.exists()) continue;
      std::string function = std::string{"motor "} + kAxisNames[axis] + ": step, direction";
      std::string pins = name_of(motor.step) + ", " + name_of(motor.direction);
      if (motor.enable.exists()) {
        function += ", enable";
        pins += ", " + name_of(motor.enable);
      }
      const char* const socket = sheet_.sockets[axis];
      row(socket != nullptr ? std::string{"driver "} + socket : "header", function, pins);
    }
  }

  void add(const std::array<Pin, kAxes>& pins, const std::string& function) const {
    for (std::size_t axis = 0; axis < kAxes; ++axis) add(pins[axis], function + kAxisNames[axis]);
  }

  void row(const std::string& connector,
           const std::string& function,
           const std::string& pins) const {
    std::printf("| %s | %s | %s |\n", connector.c_str(), function.c_str(), pins.c_str());
  }

 private:
  const BoardSheet& sheet_;
};

void print_pins(const Board& board, const BoardSheet& sheet) {
  std::puts("| connector | function | pin |\n|---|---|---|");
  const Rows rows{sheet};
  rows.add(board.motors);
  rows.add(board.second_motors);
  rows.add(board.motors_enable, "enable of all motors");
  rows.add(board.limits, "limit switch ");
  rows.add(board.second_limits, "second limit switch ");
  rows.add(board.probe, "probe");
  rows.add(board.door, "safety door");
  rows.add(board.hold, "feed hold");
  rows.add(board.start, "cycle start");
  rows.add(board.reset, "reset");
  rows.add(board.emergency_stop, "emergency stop");
  rows.add(board.power, "beam, or speed of the spindle (PWM)");
  rows.add(board.spindle_enable, "spindle enable (M3, M4)");
  rows.add(board.spindle_direction, "spindle direction (high: M4)");
  rows.add(board.mist, "mist (M7)");
  rows.add(board.flood, "flood (M8)");
  for (std::size_t i = 0; i < kDigitalOutputs; ++i) {
    rows.add(board.outputs[i], "output P" + std::to_string(i) + " (M62 to M65)");
  }
  rows.add(board.transmit, "serial line: the controller sends");
  rows.add(board.receive, "serial line: the controller receives");
  rows.add(board.can_transmit, "CAN: to the transceiver");
  rows.add(board.can_receive, "CAN: from the transceiver");
  rows.add(board.motor_power, "high from start-up on");
  rows.add(board.held_low, "low from start-up on");
  if (board.has_usb) rows.row("USB", "D-, D+", name_of(kUsbPins[0]) + ", " + name_of(kUsbPins[1]));
}

template <const Board& kBoard>
void print_board(const char* images) {
  const BoardSheet& sheet = kSheet<kBoard>;
  std::printf("\n## %s\n\nImage: %s. Chip: %s. Crystal: %lu MHz. Serial line: %lu baud.\n\n",
              kBoard.name,
              images,
              sheet.chips,
              static_cast<unsigned long>(kBoard.crystal_hz / 1'000'000),
              static_cast<unsigned long>(kBoard.baud));
  if (*sheet.caution != '\0') std::printf("**Before flashing: %s.**\n\n", sheet.caution);
  if (*sheet.notes != '\0') std::printf("%s\n\n", sheet.notes);
  print_pins(kBoard, sheet);
}

/// Prints the differences between two boards of one family.
void print_other_beam(const Board& board, const BoardSheet& sheet) {
  std::puts("\nWith `-DKERFLINE_ROBIN_NANO_BEAM=HE1`, on boards from V3.0_002 on:\n");
  std::puts("| connector | function | pin |\n|---|---|---|");
  Rows{sheet}.add(board.power, "beam, or speed of the spindle (PWM)");
}

}  // namespace

int main() {
  std::puts(
      "# Boards\n\n"
      "`toolchain/boards.py` writes this page from `hal/stm32f405/boards`. Inputs have a pull-up.\n"
      "They are active while they are connected to ground; `$5`, `$6` and `$14` invert them. `$2` "
      "to\n"
      "`$4`, `$15` and `$16` invert outputs, but never the beam's pin. This project has not tried\n"
      "any of the boards: measure a pin before you connect something dangerous to it, and fit a\n"
      "pull-down at the beam's pin.");
  print_board<kBttSkr2>("`kerfline_btt_skr_2`");
  print_board<kBttSkrPro12>("`kerfline_btt_skr_pro_1_2`");
  print_board<kMksRobinNanoV30>("`kerfline_mks_robin_nano_v3_0`");
  print_other_beam(kMksRobinNanoV30He1, kSheet<kMksRobinNanoV30He1>);
  print_board<kMksRobinNanoV31>("`kerfline_mks_robin_nano_v3_1`");
  print_other_beam(kMksRobinNanoV31He1, kSheet<kMksRobinNanoV31He1>);
  print_board<kGeneric>(
      "`kerfline_generic` for 1 MiB of flash, `kerfline_generic_512` for 512 KiB,\n"
      "`kerfline_generic_1mbaud` with a serial line of 1,000,000 baud");
  print_board<kGenericCan>("`kerfline_generic_can`");
  return 0;
}
