#include "tests/hal/stm32f405/chip_model.hpp"

#include "hal/stm32f405/sectors.hpp"

namespace hal::stm32f405 {

Word ChipModel::read(Address address) {
  ++reads;
  if (is_flash(address)) {
    const auto found = flash_words.find(address);
    return found == flash_words.end() ? 0xFFFF'FFFF : found->second;
  }
  if (address == flash::kControl) return cells[address] | (flash_locked ? flash::kLock : 0);
  for (const SerialPins& pins : kSerialPins) {
    if (address == pins.base + usart::kStatus) {
      return usart::kRoomToSend | (to_receive.empty() ? 0 : to_receive.front().first);
    }
    if (address == pins.base + usart::kData && !to_receive.empty()) {
      const Word data = to_receive.front().second;
      to_receive.erase(to_receive.begin());
      return data;
    }
  }
  return cells[address];
}

void ChipModel::write(Address address, Word value) {
  writes.emplace_back(address, value);
  for (unsigned port = 0; port < gpio::kPorts; ++port) {
    if (address != gpio::set_reset(port)) continue;
    // A pin that is both set and reset is set (RM0090, 8.4.7).
    Word& high = pins_driven_high[port];
    high = (high & ~(value >> 16)) | (value & 0xFFFFU);
    return;
  }
  for (unsigned group = 0; group < 3; ++group) {
    for (unsigned place = 0; address == core::interrupt_pend(32 * group) && place < 32; ++place) {
      if ((value & bit(place)) != 0) pended.push_back(32 * group + place);
    }
  }
  for (const SerialPins& pins : kSerialPins) {
    if (address == pins.base + usart::kData) {
      sent.push_back(value);
      return;
    }
  }
  if (is_flash(address)) {
    const bool may = !flash_locked && (cells[flash::kControl] & flash::kProgram) != 0;
    if (may) flash_words[address] = read(address) & (value | flash_weak_bits);
    return;
  }
  if (address == flash::kKey) {
    const bool right = value == (flash_keys == 0 ? flash::kFirstKey : flash::kSecondKey);
    if (!flash_locked || !right) flash_key_was_wrong = true;
    if (!flash_key_was_wrong && ++flash_keys == 2 && !flash_refuses) flash_locked = false;
    return;
  }
  if (address == flash::kControl) return write_flash_control(value);
  if (address == flash::kStatus) value = cells[address] & ~value;
  if (address == rcc::kCr) {
    value &= ~(rcc::kHseReady | rcc::kPllReady);
    if ((value & rcc::kHsiOn) != 0) value |= rcc::kHsiReady;
    if ((value & rcc::kHseOn) != 0 && crystal_starts) value |= rcc::kHseReady;
    if ((value & rcc::kPllOn) != 0 && pll_locks) value |= rcc::kPllReady;
  }
  if (address == rcc::kCfgr) {
    value = (value & ~rcc::kSwitchedMask) | (value & rcc::kSwitchMask) << 2;
  }
  cells[address] = value;
}

void ChipModel::write_flash_control(Word value) {
  if ((value & flash::kLock) != 0) {
    flash_locked = true;
    flash_keys = 0;
  }
  if (flash_locked) return;
  cells[flash::kControl] = value;
  if ((value & flash::kEraseSector) == 0 || (value & flash::kStart) == 0) return;
  const unsigned sector = value >> 3 & 0xFU;
  const Address begin = flash::kMemory + sector_start(sector);
  const Address end = flash::kMemory + sector_start(sector + 1);
  for (auto at = flash_words.begin(); at != flash_words.end();) {
    at = at->first >= begin && at->first < end ? flash_words.erase(at) : ++at;
  }
}

}  // namespace hal::stm32f405
