#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/interface/byte_stream.hpp"
#include "hal/stm32f405/board.hpp"
#include "hal/stm32f405/byte_rings.hpp"
#include "hal/stm32f405/turn_marks.hpp"

namespace hal::stm32f405 {

/// The board's serial interface: an interrupt routine transfers bytes between the wire and two
/// rings.
///
/// If a byte is damaged, or if there is no free space for it, kLostByte is stored in its place. No
/// valid line may contain kLostByte, so an incomplete line is refused.
template <const Board& kBoard, RegisterBus Bus = MemoryBus>
class SerialLine final : public ByteStream {
 public:
  static constexpr std::byte kLostByte{0x7F};
  static constexpr unsigned kInterrupt = CheckedBoard<kBoard>::kSerial.interrupt;
  static constexpr unsigned kPriority = 4;

  constexpr explicit SerialLine(ByteRings& rings)
      : received_{rings.received}, to_send_{rings.to_send} {}

  /// Sets up the interface. Called once, with interrupts off.
  void set_up(const Clocks& clocks) noexcept {
    set<Bus>(kPins.clock(), bit(kPins.clock_bit));
    PinSetUp<Bus>::turn_port_on(kPins.transmit);
    PinSetUp<Bus>::turn_port_on(kPins.receive);
    PinSetUp<Bus>::hand_over(kPins.transmit, kPins.function, true);
    PinSetUp<Bus>::hand_over(kPins.receive, kPins.function, true);
    const std::uint32_t clock = kPins.fast() ? clocks.apb2 : clocks.apb1;
    Bus::write(kPins.base + usart::kBaudRate, (clock + kBoard.baud / 2) / kBoard.baud);
    Bus::write(kPins.base + usart::kCr1, kAtRest);
    enable_interrupt<Bus>(kInterrupt, kPriority);
  }

  // Functions for the main loop.

  /// Begins a cycle: from now on read() returns only bytes that had arrived by the boundary of the
  /// cycle.
  void begin_turn(std::uint32_t turn) { marks_.begin_turn(turn); }

  [[nodiscard]] std::size_t read(std::span<std::byte> into) override {
    std::size_t count = 0;
    while (count < into.size() && received_.try_pop_before(marks_.end(), into[count])) ++count;
    return count;
  }

  [[nodiscard]] std::size_t write(std::span<const std::byte> from) override {
    std::size_t count = 0;
    while (count < from.size() && to_send_.try_push(from[count])) ++count;
    if (count > 0) {
      // The interrupt disables its request when it finds no byte to send, so this write enables the
      // request after each push. If the interrupt has already sent the bytes, it disables the
      // request again.
      Bus::write(kPins.base + usart::kCr1, kAtRest | usart::kRoomInterrupt);
      pend_interrupt<Bus>(kInterrupt);
    }
    return count;
  }

  [[nodiscard]] bool may_wait() const override { return false; }

  /// Returns whether the interface has taken all written bytes from the ring.
  [[nodiscard]] bool sent() const { return to_send_.size() == 0; }
  [[nodiscard]] std::uint32_t lost_bytes() const { return lost_.load(std::memory_order_relaxed); }

  /// Marks the boundary of a cycle. Called from an interrupt of higher priority than the line's
  /// interrupt.
  void note_turn(std::uint32_t turn) noexcept { marks_.note(turn, received_.place()); }

  // The function for the line's own interrupt.

  void on_interrupt() noexcept {
    for (std::uint32_t byte = 0; byte < kMaxAtOnce; ++byte) {
      const Word status = Bus::read(kPins.base + usart::kStatus);
      if ((status & (usart::kReceived | usart::kDamaged)) == 0) break;
      // Reading the data register after the status register clears the flags of received bytes and
      // of errors.
      const auto data = static_cast<std::byte>(Bus::read(kPins.base + usart::kData) & 0xFFU);
      keep((status & usart::kDamaged) != 0 ? kLostByte : data, (status & usart::kDamaged) != 0);
    }
    send();
  }

 private:
  static constexpr SerialPins kPins = CheckedBoard<kBoard>::kSerial;
  static constexpr Word kAtRest =
      usart::kOn | usart::kReceiver | usart::kTransmitter | usart::kReceivedInterrupt;
  /// Maximum number of bytes in one interrupt. The hardware holds two bytes, but an emulator may
  /// deliver a complete file in one interrupt.
  static constexpr std::uint32_t kMaxAtOnce = 16;

  void keep(std::byte byte, bool damaged) noexcept {
    if (damaged) count_lost();
    if (gap_) gap_ = !received_.try_push(kLostByte);
    if (gap_ || !received_.try_push(byte)) {
      gap_ = true;
      count_lost();
    }
  }
  void count_lost() noexcept {
    lost_.store(lost_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  void send() noexcept {
    for (std::uint32_t sent = 0; sent < ByteRings::kSendBytes; ++sent) {
      if ((Bus::read(kPins.base + usart::kStatus) & usart::kRoomToSend) == 0) return;
      std::byte byte{};
      if (!to_send_.try_pop(byte)) {
        Bus::write(kPins.base + usart::kCr1, kAtRest);
        return;
      }
      Bus::write(kPins.base + usart::kData, static_cast<Word>(byte));
    }
  }

  SpscRing<std::byte, ByteRings::kReceiveBytes>& received_;
  SpscRing<std::byte, ByteRings::kSendBytes>& to_send_;
  TurnMarks marks_{};
  std::atomic<std::uint32_t> lost_{0};
  bool gap_ = false;  ///< Whether a byte was dropped and kLostByte is not stored in its place yet.
};

}  // namespace hal::stm32f405
