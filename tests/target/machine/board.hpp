#pragma once

#include <cstdio>
#include <deque>
#include <optional>

#include "tests/target/machine/gpio.hpp"
#include "tests/target/machine/options.hpp"
#include "tests/target/machine/power_control.hpp"
#include "tests/target/machine/rcc.hpp"
#include "tests/target/machine/timer.hpp"

namespace machine {

/// The whole machine: makes the peripherals, lays them over the emulator's memory and resets them
/// with the system.
class Board {
 public:
  /// `core` is QEMU's armv7m object, `container` the memory as the core sees it.
  Board(const Options& options, std::FILE* trace, qemu::Object* core);
  Board(const Board&) = delete;
  Board& operator=(const Board&) = delete;
  ~Board() = default;

  /// As after power-on, or after what asked for a reset since then.
  void reset();
  /// Writes out what goes to files.
  void finish();

 private:
  void add(Peripheral& peripheral);
  void end(int status);

  const Options& options_;
  Trace trace_;
  Interrupts interrupts_;
  Rcc rcc_;
  Services services_;
  PowerControl power_control_;
  std::deque<Gpio> ports_;
  std::deque<Timer> timers_;
  Alarm stop_;
  ResetCause cause_ = ResetCause::kPowerOn;
};

/// How the emulator ends when the plug-in ends it.
constexpr int kPowerCutStatus = 90;
constexpr int kStoppedStatus = 91;

}  // namespace machine
