#pragma once

#include <cstdint>

/// RM0090, 32.9.
namespace machine::can_registers {

constexpr std::uint32_t kMaster = 0x00, kMasterStatus = 0x04, kTransmitStatus = 0x08;
constexpr std::uint32_t kFifo0 = 0x0C, kFifo1 = 0x10, kInterrupts = 0x14, kErrors = 0x18;
constexpr std::uint32_t kTiming = 0x1C, kMailboxWords = 0x180, kMailWords = 0x1B0,
                        kMailWordsEnd = 0x1D0;
constexpr std::uint32_t kFilters = 0x200;

// MCR
constexpr std::uint32_t kInitialise = 1U << 0U, kSleepRequest = 1U << 1U, kByTime = 1U << 2U;
constexpr std::uint32_t kLockFifos = 1U << 3U, kOnce = 1U << 4U, kRecoverAlone = 1U << 6U;
constexpr std::uint32_t kMasterReset = 1U << 15U;
// TSR, bits of mailbox 0: those of mailboxes 1 and 2 are 8 and 16 bits higher.
constexpr std::uint32_t kDone = 1, kGood = 2, kLost = 4, kFailed = 8, kAbort = 0x80;
// RFR
constexpr std::uint32_t kFull = 1U << 3U, kOverrun = 1U << 4U, kRelease = 1U << 5U;
// ESR
constexpr std::uint32_t kWarning = 1, kPassive = 2, kBusOff = 4;
// LEC
constexpr std::uint32_t kStuffError = 1, kAcknowledgeError = 3, kRecessiveError = 4;
// IER
constexpr std::uint32_t kEmptyInterrupt = 1, kCodeInterrupt = 1U << 11U, kErrorsOn = 1U << 15U;
// BTR
constexpr std::uint32_t kLoop = 1U << 30U, kSilent = 1U << 31U;

}  // namespace machine::can_registers
