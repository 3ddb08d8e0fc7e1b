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

/// The controller on one port. It owns every object except its step generator and the powers of its
/// rows of pixels, which a chip may keep in separate memory. Allocates nothing.
template <hal::StepPort Port>
class Controller {
 public:
  /// 64 segments of at most a millisecond.
  static constexpr std::uint32_t kSegmentQueue = 64;
  using Steps = StepGenerator<Port, kSegmentQueue>;
  /// One segment is being played. The others must last until the next ones come in, even if a cycle
  /// is late.
  static_assert((kSegmentQueue - 1) * motion::SegmentRate::kShortest >=
                (kTurnsToMotion + 2) * kTurnTicks + motion::SegmentRate::kMaxSpare);
  /// The levels of the output must last as long. A segment and the end of motion add several levels
  /// at once.
  static_assert((Steps::kPieces - PowerShift::kMaxAtOnce - motion::LevelRate::kMaxShort) *
                    motion::LevelRate::kShortest >=
                (kTurnsToMotion + 2) * kTurnTicks * motion::kNsPerTick);

  /// @param board object that describes the board for `$I+` and restarts it for `$DFU`; null on a
  ///   desk
  /// @param kept memory that survives a restart; null for none
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

  /// Begins a cycle at its boundary and returns its number. To be called in the step interrupt,
  /// every kTurnTicks, after steps that are due before the boundary and before steps that are due
  /// at it. The cycle reads only bytes that have arrived by now.
  std::uint32_t begin_turn() noexcept { return steps_.player().begin_turn(); }

  /// Takes the next cycle whose boundary has passed. Returns false if there is none. A cycle may
  /// run late, and several may run one after the other: the result does not depend on the time, as
  /// long as each ends within kTurnsToMotion. Main loop.
  [[nodiscard]] bool take_turn() { return steps_.take_turn(); }
  /// Returns the number of the cycle that was taken last (wraps).
  [[nodiscard]] std::uint32_t turn() const { return steps_.turn(); }

  /// Runs the cycle that was taken. Lines are read before segments are cut, so that a burst of
  /// lines is planned as one.
  /// @param now microseconds
  void run_turn(hal::TickCount now) {
    protocol_.poll(now);
    machine_.poll(now);
    protocol_.poll(now);
    steps_.end_turn();
  }

  /// Runs a cycle for a host that knows its link: polls that would do nothing are left out.
  /// @param link_waits returns whether the link has a byte
  template <typename LinkWaits>
  void run_turn(hal::TickCount now, const LinkWaits& link_waits) {
    if (link_waits() || !protocol_.is_quiet(now)) protocol_.poll(now);
    machine_.poll(now);
    if (link_waits() || !protocol_.is_quiet(now)) protocol_.poll(now);
    steps_.end_turn();
  }

  /// Begins and runs a cycle, for programs that have both in one thread.
  /// @param now microseconds
  void poll(hal::TickCount now) {
    begin_turn();
    if (take_turn()) run_turn(now);
  }

  /// Handles CAN frames apart from the text: takes those that have arrived and reports the state.
  /// Main loop, before each cycle.
  /// @param now microseconds
  void attend(CanLink& can, hal::TickCount now) {
    const Alarm alarm = machine_.alarm();
    can.tell({.stopped = alarm != Alarm::kNone, .alarm = static_cast<std::uint8_t>(alarm)});
    can.want_node(can_node());
    can.attend(now);
    if (can.take_stop()) machine_.emergency_stop();
    if (const std::uint8_t node = can.take_node_to_store()) can.note_stored(store_can_node(node));
    for (std::byte byte{}; can.take_realtime(byte);) protocol_.act_at_once(byte);
  }

  /// Returns the node number that is set for this controller on a CAN bus.
  [[nodiscard]] std::uint8_t can_node() const {
    return static_cast<std::uint8_t>(machine_.settings().get(setting::kCanNode));
  }
  /// Stores another node number. Returns false if the machine is at work, or if the store fails.
  /// Main loop.
  [[nodiscard]] bool store_can_node(std::uint8_t node) {
    return protocol_.store_setting(setting::kCanNode, static_cast<float>(node));
  }

  /// Handles a realtime byte that came apart from the text, see LineProtocol. Main loop.
  void act_at_once(std::byte byte) { protocol_.act_at_once(byte); }
  /// Returns the number of bytes of text that can be received now. Main loop.
  [[nodiscard]] std::uint32_t text_room() const { return protocol_.room(); }

  /// Returns whether every line must carry a number and a check.
  [[nodiscard]] bool checks_lines() const { return protocol_.checks_lines(); }

  /// Reports that another sender is at the link (begin_sender), or that the sender is gone
  /// (lose_sender). Main loop.
  void begin_sender() { protocol_.begin_sender(); }
  void lose_sender() { protocol_.lose_sender(); }

  /// Checks a part of the memory that does not change at work, so that a flipped bit in settings is
  /// found within 0.2 s. Returns false from the first difference on; the program must then end.
  /// Main loop, once a millisecond.
  [[nodiscard]] bool check_memory() {
    constexpr std::size_t kBytes = 32;
    return machine_.memory().check(kBytes);
  }

  /// Runs the step interrupt. Returns the ticks until the next one; 0 stops the timer.
  std::uint32_t on_step_interrupt() noexcept { return steps_.player().on_interrupt(); }

  [[nodiscard]] Machine& machine() { return machine_; }
  [[nodiscard]] const Machine& machine() const { return machine_; }
  [[nodiscard]] const Steps& steps() const { return steps_; }

 private:
  Steps& steps_;
  Machine machine_;
  LineProtocol protocol_;
};

/// Base class that is constructed before the controller.
template <hal::StepPort Port>
class StepsOfApplication {
 protected:
  explicit StepsOfApplication(Port& port) : steps_{port} {}

  typename Controller<Port>::Steps steps_;
  motion::Pixels pixels_{};
};

/// The whole controller on one port. The simulator makes one for each run.
template <hal::StepPort Port>
class Application : private StepsOfApplication<Port>, public Controller<Port> {
 public:
  /// Parameters as in Controller.
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
