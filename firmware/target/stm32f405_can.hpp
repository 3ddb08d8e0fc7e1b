#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "firmware/link/can/can_link.hpp"
#include "firmware/link/link_choice.hpp"
#include "hal/stm32f405/can/can_line.hpp"
#include "hal/stm32f405/start_up.hpp"
#include "hal/stm32f405/unique_id.hpp"
#include "planner/base/crc32.hpp"

namespace target {

/// CAN on a board that has it: somebody there has the word before anybody on the other links.
template <const hal::stm32f405::Board& kBoard, bool kHasIt = kBoard.can_transmit.exists()>
class CanSide {
 public:
  using Bus = hal::stm32f405::MemoryBus;
  using Change = cnc::LinkChoice::Change;

  /// @param others outlive this
  explicit CanSide(hal::ByteStream& others) : choice_{link_, others} {}

  /// Interrupts off, before any object of this is constructed. Without the crystal, whose rate a
  /// bus relies on, the node stays out of it.
  static void set_up(const hal::stm32f405::Clocks& clocks) {
    using Line = hal::stm32f405::CanLine<kBoard>;
    if (line_.set_up(clocks, {})) static_cast<void>(line_.speak(Line::Voice::kSpeaking));
  }
  static void on_interrupt() noexcept { line_.on_interrupt(); }
  /// Boundary of a turn.
  static void note_turn(std::uint32_t turn) noexcept { line_.note_turn(turn); }

  /// What the application talks to.
  [[nodiscard]] hal::ByteStream& link() { return choice_; }

  /// Main loop: frames that had come when this turn began.
  template <typename Application>
  void attend(Application& application, std::uint32_t turn, hal::TickCount now) {
    line_.begin_turn(turn);
    application.attend(link_, now);
  }
  /// Whether a sender came or went, here or there; of the others only while nobody is here.
  [[nodiscard]] Change follow(Change others) {
    const Change here = choice_.attend();
    if (here != Change::kNone || choice_.first_has_word()) return here;
    return others;
  }

 private:
  static cnc::LssSlave::Identity identity() {
    const auto id = hal::stm32f405::unique_id<Bus>();
    if (!id) return {};
    cnc::Crc32 sum;
    sum.add(std::as_bytes(std::span{*id}));
    return {.serial = sum.value()};
  }

  inline static constinit hal::stm32f405::CanLine<kBoard> line_{};
  cnc::CanLink link_{line_, cnc::can::kUsualNode, identity()};
  cnc::LinkChoice choice_;
};

/// A board without: the other links are all there are.
template <const hal::stm32f405::Board& kBoard>
class CanSide<kBoard, false> {
 public:
  using Change = cnc::LinkChoice::Change;

  explicit CanSide(hal::ByteStream& others) : others_{others} {}
  static void set_up(const hal::stm32f405::Clocks& /*clocks*/) {}
  static void on_interrupt() noexcept {}
  static void note_turn(std::uint32_t /*turn*/) noexcept {}
  [[nodiscard]] hal::ByteStream& link() { return others_; }
  template <typename Application>
  void attend(Application& /*application*/, std::uint32_t /*turn*/, hal::TickCount /*now*/) {}
  [[nodiscard]] Change follow(Change others) { return others; }

 private:
  hal::ByteStream& others_;
};

}  // namespace target
