#include "tests/target/machine/board.hpp"

#include <cstdlib>

#include "tests/target/machine/timer_list.hpp"

namespace machine {

Board::Board(const Options& options, std::FILE* trace, qemu::Object* core)
    : options_{options},
      trace_{trace},
      interrupts_{core},
      rcc_{trace_, interrupts_, {options.crystal_hz, options.slow_hz}},
      services_{trace_, interrupts_, rcc_},
      power_control_{services_},
      stop_{[this] { end(kStoppedStatus); }} {
  add(rcc_);
  add(power_control_);
  for (char letter = 'A'; letter <= 'I'; ++letter) add(ports_.emplace_back(services_, letter));
  for (const TimerKind& kind : kTimers) {
    Timer& timer = timers_.emplace_back(services_, kind);
    add(timer);
    rcc_.add(static_cast<ClockFollower*>(&timer));
  }
  if (options_.stop_ns > 0) stop_.set(options_.stop_ns);
}

void Board::add(Peripheral& peripheral) {
  peripheral.map(qemu::get_system_memory());
  rcc_.add(&peripheral);
}

void Board::reset() {
  rcc_.note(cause_);
  cause_ = ResetCause::kSoftware;  // Unless the watchdog says otherwise.
  trace_.event("reset", "{:08x}", rcc_.flags());
  rcc_.reset();
  power_control_.reset();
  for (Gpio& port : ports_) port.reset();
  for (Timer& timer : timers_) timer.reset();
}

void Board::finish() { trace_.flush(); }

void Board::end(int status) {
  finish();
  std::_Exit(status);
}

}  // namespace machine
