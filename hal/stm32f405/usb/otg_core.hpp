#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/stm32f405/bus.hpp"
#include "hal/stm32f405/usb/descriptors.hpp"
#include "hal/stm32f405/usb/otg_registers.hpp"

namespace hal::stm32f405::usb {

/// The full-speed core by its registers: a packet at a time, in and out, without
/// DMA. Keeps nothing itself. Its interrupt, and set_up() before that.
template <RegisterBus Bus>
class OtgCore {
 public:
  static constexpr Word kInterrupts = otg::kBusReset | otg::kSpeedKnown | otg::kReceived |
                                      otg::kInEndpoints | otg::kOutEndpoints | otg::kSuspended |
                                      otg::kWakeUp;

  /// Takes the core from reset to a device that shows itself to the host, with
  /// its clock at 48 MHz. False when it does not answer. Some 25 ms at most.
  ///
  /// VBUS is not sensed, since its pin, PA9, is a serial line's: a host that is
  /// not there is a bus that is suspended.
  [[nodiscard]] static bool set_up() noexcept {
    set<Bus>(rcc::kAhb2Enr, otg::kClock);
    static_cast<void>(Bus::read(rcc::kAhb2Enr));  // Two cycles for the clock, ES0182, 2.2.13.
    if (!wait_for<Bus>(otg::kResets, otg::kBusIdle, otg::kBusIdle, kLooks)) return false;
    Bus::write(otg::kUsbConfig, otg::kPhysical);
    Bus::write(otg::kResets, otg::kCoreReset);
    if (!wait_for<Bus>(otg::kResets, otg::kCoreReset, 0, kLooks)) return false;
    Bus::write(otg::kDeviceControl, otg::kDisconnect);
    Bus::write(otg::kUsbConfig, otg::kPhysical | otg::kForceDevice | otg::kTurnaround);
    if (!wait_for<Bus>(otg::kStatus, otg::kHostMode, 0, kModeLooks)) return false;
    Bus::write(otg::kPowerAndClock, 0);
    Bus::write(otg::kGeneral, otg::kTransceiverOn | otg::kNoVbusSensing);
    Bus::write(otg::kDeviceConfig, otg::kFullSpeed);
    share_memory();
    flush(otg::kFlushReceived);
    flush(otg::kFlushToSend | otg::kAllToSend);
    Bus::write(otg::kStatus, ~Word{0});
    Bus::write(otg::kMask, kInterrupts);
    Bus::write(otg::kInMask, otg::kDone);
    Bus::write(otg::kOutMask, otg::kDone);
    Bus::write(otg::kAhbConfig, otg::kInterruptOn);
    clear<Bus>(otg::kDeviceControl, otg::kDisconnect);
    return true;
  }

  /// The host has reset the bus: nothing but requests is heard, at address 0.
  static void begin_anew() noexcept {
    close_data();
    flush(otg::kFlushToSend | otg::kAllToSend);
    Bus::write(otg::kEndpointsMask, bit(0));
    set_address(0);
    Bus::write(otg::in_control(0), otg::kSetNak);
    allow_requests();
    for (const unsigned endpoint : {0U, kData}) {
      Bus::write(otg::in_status(endpoint), ~Word{0});
      Bus::write(otg::out_status(endpoint), ~Word{0});
    }
  }

  /// The core wants it before the host knows: it goes on with the old one until
  /// the request is over.
  static void set_address(std::uint8_t address) noexcept {
    modify<Bus>(otg::kDeviceConfig, otg::kAssignedMask, Word{address} << 4);
  }

  static void open_data() noexcept {
    Bus::write(otg::in_control(kData),
               kFromReset | otg::kBulk | otg::fifo_number(kData) | kPacketBytes);
    Bus::write(otg::out_control(kData), kFromReset | otg::kBulk | kPacketBytes);
    Bus::write(otg::in_control(kNews),
               kFromReset | otg::kByInterrupt | otg::fifo_number(kNews) | kNewsBytes);
    Bus::write(otg::kEndpointsMask, bit(0) | bit(kData) | bit(16 + kData));
  }

  static void close_data() noexcept {
    stop_sending(kData);
    for (const Address control :
         {otg::in_control(kData), otg::in_control(kNews), otg::out_control(kData)}) {
      Bus::write(control, otg::kSetNak);
    }
    Bus::write(otg::kEndpointsMask, bit(0));
  }

  /// Takes one packet; until then, and after it, the host is told to wait.
  static void allow_receiving(unsigned endpoint) noexcept {
    // One that a bus reset found open is still so, and its size must not change.
    const bool open = (Bus::read(otg::out_control(endpoint)) & otg::kEnable) != 0;
    const Word requests = endpoint == 0 ? otg::kThreeSetUps : 0;
    if (endpoint == 0 || !open) {
      Bus::write(otg::out_size(endpoint), requests | otg::kOnePacket | kPacketBytes);
    }
    set<Bus>(otg::out_control(endpoint), otg::kEnable | otg::kClearNak);
  }
  /// Requests are taken at any time; three of them may come in a row.
  static void allow_requests() noexcept { Bus::write(otg::out_size(0), kRequests); }

  /// Sends one packet. @pre none is on its way from this endpoint
  static void send(unsigned endpoint, std::span<const std::byte> packet) noexcept {
    Bus::write(otg::in_size(endpoint), otg::kOnePacket | static_cast<Word>(packet.size()));
    set<Bus>(otg::in_control(endpoint), otg::kEnable | otg::kClearNak);
    for (std::size_t at = 0; at < packet.size(); at += 4) {
      Word word = 0;
      for (unsigned byte = 0; byte < 4 && at + byte < packet.size(); ++byte) {
        word |= static_cast<Word>(packet[at + byte]) << (8 * byte);
      }
      Bus::write(otg::fifo(endpoint), word);
    }
  }

  /// Takes back a packet that the host has not fetched (RM0090, 34.17.6).
  static void stop_sending(unsigned endpoint) noexcept {
    const Address control = otg::in_control(endpoint);
    if ((Bus::read(control) & otg::kEnable) != 0) {
      change(control, 0, otg::kSetNak);
      await(otg::in_status(endpoint), otg::kNakEffective);
    }
    // It may have been fetched just before.
    if ((Bus::read(control) & otg::kEnable) != 0) {
      set<Bus>(control, otg::kSetNak | otg::kDisable);
      await(otg::in_status(endpoint), otg::kDisabled);
      flush(otg::kFlushToSend | otg::to_send_of(endpoint));
    }
    Bus::write(otg::in_status(endpoint), otg::kDisabled | otg::kDone);
  }

  /// Hands the bytes of a packet that was received to `keep`, all of them.
  template <typename Keep>
  static void receive(std::size_t bytes, Keep&& keep) noexcept {
    for (std::size_t at = 0; at < bytes; at += 4) {
      const Word word = Bus::read(otg::fifo(0));
      for (unsigned byte = 0; byte < 4 && at + byte < bytes; ++byte) {
        keep(static_cast<std::byte>(word >> (8 * byte) & 0xFFU));
      }
    }
  }

  /// On endpoint 0 until the next request, which the core sees to.
  static void stall(unsigned endpoint, bool in) noexcept {
    change(in ? otg::in_control(endpoint) : otg::out_control(endpoint), 0, otg::kStall);
  }
  static void unstall(unsigned endpoint, bool in) noexcept {
    change(in ? otg::in_control(endpoint) : otg::out_control(endpoint),
           otg::kStall,
           otg::kFirstIsData0);
  }

 private:
  // A look takes at least 4 clocks of 168 MHz.
  static constexpr std::uint32_t kLooks = 20'000;
  static constexpr std::uint32_t kModeLooks = 1'100'000;  ///< 25 ms, RM0090, 34.16.1.
  static constexpr std::uint32_t kFewLooks = 200;         ///< Some clocks of 48 MHz are enough.
  static constexpr Word kFromReset = otg::kActive | otg::kSetNak | otg::kFirstIsData0;
  static constexpr Word kRequests = otg::kThreeSetUps | otg::kOnePacket | kPacketBytes;

  // In words. Received: 10 for requests, 1, and the rest for 6 packets with their entries.
  static constexpr Word kReceiveWords = 128;
  static constexpr Word kControlWords = 32;
  static constexpr Word kDataWords = 128;
  static constexpr Word kNewsWords = 16;  ///< The least there may be.
  static_assert(kReceiveWords + kControlWords + kDataWords + kNewsWords <= otg::kFifoWords);
  static_assert(kReceiveWords >= 10U + 1U + 2U * (kPacketBytes / 4 + 1) + 4U, "RM0090, 34.13.1");

  /// Does not write the enable back that it has read: the packet may be over by then.
  static void change(Address control, Word off, Word on) noexcept {
    modify<Bus>(control, off | otg::kEnable, on);
  }

  static void share_memory() noexcept {
    Bus::write(otg::kReceiveSize, kReceiveWords);
    Word begin = kReceiveWords;
    unsigned endpoint = 0;
    for (const Word words : {kControlWords, kDataWords, kNewsWords}) {
      Bus::write(otg::transmit_size(endpoint++), begin | words << 16);
      begin += words;
    }
  }

  static void await(Address address, Word bits) noexcept {
    static_cast<void>(wait_for<Bus>(address, bits, bits, kFewLooks));
  }
  static void flush(Word what) noexcept {
    Bus::write(otg::kResets, what);
    static_cast<void>(
        wait_for<Bus>(otg::kResets, otg::kFlushReceived | otg::kFlushToSend, 0, kFewLooks));
  }
};

}  // namespace hal::stm32f405::usb
