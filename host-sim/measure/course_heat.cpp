#include "host-sim/measure/course_heat.hpp"

#include <algorithm>
#include <cmath>

namespace sim {
namespace {

constexpr double kCourseSecondsPerNs = 1.0e-9;
/// Distance that a motion at 2.5 mm/s covers in two milliseconds, mm. A slower motion counts as 2.5
/// mm/s, because the heat has no finite value at rest.
constexpr double kStandstill = 5.0e-3;

}  // namespace

CourseHeat::CourseHeat(const cnc::AxisArray<double>& steps_per_mm, OnPlace on_place)
    : step_mm_{1.0 / steps_per_mm[0], 1.0 / steps_per_mm[1]}, on_place_{std::move(on_place)} {}

void CourseHeat::on_row(const TraceRow& row) {
  const double time_s = static_cast<double>(row.time_ns) * kCourseSecondsPerNs;
  Lit here{.time_s = time_s};
  for (std::size_t axis = 0; axis < steps_.size(); ++axis) {
    const double rest = row.position[axis] * step_mm_[axis];
    here.place[axis] = rest;
    if (row.position[axis] == steps_[axis]) continue;
    const AxisEdge edge{time_s, 0.5 * (rest + steps_[axis] * step_mm_[axis]), rest};
    behind_[axis].add(edge);
    ahead_[axis].add(edge);
    steps_[axis] = row.position[axis];
  }
  // The output may have just gone off, but it was on during the motion to this position.
  here.light = static_cast<double>(std::max(duty_, row.duty));
  duty_ = row.duty;
  if (here.light > 0.0) lit_.push_back(here);
  tell_until(time_s - ahead_[0].lag_s() - kHalf);
}

void CourseHeat::on_end(std::uint64_t) { tell_until(1.0e12); }

void CourseHeat::tell_until(double time_s) {
  while (!lit_.empty() && lit_.front().time_s <= time_s) {
    const Lit& lit = lit_.front();
    std::array<double, 2> way{};
    for (std::size_t axis = 0; axis < way.size(); ++axis) {
      way[axis] = ahead_[axis].position_at(lit.time_s + kHalf) -
                  behind_[axis].position_at(lit.time_s - kHalf);
    }
    const double length = std::max(std::hypot(way[0], way[1]), kStandstill);
    on_place_(lit.place, lit.light * 2.0 * kHalf / length);
    lit_.pop_front();
  }
}

}  // namespace sim
