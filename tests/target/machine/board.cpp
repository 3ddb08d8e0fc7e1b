#include "tests/target/machine/board.hpp"

#include <cstdlib>

#include "tests/target/machine/timer_list.hpp"

namespace machine {

Board::Board(const Order& order, const Memory& memory, qemu::Object* core)
    : order_{order},
      trace_{order.trace},
      interrupts_{core},
      rcc_{trace_, interrupts_, {order.options.crystal_hz, order.options.slow_hz}},
      services_{trace_, interrupts_, rcc_},
      power_control_{services_},
      flash_{services_, order.options, [this] { end(kPowerCutStatus); }},
      watchdog_{services_,
                order.options.slow_hz,
                [this] {
                  trace_.event("watchdog", "bites");
                  reset_by(ResetCause::kWatchdog);
                }},
      can_{services_, order.options, order.frames},
      beyond_memory_{services_, {"beyond SRAM", 0x2002'0000, {}, 0x1'0000}},
      memories_{memory, order.options},
      debug_control_{services_},
      cycle_counter_{services_, debug_control_},
      pin_script_{order.pins, ports_},
      memory_changes_{order.options, flash_, trace_},
      brown_out_{[this] { reset_by(ResetCause::kBrownOut); }},
      stop_{[this] { end(kStoppedStatus); }},
      software_reset_{[] { qemu::qemu_system_reset(qemu::kGuestReset); }} {
  trace_.follow_words(order.options.words);
  add(rcc_, memory.system);
  add(power_control_, memory.system);
  for (char letter = 'A'; letter <= 'I'; ++letter) {
    add(ports_.emplace_back(services_, letter), memory.system);
  }
  for (const TimerKind& kind : kTimers) {
    Timer& timer = timers_.emplace_back(services_, kind);
    add(timer, memory.system);
    rcc_.follow(timer);
  }
  for (std::size_t i = 0; i < kUsarts.size(); ++i) {
    add(usarts_.emplace_back(services_, kUsarts[i], order.options.serial[i]), memory.system);
  }
  add(flash_, memory.system);
  rcc_.follow(flash_);
  flash_.map_memory(memory.system);
  add(watchdog_, memory.system);
  add(can_, memory.system);
  add(beyond_memory_, memory.system);
  constexpr std::uint32_t kFlash = 0x0800'0000, kLargest = 1024;
  if (const std::uint32_t kib = order.options.flash_kib; kib < kLargest) {
    beyond_flash_.emplace(services_,
                          Place{"beyond flash", kFlash + kib * 1024, {}, (kLargest - kib) * 1024});
    add(*beyond_flash_, memory.system);
  }
  add(debug_control_, memory.core);
  add(cycle_counter_, memory.core);
  rcc_.follow(cycle_counter_);
  connect_reset(core);
  if (order.options.brown_out_ns > 0) brown_out_.set(order.options.brown_out_ns);
  if (order.options.stop_ns > 0) stop_.set(order.options.stop_ns);
}

void Board::add(Peripheral& peripheral, qemu::MemoryRegion* container) {
  peripheral.map(container);
  rcc_.add(peripheral);
  all_.push_back(&peripheral);
}

void Board::reset() {
  rcc_.note(cause_);
  cause_ = ResetCause::kSoftware;  // Unless another cause is set before the next reset.
  trace_.event("reset", "{:08x}", rcc_.flags());
  for (Peripheral* peripheral : all_) peripheral->reset();
}

void Board::reset_by(ResetCause cause) {
  cause_ = cause;
  // Resets immediately. With a request, QEMU's main loop may first let virtual time jump to the
  // next alarm if the core sleeps. No instruction is in progress while an alarm is called.
  qemu::qemu_system_reset(qemu::kGuestReset);
}

/// Connects SYSRESETREQ of the core. The reset comes within the next few instructions, by virtual
/// time. QEMU's own reset would come later, when its main loop runs.
void Board::connect_reset(qemu::Object* core) {
  const auto asked = [](void* self, int, int level) {
    if (level != 0) static_cast<Board*>(self)->software_reset_.set(now_ns());
  };
  qemu::qdev_connect_gpio_out_named(
      core, "SYSRESETREQ", 0, qemu::qemu_allocate_irq(asked, this, 0));
}

void Board::finish() {
  flash_.save();
  Memories::save(order_.options.memory);
  for (const Usart& usart : usarts_) usart.flush();
  can_.flush();
  trace_.flush();
}

void Board::end(int status) {
  trace_.event("end", "{}", status);
  finish();
  std::_Exit(status);
}

}  // namespace machine
