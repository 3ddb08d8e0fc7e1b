#include "tests/target/machine/virtual_clock.hpp"

#include <utility>

namespace machine {

Alarm::Alarm(std::function<void()> action) : action_{std::move(action)} {
  qemu::timer_init_full(&timer_, nullptr, qemu::kVirtualClock, 1, 0, fire, this);
}

void Alarm::set(std::int64_t at_ns) {
  set_ = true;
  qemu::timer_mod_ns(&timer_, at_ns);
}

void Alarm::cancel() {
  set_ = false;
  qemu::timer_del(&timer_);
}

void Alarm::fire(void* self) {
  auto* const alarm = static_cast<Alarm*>(self);
  alarm->set_ = false;
  alarm->action_();
}

}  // namespace machine
