#include "host-sim/measure/motion_meter.hpp"

#include <algorithm>
#include <cstdlib>

namespace sim {
namespace {

constexpr double kSecondsPerNanosecond = 1.0e-9;

double seconds(std::uint64_t time_ns) {
  return static_cast<double>(time_ns) * kSecondsPerNanosecond;
}

}  // namespace

MotionMeter::MotionMeter(const cnc::AxisArray<double>& steps_per_mm, const MeterWindows& windows)
    : course_{windows.course_s, {}} {
  for (const double scale : steps_per_mm) {
    axes_.push_back({.step = 1.0 / scale,
                     .speed = {1, windows.speed_s},
                     .acceleration = {2, windows.acceleration_s},
                     .jerk = {3, windows.jerk_s}});
  }
}

void MotionMeter::on_row(const TraceRow& row) {
  const double time_s = seconds(row.time_ns);
  course_.advance(time_s);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (row.position[i] != position_[i]) add_edge(i, time_s, position_[i], row.position[i]);
  }
  position_ = row.position;
}

void MotionMeter::add_edge(std::size_t axis, double time_s, std::int32_t from, std::int32_t to) {
  AxisMeter& meter = axes_[axis];
  const double step = meter.step;
  const double position = (static_cast<double>(from) + to) / 2.0 * step;
  const double low = (from - 0.5) * step;
  const double high = (from + 0.5) * step;
  meter.speed.add_edge(time_s, position, low, high);
  meter.acceleration.add_edge(time_s, position, low, high);
  meter.jerk.add_edge(time_s, position, low, high);
  meter.lowest = std::min(meter.lowest, to);
  meter.highest = std::max(meter.highest, to);
  meter.steps += static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(to) - from));
  if (axis < cnc::kLinearAxisCount) course_.add_edge(axis, {time_s, position, to * step});
}

void MotionMeter::on_end(std::uint64_t time_ns) {
  course_.advance(seconds(time_ns));
  course_.finish();
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    AxisMeter& meter = axes_[i];
    const double low = (position_[i] - 0.5) * meter.step;
    const double high = (position_[i] + 0.5) * meter.step;
    meter.speed.finish(low, high);
    meter.acceleration.finish(low, high);
    meter.jerk.finish(low, high);
  }
}

AxisMotion MotionMeter::axis(cnc::Axis which) const {
  const AxisMeter& meter = axes_[cnc::index_of(which)];
  return {.greatest_speed = meter.speed.greatest(),
          .greatest_acceleration = meter.acceleration.greatest(),
          .greatest_jerk = meter.jerk.greatest(),
          .lowest = meter.lowest * meter.step,
          .highest = meter.highest * meter.step,
          .steps = meter.steps};
}

}  // namespace sim
