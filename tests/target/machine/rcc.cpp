#include "tests/target/machine/rcc.hpp"

#include <limits>

namespace machine {
namespace {

// Offsets of the registers.
constexpr std::uint32_t kCr = 0x00, kPllCfgr = 0x04, kCfgr = 0x08, kFirstReset = 0x10;
constexpr std::uint32_t kLastReset = 0x24, kFirstEnable = 0x30, kAhb1Enable = 0x30;
constexpr std::uint32_t kApb1Enable = 0x40, kApb2Enable = 0x44, kCsr = 0x74, kLastRegister = 0x88;

constexpr std::uint32_t kInternal_hz = 16'000'000;
constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::max();
// Data sheet DS8626, 5.3.8 and 5.3.9: typical start times of a crystal, of HSI and of LSI; longest
// lock time of the PLL.
constexpr std::int64_t kCrystalStart_ns = 2'000'000;
constexpr std::int64_t kInternalStart_ns = 2'200;
constexpr std::int64_t kSlowStart_ns = 15'000;
constexpr std::int64_t kPllLock_ns = 200'000;
// DS8626, table 14.
constexpr std::uint32_t kMaxCore_hz = 168'000'000;
constexpr std::uint32_t kMaxApb1_hz = 42'000'000;
constexpr std::uint32_t kMaxApb2_hz = 84'000'000;

std::uint32_t enable_offset(Bus bus) {
  if (bus == Bus::kAhb1) return kAhb1Enable;
  return bus == Bus::kApb1 ? kApb1Enable : kApb2Enable;
}

}  // namespace

Rcc::Rcc(Trace& trace, Interrupts& interrupts, const Oscillators& oscillators)
    : Peripheral{{trace, interrupts, *this}, {"RCC", 0x4002'3800, {}}}, oscillators_{oscillators} {
  ready_at_ns_.fill(kNever);
}

void Rcc::reset() {
  registers_.fill(0);
  ready_at_ns_.fill(kNever);
  ready_at_ns_[kInternal] = 0;
  at(kCr) = 0x81;
  at(kPllCfgr) = 0x2400'3010;
  at(kAhb1Enable) = 0x0010'0000;
  update_core_clock();
}

bool Rcc::runs(Gate gate) const {
  return gate.bus == Bus::kAlways || field(at(enable_offset(gate.bus)), gate.bit, 1) != 0;
}

bool Rcc::ready(Oscillator oscillator) const { return ready_at_ns_[oscillator] <= now_ns(); }

void Rcc::turn(Oscillator oscillator, bool on, std::int64_t delay_ns) {
  if (!on) {
    ready_at_ns_[oscillator] = kNever;
  } else if (ready_at_ns_[oscillator] == kNever) {
    ready_at_ns_[oscillator] = now_ns() + delay_ns;
  }
}

std::uint64_t Rcc::pll_hz() const {
  const std::uint32_t plan = at(kPllCfgr);
  const std::uint64_t source_hz = field(plan, 22, 1) != 0 ? oscillators_.crystal_hz : kInternal_hz;
  const std::uint32_t m = field(plan, 0, 6), n = field(plan, 6, 9), p = 2 * field(plan, 16, 2) + 2;
  return m == 0 ? 0 : source_hz * n / m / p;
}

void Rcc::update_core_clock() {
  const std::uint32_t source = field(at(kCfgr), 2, 2);
  std::uint64_t system_hz = kInternal_hz;
  if (source == 1) system_hz = oscillators_.crystal_hz;
  if (source == 2) system_hz = pll_hz();
  const std::uint32_t code = field(at(kCfgr), 4, 4);
  // Codes 1000, 1001, … 1011 divide by 2, 4, … 16, and the following ones by 64, 128, 256, 512;
  // there is no 32.
  const unsigned shift = code < 8 ? 0 : code - 7 + (code >= 12 ? 1 : 0);
  core_hz_ = static_cast<std::uint32_t>(system_hz >> shift);
}

std::uint32_t Rcc::bus_divisor(Bus bus) const {
  if (bus != Bus::kApb1 && bus != Bus::kApb2) return 1;
  const std::uint32_t code = field(at(kCfgr), bus == Bus::kApb1 ? 10 : 13, 3);
  return code < 4 ? 1 : 2U << (code - 4);
}

std::uint32_t Rcc::bus_hz(Bus bus) const { return core_hz_ / bus_divisor(bus); }

std::uint32_t Rcc::timer_hz(Bus bus) const {
  return bus_divisor(bus) == 1 ? core_hz_ : 2 * bus_hz(bus);
}

void Rcc::check_limits() {
  if (core_hz_ > kMaxCore_hz) trace().misuse("RCC", "core at {} Hz", core_hz_);
  if (bus_hz(Bus::kApb1) > kMaxApb1_hz) trace().misuse("RCC", "APB1 above 42 MHz");
  if (bus_hz(Bus::kApb2) > kMaxApb2_hz) trace().misuse("RCC", "APB2 above 84 MHz");
}

std::uint32_t Rcc::read(std::uint32_t offset) {
  if (offset > kLastRegister) return 0;
  if (offset == kCr) {
    return at(kCr) | (ready(kInternal) ? 2U : 0U) | (ready(kExternal) ? 1U << 17U : 0U) |
           (ready(kPll) ? 1U << 25U : 0U);
  }
  if (offset == kCsr) return at(kCsr) | status_ | (ready(kSlow) ? 2U : 0U);
  return at(offset);
}

void Rcc::write(std::uint32_t offset, std::uint32_t value) {
  if (offset > kLastRegister) return;
  if (offset == kCr) {
    write_control(value);
  } else if (offset == kPllCfgr && field(at(kCr), 24, 1) != 0) {
    trace().misuse("RCC", "PLLCFGR while the PLL is on");
  } else if (offset == kCfgr) {
    write_configuration(value);
  } else if (offset == kCsr) {
    at(kCsr) = value & 1U;
    turn(kSlow, (value & 1U) != 0, kSlowStart_ns);
    if (field(value, 24, 1) != 0) status_ = 0;
  } else {
    if (offset == kFirstReset) reset_peripherals(Bus::kAhb1, value);
    if (offset == kFirstReset + 0x10) reset_peripherals(Bus::kApb1, value);
    if (offset == kLastReset) reset_peripherals(Bus::kApb2, value);
    at(offset) = value;
  }
}

void Rcc::write_control(std::uint32_t value) {
  const std::uint32_t source = field(at(kCfgr), 2, 2);
  constexpr std::array<std::uint32_t, 3> kSourceBit = {1U, 1U << 16U, 1U << 24U};
  if ((value & kSourceBit[source]) == 0) {
    trace().misuse("RCC", "the core's own clock is not turned off");
    value |= kSourceBit[source];
  }
  at(kCr) = value & 0x010D'00F9U;
  turn(kInternal, (value & 1U) != 0, kInternalStart_ns);
  turn(kExternal, field(value, 16, 1) != 0 && oscillators_.crystal_hz != 0, kCrystalStart_ns);
  const bool from_crystal = field(at(kPllCfgr), 22, 1) != 0;
  const bool fed = ready(from_crystal ? kExternal : kInternal) && pll_hz() != 0;
  const bool wanted = field(value, 24, 1) != 0;
  if (wanted && !fed) trace().misuse("RCC", "PLL on before what feeds it is ready");
  turn(kPll, wanted && fed, kPllLock_ns);
}

void Rcc::write_configuration(std::uint32_t value) {
  std::uint32_t source = field(value, 0, 2);
  constexpr std::array<Oscillator, 3> kSources = {kInternal, kExternal, kPll};
  if (source >= kSources.size() || !ready(kSources[source])) {
    trace().misuse("RCC", "switch to clock {}, which is not ready", source);
    source = field(at(kCfgr), 2, 2);
  }
  for (ClockFollower* follower : followers_) follower->before_clock_change();
  at(kCfgr) = (value & ~0xCU) | source << 2U;
  update_core_clock();
  for (ClockFollower* follower : followers_) follower->after_clock_change();
  check_limits();
}

void Rcc::reset_peripherals(Bus bus, std::uint32_t bits) {
  for (Peripheral* peripheral : peripherals_) {
    const Gate gate = peripheral->place().gate;
    if (gate.bus == bus && field(bits, gate.bit, 1) != 0) peripheral->reset();
  }
}

}  // namespace machine
