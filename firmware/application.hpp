#pragma once

#include <cstddef>
#include <cstdint>

#include "firmware/link/can/can_link.hpp"
#include "firmware/machine/machine.hpp"
#include "firmware/protocol/line_protocol.hpp"
#include "firmware/steps/step_generator.hpp"
#include "hal/interface/auxiliary_outputs.hpp"
#include "hal/interface/byte_stream.hpp"
#include "hal/interface/control_board.hpp"
#include "hal/interface/machine_inputs.hpp"
#include "hal/interface/record_store.hpp"
#include "hal/interface/step_port.hpp"

namespace cnc {

/// The controller on one port, beside its step generator and the powers of its rows of pixels,
/// which a chip may keep in a memory of its own: owns every other object, allocates nothing.
template <hal::StepPort Port>
class Controller {
 public:
  /// 64 segments of at most a millisecond.
  static constexpr std::uint32_t kSegmentQueue = 64;
  using Steps = StepGenerator<Port, kSegmentQueue>;
  /// One is being played. The others last until the next come in, a turn that is late considered.
  static_assert((kSegmentQueue - 1) * motion::SegmentRate::kShortest >=
                (kTurnsToMotion + 2) * kTurnTicks + motion::SegmentRate::kMostSpare);
  /// So do the levels of the output, of which a segment and the end of motion add some at once.
  static_assert((Steps::kPieces - PowerShift::kMostAtOnce - motion::LevelRate::kMostShort) *
                    motion::LevelRate::kShortest >=
                (kTurnsToMotion + 2) * kTurnTicks * motion::kNsPerTick);

  /// @param board what `$I+` tells about and `$DFU` leaves for; none on a desk.
  /// @param kept memory that a restart leaves alone; null for none
  Controller(Steps& steps,
             motion::Pixels& pixels,
             hal::AuxiliaryOutputs& outputs,
             hal::MachineInputs& inputs,
             hal::RecordStore& store,
             hal::ByteStream& link,
             hal::ControlBoard* board = nullptr,
             KeptProgress* kept = nullptr)
      : steps_{steps},
        machine_{steps_, pixels, outputs, inputs, kept},
        protocol_{link, machine_, store, board} {}

  /// Step interrupt, every kTurnTicks, after what was due before and before what is due then:
  /// the boundary of a turn, whose number is returned. What the turn reads has come by now.
  std::uint32_t begin_turn() noexcept { return steps_.begin_turn(); }

  /// Main loop: begins the next turn whose boundary has passed; false when there is none. A turn
  /// may be run late, and several one after the other: nothing it does depends on when, as long
  /// as it ends within kTurnsToMotion.
  [[nodiscard]] bool take_turn() { return steps_.take_turn(); }
  /// The number of the turn taken; runs freely.
  [[nodiscard]] std::uint32_t turn() const { return steps_.turn(); }

  /// The turn that was taken. Lines are read before segments are cut, so that a
  /// burst is planned as one.
  /// @param now microseconds.
  void run_turn(hal::TickCount now) {
    protocol_.poll(now);
    machine_.poll(now);
    protocol_.poll(now);
    steps_.end_turn();
  }

  /// The same turn for a host that knows its link: polls that would do nothing are left out.
  /// @param link_waits returns whether the link has a byte
  template <typename LinkWaits>
  void run_turn(hal::TickCount now, const LinkWaits& link_waits) {
    if (link_waits() || !protocol_.is_quiet(now)) protocol_.poll(now);
    machine_.poll(now);
    if (link_waits() || !protocol_.is_quiet(now)) protocol_.poll(now);
    steps_.end_turn();
  }

  /// A boundary and its turn, for whoever has both in one thread.
  /// @param now microseconds.
  void poll(hal::TickCount now) {
    begin_turn();
    if (take_turn()) run_turn(now);
  }

  /// Main loop, before each turn: what came over CAN beside the text, and what is told there.
  /// @param now microseconds.
  void attend(CanLink& can, hal::TickCount now) {
    const Alarm alarm = machine_.alarm();
    can.tell({.stopped = alarm != Alarm::kNone, .alarm = static_cast<std::uint8_t>(alarm)});
    can.want_node(can_node());
    can.attend(now);
    if (can.take_stop()) machine_.emergency_stop();
    if (const std::uint8_t node = can.take_node_to_store()) can.note_stored(store_can_node(node));
    for (std::byte byte{}; can.take_realtime(byte);) protocol_.act_at_once(byte);
  }

  /// The number that this controller is to have on a CAN bus.
  [[nodiscard]] std::uint8_t can_node() const {
    return static_cast<std::uint8_t>(machine_.settings().get(setting::kCanNode));
  }
  /// Main loop: keeps another one; false where the machine is at work, or the store fails.
  [[nodiscard]] bool store_can_node(std::uint8_t node) {
    return protocol_.store_setting(setting::kCanNode, static_cast<float>(node));
  }

  /// Main loop: a realtime byte that came apart from the text, see LineProtocol.
  void act_at_once(std::byte byte) { protocol_.act_at_once(byte); }
  /// Main loop: bytes of text that can be received now.
  [[nodiscard]] std::uint32_t text_room() const { return protocol_.room(); }

  /// Every line must carry a number and a check.
  [[nodiscard]] bool checks_lines() const { return protocol_.checks_lines(); }

  /// Main loop: another sender is at the link, or the one that was there is gone.
  void begin_sender() { protocol_.begin_sender(); }
  void lose_sender() { protocol_.lose_sender(); }

  /// Main loop, once a millisecond: a piece of what nobody changes at work, such that settings that
  /// turned over in memory are found within 0.2 s. False from then on: the program is to end.
  [[nodiscard]] bool check_memory() {
    constexpr std::size_t kBytes = 32;
    return machine_.memory().check(kBytes);
  }

  /// The step interrupt. Returns the ticks until the next one; 0 stops the timer.
  std::uint32_t on_step_interrupt() noexcept { return steps_.on_interrupt(); }

  [[nodiscard]] Machine& machine() { return machine_; }
  [[nodiscard]] const Machine& machine() const { return machine_; }
  [[nodiscard]] const Steps& steps() const { return steps_; }

 private:
  Steps& steps_;
  Machine machine_;
  LineProtocol protocol_;
};

/// A base that is there before the controller.
template <hal::StepPort Port>
class StepsOfApplication {
 protected:
  explicit StepsOfApplication(Port& port) : steps_{port} {}

  typename Controller<Port>::Steps steps_;
  motion::Pixels pixels_{};
};

/// The whole controller on one port. The simulator makes one of these for each run.
template <hal::StepPort Port>
class Application : private StepsOfApplication<Port>, public Controller<Port> {
 public:
  /// As Controller has them.
  Application(Port& port,
              hal::AuxiliaryOutputs& outputs,
              hal::MachineInputs& inputs,
              hal::RecordStore& store,
              hal::ByteStream& link,
              hal::ControlBoard* board = nullptr,
              KeptProgress* kept = nullptr)
      : StepsOfApplication<Port>{port},
        Controller<Port>{StepsOfApplication<Port>::steps_,
                         StepsOfApplication<Port>::pixels_,
                         outputs,
                         inputs,
                         store,
                         link,
                         board,
                         kept} {}
};

}  // namespace cnc
