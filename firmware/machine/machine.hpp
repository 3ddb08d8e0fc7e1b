#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "firmware/machine/actions_in_progress.hpp"
#include "firmware/machine/alarm_sequence.hpp"
#include "firmware/machine/compensated_path.hpp"
#include "firmware/machine/configuration.hpp"
#include "firmware/machine/coolant_output.hpp"
#include "firmware/machine/door_sequence.hpp"
#include "firmware/machine/homing.hpp"
#include "firmware/machine/input_filter.hpp"
#include "firmware/machine/light_gap.hpp"
#include "firmware/machine/machine_news.hpp"
#include "firmware/machine/machine_set_up.hpp"
#include "firmware/machine/machine_types.hpp"
#include "firmware/machine/memory_guard.hpp"
#include "firmware/machine/motion_control.hpp"
#include "firmware/machine/motor_enable.hpp"
#include "firmware/machine/operator_switches.hpp"
#include "firmware/machine/poll_clock.hpp"
#include "firmware/machine/probe_cycle.hpp"
#include "firmware/machine/program_progress.hpp"
#include "firmware/machine/rest_light.hpp"
#include "firmware/machine/resumption.hpp"
#include "firmware/machine/settings.hpp"
#include "firmware/machine/side_trip.hpp"
#include "firmware/machine/state_machine.hpp"
#include "firmware/machine/tool_change.hpp"
#include "firmware/machine/tool_output.hpp"
#include "firmware/machine/travel.hpp"
#include "hal/interface/auxiliary_outputs.hpp"
#include "hal/interface/machine_inputs.hpp"
#include "hal/interface/tick_count.hpp"
#include "planner/gcode/interpreter.hpp"
#include "planner/pipeline/action_elements.hpp"
#include "planner/pipeline/path_tolerance.hpp"

namespace cnc {

/// The controller without the link to the sender. It takes lines of G-code, runs their actions in
/// order, and lets the operator hold, resume, override and abort.
///
/// Main loop only; no call blocks. `poll` advances all activities.
class Machine {
 public:
  /// @param kept memory that survives restarts; null if there is none
  Machine(StepDrive& drive,
          motion::Pixels& pixels,
          hal::AuxiliaryOutputs& outputs,
          hal::MachineInputs& inputs,
          KeptProgress* kept = nullptr);

  // Lines of G-code.

  /// Returns whether no line of G-code is accepted: in an alarm, asleep, or during a jog or a
  /// homing cycle.
  [[nodiscard]] bool locked() const;
  /// Takes the next line of G-code. A refused line changes nothing. In check mode the line is
  /// checked and moves nothing.
  /// @pre !busy() && !locked()
  [[nodiscard]] gcode::Refusal accept(std::string_view line);
  /// Returns whether no further line is accepted yet. Either the last line waits for free space in
  /// the planner, for standstill or for the end of a dwell; or homing, a stop or a reset is not
  /// complete.
  [[nodiscard]] bool busy() const;

  /// Advances all activities. To be called at least every few milliseconds.
  /// @param now microseconds
  void poll(hal::TickCount now);

  /// Takes a jog: `words` is the text after `$J=`. The machine must be idle, jogging or in an open
  /// tool change. A feed above the limits of the axes is reduced to these limits. The modes of the
  /// program do not change.
  /// @pre !busy()
  [[nodiscard]] std::optional<JogRefusal> jog(std::string_view words);

  /// Returns the reason why home(axes) is refused now; kNone if it is allowed.
  [[nodiscard]] HomingRefusal why_not_home(std::uint8_t axes) const;
  /// Begins to home `axes`: bit i for axis i, 0 for all axes in the passes of $44…$49. busy() is
  /// true until homing is complete.
  /// @pre why_not_home(axes) is kNone
  void home(std::uint8_t axes);

  // Commands of the operator, allowed at any time.

  void feed_hold();
  void resume();
  void safety_door();
  void jog_cancel();
  /// Stops because the sender is silent. A beam goes off immediately, the motors brake along the
  /// path, and an alarm follows at rest.
  void lose_link();
  /// Stops immediately with the output off, and resets the modes. If the machine was at rest, its
  /// position stays known. Otherwise an alarm follows.
  void reset();
  void emergency_stop();
  /// Switches everything off until a reset. Returns false if the machine is neither idle nor in an
  /// alarm.
  bool sleep();
  /// Enters check mode if the machine is idle, or leaves it by a reset. Returns false if neither is
  /// possible.
  bool toggle_check_mode();
  /// Ends an alarm. Returns false if the door is open, if the emergency stop is pressed, or if the
  /// alarm requires a reset first.
  bool unlock();
  /// Locks the machine at power-up because some stored data could not be read. Nothing moves before
  /// a reset and an unlock.
  void lock_for_damage() { raise_alarm(Alarm::kStoreDamaged); }
  /// Returns whether the alarm can be unlocked only after a reset.
  [[nodiscard]] bool needs_reset() const { return alarm_.needs_reset(); }

  void set_overrides(const OverridePercent& percent);
  [[nodiscard]] const OverridePercent& overrides() const { return switches_.overrides; }
  /// Stops or restarts the spindle. Has an effect only in a hold at rest. resume() restarts a
  /// stopped spindle before the motion.
  void toggle_spindle_stop();
  /// Toggles mist, flood or both. Has an effect only in Idle, Run and Hold.
  void toggle_coolant(gcode::Coolant which);
  /// Lets the sender take part in the tool change that M6 requested. While tool_change().open(),
  /// its lines and jogs are accepted as part of the tool change. resume() continues the program.
  /// Returns false if no tool change is pending, or if the sender takes part already.
  bool acknowledge_tool();
  [[nodiscard]] const ToolChange& tool_change() const { return tool_change_; }
  [[nodiscard]] OperatorSwitches& switches() { return switches_; }
  /// Toggles block delete. The toggle lasts until $890 is written. Returns whether lines with `/`
  /// are skipped from now on.
  bool toggle_block_delete();

  // An interrupted program, in machine_reentry.cpp.

  /// Returns the progress of the last program. The protocol stores and restores it.
  [[nodiscard]] ProgramProgress& progress() { return progress_; }
  /// Returns whether a program has been interrupted and all axes are at rest.
  [[nodiscard]] bool interrupted() const;
  /// Begins re-entry. All further motion has the beam off until it passes the noted position, on
  /// the noted line or a later one. A reset ends re-entry.
  /// @pre idle(), progress().noted().any(), progress().can_reenter(homed())
  void reenter();

  // Settings.

  /// Changes a setting. Returns the stored value or an error.
  /// @pre idle()
  Result<float, SettingError> change_setting(std::uint16_t number, float value);
  [[nodiscard]] const Settings& settings() const { return set_up_.settings(); }
  /// Ends G43.4, because single axes are to be moved or all settings are to change.
  /// @pre idle()
  void end_tool_centre();
  /// Sets the power table: the light power of the beam at each duty.
  /// @pre idle()
  void set_power_table(const motion::PowerTable& table);
  [[nodiscard]] const motion::PowerTable& power_table() const { return set_up_.power_table(); }
  /// Sets the kerf table that M190, G41 and G42 use from now on.
  /// @param table its view must outlive its use
  void use_kerf(const kerf::SelectedTable& table) { compensated_.use_kerf(table); }
  /// Sets the positions (origins, tool radii, G28 and G30) that were loaded from the store.
  /// @pre idle()
  void set_places(const gcode::StoredPlaces& places);

  // Memory, in machine_memory.cpp.

  /// Returns the guard that checks the settings, the memory that is computed from them, and the
  /// positions for flipped bits.
  [[nodiscard]] MemoryGuard& memory() { return memory_; }
  /// Returns the control of the light at rest, on which any context may call RestLight::allowed().
  [[nodiscard]] RestLight& rest_light() { return rest_light_; }

  // Functions that return the state, for reports.

  [[nodiscard]] MachineStatus status() const;
  [[nodiscard]] MachineState state() const { return status().state; }
  [[nodiscard]] Alarm alarm() const { return alarm_.now(); }
  /// Returns whether no action is waiting and nothing moves.
  [[nodiscard]] bool idle() const;
  /// Returns whether a spindle is on, or a beam is on at rest.
  [[nodiscard]] bool tool_runs() const;
  /// Returns whether a beam is on: during motion that is not held, or as light at rest.
  [[nodiscard]] bool beam_works() const;
  /// Returns the filtered inputs.
  [[nodiscard]] const hal::InputState& inputs() const { return inputs_.settled(); }
  /// Returns the axes whose machine coordinates are known, bit i for axis i.
  [[nodiscard]] std::uint8_t homed() const { return travel_.homed(); }
  /// Returns the present S of the output, with the override. For a beam, it includes the present
  /// effect of the speed.
  [[nodiscard]] float spindle_now() const;
  [[nodiscard]] gcode::Coolant coolant() const { return coolant_.now(); }
  /// Returns the result of the last probe. Before the first probe, the result has the position 0
  /// and is no success.
  [[nodiscard]] const Probe& last_probe() const { return probing_.last(); }
  /// Returns the events that the protocol takes and reports, each once.
  [[nodiscard]] MachineNews& news() { return news_; }
  /// Returns, once, the part of the path that a door, a lost link or a following reset leaves
  /// uncut; null if there is none.
  [[nodiscard]] const Uncut* take_uncut() { return gap_.take_uncut(); }
  /// Returns whether the last motions of a compensated path wait in the compensator for another
  /// motion, G40 or M2.
  [[nodiscard]] bool waits_for_g40() const;
  /// Returns whether news(), take_uncut() or the rest light's take_refusal() contain an event that
  /// the protocol reports without a request.
  [[nodiscard]] bool has_news() const {
    return news_.reset_pressed.is_raised() || gap_.has_uncut() || rest_light_.has_refusal();
  }

  [[nodiscard]] const gcode::Interpreter& interpreter() const { return interpreter_; }
  /// Returns the motion: the tool's position, the speed, the line being driven, free blocks.
  [[nodiscard]] const MotionControl& motion() const { return motion_; }
  /// Returns the output for the beam or spindle.
  [[nodiscard]] const ToolOutput& tool() const { return tool_; }
  /// Returns the number of boundaries at which a due cycle was not complete, so that motion may
  /// have begun too late.
  [[nodiscard]] std::uint32_t late_turns() const { return drive_.late_turns(); }
  /// Sets an observer of the plan; null for none.
  void observe(motion::SliceObserver* observer) { motion_.observe(observer); }
  void observe(motion::ShapingObserver* observer) { motion_.motors().observe(observer); }

 private:
  struct JogMove {
    Position end{};
    float feed = 0.0F;
    std::uint32_t line = 0;
  };

  // One cycle, in machine.cpp.
  void attend_inputs();
  void attend_mode(std::int32_t elapsed_us);
  void run_actions();
  [[nodiscard]] bool may_light_at_rest() const;
  [[nodiscard]] std::uint16_t duty_at_rest() const;
  void attend_rest_light(std::int32_t elapsed_us);
  [[nodiscard]] MotorEnable::Need motor_need() const;

  // Actions, in machine_actions.cpp; probing in machine_probe.cpp. A bool result says whether the
  // action is done.
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

  // An interrupted program, in machine_reentry.cpp.
  void note_progress();
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

  // The compensated path, in machine_compensation.cpp.
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

  // Alarms, resets and cut-offs, in machine_reset.cpp.
  void raise_alarm(Alarm alarm);
  void cut_off();
  void drop_everything();
  void lock_until_homed();

  void watch_memory();
  void trust_places();

  // Settings, in machine_settings.cpp.
  void apply_settings();
  void apply_motor_settings();
  void apply_language_settings();
  [[nodiscard]] bool place_fits() const;

  // Small members come first, because one load instruction of the chip reaches only the first 4 KiB
  // of an object.
  StepDrive& drive_;
  hal::AuxiliaryOutputs& outputs_;
  hal::MachineInputs& input_port_;
  StateMachine state_{};
  AlarmSequence alarm_{};
  OperatorSwitches switches_{};
  Resumption resumption_{};
  ProbeCycle probing_{};
  DoorSequence door_{};
  MachineNews news_{};
  ToolOutput tool_;
  RestLight rest_light_{};
  CoolantOutput coolant_;
  InputFilter inputs_{};
  PollClock clock_{};
  LightGap gap_;
  std::optional<JogMove> jog_{};  ///< Jog that waits for free space in the planner.
  Travel travel_{};
  /// State of G43.4 after the last line that was executed, or checked in check mode.
  kinematics::ToolCentre tool_centre_{};
  ProgramProgress progress_;
  MachineSetUp set_up_{};
  MotorEnable motor_enable_;
  Homing homing_;
  MemoryGuard memory_{};
  ActionsInProgress actions_{};
  CompensatedPath compensated_{};
  gcode::Interpreter interpreter_{};
  ToolChange tool_change_{};
  MotionControl motion_;
  SideTrip side_;
};

}  // namespace cnc
