#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/stm32f405/registers.hpp"

/// Registers of the full-speed USB core in device mode (RM0090 rev. 19, chapter 34).
namespace hal::stm32f405::otg {

inline constexpr Address kBase = 0x5000'0000;
inline constexpr unsigned kInterrupt = 67;
inline constexpr Word kClock = bit(7);  ///< Bit of rcc::kAhb2Enr.

// Global registers.
inline constexpr Address kAhbConfig = kBase + 0x008;
inline constexpr Address kUsbConfig = kBase + 0x00C;
inline constexpr Address kResets = kBase + 0x010;
inline constexpr Address kStatus = kBase + 0x014;
inline constexpr Address kMask = kBase + 0x018;
inline constexpr Address kReceivedPop = kBase + 0x020;
/// Register with the size of the receive FIFO, in words, like all FIFO sizes.
inline constexpr Address kReceiveSize = kBase + 0x024;
inline constexpr Address kGeneral = kBase + 0x038;
/// Returns the address of the register that places the FIFO of an IN endpoint: start in the lower
/// half, size in the upper half.
constexpr Address transmit_size(unsigned endpoint) {
  return kBase + (endpoint == 0 ? 0x028 : 0x100 + 4 * endpoint);
}

// Device registers.
inline constexpr Address kDeviceConfig = kBase + 0x800;
inline constexpr Address kDeviceControl = kBase + 0x804;
inline constexpr Address kInMask = kBase + 0x810;
inline constexpr Address kOutMask = kBase + 0x814;
/// Register of the endpoints' interrupts: bits from 0 on for IN endpoints, from 16 on for OUT
/// endpoints.
inline constexpr Address kEndpoints = kBase + 0x818;
inline constexpr Address kEndpointsMask = kBase + 0x81C;
constexpr Address in_control(unsigned endpoint) { return kBase + 0x900 + 0x20 * endpoint; }
constexpr Address in_status(unsigned endpoint) { return kBase + 0x908 + 0x20 * endpoint; }
constexpr Address in_size(unsigned endpoint) { return kBase + 0x910 + 0x20 * endpoint; }
constexpr Address out_control(unsigned endpoint) { return kBase + 0xB00 + 0x20 * endpoint; }
constexpr Address out_status(unsigned endpoint) { return kBase + 0xB08 + 0x20 * endpoint; }
constexpr Address out_size(unsigned endpoint) { return kBase + 0xB10 + 0x20 * endpoint; }
inline constexpr Address kPowerAndClock = kBase + 0xE00;
/// Returns the address of an endpoint's FIFO. A write appends a word to the endpoint's next packet.
/// A read of FIFO 0 takes the oldest received word.
constexpr Address fifo(unsigned endpoint) { return kBase + 0x1000 * (endpoint + 1); }
inline constexpr unsigned kFifoWords = 320;

// Bits of kAhbConfig.
inline constexpr Word kInterruptOn = bit(0);
// Bits of kUsbConfig.
inline constexpr Word kPhysical = bit(6);
/// Turnaround time for a bus clock of 32 MHz or more, table 202.
inline constexpr Word kTurnaround = 6 << 10;
inline constexpr Word kForceDevice = bit(30);
// Bits of kResets.
inline constexpr Word kCoreReset = bit(0);
inline constexpr Word kFlushReceived = bit(4);
inline constexpr Word kFlushToSend = bit(5);
inline constexpr Word kAllToSend = 0x10 << 6;
constexpr Word to_send_of(unsigned endpoint) { return endpoint << 6; }
inline constexpr Word kBusIdle = bit(31);
// Bits of kStatus and kMask.
inline constexpr Word kHostMode = bit(0);
inline constexpr Word kReceived = bit(4);
inline constexpr Word kSuspended = bit(11);
inline constexpr Word kBusReset = bit(12);
inline constexpr Word kSpeedKnown = bit(13);
inline constexpr Word kInEndpoints = bit(18);
inline constexpr Word kOutEndpoints = bit(19);
inline constexpr Word kWakeUp = bit(31);
// Fields of kReceivedPop.
enum class Received : std::uint8_t { kOut = 2, kOutDone = 3, kSetUpDone = 4, kSetUp = 6 };
constexpr unsigned endpoint_in(Word entry) { return entry & 0xFU; }
constexpr std::size_t bytes_in(Word entry) { return entry >> 4 & 0x7FFU; }
constexpr Received kind_in(Word entry) { return static_cast<Received>(entry >> 17 & 0xFU); }
// Bits of kGeneral.
inline constexpr Word kTransceiverOn = bit(16);
inline constexpr Word kNoVbusSensing = bit(21);
// Bits of kDeviceConfig.
inline constexpr Word kFullSpeed = 3;
inline constexpr Word kAssignedMask = 0x7F << 4;
// Bits of kDeviceControl.
inline constexpr Word kDisconnect = bit(1);
// Bits of in_control and out_control.
inline constexpr Word kActive = bit(15);
inline constexpr Word kStall = bit(21);
inline constexpr Word kClearNak = bit(26);
inline constexpr Word kSetNak = bit(27);
inline constexpr Word kFirstIsData0 = bit(28);
inline constexpr Word kDisable = bit(30);
inline constexpr Word kEnable = bit(31);
inline constexpr Word kBulk = 2 << 18;
inline constexpr Word kByInterrupt = 3 << 18;
constexpr Word fifo_number(unsigned endpoint) { return endpoint << 22; }
// Bits of in_status, out_status and their masks.
inline constexpr Word kDone = bit(0);
inline constexpr Word kDisabled = bit(1);
inline constexpr Word kNakEffective = bit(6);  ///< Exists only for IN endpoints.
// Bits of in_size and out_size.
inline constexpr Word kOnePacket = bit(19);
inline constexpr Word kThreeSetUps = 3 << 29;

static_assert(transmit_size(1) == 0x5000'0104 && transmit_size(3) == 0x5000'010C);
static_assert(in_control(2) == 0x5000'0940 && out_size(1) == 0x5000'0B30);
static_assert(fifo(0) == 0x5000'1000 && fifo(2) == 0x5000'3000);

}  // namespace hal::stm32f405::otg
