#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/stm32f405/bus.hpp"
#include "hal/stm32f405/usb/descriptors.hpp"
#include "hal/stm32f405/usb/otg_registers.hpp"

namespace hal::stm32f405::usb {

/// The full-speed USB core, driven by its registers: one packet at a time in each direction,
/// without DMA. The class has no state of its own. Functions are called in the USB interrupt,
/// except set_up(), which is called before that interrupt is enabled.
template <RegisterBus Bus>
class OtgCore {
 public:
  static constexpr Word kInterrupts = otg::kBusReset | otg::kSpeedKnown | otg::kReceived |
                                      otg::kInEndpoints | otg::kOutEndpoints | otg::kSuspended |
                                      otg::kWakeUp;

  /// Sets up the core after reset as a device that is visible to the host. Requires a USB clock of
  /// 48 MHz. Returns false if the core does not respond. Takes at most some 25 ms.
  ///
  /// VBUS is not sensed, because its pin, PA9, belongs to a serial line. So an absent host appears
  /// as a suspended bus.
  [[nodiscard]] static bool set_up() noexcept {
    set<Bus>(rcc::kAhb2Enr, otg::kClock);
    // This read gives the clock the two cycles that it needs (ES0182, 2.2.13).
    static_cast<void>(Bus::read(rcc::kAhb2Enr));
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

  /// Restarts after the host has reset the bus: only requests are received, at address 0.
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

  /// Sets the device's address. Called before the request is answered, because the core keeps the
  /// old address until the request is complete.
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

  /// Allows one packet to be received. While no packet is allowed, the host must wait.
  static void allow_receiving(unsigned endpoint) noexcept {
    // An endpoint that was enabled before a bus reset stays enabled, and its size must not change
    // then.
    const bool open = (Bus::read(otg::out_control(endpoint)) & otg::kEnable) != 0;
    const Word requests = endpoint == 0 ? otg::kThreeSetUps : 0;
    if (endpoint == 0 || !open) {
      Bus::write(otg::out_size(endpoint), requests | otg::kOnePacket | kPacketBytes);
    }
    set<Bus>(otg::out_control(endpoint), otg::kEnable | otg::kClearNak);
  }
  /// Allows requests at any time, up to three in a row.
  static void allow_requests() noexcept { Bus::write(otg::out_size(0), kRequests); }

  /// Sends one packet.
  /// @pre the host has fetched the previous packet of this endpoint
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

  /// Withdraws a packet that the host has not fetched (RM0090, 34.17.6).
  static void stop_sending(unsigned endpoint) noexcept {
    const Address control = otg::in_control(endpoint);
    if ((Bus::read(control) & otg::kEnable) != 0) {
      change(control, 0, otg::kSetNak);
      await(otg::in_status(endpoint), otg::kNakEffective);
    }
    // The host may have fetched the packet meanwhile.
    if ((Bus::read(control) & otg::kEnable) != 0) {
      set<Bus>(control, otg::kSetNak | otg::kDisable);
      await(otg::in_status(endpoint), otg::kDisabled);
      flush(otg::kFlushToSend | otg::to_send_of(endpoint));
    }
    Bus::write(otg::in_status(endpoint), otg::kDisabled | otg::kDone);
  }

  /// Passes all bytes of a received packet to `keep`.
  template <typename Keep>
  static void receive(std::size_t bytes, Keep&& keep) noexcept {
    for (std::size_t at = 0; at < bytes; at += 4) {
      const Word word = Bus::read(otg::fifo(0));
      for (unsigned byte = 0; byte < 4 && at + byte < bytes; ++byte) {
        keep(static_cast<std::byte>(word >> (8 * byte) & 0xFFU));
      }
    }
  }

  /// Stalls an endpoint. On endpoint 0 the core ends the stall when the next request arrives.
  static void stall(unsigned endpoint, bool in) noexcept {
    change(in ? otg::in_control(endpoint) : otg::out_control(endpoint), 0, otg::kStall);
  }
  static void unstall(unsigned endpoint, bool in) noexcept {
    change(in ? otg::in_control(endpoint) : otg::out_control(endpoint),
           otg::kStall,
           otg::kFirstIsData0);
  }

 private:
  // Greatest number of reads in a wait. One read takes at least 4 clocks of 168 MHz.
  static constexpr std::uint32_t kLooks = 20'000;
  /// Number of reads in 25 ms (RM0090, 34.16.1).
  static constexpr std::uint32_t kModeLooks = 1'100'000;
  /// Number of reads that suffices for a wait of some clocks of 48 MHz.
  static constexpr std::uint32_t kFewLooks = 200;
  static constexpr Word kFromReset = otg::kActive | otg::kSetNak | otg::kFirstIsData0;
  static constexpr Word kRequests = otg::kThreeSetUps | otg::kOnePacket | kPacketBytes;

  // FIFO sizes in words. The receive FIFO has space for requests (10 words), for the global NAK (1
  // word), and for 6 packets with their status entries.
  static constexpr Word kReceiveWords = 128;
  static constexpr Word kControlWords = 32;
  static constexpr Word kDataWords = 128;
  static constexpr Word kNewsWords = 16;  ///< Smallest FIFO size that the core allows.
  static_assert(kReceiveWords + kControlWords + kDataWords + kNewsWords <= otg::kFifoWords);
  static_assert(kReceiveWords >= 10U + 1U + 2U * (kPacketBytes / 4 + 1) + 4U, "RM0090, 34.13.1");

  /// Changes bits of a control register. Writes the enable bit as 0, which has no effect, because
  /// the packet may be complete by then and 1 would enable the endpoint again.
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
