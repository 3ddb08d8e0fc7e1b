#pragma once

#include "firmware/machine/rest_light.hpp"
#include "firmware/machine/settings.hpp"
#include "firmware/steps/step_drive.hpp"
#include "planner/gcode/options.hpp"
#include "planner/kinematics/rotary_machine.hpp"
#include "planner/motion/block/limits.hpp"
#include "planner/motion/motors/motor_stage.hpp"

namespace cnc {

/// Conversions of the settings into the types and units of each module. For an axis with backlash,
/// the limits of the planner are reduced by the share that the taking up of play may use
/// (BacklashSetting).
[[nodiscard]] motion::Limits limits_from(const Settings& settings);
[[nodiscard]] motion::MotorStageSetting motor_stage_from(const Settings& settings);
/// Returns the response of the beam. For a spindle, returns a response by which the output is
/// proportional to S.
[[nodiscard]] motion::BeamResponse beam_response_from(const Settings& settings,
                                                      const motion::PowerTable& table);
[[nodiscard]] gcode::Options gcode_options_from(const Settings& settings);
[[nodiscard]] BeamTiming beam_timing_from(const Settings& settings);
[[nodiscard]] RestLight::Allowance rest_light_from(const Settings& settings);
/// Returns the five-axis machine that $900 and the following settings describe.
[[nodiscard]] kinematics::RotaryMachine rotary_machine_from(const Settings& settings);
[[nodiscard]] StepTiming step_timing_from(const Settings& settings);

}  // namespace cnc
