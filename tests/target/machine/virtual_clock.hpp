#pragma once

#include <cstdint>
#include <functional>

#include "tests/target/machine/qemu.hpp"

namespace machine {

/// Returns the virtual time since power-on, ns. Under -icount it is the number of instructions
/// times 2^shift. A reset does not set it back.
[[nodiscard]] inline std::int64_t now_ns() { return qemu::qemu_clock_get_ns(qemu::kVirtualClock); }

constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// Calls a function once, at a given virtual time.
class Alarm {
 public:
  explicit Alarm(std::function<void()> action);
  Alarm(const Alarm&) = delete;
  Alarm& operator=(const Alarm&) = delete;
  ~Alarm() { cancel(); }

  /// Sets the time and replaces an earlier setting; a time in the past means now.
  void set(std::int64_t at_ns);
  void cancel();
  [[nodiscard]] bool is_set() const { return set_; }

 private:
  static void fire(void* self);

  std::function<void()> action_;
  bool set_ = false;
  qemu::Timer timer_{};
};

}  // namespace machine
