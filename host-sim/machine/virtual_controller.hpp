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

/// The unchanged firmware on a model of the machine, in virtual time: one
/// thread, no clock, the same result for the same bytes at the same times. The
/// main loop turns once a millisecond, the step interrupt exactly when it asks to.
///
/// Whoever owns the link decides where bytes come from and how fast time goes:
/// a program (Simulator) or somebody's sender (`kerfline serve`).
class VirtualController {
 public:
  using Firmware = cnc::Application<hal::host::RecordingPort>;
  static constexpr std::uint64_t kTicksPerTurn = cnc::motion::kTicksPerSecond / 1000;
  static constexpr std::uint64_t kNanosecondsPerTick = cnc::motion::kNsPerTick;

  /// The link must outlive the controller. What it stores is gone with it.
  VirtualController(hal::ByteStream& link, const MachineModel& model);
  /// Link and store must outlive the controller.
  VirtualController(hal::ByteStream& link, const MachineModel& model, hal::RecordStore& store);

  /// Sinks see every edge from now on; they must outlive the controller.
  void add_sink(TraceSink& sink) { sinks_.push_back(&sink); }

  /// Leaves out work that changes nothing from now on: polls of the link where no byte waits and
  /// nothing is to be said. @param link the controller's own; must outlive it
  void skip_quiet_polls(const KnownLink& link) { known_link_ = &link; }
  /// Lets the firmware look for memory that has changed by itself, as it does from the beginning,
  /// or not: where no breakdown is planted it finds none.
  void watch_memory(bool watches) { watches_memory_ = watches; }

  /// In place of one that has not happened yet. @pre the tick is not past
  void plant(const PlantedBreakdown& breakdown) { planted_ = breakdown; }
  /// By breakdowns: each ends motion and beam at once, and starts the firmware over with what it
  /// stored.
  [[nodiscard]] std::uint32_t restarts() const { return restarts_; }

  /// One turn of the main loop and the interrupts of the millisecond after it.
  void turn();

  // The same in parts, for tests in which the main loop comes late.

  /// The boundary of a turn.
  void begin_turn();
  /// The main loop turns to the oldest turn that has begun and was not taken: its number, as
  /// boundaries before its own; none when there is none.
  [[nodiscard]] std::optional<std::uint32_t> take_turn();
  /// Runs the main loop's work of the turn taken last.
  void run_turn();
  /// The interrupts of the millisecond after the boundary.
  void pass_turn() { advance_to(now_ + kTicksPerTurn); }
  /// Turns that were run after what they hand over was due.
  [[nodiscard]] std::uint32_t late_turns() const { return firmware_->steps().late_turns(); }

  /// Hands out the last row and tells the sinks that there are no more.
  void end();

  [[nodiscard]] std::uint64_t now_ticks() const { return now_; }
  /// Of the last interrupt in the last turn, or else its start.
  [[nodiscard]] std::uint64_t last_event_ticks() const { return last_event_; }
  [[nodiscard]] bool step_timer_runs() const { return timer_runs_; }
  /// Until it restarts.
  [[nodiscard]] Firmware& firmware() { return *firmware_; }
  [[nodiscard]] cnc::Machine& machine() { return firmware_->machine(); }
  [[nodiscard]] const cnc::Machine& machine() const { return firmware_->machine(); }
  [[nodiscard]] const hal::host::RecordingPort& port() const { return port_; }
  /// Where the axes are since power-up, in steps: the motors less their play.
  [[nodiscard]] PlayModel::Steps axes() const { return play_.axes(port_.position); }
  /// Door and buttons, for whoever plays the operator; limits and probe in it
  /// are the model's.
  [[nodiscard]] hal::InputState& panel() { return port_.panel; }

  /// Takes back what the last turn went on after its last interrupt: a run ends
  /// with its motion, not with the turn in which that was noticed.
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
  PlayModel second_play_;  ///< Of second motors.
  SwitchModel switches_;
  ProbeModel probe_;
  std::uint32_t settings_revision_ = 0;
  std::uint64_t undisturbed_ = 0;  ///< Step interrupts before a contact can change.
  hal::host::RecordingPort port_{};
  hal::host::MemoryStore own_store_{};
  hal::RecordStore& store_;
  hal::ByteStream& link_;
  cnc::KeptProgress kept_progress_{};
  std::optional<Firmware> firmware_;  ///< Never empty.
  std::optional<PlantedBreakdown> planted_;
  std::uint32_t hangs_ms_ = 0;  ///< Before the watchdog bites; 0 while the main loop runs.
  std::uint32_t restarts_ = 0;
  const KnownLink* known_link_ = nullptr;
  bool watches_memory_ = true;
  std::vector<TraceSink*> sinks_;
  std::uint64_t now_ = 0;             ///< Ticks of the step clock.
  std::uint64_t last_event_ = 0;      ///< Start of the last turn, or an interrupt in it.
  std::uint64_t next_interrupt_ = 0;  ///< Valid while the timer runs.
  bool timer_runs_ = false;
  TraceRow row_{};  ///< Not handed out while its instant lasts.
  bool row_waits_ = false;
};

}  // namespace sim
