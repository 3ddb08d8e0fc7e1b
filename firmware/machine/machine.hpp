#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware/machine/configuration.hpp"
#include "firmware/machine/coolant_output.hpp"
#include "firmware/machine/door_sequence.hpp"
#include "firmware/machine/dwell.hpp"
#include "firmware/machine/homing.hpp"
#include "firmware/machine/input_filter.hpp"
#include "firmware/machine/light_gap.hpp"
#include "firmware/machine/machine_news.hpp"
#include "firmware/machine/machine_types.hpp"
#include "firmware/machine/memory_guard.hpp"
#include "firmware/machine/motion_control.hpp"
#include "firmware/machine/motor_enable.hpp"
#include "firmware/machine/operator_switches.hpp"
#include "firmware/machine/progress.hpp"
#include "firmware/machine/reentry.hpp"
#include "firmware/machine/rest_light.hpp"
#include "firmware/machine/settings.hpp"
#include "firmware/machine/side_trip.hpp"
#include "firmware/machine/state_machine.hpp"
#include "firmware/machine/tool_change.hpp"
#include "firmware/machine/tool_output.hpp"
#include "firmware/machine/travel.hpp"
#include "hal/interface/auxiliary_outputs.hpp"
#include "hal/interface/machine_inputs.hpp"
#include "hal/interface/tick_count.hpp"
#include "planner/compensation/compensator.hpp"
#include "planner/gcode/interpreter.hpp"
#include "planner/pipeline/action_elements.hpp"
#include "planner/pipeline/path_tolerance.hpp"

namespace cnc {

/// The controller without its link: takes lines of G-code, does their actions
/// one after the other, and lets an operator hold, resume, override and abort.
///
/// Main loop only; no call blocks. `poll` keeps everything going.
class Machine {
 public:
  /// @param kept outlives restarts; null where nothing does
  Machine(StepDrive& drive,
          motion::Pixels& pixels,
          hal::AuxiliaryOutputs& outputs,
          hal::MachineInputs& inputs,
          KeptProgress* kept = nullptr);

  // A line at a time.

  /// No line of G-code is taken: alarm, sleep, or a jog or homing cycle in
  /// progress.
  [[nodiscard]] bool locked() const;
  /// Takes a line when the one before is done. A refused line changes nothing.
  /// In check mode it is judged and moves nothing.
  /// @pre !busy() && !locked()
  [[nodiscard]] gcode::Refusal accept(std::string_view line);
  /// What was asked for last is still waiting: for room in the planner, for
  /// standstill, or for time to pass; or homing or a reset is not over yet.
  [[nodiscard]] bool busy() const;

  /// Does what can be done now. Call at least every few milliseconds.
  /// @param now microseconds.
  void poll(hal::TickCount now);

  /// Takes the body of `$J=`: a move of its own, while idle or jogging. Faster
  /// than the axes can is as fast as they can. Modes do not change.
  /// @pre !busy()
  [[nodiscard]] std::optional<JogRefusal> jog(std::string_view words);

  /// Returns why `axes` cannot be homed now, as home() takes them.
  [[nodiscard]] HomingRefusal why_not_home(std::uint8_t axes) const;
  /// Searches the switches of these axes, bit i for axis i; 0 is all, in the
  /// passes of $44…$49. busy() until over. @pre why_not_home(axes) is kNone
  void home(std::uint8_t axes);

  // The operator, at any time.

  void feed_hold();
  void resume();
  void safety_door();
  void jog_cancel();
  /// Nobody is at the link any more: a beam is dark at once, and when all stands still on
  /// its path an alarm follows.
  void lose_link();
  /// Stops at once, output off, modes forgotten. At rest the position stays
  /// known; else an alarm.
  void reset();
  void emergency_stop();
  /// All off until a reset. False where that is not allowed: only in idle or alarm.
  bool sleep();
  /// Into check mode from idle, and out of it by a reset. False where neither is.
  bool toggle_check_mode();
  /// False while the door is open or the emergency stop is pressed, and after
  /// an alarm that asks for a reset first.
  bool unlock();
  /// At power-up: what was stored could not all be read. Nothing moves before a reset and an
  /// unlock.
  void lock_for_damage() { raise_alarm(Alarm::kStoreDamaged); }
  /// The alarm is one that only a reset makes fit to be unlocked.
  [[nodiscard]] bool needs_reset() const { return needs_reset_; }

  void set_overrides(const OverridePercent& percent);
  [[nodiscard]] const OverridePercent& overrides() const { return percent_; }
  /// Only while held at rest; resume() brings the spindle back first.
  void toggle_spindle_stop();
  void toggle_flood();
  void toggle_mist();
  /// The sender takes part in the tool change that M6 asked for: from now on its lines and jogs are
  /// taken, as long as changes_tool(), and resume() goes on. False where no tool is asked for, or
  /// that was said before.
  bool acknowledge_tool();
  [[nodiscard]] bool changes_tool() const { return tool_change_.open(); }
  [[nodiscard]] OperatorSwitches& switches() { return switches_; }
  /// Until the setting is written again; whether lines with / are skipped from now on.
  bool toggle_block_delete();
  /// Lines with / are skipped: $890, or the opposite where it was toggled.
  [[nodiscard]] bool block_delete() const { return interpreter_.options().block_delete; }

  // A program that was interrupted, in machine_reentry.cpp.

  /// How far the last program with numbered lines has come; none when it has ended.
  [[nodiscard]] const Progress& progress() const { return progress_; }
  /// What was stored of one before power-down.
  void set_progress(const Progress& progress);
  /// Where that is, machine coordinates. @pre progress().any()
  [[nodiscard]] Position progress_place() const { return motion_.place_of(progress_.steps); }
  /// It has been interrupted, and all stands still.
  [[nodiscard]] bool interrupted() const;
  /// The motors' counters still mean what they did, or the axes have been homed since.
  [[nodiscard]] bool can_reenter() const { return place_is_kept_ || homed_ != 0; }
  /// What is driven from now on is dark until it passes that place, on the line that was driven
  /// or behind it. A reset ends that. @pre idle(), progress().any(), can_reenter()
  void reenter();
  void stop_reentry() { reentry_.cancel(); }
  [[nodiscard]] bool reenters() const { return reentry_.active(); }

  // Settings.

  /// @pre idle()
  Result<float, SettingError> change_setting(std::uint16_t number, float value);
  [[nodiscard]] const Settings& settings() const { return settings_; }
  /// Ends G43.4, before the axes are moved by themselves or all settings change. @pre idle()
  void end_tool_centre();
  /// How much light the beam gives at which duty. @pre idle()
  void set_power_table(const motion::PowerTable& table);
  [[nodiscard]] const motion::PowerTable& power_table() const { return power_table_; }
  /// What M190, G41 and G42 know of kerfs from now on. @param table its view outlives its use
  void use_kerf(const kerf::SelectedTable& table) { kerf_ = table; }
  [[nodiscard]] const kerf::SelectedTable& kerf() const { return kerf_; }
  /// What was stored at the last power-down. @pre idle()
  void set_places(const gcode::StoredPlaces& places);

  // Memory, in machine_memory.cpp.

  /// Watches settings, memory that follows from them, and places.
  [[nodiscard]] MemoryGuard& memory() { return memory_; }
  /// Any context: the output goes with the motion, and is dark while nothing moves, but for what
  /// rest_light() allows.
  [[nodiscard]] bool rests_dark() const { return tool_.is_dark_at_rest(); }
  /// Any context: for RestLight::allowed().
  [[nodiscard]] RestLight& rest_light() { return rest_light_; }

  // What there is to report.

  [[nodiscard]] MachineStatus status() const;
  [[nodiscard]] MachineState state() const { return status().state; }
  [[nodiscard]] Alarm alarm() const { return alarm_; }
  /// Nothing to do and nothing moving.
  [[nodiscard]] bool idle() const;
  /// Nothing is moving; there may be more to do.
  [[nodiscard]] bool at_rest() const { return motion_.drained() || motion_.halted(); }
  /// A spindle turns; or a beam is lit that does not go with the motion.
  [[nodiscard]] bool tool_runs() const;
  /// A beam is on and goes with a motion that is not held.
  [[nodiscard]] bool beam_works() const;
  /// Without their bounce.
  [[nodiscard]] const hal::InputState& inputs() const { return inputs_.settled(); }
  /// Axes whose machine coordinates are known, bit i for axis i.
  [[nodiscard]] std::uint8_t homed() const { return homed_; }
  /// Where the tool is, machine coordinates.
  [[nodiscard]] Position position() const { return motion_.tool_place(); }
  [[nodiscard]] float feed_now_mm_min() const;
  /// S as the output really is: overridden, and for a beam that of the moment.
  [[nodiscard]] float spindle_now() const;
  [[nodiscard]] gcode::SpindleMode spindle() const { return tool_.mode_now(); }
  [[nodiscard]] gcode::Coolant coolant() const { return coolant_.now(); }
  [[nodiscard]] std::size_t blocks_free() const { return motion_.blocks_free(); }
  /// N of the block being executed; 0 for none.
  [[nodiscard]] std::uint32_t line_number() const { return motion_.line_in_execution(); }
  /// Place 0 and no success before the first.
  [[nodiscard]] const Probe& last_probe() const { return last_probe_; }
  /// Events that are reported once.
  [[nodiscard]] MachineNews& news() { return news_; }
  /// The tool that M6 waits for.
  [[nodiscard]] std::optional<std::uint32_t> pending_tool() const;
  /// Returns once what a door, a lost link or a reset after it leave uncut.
  [[nodiscard]] const Uncut* take_uncut() { return gap_.take_uncut(); }
  /// The last motions of a path are held, and only another motion, G40 or M2 sets them free.
  [[nodiscard]] bool waits_for_g40() const;
  /// Returns whether news(), take_uncut() or the rest light's take_refusal() have something that a
  /// poll reports by itself.
  [[nodiscard]] bool has_news() const {
    return news_.reset_pressed.is_raised() || gap_.has_uncut() || rest_light_.has_refusal();
  }
  /// The last line was M2 or M30.
  [[nodiscard]] bool program_ended() const { return program_ended_; }

  [[nodiscard]] const gcode::Interpreter& interpreter() const { return interpreter_; }
  [[nodiscard]] const MotionControl& motion() const { return motion_; }
  /// Turns of the main loop that took too long for motion to begin in time.
  [[nodiscard]] std::uint32_t late_turns() const { return drive_.late_turns(); }
  /// For whoever wants to see the plan itself; null for nobody.
  void observe(motion::SliceObserver* observer) { motion_.observe(observer); }
  void observe(motion::ShapingObserver* observer) { motion_.motors().observe(observer); }

 private:
  enum class Probing : std::uint8_t { kNo, kMoving, kStopping };
  /// Of splines, in a turn: 0.4 ms on the emulated chip, and as much again for the last step of it.
  static constexpr std::uint32_t kSplinePoints = 300;

  struct JogMove {
    Position end{};
    float feed = 0.0F;
    std::uint32_t line = 0;
  };

  // One turn, in machine.cpp.
  void attend_inputs();
  void attend_mode(std::int32_t elapsed_us);
  void run_actions();
  [[nodiscard]] bool may_light_at_rest() const;
  [[nodiscard]] std::uint16_t duty_at_rest() const;
  void attend_rest_light(std::int32_t elapsed_us);
  [[nodiscard]] MotorEnable::Need motor_need() const;

  // Actions, in machine_actions.cpp; probing in machine_probe.cpp. True when done.
  [[nodiscard]] bool run(const gcode::Action& action);
  [[nodiscard]] bool move(const gcode::Action& action);
  [[nodiscard]] bool probe(const gcode::Action& action);
  [[nodiscard]] bool fail_probe(Alarm alarm);
  [[nodiscard]] bool finish_probe(const gcode::Action& action);
  void end_probe(const Position& place, bool success);
  [[nodiscard]] bool dwell(float seconds);
  [[nodiscard]] bool wait(float seconds);
  [[nodiscard]] bool set_spindle(gcode::SpindleMode mode);
  [[nodiscard]] bool switch_output(const gcode::OutputChange& change);
  [[nodiscard]] bool pause();
  [[nodiscard]] bool change_tool(std::uint32_t tool);
  [[nodiscard]] bool end_program();
  [[nodiscard]] bool takes_rows() const;
  void append(const ActionPart& part);
  void append_row(path::PathItem& item, std::span<const float> speeds);
  [[nodiscard]] bool drive(path::PathItem& item);
  [[nodiscard]] bool standstill();
  [[nodiscard]] UsualTolerance usual_tolerance() const;
  [[nodiscard]] path::Tolerance tolerance() const;

  // A program that was interrupted, in machine_reentry.cpp.
  void note_progress();
  void place_progress(const AxisArray<std::int32_t>& steps);
  void forget_progress();
  void darken_until_place(path::PathItem& item);
  [[nodiscard]] bool drive_rest();

  // Five axes, in machine_five_axes.cpp.
  [[nodiscard]] kinematics::ToolCentre wanted_tool_centre() const;
  [[nodiscard]] bool switch_tool_centre();
  void judge_tool_centre();
  [[nodiscard]] bool leaves_travel(gcode::Actions actions, const Position& from);

  // Jogs, in machine_jog.cpp.
  void attend_jog();
  void append_jog();
  void drive_straight(const Position& end, float feed_mm_s, std::uint32_t line = 0);
  void drop_jog();

  void attend_homing(std::int32_t elapsed_us);  // In machine_homing.cpp.

  // The operator, in machine_operator.cpp.
  void restart();
  void cancel_restart();
  [[nodiscard]] bool tool_turns() const;
  void switch_coolant_by_hand(gcode::Coolant wanted);

  // A tool change, in machine_tool_change.cpp.
  void attend_tool_change();
  void close_tool_change();
  void stop_in_tool_change();
  void drop_in_tool_change();
  void go_back_to(const Position& place);

  // The door, in machine_door.cpp.
  [[nodiscard]] bool door_stops_jog() const;
  void attend_door();
  void end_door();
  void find_gap();
  void pull_out();
  void park();
  void resume_from_door();
  void restore_spindle();
  void restore_coolant();
  [[nodiscard]] bool parks() const;
  [[nodiscard]] std::size_t parking_axis() const;
  void trip_to(StepPosition place, std::uint16_t rate, const motion::BeamCommand& beam);

  // Beside the programmed path, in machine_compensation.cpp.
  [[nodiscard]] bool compensates() const;
  [[nodiscard]] bool has_room();
  [[nodiscard]] const Position& target() const;
  [[nodiscard]] bool follows_kerf() const;
  [[nodiscard]] bool set_kerf_control(const gcode::CutterCompensation& wanted);
  [[nodiscard]] motion::BeamCommand beam_for(bool rapid) const;
  [[nodiscard]] bool set_compensation(const gcode::Action& action);
  [[nodiscard]] bool leave_path(const gcode::Action& action);
  void append_beside(path::PathItem& item);
  void drive_apart(path::PathItem& item);
  void give_out();
  void refuse_path(const compensation::Fault& fault);
  void forget_exit();

  // Ends of the travel, in machine_limits.cpp.
  void stop_for(Alarm alarm);
  [[nodiscard]] gcode::Refusal take_line(std::string_view line);
  [[nodiscard]] gcode::Refusal leave_travel(const Position& from);
  void judge(gcode::Actions actions, const Position& from);
  void hit_limit();
  void set_homed(std::uint8_t axes);

  // Ends of all kinds, in machine_reset.cpp.
  void raise_alarm(Alarm alarm);
  void cut_off();
  void drop_everything();
  void lock_until_homed();

  void watch_memory();
  void trust_places();

  // Settings, in machine_settings.cpp.
  void apply_settings();
  void apply_limits();
  void apply_motor_settings();
  void apply_language_settings();
  [[nodiscard]] bool place_fits() const;

  StepDrive& drive_;
  hal::AuxiliaryOutputs& outputs_;
  hal::MachineInputs& input_port_;
  Settings settings_{};
  motion::PowerTable power_table_{};
  motion::Limits limits_{};
  MemoryGuard memory_{};
  kerf::SelectedTable kerf_{};
  gcode::Interpreter interpreter_{};
  MotionControl motion_;
  ToolOutput tool_;
  RestLight rest_light_{};
  CoolantOutput coolant_;
  Homing homing_;
  SideTrip side_;
  LightGap gap_;
  MotorEnable motor_enable_;
  InputFilter inputs_{};
  StateMachine state_{};
  Alarm alarm_ = Alarm::kNone;
  bool needs_reset_ = false;
  bool cutting_off_ = false;  ///< Motion was cut off; the rest goes at the next turn.
  std::uint8_t homed_ = 0;
  Alarm stopping_for_ = Alarm::kNone;  ///< Holding, for this alarm at standstill.
  DoorSequence door_{};
  Travel travel_{};
  kinematics::ToolCentre tool_centre_{};  ///< As lines have it, in check mode, too.

  gcode::Actions waiting_{};
  ActionElements elements_{};  ///< Of the action that is being driven.
  compensation::Compensator compensator_{};
  gcode::CutterCompensation compensation_{};     ///< What G41 or G42 said.
  Plane compensation_plane_ = Plane::kXY;        ///< Of G41 or G42.
  kerf::KerfCourse kerf_course_{};               ///< While the path follows the kerf.
  std::uint32_t spline_points_ = kSplinePoints;  ///< Budget of this cycle.
  motion::OutputChanges with_next_motion_{};
  std::optional<JogMove> jog_{};  ///< Waits for room in the planner.
  Dwell dwell_{};                 ///< Of an action.
  Dwell restart_dwell_{};         ///< Until spindle or coolant are back.
  bool dwelling_ = false;
  bool pause_seen_ = false;
  bool step_pause_ = false;  ///< The line is done; single block holds before the next.
  bool restarting_ = false;  ///< resume() waits for the spindle.
  OperatorSwitches switches_{};
  std::optional<std::uint32_t> tool_wanted_{};
  ToolChange tool_change_{};
  MachineNews news_{};
  Probing probing_ = Probing::kNo;
  Probe last_probe_{};
  bool program_ended_ = false;

  bool seen_suspended_ = false;
  bool place_is_kept_ = false;  ///< Since progress_ was noted the motors have lost no step.
  Progress progress_{};
  KeptProgress* kept_progress_;
  Reentry reentry_{};

  OverridePercent percent_{};
  hal::TickCount last_poll_{};
  bool polled_ = false;
};

}  // namespace cnc
