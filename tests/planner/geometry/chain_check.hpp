#pragma once

#include <algorithm>
#include <vector>

#include "planner/geometry/arc_fit.hpp"
#include "tests/planner/geometry/exact_spline.hpp"

namespace cnc::exact {

inline std::vector<PathElement> chain_of(const Spline& spline,
                                         const Position& start,
                                         double tolerance) {
  ArcFit fit{spline, start, static_cast<float>(tolerance)};
  std::vector<PathElement> chain;
  while (!fit.done() && chain.size() < 100'000) chain.push_back(fit.next());
  return chain;
}

/// Compares a chain of arcs with the exact spline, in double precision and both directions. All
/// computed distances are upper bounds, because each is the distance to some point.
class ChainCheck {
 public:
  ChainCheck(const Spline& spline, const std::vector<PathElement>& chain) : curve_{spline} {
    for (const PathElement& element : chain) arcs_.emplace_back(element, chain.front().start);
    walk();
    for (const ExactArc& arc : arcs_) look_from(arc);
  }

  [[nodiscard]] double deviation() const { return std::max(curve_to_chain_, chain_to_curve_); }

  /// Corners that exceed the documented bound: the greatest one in radians that the curve itself
  /// does not make within `near`, and their number.
  struct Corners {
    double unfounded = 0.0;
    double smooth = 0.0;  ///< Greatest of the other corners, relative to the documented bound.
    std::size_t count = 0;
  };
  [[nodiscard]] Corners corners(double near) const {
    Corners found;
    for (std::size_t i = 1; i < arcs_.size(); ++i) {
      const double shorter = std::min(arcs_[i - 1].chord(), arcs_[i].chord());
      const double kink = angle_between(arcs_[i - 1].end_tangent(), arcs_[i].start_tangent());
      const double promised = ArcFit::kLargestKink + ArcFit::kKinkRoundingMm / shorter;
      if (kink <= promised) {
        found.smooth = std::max(found.smooth, kink / promised);
        continue;
      }
      ++found.count;
      found.unfounded = std::max(found.unfounded, kink - turn_near(i, near));
    }
    return found;
  }

 private:
  struct Sample {
    double u;
    Vector place;
  };

  /// Checks the distance of points along the curve, closely spaced, from all arcs.
  void walk() {
    const std::size_t count = 400 + 48 * arcs_.size();
    const double step = curve_.segments() / static_cast<double>(count);
    for (std::size_t i = 0; i <= count; ++i) {
      const double u = step * static_cast<double>(i);
      samples_.push_back({u, curve_.at(u)});
      if (i > 0) {
        longest_ = std::max(longest_, distance(samples_[i].place, samples_[i - 1].place));
      }
      double nearest = 1.0e9;
      for (const ExactArc& arc : arcs_) {
        nearest = std::min(nearest, arc.distance_to(samples_.back().place));
      }
      curve_to_chain_ = std::max(curve_to_chain_, nearest);
    }
  }

  /// Checks the distance of points of an arc from the complete curve.
  void look_from(const ExactArc& arc) {
    for (int i = 0; i <= 12; ++i) {
      const Vector q = arc.at(i / 12.0);
      double least = 1.0e9;
      for (const Sample& sample : samples_) least = std::min(least, distance(sample.place, q));
      // The nearest point lies next to one of the samples that are nearer than their neighbours.
      double nearest = least;
      for (std::size_t k = 0; k < samples_.size(); ++k) {
        const double away = distance(samples_[k].place, q);
        if (away > least + longest_) {
          k += static_cast<std::size_t>((away - least) / longest_) - 1;
          continue;
        }
        if (k > 0 && distance(samples_[k - 1].place, q) < away) continue;
        if (k + 1 < samples_.size() && distance(samples_[k + 1].place, q) < away) continue;
        nearest = std::min(nearest, distance_near(q, samples_[k].u));
      }
      chain_to_curve_ = std::max(chain_to_curve_, nearest);
    }
  }

  [[nodiscard]] double distance_near(Vector q, double u) const {
    const double step = samples_[1].u;
    double low = std::max(0.0, u - step);
    double high = std::min(curve_.segments(), u + step);
    for (int i = 0; i < 30; ++i) {
      const double a = low + (high - low) / 3.0;
      const double b = high - (high - low) / 3.0;
      (distance(curve_.at(a), q) < distance(curve_.at(b), q) ? high : low) =
          distance(curve_.at(a), q) < distance(curve_.at(b), q) ? b : a;
    }
    return distance(curve_.at(0.5 * (low + high)), q);
  }

  /// Returns the angle by which the curve itself turns near the beginning of an arc.
  [[nodiscard]] double turn_near(std::size_t arc, double near) const {
    const Vector joint = arcs_[arc].start();
    std::vector<Vector> tangents;
    const double fine = samples_[1].u / 16.0;
    for (const Sample& sample : samples_) {
      if (distance(sample.place, joint) > 2.0 * near) continue;
      for (int i = -16; i <= 16; ++i) {
        const double u = std::clamp(sample.u + fine * i, 0.0, curve_.segments());
        if (distance(curve_.at(u), joint) > near) continue;
        const Vector direction = curve_.direction_at(u);
        if (norm(direction) > 1.0e-9) tangents.push_back(direction);
      }
    }
    double greatest = 0.0;
    for (const Vector& tangent : tangents) {
      greatest = std::max(greatest, angle_between(tangents.front(), tangent));
    }
    return 2.0 * greatest;
  }

  ExactSpline curve_;
  std::vector<ExactArc> arcs_;
  std::vector<Sample> samples_;
  double longest_ = 1.0e-9;  ///< Greatest distance of two consecutive samples, mm.
  double curve_to_chain_ = 0.0;
  double chain_to_curve_ = 0.0;
};

}  // namespace cnc::exact
