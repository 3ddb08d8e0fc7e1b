#include "firmware/machine/configuration.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/units.hpp"

namespace cnc {
namespace {

constexpr float kTicksPerMicrosecond = static_cast<float>(motion::kTicksPerSecond) * 1.0e-6F;

/// Combined limit of all motors: what the step interrupt is budgeted for.
constexpr float kMostStepsPerSecond = 200'000.0F;

/// A motor gets at most 9 of 10 slots, so that lateness never adds up.
constexpr float kSlotUse = 0.9F;

/// Half of what AxisScale holds, so that the way from one end to the other
/// still fits; linear axes have the same reserve in nanometres for their arcs.
constexpr std::int32_t kFarthestStep = AxisScale::kMostSteps / 2;
constexpr Coordinate farthest_on(std::size_t axis) {
  constexpr std::int64_t kMost = Coordinate::kFarthestNanometres;
  return Coordinate{axis < kLinearAxisCount ? kMost / 2 : kMost};
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
  const auto slot = static_cast<float>(2U * step_timing_from(settings).pulse);
  limits.steps_per_s_one_motor = kSlotUse * static_cast<float>(motion::kTicksPerSecond) / slot;
  limits.steps_per_s_all_motors = kMostStepsPerSecond;
  return limits;
}

BeamTiming beam_timing_from(const Settings& settings) {
  if (settings.get(setting::kLaserMode) == 0.0F) return {};
  return {.lag = static_cast<std::int32_t>(settings.get(setting::kBeamLag) * kTicksPerMicrosecond),
          .on_delay = to_ticks(settings.get(setting::kBeamOnDelay)),
          .off_delay = to_ticks(settings.get(setting::kBeamOffDelay))};
}

motion::BeamResponse beam_response_from(const Settings& settings, const motion::PowerTable& table) {
  if (settings.get(setting::kLaserMode) == 0.0F) return {};
  return {.table = table, .least_duty = 0.01F * settings.get(setting::kLeastBeamPower)};
}

gcode::Options gcode_options_from(const Settings& settings) {
  gcode::Options options;
  options.laser = settings.get(setting::kLaserMode) != 0.0F;
  options.arc.absolute_mm = settings.get(setting::kArcRepairMm);
  options.arc.relative = 0.01F * settings.get(setting::kArcRepairPercent);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const AxisScale scale{settings.get(setting::kStepsPerMm, axis)};
    options.reach[axis] = std::min(scale.place_of(kFarthestStep), farthest_on(axis));
  }
  return options;
}

StepTiming step_timing_from(const Settings& settings) {
  return {.pulse = to_ticks(settings.get(setting::kStepPulse)),
          .direction_set_up = to_ticks(settings.get(setting::kDirectionSetUp))};
}

}  // namespace cnc
