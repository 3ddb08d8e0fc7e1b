#pragma once

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/planner/geometry/exact_spline.hpp"

namespace cnc::exact {

/// Computes the least number of arcs in a chain of biarcs within a tolerance of a curve. The joints
/// lie on a grid of points of the curve, and have its tangents. Uses dynamic programming over the
/// grid, in double precision.
///
/// Optimistic: distances are computed from the curve to the biarc only, at samples.
class FewestArcs {
 public:
  FewestArcs(const Spline& spline, double tolerance, std::size_t grid) : tolerance_{tolerance} {
    const ExactSpline curve{spline};
    const std::size_t count = grid * kSamplesPerCell;
    for (std::size_t i = 0; i <= count; ++i) {
      const double u = curve.segments() * static_cast<double>(i) / static_cast<double>(count);
      places_.push_back(curve.at(u));
      if (i % kSamplesPerCell != 0) continue;
      const double inside = std::clamp(u, 1.0e-7, curve.segments() - 1.0e-7);
      const Vector direction = curve.direction_at(inside);
      tangents_.push_back((1.0 / norm(direction)) * direction);
    }
  }

  [[nodiscard]] std::size_t count() const {
    const std::size_t last = tangents_.size() - 1;
    std::vector<std::size_t> fewest(last + 1, std::numeric_limits<std::size_t>::max() / 2);
    fewest[0] = 0;
    std::size_t reach = 0;
    for (std::size_t from = 0; from < last; ++from) {
      const std::size_t sure = reach > from ? from + (reach - from) / 2 : from;
      int misses = 0;
      for (std::size_t to = sure + 1; to <= last && misses < 5; ++to) {
        const std::size_t cost = arcs_between(from, to);
        misses = cost == 0 ? misses + 1 : 0;
        if (cost == 0) continue;
        fewest[to] = std::min(fewest[to], fewest[from] + cost);
        reach = std::max(reach, to);
      }
      // An arc that reaches far can also reach less far.
      for (std::size_t to = from + 1; to <= sure; ++to) {
        fewest[to] = std::min(fewest[to], fewest[from] + 2);
      }
    }
    return fewest[last];
  }

 private:
  static constexpr std::size_t kSamplesPerCell = 2;

  struct Frame {
    Vector start;
    Vector along;  ///< Unit vector of the chord.
    double chord;
    double a;  ///< Angles from the chord to the tangents.
    double b;
  };

  [[nodiscard]] std::size_t arcs_between(std::size_t from, std::size_t to) const {
    const Vector start = places_[from * kSamplesPerCell];
    const Vector end = places_[to * kSamplesPerCell];
    const double chord = distance(start, end);
    if (chord <= 0.0) return 0;
    const Vector along = (1.0 / chord) * (end - start);
    const auto angle = [&](Vector t) { return std::atan2(cross(along, t), dot(along, t)); };
    const Frame frame{start, along, chord, angle(tangents_[from]), angle(tangents_[to])};
    if (std::abs(frame.a + frame.b) < 1.0e-5 && deviation(frame, from, to, 0.5) <= tolerance_) {
      return 1;
    }
    return min_deviation(frame, from, to) <= tolerance_ ? 2 : 0;
  }

  [[nodiscard]] double min_deviation(const Frame& frame, std::size_t from, std::size_t to) const {
    double best = 0.5;
    double least = deviation(frame, from, to, best);
    for (double step = 0.2; step > 0.004 && least > tolerance_ && least < 30.0 * tolerance_;
         step *= 0.5) {
      for (const double share : {best - step, best + step}) {
        if (share <= 0.02 || share >= 0.98) continue;
        const double found = deviation(frame, from, to, share);
        if (found >= least) continue;
        least = found;
        best = share;
      }
    }
    return least;
  }

  [[nodiscard]] double deviation(const Frame& frame,
                                 std::size_t from,
                                 std::size_t to,
                                 double share) const {
    const double w = 0.5 * (frame.b - frame.a);
    const double first = -frame.a - (1.0 - share) * w;
    const double second = frame.b - share * w;
    if (std::max(std::abs(first), std::abs(second)) > 0.5 * std::numbers::pi) return 1.0e9;
    const double part = std::abs(w) < 1.0e-9 ? share : std::sin(share * w) / std::sin(w);
    const double rest =
        std::abs(w) < 1.0e-9 ? 1.0 - share : std::sin((1.0 - share) * w) / std::sin(w);
    const double turn = -(1.0 - share) * w;
    const Vector joint{frame.chord * part * std::cos(turn), frame.chord * part * std::sin(turn)};
    const double direction = frame.a + 2.0 * first;
    const Vector joint_tangent{std::cos(direction), std::sin(direction)};
    const double k1 = 2.0 * std::sin(first) / (frame.chord * part);
    const double k2 = 2.0 * std::sin(second) / (frame.chord * rest);
    const Vector t1{std::cos(frame.a), std::sin(frame.a)};
    const Vector t2{std::cos(frame.b), std::sin(frame.b)};
    const std::size_t count = (to - from) * kSamplesPerCell;
    const std::size_t stride = 1 + count / 80;
    double greatest = 0.0;
    for (std::size_t i = stride; i < count; i += stride) {
      const Vector seen = places_[from * kSamplesPerCell + i] - frame.start;
      const Vector q{dot(seen, frame.along), cross(frame.along, seen)};
      const bool before = dot(q - joint, joint_tangent) < 0.0;
      const Vector r = before ? q : q - Vector{frame.chord, 0.0};
      const double f = (before ? k1 : k2) * dot(r, r) - 2.0 * cross(before ? t1 : t2, r);
      const double across = f / (1.0 + std::sqrt(std::max(0.0, 1.0 + (before ? k1 : k2) * f)));
      greatest = std::max(greatest, std::abs(across));
      if (greatest > 60.0 * tolerance_) return greatest;
    }
    return greatest;
  }

  double tolerance_;
  std::vector<Vector> places_;
  std::vector<Vector> tangents_;
};

}  // namespace cnc::exact
