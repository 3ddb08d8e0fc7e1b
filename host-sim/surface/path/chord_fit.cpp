#include "host-sim/surface/path/chord_fit.hpp"

#include <algorithm>
#include <cmath>

#include "planner/geometry/vector.hpp"

namespace sim::surface {
namespace {

using Place = cnc::WideVec2;
using cnc::cross;

/// The directions from `right` counter-clockwise to `left`. The angle between both is less than
/// half a turn.
struct Cone {
  Place right;
  Place left;
};

/// Returns points of the curve. The points are close to each other: if a line is within tolerance
/// of two neighbouring points, it is also within tolerance of the curve between them.
std::vector<Place> places_of(const cnc::contour::PlaneCurve& curve,
                             const SpanRange& spans,
                             double tolerance_mm) {
  constexpr double kShareOfTolerance = 0.02;
  std::vector<Place> places{curve.at(spans.from, 0.0).place};
  for (std::size_t span = spans.from; span < spans.to; ++span) {
    // If a cubic is divided into n parts, its distance from the chord of a part is at most its
    // second derivative / 8 n².
    const double bend =
        std::max(curve.at(span, 0.0).second.norm(), curve.at(span, 1.0).second.norm());
    const double parts = std::ceil(std::sqrt(bend / (8.0 * kShareOfTolerance * tolerance_mm)));
    const int count = std::clamp(static_cast<int>(parts), 1, 1'000);
    for (int i = 1; i <= count; ++i) {
      places.emplace_back(curve.at(span, static_cast<double>(i) / count).place);
    }
  }
  return places;
}

/// Finds lines that pass all given points, in order, within a tolerance.
class ChordFinder {
 public:
  ChordFinder(std::vector<Place> places, double tolerance_mm)
      : places_{std::move(places)}, tolerance_mm_{tolerance_mm} {}

  void run(std::vector<ContourVertex>& out) {
    Line line = best_from_start();
    add(line.from, out);
    while (line.end < places_.size()) {
      const Line next = best_after(line);
      add(next.from, out);
      line = next;
    }
    add(places_.back(), out);
  }

 private:
  /// A line within the tolerance of the points from index `begin` up to but not including `end`.
  struct Line {
    Place from;
    Place direction;  ///< Unit vector of the line's direction.
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  static void add(const Place& place, std::vector<ContourVertex>& out) {
    out.push_back({.x = place.x(), .y = place.y(), .bulge = 0.0});
  }

  /// Returns the line from `from` that passes the greatest number of points, beginning with point
  /// `begin`. A line to the curve's end passes exactly through the end.
  [[nodiscard]] Line farthest(const Place& from, std::size_t begin) const {
    Line line{.from = from, .direction = Place::UnitX(), .begin = begin, .end = begin};
    Cone cone{};
    bool open = true;  // Whether all directions are still possible.
    Place reached = from;
    for (std::size_t i = begin; i < places_.size(); ++i) {
      const Place seen = places_[i] - from;
      const double distance = seen.norm();
      const double most = i + 1 == places_.size() ? 1.0e-9 : tolerance_mm_;
      if (distance > most && !narrow(seen, distance, most, open, cone)) break;
      if (distance > most) open = false;
      reached = places_[i];
      line.end = i + 1;
    }
    if (!open) line.direction = direction_in(cone, reached - from);
    return line;
  }

  /// Restricts the cone to the directions that pass the point `seen` within the distance `most`.
  /// Returns false and leaves the cone unchanged if no direction remains.
  static bool narrow(const Place& seen, double distance, double most, bool open, Cone& cone) {
    const double sine = most / distance;
    const double cosine = std::sqrt(1.0 - sine * sine);
    const Place unit = seen / distance;
    const Place normal{-unit.y(), unit.x()};
    const Cone now{cosine * unit - sine * normal, cosine * unit + sine * normal};
    if (open) {
      cone = now;
      return true;
    }
    // A line must not continue past a point where the curve reverses.
    if (unit.dot(cone.right + cone.left) <= 0.0) return false;
    const Cone both{cross(cone.right, now.right) > 0.0 ? now.right : cone.right,
                    cross(cone.left, now.left) < 0.0 ? now.left : cone.left};
    if (cross(both.right, both.left) < 0.0) return false;
    cone = both;
    return true;
  }

  /// Returns the direction of `towards` if the cone contains it, else the nearest side of the cone.
  static Place direction_in(const Cone& cone, const Place& towards) {
    Place unit = towards.normalized();
    if (cross(cone.right, unit) < 0.0) return cone.right;
    if (cross(cone.left, unit) > 0.0) return cone.left;
    return unit;
  }

  [[nodiscard]] Line best_from_start() const { return farthest(places_.front(), 1); }

  /// Returns the line with the greatest `end` among lines that begin on `line`, next to one of its
  /// last points.
  [[nodiscard]] Line best_after(const Line& line) const {
    constexpr std::size_t kTried = 12;
    const std::size_t last = line.end - 1;
    const std::size_t count = std::min(kTried, line.end - line.begin);
    Line best = farthest(beside(line, last), line.end);
    for (std::size_t i = 1; i < count; ++i) {
      const std::size_t index = last - i * (line.end - line.begin) / (2 * kTried);
      const Line other = farthest(beside(line, index), index + 1);
      if (other.end > best.end) best = other;
    }
    if (best.end > line.end) return best;
    // None of these lines reaches the next point. The path then goes exactly through the last
    // point.
    return farthest(places_[last], line.end);
  }

  [[nodiscard]] Place beside(const Line& line, std::size_t index) const {
    const double along = std::max(0.0, line.direction.dot(places_[index] - line.from));
    return line.from + along * line.direction;
  }

  std::vector<Place> places_;
  double tolerance_mm_;
};

}  // namespace

void fit_chords(const cnc::contour::PlaneCurve& curve,
                const SpanRange& spans,
                double tolerance_mm,
                std::vector<ContourVertex>& out) {
  ChordFinder{places_of(curve, spans, tolerance_mm), tolerance_mm}.run(out);
}

}  // namespace sim::surface
