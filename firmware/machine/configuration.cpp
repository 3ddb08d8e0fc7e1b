#include "firmware/machine/configuration.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "firmware/machine/tool_output.hpp"
#include "planner/base/units.hpp"

namespace cnc {
namespace {

constexpr float kTicksPerMicrosecond = static_cast<float>(motion::kTicksPerSecond) * 1.0e-6F;

/// Maximum sum of the step rates of all motors, in steps/s. The step interrupt is budgeted for it.
constexpr float kMaxStepsPerSecond = 200'000.0F;

/// Delay, in ticks, between the due time of a step pulse and its two real edges. The interrupt
/// takes most of a microsecond to reach each edge, and the lengths of pulse and pause are measured
/// between the real edges.
constexpr float kTicksToEdges = 8.0F;

/// Share of the maximum step rate that a motor may use. The rest is a reserve, in which late steps
/// catch up, so that their lateness does not accumulate.
constexpr float kSlotUse = 0.97F;

/// Farthest position of an axis from zero, in steps. It is about half of AxisScale::kMaxSteps, so
/// that the distance between the farthest positions on both sides of zero, plus the offset of a
/// tool, still fits. Linear axes have the same reserve in nanometres, because arcs require it.
constexpr std::int32_t kFarthestStep = AxisScale::kMaxSteps / 2 - (1 << 24);
constexpr Coordinate farthest_on(std::size_t axis) {
  constexpr std::int64_t kMax = Coordinate::kFarthestNanometres;
  return Coordinate{axis < kLinearAxisCount ? kMax / 2 : kMax};
}

/// Returns the greatest distance of an axis from machine zero. For all linear axes it is the
/// distance that the linear axis with the most steps per mm allows. The reason is that the planner
/// also turns the chord of an arc by 90 degrees, so that its length on one axis is counted in steps
/// of the other axis of the plane.
Coordinate reach_on(const Settings& settings, std::size_t axis) {
  const bool is_linear = axis < kLinearAxisCount;
  const std::size_t begin = is_linear ? 0 : axis;
  const std::size_t end = is_linear ? kLinearAxisCount : axis + 1;
  Coordinate reach = farthest_on(axis);
  for (std::size_t other = begin; other < end; ++other) {
    const AxisScale scale{settings.get(setting::kStepsPerMm, other)};
    reach = std::min(reach, scale.place_of(kFarthestStep));
  }
  return reach;
}

/// Returns the backlash of an axis in whole steps of its motor.
std::int32_t backlash_steps(const Settings& settings, std::size_t axis) {
  const float steps =
      settings.get(setting::kBacklash, axis) * settings.get(setting::kStepsPerMm, axis);
  return static_cast<std::int32_t>(steps + 0.5F);
}

/// Returns the maximum step rate of a single motor, in steps/s.
float max_of_one_motor(const Settings& settings) {
  const float slot = static_cast<float>(2U * step_timing_from(settings).pulse) + kTicksToEdges;
  return kSlotUse * static_cast<float>(motion::kTicksPerSecond) / slot;
}

void leave_room_for_backlash(std::size_t axis, motion::Limits& limits) {
  constexpr float kRate = 1.0F - motion::BacklashSetting::kRateShare;
  constexpr float kAcceleration = 1.0F - motion::BacklashSetting::kAccelerationShare;
  limits.rate_mm_s[axis] *= kRate;
  limits.acceleration_mm_s2[axis] *= kAcceleration;
  limits.jerk_mm_s3[axis] *= kAcceleration;
  limits.steps_per_s_one_motor *= kRate;
  limits.steps_per_s_all_motors *= kRate;
}

motion::BacklashSetting backlash_from(const Settings& settings, std::size_t axis, float rate) {
  using motion::BacklashSetting;
  const std::int32_t steps = backlash_steps(settings, axis);
  if (steps == 0) return {};
  const float scale = settings.get(setting::kStepsPerMm, axis);
  const float share = BacklashSetting::kAccelerationShare * scale;
  const auto homes_low = static_cast<unsigned>(settings.get(setting::kHomingDirectionInvert));
  return {.steps = steps,
          .rate = BacklashSetting::kRateShare * rate,
          .acceleration = share * settings.get(setting::kAcceleration, axis),
          .jerk = share * settings.get(setting::kJerk, axis),
          // The last motion of homing is the pull-off, in this direction.
          .starts_towards_plus = (homes_low >> axis & 1U) != 0};
}

std::uint32_t to_ticks(float microseconds) {
  return static_cast<std::uint32_t>(std::ceil(microseconds * kTicksPerMicrosecond));
}

}  // namespace

motion::Limits limits_from(const Settings& settings) {
  motion::Limits limits;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    limits.scale[axis] = AxisScale{settings.get(setting::kStepsPerMm, axis)};
    limits.rate_mm_s[axis] = settings.get(setting::kRate, axis) / kSecondsPerMinute;
    limits.acceleration_mm_s2[axis] = settings.get(setting::kAcceleration, axis);
    limits.jerk_mm_s3[axis] = settings.get(setting::kJerk, axis);
  }
  limits.junction_deviation_mm = settings.get(setting::kJunctionDeviation);
  limits.steps_per_s_one_motor = max_of_one_motor(settings);
  limits.steps_per_s_all_motors = kMaxStepsPerSecond;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (backlash_steps(settings, axis) > 0) leave_room_for_backlash(axis, limits);
  }
  return limits;
}

motion::MotorStageSetting motor_stage_from(const Settings& settings) {
  motion::MotorStageSetting stage{.dark_at_rest = settings.get(setting::kLaserMode) != 0.0F};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float rate = settings.get(setting::kRate, axis) / kSecondsPerMinute *
                       settings.get(setting::kStepsPerMm, axis);
    stage.max_steps_per_s[axis] = std::min(rate, max_of_one_motor(settings));
    stage.backlash[axis] = backlash_from(settings, axis, stage.max_steps_per_s[axis]);
    const auto kind = static_cast<std::uint8_t>(settings.get(setting::kShaper, axis));
    if (kind == 0) continue;
    stage.shapers[axis] = {.kind = static_cast<motion::ShaperKind>(kind),
                           .frequency_hz = settings.get(setting::kShaperFrequency, axis),
                           .damping = settings.get(setting::kShaperDamping, axis)};
  }
  return stage;
}

BeamTiming beam_timing_from(const Settings& settings) {
  if (settings.get(setting::kLaserMode) == 0.0F) return {};
  return {.lag = static_cast<std::int32_t>(settings.get(setting::kBeamLag) * kTicksPerMicrosecond),
          .on_delay = to_ticks(settings.get(setting::kBeamOnDelay)),
          .off_delay = to_ticks(settings.get(setting::kBeamOffDelay))};
}

motion::BeamResponse beam_response_from(const Settings& settings, const motion::PowerTable& table) {
  if (settings.get(setting::kLaserMode) == 0.0F) return {};
  return {.table = table, .min_duty = 0.01F * settings.get(setting::kMinBeamPower)};
}

gcode::Options gcode_options_from(const Settings& settings) {
  gcode::Options options;
  options.five_axes = settings.get(setting::kRotaryAxes) != 0.0F;
  options.laser = settings.get(setting::kLaserMode) != 0.0F;
  options.arc.absolute_mm = settings.get(setting::kArcRepairMm);
  options.arc.relative = 0.01F * settings.get(setting::kArcRepairPercent);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    options.reach[axis] = reach_on(settings, axis);
  }
  return options;
}

kinematics::RotaryMachine rotary_machine_from(const Settings& settings) {
  using kinematics::RotaryKind;
  struct Choice {
    RotaryKind kind;
    Axis tilting;
  };
  // Choices in the order of $900's values.
  constexpr std::array<Choice, 7> kChoices{{{RotaryKind::kNone, Axis::kA},
                                            {RotaryKind::kTables, Axis::kA},
                                            {RotaryKind::kTables, Axis::kB},
                                            {RotaryKind::kHeads, Axis::kA},
                                            {RotaryKind::kHeads, Axis::kB},
                                            {RotaryKind::kHeadAndTable, Axis::kA},
                                            {RotaryKind::kHeadAndTable, Axis::kB}}};
  const auto& choice = kChoices[static_cast<std::size_t>(settings.get(setting::kRotaryAxes))];
  const auto reversed = static_cast<unsigned>(settings.get(setting::kRotaryReversed));
  const auto point = [&settings](std::uint16_t first) {
    return Vec3{settings.get(first, 0), settings.get(first, 1), settings.get(first, 2)};
  };
  return {.kind = choice.kind,
          .tilting = choice.tilting,
          .tilt_reversed = (reversed & 1U) != 0,
          .turn_reversed = (reversed & 2U) != 0,
          .tilt_point = point(setting::kTiltPoint),
          .turn_point = point(setting::kTurnPoint),
          .min_tilt_deg = settings.get(setting::kMinTilt),
          .max_tilt_deg = settings.get(setting::kMaxTilt)};
}

RestLight::Allowance rest_light_from(const Settings& settings) {
  if (settings.get(setting::kLaserMode) == 0.0F) return {};
  return {.greatest_duty = to_full_scale(0.01F * settings.get(setting::kRestLightDuty)),
          .longest_us = 1000 * static_cast<std::int32_t>(settings.get(setting::kRestLightTime))};
}

StepTiming step_timing_from(const Settings& settings) {
  return {.pulse = to_ticks(settings.get(setting::kStepPulse)),
          .direction_set_up = to_ticks(settings.get(setting::kDirectionSetUp))};
}

}  // namespace cnc
