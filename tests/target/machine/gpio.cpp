#include "tests/target/machine/gpio.hpp"

namespace machine {
namespace {

// Offsets of the registers.
constexpr std::uint32_t kMode = 0x00, kOutputType = 0x04, kSpeed = 0x08, kPull = 0x0C;
constexpr std::uint32_t kInput = 0x10, kOutput = 0x14, kSetReset = 0x18, kLast = 0x24;
constexpr std::uint32_t kPullUp = 1;

constexpr std::array<const char*, 9> kNames = {
    "GPIOA", "GPIOB", "GPIOC", "GPIOD", "GPIOE", "GPIOF", "GPIOG", "GPIOH", "GPIOI"};

unsigned number_of(char letter) { return static_cast<unsigned>(letter - 'A'); }

}  // namespace

Gpio::Gpio(const Services& services, char letter)
    : Peripheral{services,
                 {kNames[number_of(letter)],
                  0x4002'0000U + 0x400U * number_of(letter),
                  {Bus::kAhb1, number_of(letter)}}},
      letter_{letter},
      name_{'P', letter} {
  drives_.fill('z');
  wires_.fill(Wire::kFree);
}

void Gpio::reset() {
  registers_.fill(0);
  // The debug pins of ports A and B have other values after reset (RM0090, 8.4.1 to 8.4.4).
  if (letter_ == 'A') {
    registers_[kMode / 4] = 0xA800'0000;
    registers_[kPull / 4] = 0x6400'0000;
  } else if (letter_ == 'B') {
    registers_[kMode / 4] = 0x0000'0280;
    registers_[kSpeed / 4] = 0x0000'00C0;
    registers_[kPull / 4] = 0x0000'0100;
  }
  follow();
}

char Gpio::drive(unsigned pin) const {
  constexpr std::uint32_t kAsOutput = 1, kAsFunction = 2;
  const std::uint32_t mode = field(at(kMode), 2 * pin, 2);
  if (mode == kAsFunction) return 'f';
  if (mode != kAsOutput) return 'z';
  if (field(at(kOutput), pin, 1) == 0) return '0';
  return field(at(kOutputType), pin, 1) != 0 ? 'z' : '1';
}

void Gpio::follow() {
  for (unsigned pin = 0; pin < kPins; ++pin) {
    const char now = drive(pin);
    if (now == drives_[pin]) continue;
    drives_[pin] = now;
    trace().driven("pin", "{}{} {}", name_, pin, now);
  }
  if (changed_) changed_();
}

void Gpio::connect(unsigned pin, Wire wire) {
  wires_[pin] = wire;
  if (changed_) changed_();
}

std::uint32_t Gpio::levels() const {
  std::uint32_t word = 0;
  for (unsigned pin = 0; pin < kPins; ++pin) {
    bool high = wires_[pin] == Wire::kHigh;
    if (wires_[pin] == Wire::kFree) high = field(at(kPull), 2 * pin, 2) == kPullUp;
    if (drives_[pin] == '0' || drives_[pin] == '1') high = drives_[pin] == '1';
    word |= (high ? 1U : 0U) << pin;
  }
  return word;
}

std::uint32_t Gpio::read(std::uint32_t offset) {
  if (offset == kInput) return levels();
  return offset <= kLast && offset != kSetReset ? at(offset) : 0;
}

void Gpio::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kSetReset) {
    const std::uint32_t set = value & 0xFFFFU;  // Setting a bit takes precedence over resetting it.
    registers_[kOutput / 4] = (at(kOutput) & ~(value >> 16U)) | set;
  } else if (offset == kInput || offset > kLast) {
    return;
  } else {
    registers_[offset / 4] = offset == kOutput ? value & 0xFFFFU : value;
  }
  if (offset <= kSetReset) follow();
}

}  // namespace machine
