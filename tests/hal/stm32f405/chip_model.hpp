#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "hal/stm32f405/board.hpp"

namespace hal::stm32f405 {

/// Model of the chip's registers: plain cells, some of which act as the reference manual says.
/// There is only one; call `start_anew` before use.
struct ChipModel {
  // Inputs that the test sets.
  bool crystal_starts = true;
  bool pll_locks = true;
  bool flash_refuses = false;
  std::uint32_t flash_weak_bits = 0;  ///< Bits that programming fails to clear.

  // Outputs that the test reads.
  std::map<Address, Word> cells;
  std::vector<std::pair<Address, Word>> writes;
  std::uint64_t reads = 0;
  std::size_t barriers = 0;
  std::size_t writes_at_barrier = 0;          ///< Number of writes before the last barrier.
  std::map<unsigned, Word> pins_driven_high;  ///< Output register of each port.
  std::vector<unsigned> pended;               ///< Numbers of the requested interrupts.
  std::vector<Word> sent;                     ///< Data that was sent on a serial interface.
  /// Status and data of each byte that will be received.
  std::vector<std::pair<Word, Word>> to_receive;
  std::map<Address, Word> flash_words;
  unsigned flash_keys = 0;
  bool flash_locked = true;
  /// After a wrong key the flash stays locked until a reset (RM0090, 3.6.1).
  bool flash_key_was_wrong = false;

  [[nodiscard]] bool is_high(Pin pin) { return (pins_driven_high[pin.port] & pin.mask()) != 0; }
  [[nodiscard]] Word mode_of(Pin pin) {
    return cells[gpio::mode(pin.port)] >> (2U * pin.number) & 3U;
  }
  /// Sets the level of an input pin.
  void feed(Pin pin, bool high) {
    Word& levels = cells[gpio::input(pin.port)];
    levels = high ? levels | pin.mask() : levels & ~pin.mask();
  }
  [[nodiscard]] std::size_t writes_to(Address address) const {
    std::size_t count = 0;
    for (const auto& [place, value] : writes) count += place == address ? 1 : 0;
    return count;
  }

  Word read(Address address);
  void write(Address address, Word value);

 private:
  void write_flash_control(Word value);
  [[nodiscard]] bool is_flash(Address address) const {
    return address >= flash::kMemory && address < flash::kMemory + 1024 * 1024;
  }
};

/// The bus to the only model.
struct ModelBus {
  static ChipModel& chip() {
    static ChipModel model;
    return model;
  }
  /// Powers the model on: pull-ups hold all inputs high.
  static ChipModel& start_anew() {
    chip() = {};
    for (unsigned port = 0; port < gpio::kPorts; ++port) chip().cells[gpio::input(port)] = 0xFFFF;
    return chip();
  }
  static Word read(Address address) noexcept { return chip().read(address); }
  static void write(Address address, Word value) noexcept { chip().write(address, value); }
  static void barrier() noexcept {
    ++chip().barriers;
    chip().writes_at_barrier = chip().writes.size();
  }
};

}  // namespace hal::stm32f405
