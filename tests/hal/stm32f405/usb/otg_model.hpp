#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "tests/hal/stm32f405/chip_model.hpp"

namespace hal::stm32f405 {

/// Model of the full-speed core by the reference manual, independent of the driver: its registers
/// on one side, the wire on the other. A transaction is one call. Actions that the manual forbids
/// are recorded in `misuse`.
///
/// Not modelled: DMA, isochronous transfers, host mode, times.
class OtgModel {
 public:
  using Bytes = std::vector<std::uint8_t>;
  enum class Shake { kAck, kNak, kStall, kSilence };
  struct Fetched {
    Shake shake = Shake::kSilence;
    bool data1 = false;
    Bytes bytes{};
  };

  // Inputs that the test sets.
  bool answers = true;    ///< If false, the core never becomes idle, as without its clock.
  int looks_as_host = 0;  ///< Number of reads that still show host mode.
  std::vector<std::string> misuse;

  // Interface to the driver.
  [[nodiscard]] static bool has(std::uint32_t address) { return address >> 18 == 0x1400; }
  std::uint32_t read(std::uint32_t address);
  void write(std::uint32_t address, std::uint32_t value);
  [[nodiscard]] bool interrupts() const;

  // Interface to the wire.
  [[nodiscard]] bool attached() const;
  void bus_reset();
  void suspend();
  void resume();
  Shake set_up(unsigned address, const std::array<std::uint8_t, 8>& request);
  Shake out(unsigned address, unsigned endpoint, bool data1, const Bytes& bytes);
  /// @param acknowledged false if the host's acknowledgement is lost or missing
  Fetched in(unsigned address, unsigned endpoint, bool acknowledged);

 private:
  static constexpr unsigned kEndpoints = 4;
  struct Endpoint {
    std::uint32_t control = 0;
    std::uint32_t status = 0;
    std::uint32_t size = 0;
    bool data1 = false;
    std::deque<std::uint32_t> fifo{};  ///< Words that wait to be sent.
  };
  struct Entry {
    std::uint32_t status = 0;
    std::vector<std::uint32_t> words{};
  };

  void blame(const std::string& what) { misuse.push_back(what); }
  void look_at_clock();
  [[nodiscard]] std::uint32_t* cell(std::uint32_t offset);
  std::uint32_t pop_word();
  [[nodiscard]] std::uint32_t read_endpoint(std::uint32_t offset) const;
  void write_endpoint(std::uint32_t offset, std::uint32_t value);
  void write_resets(std::uint32_t value);
  void write_control(Endpoint& endpoint, std::uint32_t value, bool in, unsigned number);
  void push(unsigned number, std::uint32_t word);
  std::uint32_t pop_entry();
  void enter(unsigned kind, unsigned endpoint, const Bytes& bytes);
  void end_set_up();
  [[nodiscard]] bool hears(unsigned address) const;
  [[nodiscard]] std::size_t memory_used() const;
  [[nodiscard]] std::size_t fifo_depth(unsigned number) const;
  [[nodiscard]] std::uint32_t endpoint_flags() const;
  [[nodiscard]] std::uint32_t status_word() const;
  static std::uint32_t max_bytes(const Endpoint& endpoint, unsigned number);

  std::uint32_t ahb_ = 0, usb_ = 0, latched_ = 0, mask_ = 0, general_ = 0, power_ = 0;
  std::uint32_t receive_words_ = 0x200, device_ = 0, device_control_ = 0;
  std::uint32_t in_mask_ = 0, out_mask_ = 0, endpoints_mask_ = 0;
  std::array<std::uint32_t, kEndpoints> memory_{};
  std::array<Endpoint, kEndpoints> in_{};
  std::array<Endpoint, kEndpoints> out_{};
  std::deque<Entry> entries_;
  std::deque<std::uint32_t> current_;  ///< Remaining words of the last popped entry.
  /// Whether the end of the SETUP stage is still to be recorded, with the next token.
  bool set_up_ends_ = false;
  bool suspended_ = false;
  unsigned address_ = 0;  ///< Address to which the core responds now.
};

/// The bus to the only chip, including its USB core.
struct UsbBus {
  static OtgModel& core() {
    static OtgModel model;
    return model;
  }
  static void barrier() noexcept {}
  static Word read(Address address) noexcept {
    return OtgModel::has(address) ? core().read(address) : ModelBus::read(address);
  }
  static void write(Address address, Word value) noexcept {
    OtgModel::has(address) ? core().write(address, value) : ModelBus::write(address, value);
  }
};

}  // namespace hal::stm32f405
