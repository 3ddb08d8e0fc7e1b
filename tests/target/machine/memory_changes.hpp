#pragma once

#include <cstdint>
#include <deque>

#include "tests/target/machine/flash.hpp"
#include "tests/target/machine/options.hpp"
#include "tests/target/machine/trace.hpp"

namespace machine {

/// Changes memory at given times: single bits of RAM, CCM and flash, as by radiation, and words of
/// RAM and CCM.
class MemoryChanges {
 public:
  MemoryChanges(const Options& options, Flash& flash, Trace& trace) {
    for (const BitFlip& flip : options.flips) {
      alarms_.emplace_back([flip, &flash, &trace] { turn(flip, flash, trace); }).set(flip.at_ns);
    }
    for (const WordStore& store : options.stores) {
      alarms_.emplace_back([store] { put(store); }).set(store.at_ns);
    }
  }

 private:
  static void turn(const BitFlip& flip, Flash& flash, Trace& trace) {
    const auto mask = static_cast<std::uint8_t>(1U << flip.bit);
    if (flash.has(flip.address)) {
      flash.turn_over(flip.address, mask);
    } else {
      std::uint8_t byte = 0;
      qemu::cpu_physical_memory_rw(flip.address, &byte, 1, false);
      byte = static_cast<std::uint8_t>(byte ^ mask);
      qemu::cpu_physical_memory_rw(flip.address, &byte, 1, true);
    }
    trace.event("flip", "{:08x} {}", flip.address, flip.bit);
  }

  static void put(const WordStore& store) {
    std::uint32_t value = store.value;
    qemu::cpu_physical_memory_rw(store.address, &value, sizeof value, true);
  }

  std::deque<Alarm> alarms_;
};

}  // namespace machine
