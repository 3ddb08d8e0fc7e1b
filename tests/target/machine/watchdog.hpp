#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "tests/target/machine/peripheral.hpp"

namespace machine {

/// Model of the independent watchdog (RM0090, 21): keys, prescaler, reload, and the reset if
/// nothing reloads it. Writes to PR and RLR apply from the next reload on; then PVU and RVU are set
/// for five clocks of the slow oscillator.
class Watchdog final : public Peripheral {
 public:
  Watchdog(const Services& services, std::uint32_t slow_hz, std::function<void()> bite)
      : Peripheral{services, {"IWDG", 0x4000'3000, {}}},
        slow_hz_{slow_hz},
        bite_{std::move(bite)} {}

  void reset() override {
    alarm_.cancel();
    prescaler_ = 0;
    reload_ = kWidest;
    unlocked_ = false;
    runs_ = false;
    updated_until_ns_ = {};
  }

 private:
  static constexpr std::uint32_t kKey = 0x00, kPrescaler = 0x04, kReload = 0x08, kStatus = 0x0C;
  static constexpr std::uint32_t kUnlock = 0x5555, kFeed = 0xAAAA, kStart = 0xCCCC;
  static constexpr std::uint32_t kWidest = 0xFFF;

  [[nodiscard]] std::int64_t slow_clocks_ns(std::int64_t clocks) const {
    return clocks * kSecond_ns / slow_hz_;
  }

  [[nodiscard]] std::uint32_t read(std::uint32_t offset) override {
    if (offset == kPrescaler) return prescaler_;
    if (offset == kReload) return reload_;
    if (offset != kStatus) return 0;
    return (now_ns() < updated_until_ns_.first ? 1U : 0U) |
           (now_ns() < updated_until_ns_.second ? 2U : 0U);
  }

  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == kKey) return take_key(value & 0xFFFFU);
    if (offset != kPrescaler && offset != kReload) return;
    if (!unlocked_) return trace().misuse("IWDG", "offset {:#x} without the key", offset);
    if (offset == kPrescaler) {
      prescaler_ = value & 7U;
      updated_until_ns_.first = now_ns() + slow_clocks_ns(5);
    } else {
      reload_ = value & kWidest;
      updated_until_ns_.second = now_ns() + slow_clocks_ns(5);
    }
  }

  void take_key(std::uint32_t key) {
    unlocked_ = key == kUnlock;
    if (key == kStart) runs_ = true;
    if (!runs_ || (key != kStart && key != kFeed)) return;
    const std::uint32_t divisor = 4U << (prescaler_ < 6 ? prescaler_ : 6U);
    alarm_.set(now_ns() + slow_clocks_ns((std::int64_t{reload_} + 1) * divisor));
  }

  std::int64_t slow_hz_;
  std::function<void()> bite_;
  Alarm alarm_{[this] { bite_(); }};
  std::uint32_t prescaler_ = 0, reload_ = kWidest;
  bool unlocked_ = false, runs_ = false;
  // End of the update of PR and of RLR, ns.
  std::pair<std::int64_t, std::int64_t> updated_until_ns_;
};

}  // namespace machine
