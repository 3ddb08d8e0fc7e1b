#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware/machine/configuration.hpp"
#include "firmware/machine/motion_control.hpp"
#include "firmware/machine/settings.hpp"
#include "firmware/machine/tool_output.hpp"
#include "hal/interface/auxiliary_outputs.hpp"
#include "hal/interface/tick_count.hpp"
#include "planner/gcode/interpreter.hpp"
#include "planner/geometry/arc_elements.hpp"

namespace cnc {

enum class MachineState : std::uint8_t {
  kIdle,
  kRun,
  kHold,   ///< Feed hold, or a pause of the program (M0): waits for resume().
  kAlarm,  ///< Position or process in doubt: refuses G-code until unlock().
};

/// Grbl's alarm numbers.
enum class Alarm : std::uint8_t {
  kNone = 0,
  kAbortInMotion = 3,
  kProbeAtTarget = 4,  ///< The probe already was in the state it was to reach.
  kProbeMissed = 5,
  kStarved = 13,  ///< Motion was cut off because the planner came too late.
};

/// Percent of the programmed value.
struct OverridePercent {
  int feed = 100;   ///< 10…200.
  int rapid = 100;  ///< 5…100.
  int power = 100;  ///< 10…200.
};

/// The controller without its link: takes lines of G-code, does their actions
/// one after the other, and lets an operator hold, resume, override and abort.
///
/// Main loop only; no call blocks. `poll` keeps everything going.
class Machine {
 public:
  Machine(StepDrive& drive, hal::AuxiliaryOutputs& outputs);

  // A line at a time.

  /// Takes a line when the one before is done. A refused line changes nothing.
  /// @pre !busy(); state() is not kAlarm
  [[nodiscard]] gcode::Refusal accept(std::string_view line);
  /// Actions of the last line are still waiting: for room in the planner, for
  /// standstill, or for time to pass; or an abort is not over yet.
  [[nodiscard]] bool busy() const { return !waiting_.empty() || aborting_; }

  /// Does what can be done now. Call at least every few milliseconds.
  /// @param now microseconds.
  void poll(hal::TickCount now);

  // The operator, at any time.

  void feed_hold();
  void resume();
  void set_overrides(const OverridePercent& percent);
  [[nodiscard]] const OverridePercent& overrides() const { return percent_; }
  /// Stops at once, output off. At rest the position stays known; else alarm 3.
  void abort();
  void unlock() { alarm_ = Alarm::kNone; }

  /// Nothing to do and nothing moving.
  [[nodiscard]] bool idle() const { return waiting_.empty() && motion_.drained(); }
  /// @pre idle()
  Result<float, SettingError> change_setting(std::uint16_t number, float value);

  [[nodiscard]] MachineState state() const;
  [[nodiscard]] Alarm alarm() const { return alarm_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }
  [[nodiscard]] const gcode::Interpreter& interpreter() const { return interpreter_; }
  [[nodiscard]] const MotionControl& motion() const { return motion_; }
  /// For whoever wants to see the plan itself; null for nobody.
  void observe(motion::SliceObserver* observer) { motion_.observe(observer); }
  [[nodiscard]] bool program_ended() const { return program_ended_; }
  /// Where the probe input changed last (G38.x), machine coordinates.
  [[nodiscard]] const std::optional<Position>& probed() const { return probed_; }

 private:
  enum class Probing : std::uint8_t { kNo, kMoving, kStopping };

  void run_actions();
  [[nodiscard]] bool run(const gcode::Action& action);
  [[nodiscard]] bool move_straight(const gcode::Action& action, float feed);
  [[nodiscard]] bool move_arc(const gcode::Action& action);
  [[nodiscard]] bool probe(const gcode::Action& action);
  [[nodiscard]] bool finish_probe(const gcode::Action& action);
  [[nodiscard]] bool dwell(const gcode::Action& action);
  [[nodiscard]] bool switch_output(const gcode::OutputChange& change);
  [[nodiscard]] bool pause(const gcode::Action& action);
  [[nodiscard]] bool end_program();
  void append(const PathElement& element, float feed);
  void apply_settings();
  [[nodiscard]] bool place_fits(std::size_t axis) const;
  void raise_alarm(Alarm alarm);
  void drop_everything();

  StepDrive& drive_;
  hal::AuxiliaryOutputs& outputs_;
  Settings settings_{};
  motion::Limits limits_{};
  gcode::Interpreter interpreter_{};
  MotionControl motion_;
  ToolOutput tool_;

  gcode::Actions waiting_{};
  std::optional<ArcElements> arc_{};  ///< The arc being divided.
  std::uint32_t arc_index_ = 0;
  std::uint32_t lines_accepted_ = 0;
  motion::OutputChanges with_next_motion_{};
  std::int64_t dwell_left_us_ = 0;
  bool dwelling_ = false;
  bool dwell_begins_ = false;
  bool held_ = false;
  bool paused_ = false;
  bool pause_seen_ = false;
  bool aborting_ = false;
  bool abort_in_motion_ = false;
  bool program_ended_ = false;
  Probing probing_ = Probing::kNo;
  std::optional<Position> probed_{};
  Alarm alarm_ = Alarm::kNone;
  OverridePercent percent_{};
  hal::TickCount last_poll_{};
  bool polled_ = false;
};

}  // namespace cnc
