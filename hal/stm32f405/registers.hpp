#pragma once

#include <cstdint>

/// Addresses and bits of the STM32F405 (ST, RM0090 rev. 19) and of its core (Arm, DDI 0403E) that
/// this port uses.
namespace hal::stm32f405 {

using Address = std::uint32_t;
using Word = std::uint32_t;

constexpr Word bit(unsigned place) { return Word{1} << place; }

/// Reset and clock control, RM0090 chapter 7.
namespace rcc {
inline constexpr Address kBase = 0x4002'3800;
inline constexpr Address kCr = kBase + 0x00;
inline constexpr Address kPllCfgr = kBase + 0x04;
inline constexpr Address kCfgr = kBase + 0x08;
inline constexpr Address kAhb1Reset = kBase + 0x10;
inline constexpr Address kAhb2Reset = kBase + 0x14;
inline constexpr Address kApb1Reset = kBase + 0x20;
inline constexpr Address kApb2Reset = kBase + 0x24;
inline constexpr Address kAhb1Enr = kBase + 0x30;
inline constexpr Address kAhb2Enr = kBase + 0x34;
inline constexpr Address kApb1Enr = kBase + 0x40;
inline constexpr Address kApb2Enr = kBase + 0x44;
inline constexpr Address kCsr = kBase + 0x74;

inline constexpr Word kHsiOn = bit(0);
inline constexpr Word kHsiReady = bit(1);
inline constexpr Word kHseOn = bit(16);
inline constexpr Word kHseReady = bit(17);
inline constexpr Word kSecurityOn = bit(19);  ///< Raises an NMI if the crystal stops.
inline constexpr Word kPllOn = bit(24);
inline constexpr Word kPllReady = bit(25);
inline constexpr Word kPllFromHse = bit(22);
inline constexpr Word kSwitchMask = 3;
inline constexpr Word kSwitchToPll = 2;
inline constexpr Word kSwitchedMask = 3 << 2;
inline constexpr Word kSwitchedToPll = 2 << 2;
inline constexpr Word kApb1By4 = 5 << 10;
inline constexpr Word kApb2By2 = 4 << 13;
inline constexpr Word kPowerClock = bit(28);   ///< Bit of kApb1Enr.
inline constexpr Word kSystemClock = bit(14);  ///< Bit of kApb2Enr.

inline constexpr Word kForgetResets = bit(24);
inline constexpr Word kBrownOutReset = bit(25);
inline constexpr Word kPinReset = bit(26);
inline constexpr Word kPowerOnReset = bit(27);
inline constexpr Word kSoftwareReset = bit(28);
inline constexpr Word kWatchdogReset = bit(29);
inline constexpr Word kWindowReset = bit(30);
inline constexpr Word kLowPowerReset = bit(31);
}  // namespace rcc

/// Power control, chapter 5. The supply supervisor raises external interrupt line 16.
namespace pwr {
inline constexpr Address kCr = 0x4000'7000;
inline constexpr Word kHighestScale = bit(14);
inline constexpr Word kSupervisorOn = bit(4);
inline constexpr Word kSupervisor2900mV = 7 << 5;
inline constexpr Address kCsr = kCr + 0x04;
/// The supply is below the supervisor's level; valid if the supervisor is on.
inline constexpr Word kSupplyIsLow = bit(2);
}  // namespace pwr

/// External interrupts, chapter 12.
namespace exti {
inline constexpr Address kBase = 0x4001'3C00;
inline constexpr Address kMask = kBase + 0x00;
inline constexpr Address kRising = kBase + 0x08;
inline constexpr Word kSupplyLine = bit(16);
}  // namespace exti

/// Flash interface, chapter 3.
namespace flash {
inline constexpr Address kBase = 0x4002'3C00;
inline constexpr Address kAcr = kBase + 0x00;
inline constexpr Address kKey = kBase + 0x04;
inline constexpr Address kStatus = kBase + 0x0C;
inline constexpr Address kControl = kBase + 0x10;
inline constexpr Address kOptions = kBase + 0x14;
/// Position of the two bits of the brown-out level; 3 is the lowest level.
inline constexpr unsigned kBrownOutShift = 2;
inline constexpr Address kMemory = 0x0800'0000;

inline constexpr Word kFirstKey = 0x4567'0123;
inline constexpr Word kSecondKey = 0xCDEF'89AB;
/// Setting for 150 to 168 MHz at 2.7 to 3.6 V, table 10.
inline constexpr Word kFiveWaitStates = 5;
inline constexpr Word kPrefetch = bit(8);
inline constexpr Word kInstructionCache = bit(9);
inline constexpr Word kDataCache = bit(10);
inline constexpr Word kDataCacheReset = bit(12);
inline constexpr Word kBusy = bit(16);
inline constexpr Word kErrors = 0xF2;  ///< Error flags; writing 1 to a flag clears it.
inline constexpr Word kProgram = bit(0);
inline constexpr Word kEraseSector = bit(1);
inline constexpr Word kBy32 = 2 << 8;
inline constexpr Word kStart = bit(16);
inline constexpr Word kLock = bit(31);
constexpr Word number_of_sector(unsigned sector) { return sector << 3; }
}  // namespace flash

/// System configuration, chapter 9: selects the memory mapped to address 0.
namespace syscfg {
inline constexpr Address kRemap = 0x4001'3800;
inline constexpr Word kSystemMemory = 1;
}  // namespace syscfg

/// General-purpose pins, chapter 8. Port 0 is port A.
namespace gpio {
inline constexpr unsigned kPorts = 9;
constexpr Address base(unsigned port) { return 0x4002'0000 + 0x400 * port; }
constexpr Address mode(unsigned port) { return base(port) + 0x00; }
constexpr Address speed(unsigned port) { return base(port) + 0x08; }
constexpr Address pull(unsigned port) { return base(port) + 0x0C; }
constexpr Address input(unsigned port) { return base(port) + 0x10; }
/// Returns the register whose bits 0 to 15 set a pin and whose bits 16 to 31 reset it. One store
/// changes several pins, so no interrupt can come in between.
constexpr Address set_reset(unsigned port) { return base(port) + 0x18; }
constexpr Address alternate(unsigned port, unsigned pin) {
  return base(port) + (pin < 8 ? 0x20 : 0x24);
}
}  // namespace gpio

/// Timers, chapters 17 and 18: offsets from a timer's base.
namespace timer {
inline constexpr Address kTim1 = 0x4001'0000;
inline constexpr Address kTim2 = 0x4000'0000;
inline constexpr Address kTim3 = 0x4000'0400;
inline constexpr Address kTim4 = 0x4000'0800;
inline constexpr Address kCr1 = 0x00;
inline constexpr Address kInterrupts = 0x0C;
inline constexpr Address kStatus = 0x10;
inline constexpr Address kEvents = 0x14;
inline constexpr Address kCounter = 0x24;
inline constexpr Address kPrescaler = 0x28;
inline constexpr Address kReload = 0x2C;
inline constexpr Address kBreak = 0x44;  ///< Exists only in TIM1.
constexpr Address compare_mode(unsigned channel) { return channel < 3 ? 0x18 : 0x1C; }
inline constexpr Address kCompareEnable = 0x20;
constexpr Address compare(unsigned channel) { return 0x34 + 4 * (channel - 1); }

inline constexpr Word kCounterOn = bit(0);
inline constexpr Word kReloadPreload = bit(7);
inline constexpr Word kUpdate = bit(0);
inline constexpr Word kCompare1 = bit(1);
inline constexpr Word kCompare2 = bit(2);
inline constexpr Word kMainOutput = bit(15);
/// Returns the bits of PWM mode 1 with preload: the output is high while the counter is below the
/// compare value.
constexpr Word pwm_mode(unsigned channel) { return Word{0x68} << (8 * ((channel - 1) % 2)); }
constexpr Word output_on(unsigned channel) { return bit(4 * (channel - 1)); }
}  // namespace timer

/// Serial interfaces, chapter 30: offsets from an interface's base.
namespace usart {
inline constexpr Address kStatus = 0x00;
inline constexpr Address kData = 0x04;
inline constexpr Address kBaudRate = 0x08;
inline constexpr Address kCr1 = 0x0C;

inline constexpr Word kDamaged = 0x0F;  ///< Parity, framing, noise and overrun errors.
inline constexpr Word kReceived = bit(5);
inline constexpr Word kRoomToSend = bit(7);
inline constexpr Word kReceiver = bit(2);
inline constexpr Word kTransmitter = bit(3);
inline constexpr Word kReceivedInterrupt = bit(5);
inline constexpr Word kRoomInterrupt = bit(7);
inline constexpr Word kOn = bit(13);
}  // namespace usart

/// Independent watchdog, chapter 21. Its clock has nominally 32 kHz, but 17 to 47 kHz over all
/// chips and temperatures.
namespace watchdog {
inline constexpr Address kBase = 0x4000'3000;
inline constexpr Address kKey = kBase + 0x00;
inline constexpr Address kPrescaler = kBase + 0x04;
inline constexpr Address kReload = kBase + 0x08;
inline constexpr Address kStatus = kBase + 0x0C;
inline constexpr Word kFeed = 0xAAAA;
inline constexpr Word kAllowChange = 0x5555;
inline constexpr Word kBegin = 0xCCCC;
}  // namespace watchdog

/// Identification of the chip, chapters 38 and 39.
inline constexpr Address kDeviceCode = 0xE004'2000;
inline constexpr Address kUniqueId = 0x1FFF'7A10;
/// Address of the flash size in KiB, in the upper half of the word.
inline constexpr Address kFlashSize = 0x1FFF'7A20;
inline constexpr Address kSystemMemory = 0x1FFF'0000;  ///< Address of ST's boot loader, table 3.

/// Registers of the core: system control, system timer, interrupts, memory protection.
namespace core {
inline constexpr Address kTickControl = 0xE000'E010;
inline constexpr Address kTickReload = 0xE000'E014;
inline constexpr Address kTickValue = 0xE000'E018;
constexpr Address interrupt_on(unsigned number) { return 0xE000'E100 + 4 * (number / 32); }
constexpr Address interrupt_off(unsigned number) { return 0xE000'E180 + 4 * (number / 32); }
constexpr Address interrupt_forget(unsigned number) { return 0xE000'E280 + 4 * (number / 32); }
constexpr Address interrupt_pend(unsigned number) { return 0xE000'E200 + 4 * (number / 32); }
constexpr Address interrupt_priority(unsigned number) { return 0xE000'E400 + number / 4 * 4; }
inline constexpr Address kVectors = 0xE000'ED08;
inline constexpr Address kResetControl = 0xE000'ED0C;
inline constexpr Address kTickPriority = 0xE000'ED20;
inline constexpr Address kFaultControl = 0xE000'ED24;
inline constexpr Address kCoprocessors = 0xE000'ED88;
inline constexpr Address kProtection = 0xE000'ED94;
inline constexpr Address kRegion = 0xE000'ED98;
inline constexpr Address kRegionBase = 0xE000'ED9C;
inline constexpr Address kRegionSize = 0xE000'EDA0;

inline constexpr Word kResetNow = 0x05FA'0004;
inline constexpr Word kFpuOn = 0xF << 20;
inline constexpr Word kFaultsOn = 7 << 16;  ///< Enables separate memory, bus and usage faults.
inline constexpr Word kTickOn = 7;          ///< Counts core clocks, with interrupts on.
}  // namespace core

/// Positions in the vector table after the core's sixteen entries, table 62.
namespace interrupt {
inline constexpr unsigned kSupply = 1;
inline constexpr unsigned kTim2 = 28;
inline constexpr unsigned kCount = 82;
}  // namespace interrupt

// Checks the composed addresses against the addresses in the manual's memory map.
static_assert(rcc::kCsr == 0x4002'3874 && rcc::kApb2Enr == 0x4002'3844);
static_assert(flash::kControl == 0x4002'3C10);
static_assert(gpio::set_reset(0) == 0x4002'0018 && gpio::input(2) == 0x4002'0810);
static_assert(gpio::base(8) == 0x4002'2000 && gpio::alternate(1, 9) == 0x4002'0424);
static_assert(timer::kTim3 + timer::compare(3) == 0x4000'043C);
static_assert(timer::kTim2 + timer::compare(1) == 0x4000'0034);
static_assert(timer::kTim1 + timer::compare_mode(4) == 0x4001'001C);
static_assert(timer::pwm_mode(1) == 0x0068 && timer::pwm_mode(4) == 0x6800);
static_assert(watchdog::kReload == 0x4000'3008 && exti::kRising == 0x4001'3C08);
static_assert(core::interrupt_on(37) == 0xE000'E104 && core::interrupt_priority(37) == 0xE000'E424);

}  // namespace hal::stm32f405
