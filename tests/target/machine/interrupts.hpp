#pragma once

#include <array>

#include "tests/target/machine/qemu.hpp"

namespace machine {

/// The interrupt controller's inputs. Several peripherals may share an input, which is high while
/// any of them is.
class Interrupts {
 public:
  static constexpr unsigned kCount = 82;  // RM0090, table 61.

  explicit Interrupts(qemu::Object* core) : core_{core} {}

  void add(unsigned number) {
    if (raised_[number]++ == 0) set(number, 1);
  }
  void remove(unsigned number) {
    if (--raised_[number] == 0) set(number, 0);
  }

 private:
  void set(unsigned number, int level) {
    qemu::qemu_set_irq(qemu::qdev_get_gpio_in(core_, static_cast<int>(number)), level);
  }

  qemu::Object* core_;
  std::array<unsigned, kCount> raised_{};
};

/// The output of one peripheral to an input.
class InterruptLine {
 public:
  InterruptLine(Interrupts& interrupts, unsigned number)
      : interrupts_{interrupts}, number_{number} {}

  void set(bool level) {
    if (level == level_) return;
    level_ = level;
    if (level) {
      interrupts_.add(number_);
    } else {
      interrupts_.remove(number_);
    }
  }

 private:
  Interrupts& interrupts_;
  unsigned number_;
  bool level_ = false;
};

}  // namespace machine
