#pragma once

#include <cstdint>

#include "hal/stm32f405/bus.hpp"

namespace hal::stm32f405 {

enum class Fault : std::uint8_t {
  kNone,
  kException,
  kContract,
  kSupply,
  kCrystal,
  kStack,
  kBeam,           ///< The beam was on while nothing moved.
  kConfiguration,  ///< A bit flipped in values that are computed from settings.
  kImage,          ///< A bit flipped in the image in the flash.
};

/// Record of a fault that stopped the program. It is in memory that start-up does not clear, so
/// that the next start can report it.
struct FaultRecord {
  static constexpr std::uint32_t kValid = 0x4661'756C;

  std::uint32_t mark;
  Fault fault;
  std::uint8_t exception;  ///< Number of the core's exception; 0 if the fault was no exception.
  /// Address in the program, 0 if unknown. For kBeam: StepTimer::ticks_left() at the fault.
  std::uint32_t place;
};

enum class ResetCause : std::uint8_t {
  kUnknown,
  kPowerOn,
  kPin,
  kSoftware,
  kBrownOut,
  kWatchdog,
  kFault,
};

/// Returns the cause that the chip's flags show. One reset sets several flags: power-on also sets
/// the brown-out flag, and every reset sets the pin flag. So the most specific flag is checked
/// first.
constexpr ResetCause cause_of(Word flags, bool fault_recorded) {
  if (fault_recorded) return ResetCause::kFault;
  if ((flags & rcc::kPowerOnReset) != 0) return ResetCause::kPowerOn;
  if ((flags & (rcc::kWatchdogReset | rcc::kWindowReset)) != 0) return ResetCause::kWatchdog;
  if ((flags & rcc::kSoftwareReset) != 0) return ResetCause::kSoftware;
  if ((flags & rcc::kBrownOutReset) != 0) return ResetCause::kBrownOut;
  if ((flags & rcc::kPinReset) != 0) return ResetCause::kPin;
  return ResetCause::kUnknown;
}

constexpr const char* text_of(ResetCause cause) {
  switch (cause) {
    case ResetCause::kPowerOn:
      return "power on";
    case ResetCause::kPin:
      return "reset button";
    case ResetCause::kSoftware:
      return "software";
    case ResetCause::kBrownOut:
      return "supply too low";
    case ResetCause::kWatchdog:
      return "watchdog";
    case ResetCause::kFault:
      return "fault";
    case ResetCause::kUnknown:
      break;
  }
  return "unknown";
}

constexpr const char* text_of(Fault fault) {
  switch (fault) {
    case Fault::kException:
      return "exception";
    case Fault::kContract:
      return "broken contract";
    case Fault::kSupply:
      return "supply too low";
    case Fault::kCrystal:
      return "the crystal stopped";
    case Fault::kStack:
      return "stack overflow";
    case Fault::kBeam:
      return "the beam was on at rest";
    case Fault::kConfiguration:
      return "the settings changed in memory";
    case Fault::kImage:
      return "the image changed in flash";
    case Fault::kNone:
      break;
  }
  return "none";
}

/// Reads the reset flags and clears them for the next reset. Called once.
template <RegisterBus Bus>
[[nodiscard]] ResetCause take_reset_cause(bool fault_recorded) noexcept {
  const Word flags = Bus::read(rcc::kCsr);
  set<Bus>(rcc::kCsr, rcc::kForgetResets);
  return cause_of(flags, fault_recorded);
}

}  // namespace hal::stm32f405
