#include "planner/motion/block/power_table.hpp"

#include <algorithm>

namespace cnc::motion {
namespace {

constexpr auto kFullDutyF = static_cast<float>(PowerPoint::kFullDuty);

/// Returns y at x, interpolated between the points, which begin at the origin (0, 0). Where y has a
/// step at x, returns the value after the step.
template <typename X, typename Y>
float interpolated(std::span<const PowerPoint> points, float x, X x_of, Y y_of) {
  float x_before = 0.0F;
  float y_before = 0.0F;
  for (const PowerPoint& point : points) {
    const float x_here = x_of(point);
    const float y_here = y_of(point);
    if (x < x_here) return y_before + (y_here - y_before) * ((x - x_before) / (x_here - x_before));
    x_before = x_here;
    y_before = y_here;
  }
  return y_before;
}

float duty_of(const PowerPoint& point) { return static_cast<float>(point.duty) / kFullDutyF; }

/// Returns a function that computes the power of a point as a share of the last point's power.
/// @pre !points.empty()
auto share_of_last(std::span<const PowerPoint> points) {
  return [most = static_cast<float>(points.back().milliwatts)](const PowerPoint& point) {
    return static_cast<float>(point.milliwatts) / most;
  };
}

}  // namespace

Result<PowerTable, PowerTableError> PowerTable::make(std::span<const PowerPoint> points) {
  if (points.size() > kMaxPoints) return PowerTableError::kTooManyPoints;
  PowerTable table;
  for (const PowerPoint& point : points) {
    if (point.duty > PowerPoint::kFullDuty || point.milliwatts > PowerPoint::kMaxMilliwatts) {
      return PowerTableError::kBeyondRange;
    }
    if (point.duty == 0 && point.milliwatts > 0) return PowerTableError::kLightWithoutDuty;
    const bool first = table.count_ == 0;
    const PowerPoint before = first ? PowerPoint{} : table.points_[table.count_ - 1];
    if (!first && point.duty <= before.duty) return PowerTableError::kDutyNotRising;
    if (!first && point.milliwatts <= before.milliwatts) return PowerTableError::kWattsNotRising;
    table.points_[table.count_++] = point;
  }
  const bool dark = table.count_ > 0 && table.points_[table.count_ - 1].milliwatts == 0;
  if (dark) return PowerTableError::kWattsNotRising;
  return table;
}

float PowerTable::duty_for(float share) const {
  if (count_ == 0) return share;
  return interpolated(points(), share, share_of_last(points()), duty_of);
}

float PowerTable::share_of(float duty) const {
  if (count_ == 0) return duty;
  return interpolated(points(), duty, duty_of, share_of_last(points()));
}

}  // namespace cnc::motion
