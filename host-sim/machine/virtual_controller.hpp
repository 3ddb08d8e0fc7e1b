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

/// The unchanged firmware on a model of the machine, in virtual time: one thread, no clock, the
/// same result for the same bytes at the same times. The main loop runs a cycle once a millisecond,
/// and the step interrupt runs exactly when it is due.
///
/// The owner of the link decides where bytes come from and how fast time passes: Simulator sends a
/// program, and `kerfline serve` connects an external sender.
class VirtualController {
 public:
  using Firmware = cnc::Application<hal::host::RecordingPort>;
  static constexpr std::uint64_t kTicksPerTurn = cnc::motion::kTicksPerSecond / 1000;
  static constexpr std::uint64_t kNanosecondsPerTick = cnc::motion::kNsPerTick;

  /// Starts a controller whose stored records are lost when it is destroyed. The link must outlive
  /// it.
  VirtualController(hal::ByteStream& link, const MachineModel& model);
  /// Starts a controller. The link and the store must outlive it.
  VirtualController(hal::ByteStream& link, const MachineModel& model, hal::RecordStore& store);

  /// Adds a sink, which sees every edge from now on and must outlive the controller.
  void add_sink(TraceSink& sink) { sinks_.push_back(&sink); }

  /// Leaves out work that changes nothing from now on: polls of the link while no byte waits and
  /// the controller has nothing to send.
  /// @param link the controller's own; must outlive it
  void skip_quiet_polls(const KnownLink& link) { known_link_ = &link; }
  /// Sets whether the firmware looks for memory that has changed by itself, as it does from the
  /// beginning. It finds such memory only where a breakdown is planted.
  void watch_memory(bool watches) { watches_memory_ = watches; }

  /// Plants a breakdown, which replaces a planted one that has not happened yet.
  /// @pre the tick is not past
  void plant(const PlantedBreakdown& breakdown) { planted_ = breakdown; }
  /// Returns the number of restarts by breakdowns. Each one ends motion and beam at once and starts
  /// the firmware again with the records that it stored.
  [[nodiscard]] std::uint32_t restarts() const { return restarts_; }

  /// Runs one cycle of the main loop and the interrupts of the millisecond after it.
  void turn();

  // The next four functions are the parts of turn(), for tests in which the main loop comes late.

  /// Begins the boundary of a cycle.
  void begin_turn();
  /// Makes the main loop take the oldest cycle that has begun and was not taken. Returns its
  /// number, which is the count of boundaries before its own; empty if there is no such cycle.
  [[nodiscard]] std::optional<std::uint32_t> take_turn();
  /// Runs the main loop's work of the cycle that was taken last.
  void run_turn();
  /// Runs the interrupts of the millisecond after the boundary.
  void pass_turn() { advance_to(now_ + kTicksPerTurn); }
  /// Returns the number of late cycles: those that ran after their handover was due.
  [[nodiscard]] std::uint32_t late_turns() const { return firmware_->steps().late_turns(); }

  /// Hands out the last row and tells the sinks that no more rows follow.
  void end();

  [[nodiscard]] std::uint64_t now_ticks() const { return now_; }
  /// Returns the tick of the last interrupt in the last cycle, or the start of that cycle if it had
  /// no interrupt.
  [[nodiscard]] std::uint64_t last_event_ticks() const { return last_event_; }
  [[nodiscard]] bool step_timer_runs() const { return timer_runs_; }
  /// Returns the firmware; the reference is valid until the controller restarts.
  [[nodiscard]] Firmware& firmware() { return *firmware_; }
  [[nodiscard]] cnc::Machine& machine() { return firmware_->machine(); }
  [[nodiscard]] const cnc::Machine& machine() const { return firmware_->machine(); }
  [[nodiscard]] const hal::host::RecordingPort& port() const { return port_; }
  /// Returns the positions of the axes since power-up, in steps: those of the motors minus their
  /// play.
  [[nodiscard]] PlayModel::Steps axes() const { return play_.axes(port_.position); }
  /// Returns the door and the buttons, which the caller operates. Its limit and probe inputs belong
  /// to the model.
  [[nodiscard]] hal::InputState& panel() { return port_.panel; }

  /// Takes back the time of the last cycle after its last interrupt: a run ends with its motion,
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
  std::optional<Firmware> firmware_;  ///< Never empty.
  std::optional<PlantedBreakdown> planted_;
  /// Time until the watchdog restarts the controller; 0 while the main loop runs.
  std::uint32_t hangs_ms_ = 0;
  std::uint32_t restarts_ = 0;
  const KnownLink* known_link_ = nullptr;
  bool watches_memory_ = true;
  std::vector<TraceSink*> sinks_;
  std::uint64_t now_ = 0;         ///< Present tick of the step clock.
  std::uint64_t last_event_ = 0;  ///< Tick at which the last cycle began, or of an interrupt in it.
  /// Tick of the next step interrupt; valid while the timer runs.
  std::uint64_t next_interrupt_ = 0;
  bool timer_runs_ = false;
  TraceRow row_{};  ///< Not handed out until its tick is over.
  bool row_waits_ = false;
};

}  // namespace sim
