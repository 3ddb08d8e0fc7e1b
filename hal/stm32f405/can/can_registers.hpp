#pragma once

#include <array>

#include "hal/stm32f405/registers.hpp"

/// Registers of CAN1 (RM0090 rev. 19, chapter 32).
namespace hal::stm32f405::bxcan {

inline constexpr Address kBase = 0x4000'6400;
inline constexpr Word kClock = bit(25);  ///< Bit of rcc::kApb1Enr.
inline constexpr unsigned kTransmitInterrupt = 19;
inline constexpr unsigned kFifo0Interrupt = 20;
inline constexpr unsigned kFifo1Interrupt = 21;
inline constexpr unsigned kStatusInterrupt = 22;
inline constexpr std::array kInterruptNumbers{
    kTransmitInterrupt, kFifo0Interrupt, kFifo1Interrupt, kStatusInterrupt};

inline constexpr Address kControl = kBase + 0x00;
inline constexpr Address kStatus = kBase + 0x04;
inline constexpr Address kTransmit = kBase + 0x08;
constexpr Address fifo(unsigned number) { return kBase + 0x0C + 4 * number; }
inline constexpr Address kInterrupts = kBase + 0x14;
inline constexpr Address kErrors = kBase + 0x18;
inline constexpr Address kTiming = kBase + 0x1C;
/// Returns the address of a mailbox. It has four words: identifier, length and two words of data.
constexpr Address mailbox(unsigned number) { return kBase + 0x180 + 0x10 * number; }
constexpr Address received(unsigned number) { return kBase + 0x1B0 + 0x10 * number; }
inline constexpr Address kFilterControl = kBase + 0x200;
inline constexpr Address kFilterLists = kBase + 0x204;
inline constexpr Address kFilterWide = kBase + 0x20C;
inline constexpr Address kFilterFifos = kBase + 0x214;
inline constexpr Address kFiltersOn = kBase + 0x21C;
constexpr Address filter(unsigned bank) { return kBase + 0x240 + 8 * bank; }
inline constexpr unsigned kMailboxes = 3;
inline constexpr unsigned kFifos = 2;
/// Number of filter banks of CAN1; the other 14 banks belong to CAN2.
inline constexpr unsigned kBanks = 14;

// Bits of kControl. The same bits of kStatus acknowledge the first two.
inline constexpr Word kInitialise = bit(0);
inline constexpr Word kSleep = bit(1);
/// Sends mailboxes in the order of filling, not of identifiers.
inline constexpr Word kInOrder = bit(2);
/// A full FIFO drops new frames instead of old frames.
inline constexpr Word kKeepOldest = bit(3);
inline constexpr Word kRecoverAlone = bit(6);
// Bits of kStatus.
inline constexpr Word kErrorAsked = bit(2);
// Bits of kTransmit.
constexpr Word empty(unsigned number) { return bit(26 + number); }
inline constexpr Word kRequestsDone = bit(0) | bit(8) | bit(16);
// Bits of fifo().
inline constexpr Word kPending = 3;
inline constexpr Word kOverrun = bit(4);
inline constexpr Word kRelease = bit(5);
// Bits of kInterrupts.
/// Interrupts of an empty mailbox, of frames in both FIFOs, of bus-off and of errors.
inline constexpr Word kAllInterrupts = bit(0) | bit(1) | bit(4) | bit(10) | bit(15);
// Bits of kErrors.
inline constexpr Word kWarning = bit(0);
inline constexpr Word kPassive = bit(1);
inline constexpr Word kBusOff = bit(2);
// Bits of kTiming.
inline constexpr Word kLoopBack = bit(30);
inline constexpr Word kSilent = bit(31);
// Bits of the identifier word of frames and filters.
inline constexpr Word kGo = bit(0);
inline constexpr Word kRemote = bit(1);
inline constexpr Word kExtended = bit(2);
// Values of kFilterControl.
inline constexpr Word kFiltersSetUp = 0x2A1C'0E01;
inline constexpr Word kFiltersUsed = 0x2A1C'0E00;

static_assert(mailbox(2) == 0x4000'65A0 && received(1) == 0x4000'65C0);
static_assert(filter(13) == 0x4000'66A8);

}  // namespace hal::stm32f405::bxcan
