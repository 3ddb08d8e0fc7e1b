#pragma once

#include <cmath>
#include <functional>
#include <numbers>

#include "host-sim/trace/trace_row.hpp"

namespace sim {

struct PenPoint {
  double x_mm;
  double y_mm;
  double z_mm = 0.0;
};

/// Generates the trace of a machine that follows curves from standstill to standstill with a
/// trapezoidal speed. Pictures are compared with this trace.
class StepPen {
 public:
  using Curve = std::function<PenPoint(double)>;  ///< Returns the point at a distance along the
                                                  ///< curve, mm.

  StepPen(TraceSink& sink, double steps_per_mm) : sink_{sink}, steps_per_mm_{steps_per_mm} {}

  void set_duty(float duty) {
    row_.duty = duty;
    emit();
  }

  void wait_ns(std::uint64_t time_ns) { now_ns_ += time_ns; }

  void follow(const Curve& curve, double length_mm, double speed_mm_s, double acceleration_mm_s2) {
    double length = 0.0;
    double speed = 0.0;
    while (length < length_mm) {
      const double braking_mm_s = std::sqrt(2.0 * acceleration_mm_s2 * (length_mm - length));
      speed = std::min({speed + acceleration_mm_s2 * kTickS, speed_mm_s, braking_mm_s + 1e-3});
      length = std::min(length + speed * kTickS, length_mm);
      now_ns_ += kTickNs;
      move_to(curve(length));
    }
  }

  void line(const PenPoint& to, double speed_mm_s, double acceleration_mm_s2) {
    const PenPoint from = at_;
    const PenPoint way{to.x_mm - from.x_mm, to.y_mm - from.y_mm, to.z_mm - from.z_mm};
    const double length = std::hypot(way.x_mm, way.y_mm, way.z_mm);
    const auto curve = [=](double s) {
      const double f = s / length;
      return PenPoint{from.x_mm + f * way.x_mm, from.y_mm + f * way.y_mm, from.z_mm + f * way.z_mm};
    };
    follow(curve, length, speed_mm_s, acceleration_mm_s2);
  }

  /// Moves counter-clockwise around a centre, from the pen's position.
  void arc(const PenPoint& centre, double turns, double speed_mm_s, double acceleration_mm_s2) {
    const PenPoint from = at_;
    const double radius = std::hypot(from.x_mm - centre.x_mm, from.y_mm - centre.y_mm);
    const double start = std::atan2(from.y_mm - centre.y_mm, from.x_mm - centre.x_mm);
    const auto curve = [=](double s) {
      const double angle = start + s / radius;
      return PenPoint{centre.x_mm + radius * std::cos(angle),
                      centre.y_mm + radius * std::sin(angle),
                      from.z_mm};
    };
    follow(curve, turns * 2.0 * std::numbers::pi * radius, speed_mm_s, acceleration_mm_s2);
  }

  void end() { sink_.on_end(now_ns_); }

 private:
  static constexpr std::uint64_t kTickNs = 5'000;
  static constexpr double kTickS = 1e-9 * kTickNs;

  void move_to(const PenPoint& to) {
    at_ = to;
    const cnc::AxisArray<std::int32_t> before = row_.position;
    row_.position[0] = static_cast<std::int32_t>(std::lround(to.x_mm * steps_per_mm_));
    row_.position[1] = static_cast<std::int32_t>(std::lround(to.y_mm * steps_per_mm_));
    row_.position[2] = static_cast<std::int32_t>(std::lround(to.z_mm * steps_per_mm_));
    if (row_.position != before) emit();
  }

  void emit() {
    row_.time_ns = now_ns_;
    sink_.on_row(row_);
  }

  TraceSink& sink_;
  double steps_per_mm_;
  TraceRow row_;
  std::uint64_t now_ns_ = 0;
  PenPoint at_{0.0, 0.0};
};

}  // namespace sim
