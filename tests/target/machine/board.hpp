#pragma once

#include <cstdio>
#include <deque>
#include <optional>

#include "tests/target/machine/can.hpp"
#include "tests/target/machine/cycle_counter.hpp"
#include "tests/target/machine/flash.hpp"
#include "tests/target/machine/gpio.hpp"
#include "tests/target/machine/memories.hpp"
#include "tests/target/machine/memory_changes.hpp"
#include "tests/target/machine/options.hpp"
#include "tests/target/machine/pin_script.hpp"
#include "tests/target/machine/power_control.hpp"
#include "tests/target/machine/rcc.hpp"
#include "tests/target/machine/timer.hpp"
#include "tests/target/machine/usart.hpp"
#include "tests/target/machine/watchdog.hpp"

namespace machine {

/// The options of the machine, and the files that were opened for it.
struct Order {
  Options options;
  std::FILE* trace = nullptr;
  std::vector<PinChange> pins;
  std::vector<TimedFrame> frames;
};

/// The complete machine: makes the peripherals, lays them over the emulator's memory and resets
/// them together with the system.
class Board {
 public:
  /// `core` is QEMU's armv7m object.
  Board(const Order& order, const Memory& memory, qemu::Object* core);
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;
  ~Board() = default;

  /// Resets the machine as after power-on, or for the cause that has been noted since.
  void reset();
  /// Writes all output files.
  void finish();

 private:
  void add(Peripheral& peripheral, qemu::MemoryRegion* container);
  void reset_by(ResetCause cause);
  void connect_reset(qemu::Object* core);
  void end(int status);

  const Order& order_;
  Trace trace_;
  Interrupts interrupts_;
  Rcc rcc_;
  Services services_;
  PowerControl power_control_;
  std::deque<Gpio> ports_;
  std::deque<Timer> timers_;
  std::deque<Usart> usarts_;
  Flash flash_;
  Watchdog watchdog_;
  Can can_;
  BeyondMemory beyond_memory_;
  std::optional<BeyondMemory> beyond_flash_;
  Memories memories_;
  DebugControl debug_control_;
  CycleCounter cycle_counter_;
  PinScript pin_script_;
  MemoryChanges memory_changes_;
  std::vector<Peripheral*> all_;
  Alarm brown_out_;
  Alarm stop_;
  Alarm software_reset_;
  ResetCause cause_ = ResetCause::kPowerOn;
};

/// Exit status of the emulator when the plug-in ends it.
constexpr int kPowerCutStatus = 90;
constexpr int kStoppedStatus = 91;

}  // namespace machine
