#include "tests/hal/stm32f405/can/can_model.hpp"

namespace hal::stm32f405 {

std::uint32_t CanModel::read(std::uint32_t address) {
  const std::uint32_t offset = address - 0x4000'6400;
  if (offset >= 0x1B0 && offset < 0x1D0) {
    const Fifo& fifo = fifos[(offset - 0x1B0) / 16];
    if (!fifo.mails.empty()) return fifo.mails.front()[offset / 4 % 4];
    misuse.emplace_back("reads an empty FIFO");
    return 0;
  }
  switch (offset) {
    case 0x00:
      return master;
    case 0x04:
      return status;
    case 0x08: {
      std::uint32_t word = transmitted;
      for (unsigned i = 0; i < 3; ++i) word |= (mailboxes[i][0] & 1U) != 0 ? 0 : 1U << (26 + i);
      return word;
    }
    case 0x0C:
    case 0x10: {
      const Fifo& fifo = fifos[(offset - 0x0C) / 4];
      return static_cast<std::uint32_t>(fifo.mails.size()) | (fifo.overrun ? 1U << 4 : 0U);
    }
    case 0x14:
      return interrupts;
    case 0x18:
      return errors;
    case 0x1C:
      return timing;
    default:
      return 0;
  }
}

void CanModel::write(std::uint32_t address, std::uint32_t value) {
  const std::uint32_t offset = address - 0x4000'6400;
  if (offset >= 0x240 && offset < 0x320) {
    const unsigned bank = (offset - 0x240) / 8;
    if ((filter_master & 1U) == 0 && (filters_on >> bank & 1U) != 0) {
      misuse.emplace_back("changes a filter that is on");
    }
    banks[bank][offset / 4 % 2] = value;
    return;
  }
  if (offset >= 0x180 && offset < 0x1B0) {
    const unsigned number = (offset - 0x180) / 16;
    if ((mailboxes[number][0] & 1U) != 0) misuse.emplace_back("writes a mailbox that waits");
    mailboxes[number][offset / 4 % 4] = value;
    if (offset % 16 == 0 && (value & 1U) != 0) requested.push_back(number);
    return;
  }
  switch (offset) {
    case 0x00:
      master = value;
      if (answers) status = (status & ~3U) | (value & 3U);
      break;
    case 0x04:
      status &= ~(value & 0x1CU);
      break;
    case 0x08:
      for (unsigned i = 0; i < 3; ++i) {
        if ((value >> (8 * i) & 1U) != 0) transmitted &= ~(0xFU << (8 * i));
      }
      break;
    case 0x0C:
    case 0x10: {
      Fifo& fifo = fifos[(offset - 0x0C) / 4];
      if ((value & 1U << 4) != 0) fifo.overrun = false;
      if ((value & 1U << 5) != 0 && !fifo.mails.empty()) fifo.mails.pop_front();
      break;
    }
    case 0x14:
      interrupts = value;
      break;
    case 0x1C:
      if ((status & 1U) == 0) misuse.emplace_back("changes the timing on the bus");
      timing = value;
      break;
    case 0x200:
      filter_master = value;
      break;
    case 0x204:
    case 0x20C:
    case 0x214:
      if ((filter_master & 1U) == 0) misuse.emplace_back("changes the kind of filters in use");
      (offset == 0x204 ? lists : offset == 0x20C ? wide : second) = value;
      break;
    case 0x21C:
      filters_on = value;
      break;
    default:
      misuse.emplace_back("a register that is not there");
  }
}

}  // namespace hal::stm32f405
