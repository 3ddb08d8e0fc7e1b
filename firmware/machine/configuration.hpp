#pragma once

#include "firmware/machine/rest_light.hpp"
#include "firmware/machine/settings.hpp"
#include "firmware/steps/step_drive.hpp"
#include "planner/gcode/options.hpp"
#include "planner/kinematics/rotary_machine.hpp"
#include "planner/motion/block/limits.hpp"
#include "planner/motion/motors/motor_stage.hpp"

namespace cnc {

/// The settings as each room wants them, in its own units.
/// Of an axis with backlash the planner has what taking it up leaves (BacklashSetting).
[[nodiscard]] motion::Limits limits_from(const Settings& settings);
[[nodiscard]] motion::MotorStageSetting motor_stage_from(const Settings& settings);
/// A beam's; a spindle's output is what S asks for.
[[nodiscard]] motion::BeamResponse beam_response_from(const Settings& settings,
                                                      const motion::PowerTable& table);
[[nodiscard]] gcode::Options gcode_options_from(const Settings& settings);
[[nodiscard]] BeamTiming beam_timing_from(const Settings& settings);
[[nodiscard]] RestLight::Allowance rest_light_from(const Settings& settings);
/// The five-axis machine that $900 and those after it describe.
[[nodiscard]] kinematics::RotaryMachine rotary_machine_from(const Settings& settings);
[[nodiscard]] StepTiming step_timing_from(const Settings& settings);

}  // namespace cnc
