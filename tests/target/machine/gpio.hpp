#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "tests/target/machine/peripheral.hpp"

namespace machine {

/// Model of a general-purpose port (RM0090, 8.4). Traces each pin whose drive changes: 0 or 1 as an
/// output, `f` if another peripheral has it, `z` if nothing drives it. An open-drain output drives
/// 0 or nothing. LCKR keeps its value and locks nothing.
class Gpio final : public Peripheral {
 public:
  static constexpr unsigned kPins = 16;
  enum class Wire : std::uint8_t { kLow, kHigh, kFree };

  Gpio(const Services& services, char letter);

  void reset() override;
  /// Connects a wire to a pin. A free pin follows its pull-up, or reads 0.
  void connect(unsigned pin, Wire wire);
  /// Returns the levels that IDR shows.
  [[nodiscard]] std::uint32_t levels() const;
  /// Sets the function that is called after levels may have changed.
  void on_change(std::function<void()> action) { changed_ = std::move(action); }

 private:
  [[nodiscard]] std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  [[nodiscard]] char drive(unsigned pin) const;
  void follow();
  [[nodiscard]] std::uint32_t at(std::uint32_t offset) const { return registers_[offset / 4]; }

  char letter_;
  std::string name_;
  std::array<std::uint32_t, 10> registers_{};
  std::array<char, kPins> drives_{};
  std::array<Wire, kPins> wires_{};
  std::function<void()> changed_;
};

}  // namespace machine
