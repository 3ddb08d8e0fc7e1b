#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {

/// Model of CAN1's registers by the reference manual: handshakes, mailboxes, FIFOs, and where
/// filters are set. The filtering of frames is left to the emulator.
struct CanModel {
  using Mail = std::array<std::uint32_t, 4>;

  // Inputs that the test sets.
  bool answers = true;

  // Outputs that the test reads.
  std::vector<std::string> misuse;
  std::uint32_t master = 0x0001'0002, status = 0x0000'0C02, timing = 0x0123'0000, errors = 0;
  std::uint32_t interrupts = 0, transmitted = 0;
  std::array<Mail, 3> mailboxes{};
  std::vector<unsigned> requested;  ///< Mailboxes in the order in which they were filled.
  struct Fifo {
    std::deque<Mail> mails;
    bool overrun = false;
  };
  std::array<Fifo, 2> fifos{};
  std::uint32_t filter_master = 0x2A1C'0E01, lists = 0, wide = 0, second = 0, filters_on = 0;
  std::array<std::array<std::uint32_t, 2>, 28> banks{};

  [[nodiscard]] static bool has(std::uint32_t address) {
    return address >= 0x4000'6400 && address < 0x4000'6800;
  }
  /// Returns the oldest request, as other nodes see it, and empties its mailbox.
  Mail take_sent() {
    const unsigned number = requested.front();
    requested.erase(requested.begin());
    const Mail mail = mailboxes[number];
    mailboxes[number][0] &= ~1U;
    transmitted |= 3U << (8 * number);
    return mail;
  }
  void arrive(unsigned fifo, const Mail& mail) {
    if (fifos[fifo].mails.size() == 3) {
      fifos[fifo].overrun = true;
      return;
    }
    fifos[fifo].mails.push_back(mail);
  }

  std::uint32_t read(std::uint32_t address);
  void write(std::uint32_t address, std::uint32_t value);
};

struct CanBus {
  static CanModel& can() {
    static CanModel model;
    return model;
  }
  static void barrier() noexcept {}
  static Word read(Address address) noexcept {
    return CanModel::has(address) ? can().read(address) : ModelBus::read(address);
  }
  static void write(Address address, Word value) noexcept {
    CanModel::has(address) ? can().write(address, value) : ModelBus::write(address, value);
  }
};

}  // namespace hal::stm32f405
