#include "host-sim/surface/path/level_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sim::surface {
namespace {

using cnc::contour::CurveJet;
using Eigen::Vector2d;

Vector2d left_of(const Vector2d& way) { return {-way.y(), way.x()}; }

/// Returns a point of the cubic between two nodes at the parameter `share`, from 0 to 1, with its
/// derivatives by the parameter.
CurveJet cubic_at(const LevelNode& from, const LevelNode& to, double share) {
  const Vector2d way = to.place - from.place;
  const double length = way.norm();
  const Vector2d begin = length * from.after;
  const Vector2d end = length * to.before;
  const Vector2d square = 3.0 * way - 2.0 * begin - end;
  const Vector2d cube = begin + end - 2.0 * way;
  return {from.place + share * (begin + share * (square + share * cube)),
          begin + share * (2.0 * square + share * 3.0 * cube),
          2.0 * square + 6.0 * share * cube};
}

/// Builds curves that follow a level set along given points of the set.
class CurveFollower {
 public:
  CurveFollower(const LevelSet& set,
                const std::vector<Vector2d>& places,
                bool is_low_left,
                const SliceDensity& density)
      : set_{set}, places_{places}, left_{is_low_left ? 1.0 : -1.0}, density_{density} {}

  std::vector<LevelCurve> run() {
    constexpr std::size_t kMaxPlacesAtOnce = 12;
    // A short closed loop is divided into at least two steps, because the ends of a step must
    // differ.
    const std::size_t at_once =
        std::clamp((places_.size() - 1) / 2, std::size_t{1}, kMaxPlacesAtOnce);
    nodes_.push_back({places_.front(), tangent_after(0), tangent_after(0)});
    for (std::size_t done = 0; done + 1 < places_.size();) {
      done = std::min(done + at_once, places_.size() - 1);
      pending_.push_back(node_at(done));
      while (!pending_.empty()) settle();
    }
    end_curve();
    return std::move(curves_);
  }

 private:
  /// A node that is still to be reached, and the index of the last given point that is not after
  /// the node.
  struct Pending {
    LevelNode node;
    std::size_t place = 0;
  };

  [[nodiscard]] Pending node_at(std::size_t place) const {
    const Vector2d before = tangent_before(place);
    const bool ends = place + 1 == places_.size();
    return {{places_[place], before, ends ? before : tangent_after(place)}, place};
  }
  [[nodiscard]] Vector2d tangent_after(std::size_t place) const {
    return tangent(places_[place], places_[place + 1] - places_[place], 1.0);
  }
  [[nodiscard]] Vector2d tangent_before(std::size_t place) const {
    return tangent(places_[place], places_[place] - places_[place - 1], -1.0);
  }

  /// Returns the tangent at a point of the set, computed from a second point at a very short
  /// distance.
  /// @param way approximate direction of the tangent
  /// @param sense 1 if the second point is ahead of `place`, -1 if it is behind `place`
  [[nodiscard]] Vector2d tangent(const Vector2d& place, const Vector2d& way, double sense) const {
    const double ahead = 0.1 * density_.error_mm;
    const Vector2d unit = way.normalized();
    const auto seen = set_.near(place + sense * ahead * unit, left_ * left_of(unit), 4.0 * ahead);
    return seen && *seen != place ? Vector2d{sense * (*seen - place).normalized()} : unit;
  }

  /// Accepts the nearest pending node if one cubic follows the set up to this node. Otherwise
  /// inserts a node before it or, if there is none, ends the curve.
  void settle() {
    const Pending next = pending_.back();
    const LevelNode& last = nodes_.back();
    const double length = (next.node.place - last.place).norm();
    if (length <= density_.min_mm || follows(last, next.node)) return take(next);
    if (next.place > place_ + 1) {
      pending_.push_back(node_at((place_ + next.place) / 2));
      return;
    }
    // Reach of the search, relative to the distance between the nodes. It is sufficient for a
    // narrow notch.
    constexpr double kReach = 4.0;
    const Vector2d way = (next.node.place - last.place) / length;
    const auto middle =
        set_.near(0.5 * (last.place + next.node.place), left_ * left_of(way), kReach * length);
    const bool is_between = middle && (*middle - last.place).dot(way) > 0.1 * length &&
                            (next.node.place - *middle).dot(way) > 0.1 * length;
    if (!is_between) {
      end_curve();
      return take(next);
    }
    const LevelNode node{*middle,
                         tangent(*middle, *middle - last.place, -1.0),
                         tangent(*middle, next.node.place - *middle, 1.0)};
    pending_.push_back({node, place_});
  }

  void take(const Pending& next) {
    if (nodes_.empty() || next.node.place != nodes_.back().place) nodes_.push_back(next.node);
    place_ = next.place;
    pending_.pop_back();
  }

  void end_curve() {
    if (nodes_.size() > 1) curves_.emplace_back(std::move(nodes_), density_.min_mm);
    nodes_.clear();
  }

  [[nodiscard]] bool follows(const LevelNode& from, const LevelNode& to) const {
    constexpr int kMinLooks = 8;
    const double length = (to.place - from.place).norm();
    if (from.after.dot(to.place - from.place) <= 0.0) return false;
    if (to.before.dot(to.place - from.place) <= 0.0) return false;
    const int looks = std::max(kMinLooks, static_cast<int>(std::ceil(length / density_.pitch_mm)));
    for (int i = 1; i < looks; ++i) {
      if (!is_on_set(cubic_at(from, to, static_cast<double>(i) / looks))) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_on_set(const CurveJet& jet) const {
    const double error = 0.5 * density_.error_mm;
    const double above = set_.above(jet.place);
    const Vector2d to_low = left_ * left_of(jet.first.normalized());
    if (above > 0.0) return above <= error || set_.above(jet.place + error * to_low) <= 0.0;
    if (set_.above(jet.place - error * to_low) > 0.0) return true;
    return above >= -error && leaves_little(jet.place, to_low);
  }

  /// Returns whether a point on the low side is near enough to the line. Of the material that a
  /// tool on the line would remove, a tool at the point may leave at most a layer of the permitted
  /// error. The height of the tip is not a sufficient criterion, because a flat bottom is at the
  /// level at any distance from a wall.
  [[nodiscard]] bool leaves_little(const Vector2d& place, const Vector2d& to_low) const {
    constexpr double kReach = 32.0;
    const double error = 0.5 * density_.error_mm;
    const auto line = set_.near(place, to_low, kReach * error);
    if (!line) return false;
    const double rise = set_.above(*line - error * to_low);
    return (*line - place).norm() * rise <= error * std::hypot(rise, error);
  }

  const LevelSet& set_;
  const std::vector<Vector2d>& places_;
  double left_;
  SliceDensity density_;
  std::vector<LevelCurve> curves_;
  std::vector<LevelNode> nodes_;
  std::vector<Pending> pending_;  ///< Nodes that are still to be reached; the nearest node is last.
  /// Index of the last given point that is not after the last accepted node.
  std::size_t place_ = 0;
};

}  // namespace

CurveJet LevelCurve::at(std::size_t span, double share) const {
  const LevelNode& from = nodes_[span];
  const LevelNode& to = nodes_[span + 1];
  const Vector2d way = to.place - from.place;
  if (way.norm() <= min_mm_) return {from.place + share * way, way, {0.0, 0.0}};
  return cubic_at(from, to, share);
}

std::vector<LevelCurve> level_curves(const LevelSet& set,
                                     const std::vector<Vector2d>& places,
                                     bool is_low_left,
                                     const SliceDensity& density) {
  return CurveFollower{set, places, is_low_left, density}.run();
}

}  // namespace sim::surface
