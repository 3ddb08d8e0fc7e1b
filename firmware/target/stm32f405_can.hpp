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

/// The CAN link of a board that has CAN. While a sender uses CAN, it is the active link and has
/// precedence over all other links.
template <const hal::stm32f405::Board& kBoard, bool kHasIt = kBoard.can_transmit.exists()>
class CanSide {
 public:
  using Bus = hal::stm32f405::MemoryBus;
  using Change = cnc::LinkChoice::Change;

  /// @param others choice among the other links; outlives this object
  explicit CanSide(hal::ByteStream& others) : choice_{link_, others} {}

  /// Sets up CAN, with interrupts off, before any object of this class is constructed. Without a
  /// working crystal the node does not join the bus, because a bus requires the crystal's accuracy.
  static void set_up(const hal::stm32f405::Clocks& clocks) {
    using Line = hal::stm32f405::CanLine<kBoard>;
    if (line_.set_up(clocks, {})) static_cast<void>(line_.speak(Line::Voice::kSpeaking));
  }
  static void on_interrupt() noexcept { line_.on_interrupt(); }
  /// Marks the boundary of a cycle in the received frames.
  static void note_turn(std::uint32_t turn) noexcept { line_.note_turn(turn); }

  /// Returns the link for the application: CAN or one of the other links.
  [[nodiscard]] hal::ByteStream& link() { return choice_; }

  /// Processes the frames that had arrived by the boundary of cycle `turn`. Main loop.
  template <typename Application>
  void attend(Application& application, std::uint32_t turn, hal::TickCount now) {
    line_.begin_turn(turn);
    application.attend(link_, now);
  }
  /// Returns whether a sender came or went, on CAN or on another link. Changes on the other links
  /// are reported only while no sender uses CAN.
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

/// The variant for a board without CAN: only the other links exist.
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
