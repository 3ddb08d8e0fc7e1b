#include "tests/target/machine/usart.hpp"

#include <algorithm>

namespace machine {
namespace {

// Offsets of the registers.
constexpr std::uint32_t kStatus = 0x00, kData = 0x04, kRate = 0x08, kControl1 = 0x0C;
constexpr std::uint32_t kControl2 = 0x10, kControl3 = 0x14;
// SR
constexpr std::uint32_t kFramingError = 1U << 1U, kOverrun = 1U << 3U, kIdle = 1U << 4U;
constexpr std::uint32_t kReceived = 1U << 5U, kComplete = 1U << 6U, kEmpty = 1U << 7U;
constexpr std::uint32_t kClearedByReading = 0x1F;
// CR1
constexpr std::uint32_t kReceiver = 1U << 2U, kTransmitter = 1U << 3U, kEnabled = 1U << 13U;
constexpr std::uint32_t kBreakAndParity = 0x0F03, kNineBits = 1U << 12U, kBy8 = 1U << 15U;

constexpr std::uint32_t kUsual_baud = 115'200;  // Baud rate of the sender while BRR is 0.

}  // namespace

Usart::Usart(const Services& services, const UsartKind& kind, const SerialOptions& options)
    : Peripheral{services, kind.place},
      kind_{kind},
      line_baud_{options.baud},
      answer_baud_{options.answer_baud},
      line_from_ns_{options.from_ns},
      peer_{options},
      line_{services.interrupts, kind.interrupt},
      receive_{[this] { take_byte(); }},
      idle_{[this] {
        status_ |= kIdle;
        settle();
      }},
      transmit_{[this] { shifted(); }} {
  peer_.on_more([this] { await_byte(); });
}

void Usart::reset() {
  transmit_.cancel();
  idle_.cancel();
  status_ = kComplete | kEmpty;
  rate_ = control1_ = control2_ = control3_ = 0;
  status_was_read_ = false;
  settle();
}

bool Usart::receives() const {
  return (control1_ & (kEnabled | kReceiver)) == (kEnabled | kReceiver);
}
bool Usart::transmits() const {
  return (control1_ & (kEnabled | kTransmitter)) == (kEnabled | kTransmitter);
}

std::uint32_t Usart::baud() const {
  std::uint32_t clocks_per_bit = rate_;
  if ((control1_ & kBy8) != 0) clocks_per_bit = (rate_ >> 4U) * 8 + (rate_ & 7U);
  return clocks_per_bit == 0 ? 0 : clocks().bus_hz(kind_.bus) / clocks_per_bit;
}

std::uint32_t Usart::sender_baud() const {
  if (line_baud_ != 0) return line_baud_;
  return baud() != 0 ? baud() : kUsual_baud;
}

std::uint32_t Usart::transmitter_baud() const {
  if (answer_baud_ != 0) return answer_baud_;
  return baud() != 0 ? baud() : kUsual_baud;
}

std::int64_t Usart::byte_ns(std::uint32_t baud) const {
  // Length in half bits: start, data, and 1, 0.5, 2 or 1.5 stop bits.
  constexpr std::array<std::uint32_t, 4> kStops = {2, 1, 4, 3};
  const std::uint32_t halves =
      2 + ((control1_ & kNineBits) != 0 ? 18 : 16) + kStops[field(control2_, 12, 2)];
  return std::int64_t{halves} * kSecond_ns / (2 * std::int64_t{baud});
}

void Usart::await_byte() {
  if (!line_runs_ || receive_.is_set() || !peer_.has_byte()) return;
  idle_.cancel();
  receive_.set(std::max(now_ns(), line_from_ns_) + byte_ns(sender_baud()));
}

void Usart::take_byte() {
  const std::uint8_t byte = peer_.send().value_or(0);
  if (receives()) {
    const std::int64_t off = std::int64_t{sender_baud()} - baud();
    const bool framed = (off < 0 ? -off : off) * 25 <= sender_baud();
    trace().event(place().name, "rx {:02x}", byte);
    if ((status_ & kReceived) != 0) {
      status_ |= kOverrun;
      trace().event(place().name, "overrun");
    } else {
      received_ = framed ? byte : static_cast<std::uint8_t>(~byte);
      status_ |= kReceived | (framed ? 0 : kFramingError);
    }
    settle();
  }
  await_byte();
  if (!receive_.is_set() && receives()) idle_.set(now_ns() + byte_ns(sender_baud()));
}

void Usart::shift(std::uint8_t byte) {
  shifting_ = byte;
  status_ &= ~kComplete;
  transmit_.set(now_ns() + byte_ns(transmitter_baud()));
}

void Usart::shifted() {
  trace().event(place().name, "tx {:02x}", shifting_);
  peer_.hear(shifting_);
  if ((status_ & kEmpty) == 0) {
    status_ |= kEmpty;
    shift(waiting_);
  } else {
    status_ |= kComplete;
  }
  settle();
}

std::uint32_t Usart::read_data() {
  status_ &= ~kReceived;
  if (status_was_read_) status_ &= ~kClearedByReading;
  status_was_read_ = false;
  return received_;
}

void Usart::write_data(std::uint8_t byte) {
  if (!transmits()) return trace().misuse(place().name, "DR without a transmitter");
  if (rate_ == 0) trace().misuse(place().name, "DR without a rate");
  if (status_was_read_) status_ &= ~kComplete;
  status_was_read_ = false;
  if (!transmit_.is_set()) return shift(byte);
  if ((status_ & kEmpty) == 0) trace().misuse(place().name, "DR while it is full");
  waiting_ = byte;
  status_ &= ~kEmpty;
}

std::uint32_t Usart::read(std::uint32_t offset) {
  std::uint32_t value = 0;
  switch (offset) {
    case kStatus:
      status_was_read_ = true;
      value = status_;
      break;
    case kData:
      value = read_data();
      break;
    case kRate:
      value = rate_;
      break;
    case kControl1:
      value = control1_;
      break;
    case kControl2:
      value = control2_;
      break;
    case kControl3:
      value = control3_;
      break;
    default:
      break;
  }
  settle();
  return value;
}

void Usart::write(std::uint32_t offset, std::uint32_t value) {
  constexpr std::uint32_t kStopBits = 0x3000, kErrorInterrupt = 1;
  if (offset == kStatus) status_ &= value | ~(kReceived | kComplete);
  if (offset == kData) write_data(static_cast<std::uint8_t>(value));
  if (offset == kRate) rate_ = value & 0xFFFFU;
  if (offset == kControl1) {
    not_modelled(offset, value & kBreakAndParity);
    control1_ = value & 0xBFFFU;
    line_runs_ = line_runs_ || (receives() && rate_ != 0);
    await_byte();
  }
  if (offset == kControl2) {
    not_modelled(offset, value & ~kStopBits);
    control2_ = value;
  }
  if (offset == kControl3) {
    not_modelled(offset, value & ~kErrorInterrupt);
    control3_ = value;
  }
  settle();
}

void Usart::settle() {
  const std::uint32_t receive_causes = (status_ & kOverrun) != 0 ? kReceived : 0;
  // The enable bits of IDLE, RXNE, TC and TXE have the same positions as their flags.
  constexpr std::uint32_t kEnables = kIdle | kReceived | kComplete | kEmpty;
  line_.set(((status_ | receive_causes) & control1_ & kEnables) != 0 &&
            (control1_ & kEnabled) != 0);
}

}  // namespace machine
