#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "planner/contour/contour.hpp"
#include "planner/contour/curve_piece.hpp"

namespace cnc::contour::exact {

/// An arc by both ends and its bulge, as two consecutive vertices store it.
struct ChainArc {
  WideVec2 start{0.0, 0.0};
  WideVec2 end{0.0, 0.0};
  double bulge = 0.0;
};

inline std::vector<ChainArc> arcs_between(std::span<const Vertex<double>> vertices) {
  std::vector<ChainArc> arcs;
  for (std::size_t i = 0; i + 1 < vertices.size(); ++i) {
    arcs.push_back({vertices[i].point(), vertices[i + 1].point(), vertices[i].bulge});
  }
  return arcs;
}

/// Returns the squared distance of a point from a straight edge.
inline double to_edge(const WideVec2& place, const WideVec2& from, const WideVec2& to) {
  const WideVec2 edge = to - from;
  const WideVec2 seen = place - from;
  const double square = edge.squaredNorm();
  const double share = square > 0.0 ? std::clamp(seen.dot(edge) / square, 0.0, 1.0) : 0.0;
  return (seen - share * edge).squaredNorm();
}

/// Computes distances from an arc by its centre and angles, with the library's trigonometry.
class PlainArc {
 public:
  explicit PlainArc(const ChainArc& arc)
      : start_{arc.start}, end_{arc.end}, sweep_{4.0 * std::atan(arc.bulge)} {
    const WideVec2 chord = end_ - start_;
    straight_ = std::abs(sweep_) < 1.0e-7;
    if (straight_) return;
    const double to_centre = 0.5 * chord.norm() / std::tan(0.5 * sweep_);
    const WideVec2 left = WideVec2{-chord.y(), chord.x()} / chord.norm();
    centre_ = 0.5 * (start_ + end_) + to_centre * left;
    radius_ = (start_ - centre_).norm();
    from_ = std::atan2(start_.y() - centre_.y(), start_.x() - centre_.x());
  }
  [[nodiscard]] double distance(const WideVec2& place) const {
    if (straight_) return std::sqrt(to_edge(place, start_, end_));
    const WideVec2 out = place - centre_;
    double turn = std::atan2(out.y(), out.x()) - from_;
    turn = sweep_ > 0.0 ? turn : -turn;
    turn -= 2.0 * std::numbers::pi * std::floor(turn / (2.0 * std::numbers::pi));
    const bool beside = turn <= std::abs(sweep_);
    const double ends = std::min((place - start_).norm(), (place - end_).norm());
    return beside ? std::min(ends, std::abs(out.norm() - radius_)) : ends;
  }
  [[nodiscard]] WideVec2 at(double share) const {
    if (straight_) return start_ + share * (end_ - start_);
    const double angle = from_ + share * sweep_;
    return centre_ + radius_ * WideVec2{std::cos(angle), std::sin(angle)};
  }

 private:
  WideVec2 start_;
  WideVec2 end_;
  WideVec2 centre_{0.0, 0.0};
  double sweep_;
  double radius_ = 0.0;
  double from_ = 0.0;
  bool straight_ = false;
};

/// Computes the distances between a chain of arcs and a piece of a curve, in both directions. It
/// uses none of the fit's functions, but centres, angles and the library's trigonometry.
class BothWays {
 public:
  BothWays(const CurvePiece& piece, std::span<const ChainArc> chain, double tolerance)
      : piece_{piece}, fine_{tolerance / 400.0} {
    for (const ChainArc& arc : chain) circles_.emplace_back(arc);
    sample_curve_finely();
  }

  [[nodiscard]] double curve_to_chain() const {
    double greatest = 0.0;
    for (const WideVec2& place : curve_) {
      double least = std::numeric_limits<double>::max();
      for (const PlainArc& circle : circles_) least = std::min(least, circle.distance(place));
      greatest = std::max(greatest, least);
    }
    return greatest;
  }

  /// The chords between the curve's points increase the result by `fine()` at most.
  [[nodiscard]] double chain_to_curve() const {
    double greatest = 0.0;
    for (const PlainArc& circle : circles_) {
      for (int i = 0; i <= kPlacesOfArc; ++i) {
        const WideVec2 place = circle.at(static_cast<double>(i) / kPlacesOfArc);
        double least = std::numeric_limits<double>::max();
        for (std::size_t k = 0; k + 1 < curve_.size(); ++k) {
          least = std::min(least, to_edge(place, curve_[k], curve_[k + 1]));
        }
        greatest = std::max(greatest, std::sqrt(least));
      }
    }
    return greatest;
  }
  [[nodiscard]] double fine() const { return fine_; }

  /// Returns the direction in which an arc begins, degrees; arriving(), in which it ends.
  [[nodiscard]] static double leaving(const ChainArc& arc) {
    return direction(arc) - 2.0 * degrees(std::atan(arc.bulge));
  }
  [[nodiscard]] static double arriving(const ChainArc& arc) {
    return direction(arc) + 2.0 * degrees(std::atan(arc.bulge));
  }
  [[nodiscard]] static double kink(double from, double to) {
    return std::abs(std::remainder(to - from, 360.0));
  }

 private:
  static constexpr int kPlacesOfArc = 24;

  static double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }
  static double direction(const ChainArc& arc) {
    const WideVec2 chord = arc.end - arc.start;
    return degrees(std::atan2(chord.y(), chord.x()));
  }

  /// Returns the point by paper 1, eq. 3, from the derivatives.
  [[nodiscard]] WideVec2 place_at(double spans) const {
    const double last = std::max(std::floor(piece_.from), std::ceil(piece_.to) - 1.0);
    const double span = std::min(std::floor(spans), last);
    const CurveJet jet = piece_.curve->at(static_cast<std::size_t>(span), spans - span);
    const double pace = std::hypot(jet.first.x(), jet.first.y());
    if (!(pace > 0.0)) return piece_.at(spans).place;
    return jet.place + piece_.offset_mm * WideVec2{jet.first.y(), -jet.first.x()} / pace;
  }

  void sample_curve_finely() {
    constexpr int kCoarse = 400;
    WideVec2 before = place_at(piece_.from);
    double from = piece_.from;
    curve_.push_back(before);
    for (int i = 1; i <= kCoarse; ++i) {
      const double to =
          i == kCoarse ? piece_.to : piece_.from + (piece_.to - piece_.from) * i / kCoarse;
      const WideVec2 after = place_at(to);
      refine(from, before, to, after, 0);
      from = to;
      before = after;
    }
  }
  void refine(double from, const WideVec2& before, double to, const WideVec2& after, int depth) {
    const double middle = 0.5 * (from + to);
    const WideVec2 between = place_at(middle);
    // The middle alone does not represent a curve that bends in both directions.
    const auto off = [&](double share) {
      return to_edge(place_at(from + share * (to - from)), before, after);
    };
    const double farthest = std::max({to_edge(between, before, after), off(0.23), off(0.79)});
    if (depth < 40 && farthest > fine_ * fine_) {
      refine(from, before, middle, between, depth + 1);
      refine(middle, between, to, after, depth + 1);
      return;
    }
    curve_.push_back(between);
    curve_.push_back(after);
  }

  CurvePiece piece_;
  double fine_;
  std::vector<PlainArc> circles_;
  std::vector<WideVec2> curve_;
};

}  // namespace cnc::contour::exact
