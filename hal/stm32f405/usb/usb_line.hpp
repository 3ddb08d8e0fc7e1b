#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/interface/session_stream.hpp"
#include "hal/stm32f405/board.hpp"
#include "hal/stm32f405/byte_rings.hpp"
#include "hal/stm32f405/turn_marks.hpp"
#include "hal/stm32f405/unique_id.hpp"
#include "hal/stm32f405/usb/control_pipe.hpp"

namespace hal::stm32f405 {

/// The board's USB socket as a serial line: an interrupt routine transfers bytes between the USB
/// core and two rings. Only the interrupt accesses the core; the main loop requests the interrupt.
///
/// No byte is dropped: while there is no free space, the host must wait with each packet (NAK). A
/// session begins when a program on the host opens the line (DTR). For programs that do not use
/// DTR, it begins when the host sends bytes. It ends when the line is closed, or when the bus is
/// reset or suspended, as happens without a host.
template <const Board& kBoard, RegisterBus Bus = MemoryBus>
class UsbLine final : public SessionStream {
 public:
  static constexpr unsigned kInterrupt = otg::kInterrupt;
  static constexpr unsigned kPriority = 4;

  constexpr explicit UsbLine(UsbRings& rings)
      : received_{rings.received}, to_send_{rings.to_send} {}

  /// Sets up USB. Called once, with interrupts off. Without the crystal USB stays off, because USB
  /// requires 48 MHz within 0.25 %.
  void set_up(const Clocks& clocks) noexcept {
    if (!kBoard.has_usb || clocks.source != ClockSource::kCrystal) return;
    for (const Pin pin : kUsbPins) PinSetUp<Bus>::hand_over(pin, kFunction, false);
    control_.device().introduce(kBoard.usb, "Kerfline", kBoard.name);
    if (const auto serial = unique_id<Bus>()) control_.device().set_serial(*serial);
    if (Core::set_up()) enable_interrupt<Bus>(kInterrupt, kPriority);
  }

  // Functions for the main loop.

  /// Begins a cycle: from now on read() returns only bytes that had arrived by the boundary of the
  /// cycle.
  void begin_turn(std::uint32_t turn) { marks_.begin_turn(turn); }

  [[nodiscard]] std::uint32_t session() const override {
    return session_.load(std::memory_order_acquire);
  }

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override {
    const std::uint32_t session = session_.load(std::memory_order_acquire);
    if (session == 0 || session != read_session_) {
      received_.drop_before(begin_.load(std::memory_order_relaxed));
      read_session_ = session;
    }
    std::size_t count = 0;
    while (session != 0 && count < into.size() &&
           received_.try_pop_before(marks_.end(), into[count])) {
      ++count;
    }
    if (waits_for_room_.load(std::memory_order_relaxed) && has_room()) {
      pend_interrupt<Bus>(kInterrupt);
    }
    return count;
  }

  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override {
    if (session_.load(std::memory_order_acquire) == 0) return 0;
    std::size_t count = 0;
    while (count < from.size() && to_send_.try_push(from[count])) ++count;
    if (count > 0) pend_interrupt<Bus>(kInterrupt);
    return count;
  }

  /// Returns false: if bytes waited, the host could send a feed hold only after its waiting lines.
  [[nodiscard]] bool may_wait() const override { return false; }

  /// Returns whether the host has fetched all written bytes, or no host is connected.
  [[nodiscard]] bool sent() const {
    return session() == 0 || (to_send_.size() == 0 && !sending_.load(std::memory_order_relaxed));
  }

  /// Marks the boundary of a cycle. Called from an interrupt of higher priority than the line's
  /// interrupt.
  void note_turn(std::uint32_t turn) noexcept { marks_.note(turn, received_.place()); }

  // The function for the line's own interrupt.

  void on_interrupt() noexcept {
    for (unsigned turn = 0; turn < kMaxTurns; ++turn) {
      const Word status = Bus::read(otg::kStatus) & Core::kInterrupts;
      if (status == 0) break;
      attend(status);
    }
    exchange_data();
  }

 private:
  using Core = usb::OtgCore<Bus>;
  using Effect = usb::Effect;
  static constexpr unsigned kFunction = 10;
  /// Greatest numbers of rounds of the loops. If work is left over, the core raises the interrupt
  /// again.
  static constexpr unsigned kMaxTurns = 8;
  static constexpr unsigned kMaxEntries = 16;

  void attend(Word status) noexcept {
    // All other flags are cleared by the code that handles their events.
    Bus::write(otg::kStatus,
               status & (otg::kBusReset | otg::kSpeedKnown | otg::kSuspended | otg::kWakeUp));
    // The order matters: a bus reset discards the packets that arrived before it, and a new request
    // ends an earlier answer.
    if ((status & otg::kReceived) != 0) take_packets();
    if ((status & otg::kBusReset) != 0) on_bus_reset();
    if ((status & otg::kSuspended) != 0) suspended_ = true;
    if ((status & (otg::kWakeUp | otg::kBusReset)) != 0) suspended_ = false;
    if ((status & otg::kInEndpoints) != 0) on_in_endpoints();
    if ((status & otg::kOutEndpoints) != 0 && take_done(otg::out_status(usb::kData))) {
      listening_ = false;
    }
    judge_session();
  }

  void on_bus_reset() noexcept {
    control_.begin_anew();
    Core::begin_anew();
    forget_data();
  }

  void take_packets() noexcept {
    for (unsigned entries = 0; entries < kMaxEntries; ++entries) {
      if ((Bus::read(otg::kStatus) & otg::kReceived) == 0) return;
      take(Bus::read(otg::kReceivedPop));
    }
  }

  /// Handles one received entry. Only these entries drive endpoint 0, because they have the order
  /// of the wire; the interrupt flags of the endpoint do not show that order.
  void take(Word entry) noexcept {
    const bool data = otg::endpoint_in(entry) == usb::kData;
    switch (otg::kind_in(entry)) {
      case otg::Received::kSetUp:
        return control_.take_request(otg::bytes_in(entry));
      case otg::Received::kSetUpDone:
        return apply(control_.on_request());
      case otg::Received::kOut:
        return data ? keep(otg::bytes_in(entry)) : control_.take_data(otg::bytes_in(entry));
      case otg::Received::kOutDone:
        if (!data) control_.on_received();
        return;
      default:
        return;
    }
  }

  void keep(std::size_t bytes) noexcept {
    if (bytes > 0) spoken_ = true;
    // Called before the bytes are stored, because the bytes belong to the new session.
    judge_session();
    Core::receive(bytes, [this](std::byte byte) {
      // There is free space, because the endpoint accepts a packet only if it fits.
      static_cast<void>(received_.try_push(byte));
    });
  }

  void on_in_endpoints() noexcept {
    const Word which = Bus::read(otg::kEndpoints);
    if ((which & bit(0)) != 0 && take_done(otg::in_status(0))) control_.on_sent();
    if ((which & bit(usb::kData)) != 0 && take_done(otg::in_status(usb::kData))) {
      sending_.store(false, std::memory_order_relaxed);
    }
  }

  /// Returns whether a transfer is complete. Clears its flags, so that each transfer is reported
  /// once.
  static bool take_done(Address status) noexcept {
    const Word flags = Bus::read(status);
    Bus::write(status, flags);
    return (flags & otg::kDone) != 0;
  }

  void apply(const usb::Answer& answer) noexcept {
    const bool in = (answer.endpoint & 0x80U) != 0;
    switch (answer.effect) {
      case Effect::kAddress:
        return Core::set_address(control_.device().address());
      case Effect::kConfigure:
        Core::close_data();
        forget_data();
        if (control_.device().configured()) Core::open_data();
        return;
      case Effect::kHalt:
        return Core::stall(answer.endpoint & 0xFU, in);
      case Effect::kUnhalt:
        return Core::unstall(answer.endpoint & 0xFU, in);
      case Effect::kLineState:
        if (!control_.device().line_is_open()) spoken_ = false;
        return judge_session();
      case Effect::kNone:
        return;
    }
  }

  /// Restores the initial state of the data endpoints.
  void forget_data() noexcept {
    spoken_ = listening_ = ends_full_ = false;
    sending_.store(false, std::memory_order_relaxed);
  }

  void judge_session() noexcept {
    const usb::Device& device = control_.device();
    const bool open = device.configured() && !suspended_ && (device.line_is_open() || spoken_);
    if (open == (session_.load(std::memory_order_relaxed) != 0)) return;
    take_back_answers();
    begin_.store(received_.place(), std::memory_order_relaxed);
    if (open && ++sessions_ == 0) ++sessions_;
    session_.store(open ? sessions_ : 0, std::memory_order_release);
  }

  void take_back_answers() noexcept {
    to_send_.clear();
    if (!sending_.load(std::memory_order_relaxed)) return;
    Core::stop_sending(usb::kData);
    sending_.store(false, std::memory_order_relaxed);
    ends_full_ = false;
  }

  [[nodiscard]] bool has_room() const {
    return UsbRings::kReceiveBytes - received_.size() >= usb::kPacketBytes;
  }

  void exchange_data() noexcept {
    if (!control_.device().configured() || suspended_) return;
    if (!listening_ && has_room()) {
      Core::allow_receiving(usb::kData);
      listening_ = true;
    }
    waits_for_room_.store(!listening_, std::memory_order_relaxed);
    if (sending_.load(std::memory_order_relaxed)) return;
    std::array<std::byte, usb::kPacketBytes> packet{};
    std::size_t count = 0;
    while (count < packet.size() && to_send_.try_pop(packet[count])) ++count;
    // A transfer must end with a packet that is not full; otherwise the host's driver waits for
    // more bytes.
    if (count == 0 && !ends_full_) return;
    ends_full_ = count == packet.size();
    sending_.store(true, std::memory_order_relaxed);
    Core::send(usb::kData, std::span{packet}.first(count));
  }

  usb::ControlPipe<Bus> control_{};
  SpscRing<std::byte, UsbRings::kReceiveBytes>& received_;
  SpscRing<std::byte, UsbRings::kSendBytes>& to_send_;
  TurnMarks marks_{};
  std::atomic<std::uint32_t> session_{0};
  /// Position in `received_` of the first byte after the last change of session.
  std::atomic<std::uint32_t> begin_{0};
  std::atomic<bool> waits_for_room_{false};
  std::atomic<bool> sending_{false};  ///< Whether the core has a packet to send.
  std::uint32_t read_session_ = 0;    ///< Session of the last read(); used in the main loop only.

  // Used in the interrupt only.
  std::uint32_t sessions_ = 0;
  bool suspended_ = false;
  bool spoken_ = false;     ///< Whether the host has sent bytes since the line was last closed.
  bool listening_ = false;  ///< Whether the core is allowed to receive a packet.
  bool ends_full_ = false;  ///< Whether the last sent packet was full.
};

}  // namespace hal::stm32f405
