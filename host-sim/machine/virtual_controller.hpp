#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "firmware/application.hpp"
#include "hal/host/memory_store.hpp"
#include "hal/host/recording_port.hpp"
#include "hal/interface/byte_stream.hpp"
#include "hal/interface/record_store.hpp"
#include "host-sim/machine/breakdown.hpp"
#include "host-sim/machine/known_link.hpp"
#include "host-sim/machine/machine_model.hpp"
#include "host-sim/machine/play_model.hpp"
#include "host-sim/machine/probe_model.hpp"
#include "host-sim/machine/switch_model.hpp"
#include "host-sim/trace/trace_row.hpp"

namespace sim {

/// The unchanged firmware on a model of the machine, in virtual time. It uses one thread and no
/// clock, and gives the same result for the same bytes at the same times. The main loop runs one
/// cycle per millisecond. The step interrupt runs exactly when it is due.
///
/// The owner of the link decides where bytes come from and how fast time passes: Simulator sends a
/// program, and `kerfline serve` connects an external sender.
class VirtualController {
 public:
  using Firmware = cnc::Application<hal::host::RecordingPort>;
  static constexpr std::uint64_t kTicksPerTurn = cnc::motion::kTicksPerSecond / 1000;
  static constexpr std::uint64_t kNanosecondsPerTick = cnc::motion::kNsPerTick;

  /// Starts a controller with its own store, whose records end with the controller. The link must
  /// outlive the controller.
  VirtualController(hal::ByteStream& link, const MachineModel& model);
  /// Starts a controller with an external store. The link and the store must outlive the
  /// controller.
  VirtualController(hal::ByteStream& link, const MachineModel& model, hal::RecordStore& store);

  /// Adds a sink, which receives every later edge and must outlive the controller.
  void add_sink(TraceSink& sink) { sinks_.push_back(&sink); }

  /// Omits work without effect from now on: polls of the link while no byte waits and the
  /// controller has nothing to send.
  /// @param link the controller's own link; must outlive the controller
  void skip_quiet_polls(const KnownLink& link) { known_link_ = &link; }
  /// Sets whether the firmware checks for memory that has changed by itself. The check is on at the
  /// start. It can find a change only after a planted breakdown.
  void watch_memory(bool watches) { watches_memory_ = watches; }

  /// Plants a breakdown. It replaces a planted breakdown that has not happened yet.
  /// @pre the tick is not in the past
  void plant(const PlantedBreakdown& breakdown) { planted_ = breakdown; }
  /// Returns the number of restarts by breakdowns. Each restart ends motion and beam immediately,
  /// and starts the firmware with the records that it stored.
  [[nodiscard]] std::uint32_t restarts() const { return restarts_; }

  /// Runs one cycle of the main loop, then the interrupts of the following millisecond.
  void turn();

  // The next four functions are the parts of turn(), for tests in which the main loop is late.

  /// Begins the boundary of a cycle.
  void begin_turn();
  /// Makes the main loop take the oldest cycle that has begun and was not taken. Returns the number
  /// of this cycle, which is the number of earlier boundaries; none if there is no such cycle.
  [[nodiscard]] std::optional<std::uint32_t> take_turn();
  /// Runs the main loop's work for the last cycle that was taken.
  void run_turn();
  /// Runs the interrupts of the millisecond after the boundary.
  void pass_turn() { advance_to(now_ + kTicksPerTurn); }
  /// Returns the number of late cycles, which ran after their handover was due.
  [[nodiscard]] std::uint32_t late_turns() const { return firmware_->steps().late_turns(); }

  /// Passes the last row to the sinks and reports the end of the run to them.
  void end();

  [[nodiscard]] std::uint64_t now_ticks() const { return now_; }
  /// Returns the tick of the last interrupt in the last cycle. If that cycle had no interrupt,
  /// returns the tick of its start.
  [[nodiscard]] std::uint64_t last_event_ticks() const { return last_event_; }
  [[nodiscard]] bool step_timer_runs() const { return timer_runs_; }
  /// Returns the firmware. The reference is valid until the controller restarts.
  [[nodiscard]] Firmware& firmware() { return *firmware_; }
  [[nodiscard]] cnc::Machine& machine() { return firmware_->machine(); }
  [[nodiscard]] const cnc::Machine& machine() const { return firmware_->machine(); }
  [[nodiscard]] const hal::host::RecordingPort& port() const { return port_; }
  /// Returns the positions of the axes since power-up, steps: the positions of the motors without
  /// the play.
  [[nodiscard]] PlayModel::Steps axes() const { return play_.axes(port_.position); }
  /// Returns the state of the door and the buttons, which the caller operates. Its limit and probe
  /// inputs are set by the model.
  [[nodiscard]] hal::InputState& panel() { return port_.panel; }

  /// Removes the time after the last interrupt of the last cycle. Thus a run ends with its motion,
  /// not with the cycle in which the firmware noticed the end.
  void take_back_idle_time() { now_ = last_event_; }

 private:
  void advance_to(std::uint64_t tick);
  void play_until(std::uint64_t tick);
  void happen(const PlantedBreakdown& breakdown);
  void restart();
  void follow_settings();
  void feel_machine();
  void touch_machine();
  [[nodiscard]] std::uint64_t steps_undisturbed(const PlayModel::Steps& axes,
                                                const PlayModel::Steps& second) const;
  void report_change();
  void keep_row();
  void hand_out_row();

  MachineModel model_;
  PlayModel play_;
  PlayModel second_play_;  ///< Play of the second motors.
  SwitchModel switches_;
  ProbeModel probe_;
  std::uint32_t settings_revision_ = 0;
  std::uint64_t undisturbed_ = 0;  ///< Number of step interrupts before a contact can change.
  hal::host::RecordingPort port_{};
  hal::host::MemoryStore own_store_{};
  hal::RecordStore& store_;
  hal::ByteStream& link_;
  cnc::KeptProgress kept_progress_{};
  std::optional<Firmware> firmware_;  ///< The firmware; never empty.
  std::optional<PlantedBreakdown> planted_;
  /// Time until the watchdog restarts the controller, ms; 0 while the main loop runs.
  std::uint32_t hangs_ms_ = 0;
  std::uint32_t restarts_ = 0;
  const KnownLink* known_link_ = nullptr;
  bool watches_memory_ = true;
  std::vector<TraceSink*> sinks_;
  std::uint64_t now_ = 0;  ///< Present tick of the step clock.
  /// Tick of the last interrupt in the last cycle, or of the start of that cycle.
  std::uint64_t last_event_ = 0;
  /// Tick of the next step interrupt; valid while the timer runs.
  std::uint64_t next_interrupt_ = 0;
  bool timer_runs_ = false;
  /// State of the outputs at the last change; passed to the sinks after its tick.
  TraceRow row_{};
  bool row_waits_ = false;
};

}  // namespace sim
