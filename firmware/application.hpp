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

/// The complete program of the controller, for one type of step port. It owns every object except
/// its step generator and its pixels, which a chip may keep in separate memory. It allocates
/// nothing.
template <hal::StepPort Port>
class Controller {
 public:
  /// Number of segments in the queue of the step interrupt. A segment takes at most a millisecond.
  static constexpr std::uint32_t kSegmentQueue = 64;
  using Steps = StepGenerator<Port, kSegmentQueue>;
  /// While one segment is being played, the other segments of the full queue must last until the
  /// main loop adds the next segments, even if a cycle is late.
  static_assert((kSegmentQueue - 1) * motion::SegmentRate::kShortest >=
                (kTurnsToMotion + 2) * kTurnTicks + motion::SegmentRate::kMaxSpare);
  /// The queued levels of the output must last for the same time. kMaxAtOnce places do not count,
  /// because a segment and the end of a motion add several levels together. kMaxShort levels do not
  /// count, because they may be shorter than kShortest.
  static_assert((Steps::kPieces - PowerShift::kMaxAtOnce - motion::LevelRate::kMaxShort) *
                    motion::LevelRate::kShortest >=
                (kTurnsToMotion + 2) * kTurnTicks * motion::kNsPerTick);

  /// @param board object that describes the board for `$I+` and restarts it for `$DFU`; null for a
  ///     program without a board
  /// @param kept memory that survives a restart; null if there is none
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

  /// Begins a cycle at its boundary and returns the cycle's number. Called in the step interrupt
  /// every kTurnTicks. The call comes after the steps that are due before the boundary, and before
  /// the steps that are due at the boundary. The cycle reads only bytes that arrived before this
  /// call.
  std::uint32_t begin_turn() noexcept { return steps_.player().begin_turn(); }

  /// Takes the next cycle whose boundary has passed. Returns false if there is none. A cycle may
  /// run late, and several cycles may run one after the other. The result does not depend on the
  /// time at which a cycle runs, if the cycle ends within kTurnsToMotion cycles after its boundary.
  /// Main loop.
  [[nodiscard]] bool take_turn() { return steps_.take_turn(); }
  /// Returns the number of the cycle that was taken last (wraps).
  [[nodiscard]] std::uint32_t turn() const { return steps_.turn(); }

  /// Runs the cycle that take_turn() took. Lines are read before segments are made, so that lines
  /// that arrive together are planned together.
  /// @param now microseconds
  void run_turn(hal::TickCount now) {
    protocol_.poll(now);
    machine_.poll(now);
    protocol_.poll(now);
    steps_.end_turn();
  }

  /// Runs a cycle for a host that knows the state of its link. Skips polls of the protocol that
  /// would do nothing.
  /// @param link_waits returns whether the link has an unread byte
  template <typename LinkWaits>
  void run_turn(hal::TickCount now, const LinkWaits& link_waits) {
    if (link_waits() || !protocol_.is_quiet(now)) protocol_.poll(now);
    machine_.poll(now);
    if (link_waits() || !protocol_.is_quiet(now)) protocol_.poll(now);
    steps_.end_turn();
  }

  /// Begins and runs a cycle, for programs that run the step interrupt and the main loop in one
  /// thread.
  /// @param now microseconds
  void poll(hal::TickCount now) {
    begin_turn();
    if (take_turn()) run_turn(now);
  }

  /// Serves the CAN link: processes the frames that have arrived, reports the machine's state, and
  /// carries out commands that arrived outside the text. Main loop, before each cycle.
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

  /// Returns this controller's node number on a CAN bus, from the settings.
  [[nodiscard]] std::uint8_t can_node() const {
    return static_cast<std::uint8_t>(machine_.settings().get(setting::kCanNode));
  }
  /// Stores `node` as the setting of the node number. Returns false if the machine is busy, or if
  /// the store fails. Main loop.
  [[nodiscard]] bool store_can_node(std::uint8_t node) {
    return protocol_.store_setting(setting::kCanNode, static_cast<float>(node));
  }

  /// Handles a realtime byte that arrived outside the text, see LineProtocol. Main loop.
  void act_at_once(std::byte byte) { protocol_.act_at_once(byte); }
  /// Returns the number of bytes of text that can be received now. Main loop.
  [[nodiscard]] std::uint32_t text_room() const { return protocol_.room(); }

  /// Returns whether every line must have a number and a check.
  [[nodiscard]] bool checks_lines() const { return protocol_.checks_lines(); }

  /// Report that a new sender uses the link (begin_sender), or that the sender is gone
  /// (lose_sender). Main loop.
  void begin_sender() { protocol_.begin_sender(); }
  void lose_sender() { protocol_.lose_sender(); }

  /// Checks the next part of the memory that only a command may change: the settings, the values
  /// that are computed from them, and the positions. All parts are checked within 0.2 s, so that a
  /// flipped bit in the settings is found within that time. Returns false from the first difference
  /// on; the program must then end. Main loop, once a millisecond.
  [[nodiscard]] bool check_memory() {
    constexpr std::size_t kBytes = 32;
    return machine_.memory().check(kBytes);
  }

  /// Runs the step interrupt. Returns the number of ticks until the next step interrupt; 0 stops
  /// the timer.
  std::uint32_t on_step_interrupt() noexcept { return steps_.player().on_interrupt(); }

  [[nodiscard]] Machine& machine() { return machine_; }
  [[nodiscard]] const Machine& machine() const { return machine_; }
  [[nodiscard]] const Steps& steps() const { return steps_; }

 private:
  Steps& steps_;
  Machine machine_;
  LineProtocol protocol_;
};

/// Base class with the objects that must be constructed before the controller.
template <hal::StepPort Port>
class StepsOfApplication {
 protected:
  explicit StepsOfApplication(Port& port) : steps_{port} {}

  typename Controller<Port>::Steps steps_;
  motion::Pixels pixels_{};
};

/// A Controller together with its step generator and its pixels. The simulator creates one for each
/// run.
template <hal::StepPort Port>
class Application : private StepsOfApplication<Port>, public Controller<Port> {
 public:
  /// `port` drives the motors and the beam. The other parameters have the meaning that they have in
  /// the constructor of Controller.
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
