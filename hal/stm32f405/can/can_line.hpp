#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "hal/interface/can_port.hpp"
#include "hal/interface/spsc_ring.hpp"
#include "hal/stm32f405/board.hpp"
#include "hal/stm32f405/can/can_filter.hpp"
#include "hal/stm32f405/can/can_timing.hpp"
#include "hal/stm32f405/turn_marks.hpp"

namespace hal::stm32f405 {

/// CAN1 as a CanPort: one routine handles its four interrupts and transfers frames between the bus
/// and two rings. The node is silent until speak() is called, because a node with a wrong bit rate
/// would disturb all other nodes.
///
/// A frame is repeated until another node has acknowledged it. After bus-off the node returns to
/// the bus after 128 times 11 bits of silence, without a command, and continues with its queued
/// frames.
template <const Board& kBoard, RegisterBus Bus = MemoryBus>
class CanLine final : public CanPort {
 public:
  static constexpr std::uint32_t kReceiveFrames = 32;
  static constexpr std::uint32_t kSendFrames = 16;
  static constexpr unsigned kPriority = 4;
  static constexpr CanTiming kTiming = can_timing(kFullSpeed.apb1, kBoard.can_bit_rate);

  enum class Voice : std::uint8_t {
    kSilent,    ///< Receives frames, but acknowledges and sends nothing.
    kSpeaking,  ///< Receives, acknowledges and sends.
    kToItself,  ///< Receives only its own frames, for tests.
  };

  /// Sets up CAN1 as a silent node that receives the frames of `filters`. Returns false if CAN1
  /// does not respond, or if the clock source is not the crystal, because the bus requires its
  /// accuracy. Called once, with interrupts off.
  /// @param filters at most bxcan::kBanks filters; without a filter, no frame is received
  [[nodiscard]] bool set_up(const Clocks& clocks, std::span<const CanFilter> filters) noexcept {
    if (clocks.source != ClockSource::kCrystal || filters.size() > bxcan::kBanks) return false;
    set<Bus>(rcc::kApb1Enr, bxcan::kClock);
    // This read gives the clock the two cycles that it needs (ES0182, 2.2.13).
    static_cast<void>(Bus::read(rcc::kApb1Enr));
    PinSetUp<Bus>::hand_over(kPins.receive, kFunction, true);
    PinSetUp<Bus>::hand_over(kPins.transmit, kFunction, false);
    use(filters);
    if (!speak(Voice::kSilent)) return false;
    for (const unsigned number : bxcan::kInterruptNumbers) enable_interrupt<Bus>(number, kPriority);
    return true;
  }

  /// Leaves the bus and joins it again with another voice. Returns false if this takes more than
  /// some 10 ms, for example because the receive pin is stuck low. The node then joins the bus
  /// later, when it can. Main loop.
  [[nodiscard]] bool speak(Voice voice) noexcept {
    Bus::write(bxcan::kControl, kMode | bxcan::kInitialise);
    if (!reached(bxcan::kInitialise)) return false;
    const Word modes = voice == Voice::kSilent     ? bxcan::kSilent
                       : voice == Voice::kToItself ? bxcan::kLoopBack | bxcan::kSilent
                                                   : 0;
    Bus::write(bxcan::kTiming, kTiming.word() | modes);
    Bus::write(bxcan::kInterrupts, bxcan::kAllInterrupts);
    speaks_ = voice != Voice::kSilent;
    Bus::write(bxcan::kControl, kMode);
    pend_interrupt<Bus>(bxcan::kTransmitInterrupt);
    return reached(0);
  }

  // Functions for the main loop.

  /// Begins a cycle: from now on receive() returns only frames that had arrived by the boundary of
  /// the cycle.
  void begin_turn(std::uint32_t turn) {
    in_turns_ = true;
    marks_.begin_turn(turn);
  }

  [[nodiscard]] bool receive(CanFrame& frame) override {
    return in_turns_ ? received_.try_pop_before(marks_.end(), frame) : received_.try_pop(frame);
  }

  [[nodiscard]] bool send(const CanFrame& frame) override {
    if (frame.length > frame.data.size() || !to_send_.try_push(frame)) return false;
    pend_interrupt<Bus>(bxcan::kTransmitInterrupt);
    return true;
  }

  [[nodiscard]] std::size_t room() const override { return kSendFrames - to_send_.size(); }

  [[nodiscard]] CanHealth health() const override {
    const Word errors = Bus::read(bxcan::kErrors);
    CanState state = CanState::kActive;
    if ((errors & bxcan::kWarning) != 0) state = CanState::kWarning;
    if ((errors & bxcan::kPassive) != 0) state = CanState::kPassive;
    if ((errors & bxcan::kBusOff) != 0) state = CanState::kBusOff;
    return {.state = state,
            .transmit_errors = static_cast<std::uint8_t>(errors >> 16 & 0xFFU),
            .receive_errors = static_cast<std::uint8_t>(errors >> 24),
            .bus_offs = bus_offs_.load(std::memory_order_relaxed),
            .lost_frames = lost_.load(std::memory_order_relaxed)};
  }

  void hear_only(std::span<const std::uint32_t> identifiers, std::size_t urgent) override {
    std::array<CanFilter, bxcan::kBanks> filters{};
    std::size_t count = 0;
    const auto add = [&](std::span<const std::uint32_t> part, std::uint8_t fifo) {
      for (std::size_t at = 0; at < part.size() && count < filters.size(); at += 2) {
        filters[count++] = {.kind = CanFilter::Kind::kList,
                            .fifo = fifo,
                            .id = part[at],
                            .other = part[at + 1 < part.size() ? at + 1 : at]};
      }
    };
    add(identifiers.first(urgent), 0);
    add(identifiers.subspan(urgent), 1);
    use(std::span{filters}.first(count));
  }

  /// Marks the boundary of a cycle. Called from an interrupt of higher priority than the CAN
  /// interrupts.
  void note_turn(std::uint32_t turn) noexcept { marks_.note(turn, received_.place()); }

  // The function for all CAN interrupts.

  void on_interrupt() noexcept {
    if ((Bus::read(bxcan::kStatus) & bxcan::kErrorAsked) != 0) {
      Bus::write(bxcan::kStatus, bxcan::kErrorAsked);
      // Bus-off is the only error for which this interrupt is enabled.
      if ((Bus::read(bxcan::kErrors) & bxcan::kBusOff) != 0) count(bus_offs_);
    }
    for (unsigned number = 0; number < bxcan::kFifos; ++number) empty(number);
    // This write also clears the interrupt request of the mailboxes.
    Bus::write(bxcan::kTransmit, bxcan::kRequestsDone);
    fill_mailboxes();
  }

 private:
  static constexpr CanPins kPins = can_pins_of(kBoard.can_transmit, kBoard.can_receive);
  static_assert(kPins.exists(), "these two pins are no CAN1");
  static_assert(kTiming.exists(), "this rate is not within reach");
  static constexpr unsigned kFunction = 9;
  static constexpr Word kMode = bxcan::kRecoverAlone | bxcan::kInOrder | bxcan::kKeepOldest;
  /// Number of reads after which a change of mode is abandoned. CAN1 waits for the end of the
  /// current frame, then for 11 bits of silence: 2 ms at 125 kbit/s. One read takes at least 4
  /// clocks of 168 MHz.
  static constexpr std::uint32_t kLooks = 420'000;

  static bool reached(Word mode) noexcept {
    return wait_for<Bus>(bxcan::kStatus, bxcan::kInitialise | bxcan::kSleep, mode, kLooks);
  }

  static void use(std::span<const CanFilter> filters) noexcept {
    Bus::write(bxcan::kFilterControl, bxcan::kFiltersSetUp);
    Bus::write(bxcan::kFiltersOn, 0);
    Word lists = 0;
    Word second_fifo = 0;
    unsigned bank = 0;
    for (const CanFilter& one : filters) {
      Bus::write(bxcan::filter(bank), can_identifier(one.id, one.extended, false));
      Bus::write(bxcan::filter(bank) + 4, second_word(one));
      if (one.kind == CanFilter::Kind::kList) lists |= bit(bank);
      if (one.fifo != 0) second_fifo |= bit(bank);
      ++bank;
    }
    const Word all = bit(bank) - 1;
    Bus::write(bxcan::kFilterLists, lists);
    Bus::write(bxcan::kFilterWide, all);
    Bus::write(bxcan::kFilterFifos, second_fifo);
    Bus::write(bxcan::kFiltersOn, all);
    Bus::write(bxcan::kFilterControl, bxcan::kFiltersUsed);
  }

  void empty(unsigned number) noexcept {
    constexpr unsigned kMaxAtOnce = 8;
    for (unsigned frames = 0; frames < kMaxAtOnce; ++frames) {
      const Word state = Bus::read(bxcan::fifo(number));
      if ((state & bxcan::kOverrun) != 0) {
        count(lost_);
        Bus::write(bxcan::fifo(number), bxcan::kOverrun);
      }
      if ((state & bxcan::kPending) == 0) return;
      if (!received_.try_push(frame_in(bxcan::received(number)))) count(lost_);
      Bus::write(bxcan::fifo(number), bxcan::kRelease);
      // The next frame is available only after the release is complete (RM0090, 32.9.2).
      static_cast<void>(wait_for<Bus>(bxcan::fifo(number), bxcan::kRelease, 0, kFewLooks));
    }
  }
  static constexpr std::uint32_t kFewLooks = 50;

  static CanFrame frame_in(Address place) noexcept {
    const Word identifier = Bus::read(place);
    CanFrame frame;
    frame.extended = (identifier & bxcan::kExtended) != 0;
    frame.remote = (identifier & bxcan::kRemote) != 0;
    frame.id = frame.extended ? identifier >> 3 : identifier >> 21;
    const Word length = Bus::read(place + 4) & 0xFU;
    // A length code of 9 to 15 means 8 bytes.
    frame.length = static_cast<std::uint8_t>(length < 8 ? length : 8);
    const std::array<Word, 2> words{Bus::read(place + 8), Bus::read(place + 12)};
    for (std::size_t at = 0; at < frame.length && !frame.remote; ++at) {
      frame.data[at] = static_cast<std::byte>(words[at / 4] >> (8 * (at % 4)) & 0xFFU);
    }
    return frame;
  }

  void fill_mailboxes() noexcept {
    if (!speaks_) return;
    for (unsigned number = 0; number < bxcan::kMailboxes; ++number) {
      if ((Bus::read(bxcan::kTransmit) & bxcan::empty(number)) == 0) continue;
      CanFrame frame;
      if (!to_send_.try_pop(frame)) return;
      put(frame, bxcan::mailbox(number));
    }
  }

  static void put(const CanFrame& frame, Address place) noexcept {
    std::array<Word, 2> words{};
    for (std::size_t at = 0; at < frame.length; ++at) {
      words[at / 4] |= static_cast<Word>(frame.data[at]) << (8 * (at % 4));
    }
    Bus::write(place + 4, frame.length);
    Bus::write(place + 8, words[0]);
    Bus::write(place + 12, words[1]);
    Bus::write(place, can_identifier(frame.id, frame.extended, frame.remote) | bxcan::kGo);
  }

  static void count(std::atomic<std::uint32_t>& counter) noexcept {
    counter.store(counter.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  SpscRing<CanFrame, kReceiveFrames> received_{};
  SpscRing<CanFrame, kSendFrames> to_send_{};
  std::atomic<std::uint32_t> bus_offs_{0};
  std::atomic<std::uint32_t> lost_{0};
  std::atomic<bool> speaks_{false};
  TurnMarks marks_{};
  bool in_turns_ = false;
};

}  // namespace hal::stm32f405
