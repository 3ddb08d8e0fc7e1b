#include "host-sim/cut/predicted_time.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "host-sim/cut/lead.hpp"
#include "host-sim/knowledge/experiment.hpp"

namespace sim::cut {
namespace {

/// A turn below this is none, radians.
constexpr double kTangentTurn = 2.0e-4;

/// What limits the speed along one stroke.
struct Span {
  double length_mm = 0.0;
  double speed_mm_s = 0.0;  ///< At most, by feed and by turning.
  double acceleration_mm_s2 = 0.0;
  double start_mm_s = 0.0;  ///< At most where it begins.
};

double least_of(const std::array<double, 2>& limits) { return std::min(limits[0], limits[1]); }

double along(const std::array<double, 2>& limits, const Place& way) {
  return cnc::order::RapidTime::along(
      limits, std::abs(way.x()), std::abs(way.y()), std::hypot(way.x(), way.y()));
}

/// The speed at which a corner may be passed that is rounded by an arc within the tolerance.
double corner_speed(const Stroke& before, const Stroke& after, const OrderWish& machine) {
  const Place from = tangent_at(before, 1.0);
  const Place to = tangent_at(after, 0.0);
  const double turn = std::abs(std::atan2(drawing::cross(from, to), drawing::dot(from, to)));
  if (turn < kTangentTurn) return 1.0e6;
  const double half_cosine = std::cos(0.5 * turn);
  if (half_cosine < 1.0e-3) return 0.0;
  double radius = machine.junction_deviation_mm * half_cosine / (1.0 - half_cosine);
  // The round takes at most half of either stroke.
  const double room = 0.5 * std::min(length_of(before), length_of(after));
  radius = std::min(radius, room * half_cosine / std::sin(0.5 * turn));
  return std::sqrt(least_of(machine.limits.acceleration_mm_s2) * radius);
}

Span span_of(const Stroke& stroke, const LayerPlan& layer, const OrderWish& machine) {
  const cnc::order::RapidLimits& limits = machine.limits;
  Span span{.length_mm = length_of(stroke)};
  double feed = from_thousandths(layer.condition.cut.speed_um_min) / 60.0;
  if (stroke.purpose == Purpose::kPierce && layer.settings.pierce_s > 0.0) {
    feed = std::min(feed, span.length_mm / layer.settings.pierce_s);
  }
  if (stroke.bulge == 0.0) {
    const Place way = stroke.to - stroke.from;
    span.speed_mm_s = std::min(feed, along(limits.rate_mm_s, way));
    span.acceleration_mm_s2 = along(limits.acceleration_mm_s2, way);
    return span;
  }
  const double radius = span.length_mm / (4.0 * std::abs(std::atan(stroke.bulge)));
  const double most = least_of(limits.acceleration_mm_s2);
  span.speed_mm_s = std::min({feed, least_of(limits.rate_mm_s), std::sqrt(most * radius)});
  // On a circle of radius r the speed grows as v² = a r sin(2 s / r), as turning takes its part of
  // the acceleration. Up to v² = a r that loses as much time as 0.95 of the acceleration would.
  constexpr double kLeftAtMost = 0.95;
  const double turning = span.speed_mm_s * span.speed_mm_s / radius / most;
  span.acceleration_mm_s2 = most * (1.0 - (1.0 - kLeftAtMost) * turning);
  return span;
}

/// Time over a length with speeds at both ends that the acceleration can join.
double time_of(const Span& span, double start, double end) {
  const double a = span.acceleration_mm_s2;
  const double peak_square = std::min(span.speed_mm_s * span.speed_mm_s,
                                      a * span.length_mm + 0.5 * (start * start + end * end));
  const double peak = std::sqrt(peak_square);
  const double ramps = (2.0 * peak_square - start * start - end * end) / (2.0 * a);
  return (2.0 * peak - start - end) / a + std::max(0.0, span.length_mm - ramps) / peak;
}

/// The window over which a limit of jerk spreads changes of speed.
double jerk_window(double speed, double length, const OrderWish& machine) {
  const double jerk = least_of(machine.limits.jerk_mm_s3);
  if (jerk <= 0.0) return 0.0;
  const double full = least_of(machine.limits.acceleration_mm_s2) / jerk;
  return std::min({full, std::sqrt(speed / jerk), std::cbrt(length / (2.0 * jerk))});
}

/// Strokes from rest to rest.
class Row {
 public:
  explicit Row(const OrderWish& machine) : machine_{machine} {}

  [[nodiscard]] bool empty() const { return spans_.empty(); }
  void add(const Span& span, std::size_t stroke) {
    spans_.push_back(span);
    strokes_.push_back(stroke);
  }
  /// Notes the time of each stroke, and begins another row.
  void end(std::vector<double>& times) {
    if (empty()) return;
    const std::vector<double> speeds = joint_speeds();
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      times[strokes_[i]] = time_of(spans_[i], speeds[i], speeds[i + 1]);
    }
    double fastest = 0.0;
    double length = 0.0;
    for (const Span& span : spans_) {
      fastest = std::max(fastest, span.speed_mm_s);
      length += span.length_mm;
    }
    times[strokes_.back()] += jerk_window(fastest, length, machine_);
    spans_.clear();
    strokes_.clear();
  }

 private:
  /// At both ends of all spans: what corners allow, and can be reached from both sides.
  [[nodiscard]] std::vector<double> joint_speeds() const {
    std::vector<double> speeds(spans_.size() + 1, 0.0);
    for (std::size_t i = 1; i < spans_.size(); ++i) {
      speeds[i] = std::min({spans_[i].start_mm_s, spans_[i].speed_mm_s, spans_[i - 1].speed_mm_s});
    }
    const auto reached = [](double from, const Span& span) {
      return std::sqrt(from * from + 2.0 * span.acceleration_mm_s2 * span.length_mm);
    };
    for (std::size_t i = 0; i < spans_.size(); ++i) {
      speeds[i + 1] = std::min(speeds[i + 1], reached(speeds[i], spans_[i]));
    }
    for (std::size_t i = spans_.size(); i-- > 0;) {
      speeds[i] = std::min(speeds[i], reached(speeds[i + 1], spans_[i]));
    }
    return speeds;
  }

  const OrderWish& machine_;
  std::vector<Span> spans_;
  std::vector<std::size_t> strokes_;  ///< Numbers of the spans' strokes.
};

}  // namespace

std::vector<double> stroke_times(const std::vector<Stroke>& strokes,
                                 const LayerPlan& layer,
                                 const OrderWish& machine) {
  std::vector<double> times(strokes.size(), 0.0);
  Row row{machine};
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    if (length_of(strokes[i]) <= 0.0) continue;
    if (strokes[i].dwell_s > 0.0) row.end(times);
    Span span = span_of(strokes[i], layer, machine);
    if (!row.empty()) span.start_mm_s = corner_speed(strokes[i - 1], strokes[i], machine);
    row.add(span, i);
  }
  row.end(times);
  return times;
}

double predicted_time(const std::vector<Stroke>& strokes,
                      const LayerPlan& layer,
                      const OrderWish& machine) {
  double seconds = 0.0;
  for (const Stroke& stroke : strokes) seconds += stroke.dwell_s;
  for (const double time : stroke_times(strokes, layer, machine)) seconds += time;
  return seconds;
}

}  // namespace sim::cut
