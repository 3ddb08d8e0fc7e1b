#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "tests/target/machine/options.hpp"
#include "tests/target/machine/trace.hpp"

namespace machine {

/// Turns single bits of memory over at set times, as radiation does.
class BitFlips {
 public:
  BitFlips(const std::vector<BitFlip>& flips, Trace& trace) {
    for (const BitFlip& flip : flips) {
      alarms_.emplace_back([flip, &trace] { turn(flip, trace); }).set(flip.at_ns);
    }
  }

 private:
  static void turn(const BitFlip& flip, Trace& trace) {
    std::uint8_t byte = 0;
    qemu::cpu_physical_memory_rw(flip.address, &byte, 1, false);
    byte = static_cast<std::uint8_t>(byte ^ 1U << flip.bit);
    qemu::cpu_physical_memory_rw(flip.address, &byte, 1, true);
    trace.event("flip", "{:08x} {}", flip.address, flip.bit);
  }

  std::deque<Alarm> alarms_;
};

}  // namespace machine
