#pragma once

#include <array>
#include <cstdint>

#include "tests/target/machine/options.hpp"
#include "tests/target/machine/peripheral.hpp"
#include "tests/target/machine/serial_peer.hpp"

namespace machine {

struct UsartKind {
  Place place;
  Bus bus;
  unsigned interrupt;
};

/// Addresses, gates and interrupts of the USARTs (RM0090, table 1, 7.3.13, 7.3.14, table 61).
constexpr std::array<UsartKind, Options::kSerialPorts> kUsarts = {{
    {{"USART1", 0x4001'1000, {Bus::kApb2, 4}}, Bus::kApb2, 37},
    {{"USART2", 0x4000'4400, {Bus::kApb1, 17}}, Bus::kApb1, 38},
    {{"USART3", 0x4000'4800, {Bus::kApb1, 18}}, Bus::kApb1, 39},
    {{"UART4", 0x4000'4C00, {Bus::kApb1, 19}}, Bus::kApb1, 52},
    {{"UART5", 0x4000'5000, {Bus::kApb1, 20}}, Bus::kApb1, 53},
    {{"USART6", 0x4001'1400, {Bus::kApb2, 5}}, Bus::kApb2, 71},
}};

/// Model of an asynchronous receiver and transmitter (RM0090, 30). Bytes take the time by BRR, word
/// length and stop bits. A byte that arrives while RXNE is set is lost and sets ORE. IDLE is set
/// after one byte's time of silence, FE if the sender's rate is off by more than 4 %.
///
/// Not modelled but reported: parity, DMA, RTS and CTS, half duplex, synchronous modes, breaks.
class Usart final : public Peripheral {
 public:
  Usart(const Services& services, const UsartKind& kind, const SerialOptions& options);

  void reset() override;
  void flush() const { peer_.flush(); }

 private:
  [[nodiscard]] std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  [[nodiscard]] std::uint32_t read_data();
  void write_data(std::uint8_t byte);
  [[nodiscard]] bool receives() const;
  [[nodiscard]] bool transmits() const;
  [[nodiscard]] std::uint32_t baud() const;
  [[nodiscard]] std::int64_t byte_ns(std::uint32_t baud) const;
  [[nodiscard]] std::uint32_t sender_baud() const;
  [[nodiscard]] std::uint32_t transmitter_baud() const;
  void await_byte();
  void take_byte();
  void shift(std::uint8_t byte);
  void shifted();
  void settle();

  UsartKind kind_;
  std::uint32_t line_baud_;
  std::uint32_t answer_baud_;
  std::int64_t line_from_ns_;
  SerialPeer peer_;
  InterruptLine line_;
  Alarm receive_, idle_, transmit_;
  // Whether the sender has begun, which it does when it first finds a receiver.
  bool line_runs_ = false;
  std::uint32_t status_ = 0, rate_ = 0, control1_ = 0, control2_ = 0, control3_ = 0;
  bool status_was_read_ = false;
  std::uint8_t received_ = 0, waiting_ = 0, shifting_ = 0;
};

}  // namespace machine
