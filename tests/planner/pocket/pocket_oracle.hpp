#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "planner/pocket/passes.hpp"
#include "tests/planner/contour/exact_distance.hpp"
#include "tests/support/random_source.hpp"

namespace cnc::pocket {

/// Elements by centres, radii and angles, with queries that try all of them.
class PlainContour {
 public:
  /// @param min_area  least area of loops that count, mm²
  void add(const contour::ContourView<double>& contour, double min_area = 0.0) {
    for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
      const std::uint32_t first = contour.loop_begin(loop);
      if (std::abs(area_of(contour, loop)) < min_area) continue;
      for (std::uint32_t i = first; i < contour.loop_ends[loop]; ++i) {
        const auto& from = contour.vertices[i];
        const auto& to = contour.vertices[i + 1 < contour.loop_ends[loop] ? i + 1 : first];
        add_element({from.point(), to.point(), from.bulge});
      }
    }
  }
  /// Computes the area with 128 chords for each arc, as the arcs of a loop may nearly cancel its
  /// area.
  [[nodiscard]] static double area_of(const contour::ContourView<double>& contour,
                                      std::size_t loop) {
    constexpr int kChords = 128;
    double sum = 0.0;
    const std::uint32_t first = contour.loop_begin(loop);
    for (std::uint32_t i = first; i < contour.loop_ends[loop]; ++i) {
      const auto& from = contour.vertices[i];
      const auto& to = contour.vertices[i + 1 < contour.loop_ends[loop] ? i + 1 : first];
      const contour::exact::PlainArc arc{{from.point(), to.point(), from.bulge}};
      for (int k = 0; k < kChords; ++k) {
        const WideVec2 a = k == 0 ? from.point() : arc.at(static_cast<double>(k) / kChords);
        const WideVec2 b =
            k == kChords - 1 ? to.point() : arc.at(static_cast<double>(k + 1) / kChords);
        sum += 0.5 * cross(a, b);
      }
    }
    return sum;
  }
  void add_element(const contour::exact::ChainArc& arc) {
    if ((arc.end - arc.start).norm() == 0.0) return;
    arcs_.push_back(arc);
    plain_.emplace_back(arc);
  }
  [[nodiscard]] bool empty() const { return plain_.empty(); }
  [[nodiscard]] double distance(const WideVec2& place) const {
    double least = 1.0e30;
    for (const auto& arc : plain_) least = std::min(least, arc.distance(place));
    return least;
  }
  /// Returns whether the loops enclose a point, by the angle by which they turn around it: the
  /// angle of each chord, and a full turn if the point is between chord and arc.
  [[nodiscard]] bool encloses(const WideVec2& place) const {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    double turned = 0.0;
    for (const auto& arc : arcs_) {
      const WideVec2 a = arc.start - place;
      const WideVec2 b = arc.end - place;
      turned += std::atan2(cross(a, b), a.dot(b));
      if (arc.bulge == 0.0) continue;
      const WideVec2 chord = arc.end - arc.start;
      if (arc.bulge * cross(chord, WideVec2{place - arc.start}) >= 0.0) continue;
      const WideVec2 left{-chord.y(), chord.x()};
      const double half_sweep = 2.0 * std::atan(arc.bulge);
      const WideVec2 centre = 0.5 * (arc.start + arc.end) + 0.5 / std::tan(half_sweep) * left;
      if ((place - centre).norm() >= (arc.start - centre).norm()) continue;
      turned += arc.bulge > 0.0 ? kTurn : -kTurn;
    }
    return turned > std::numbers::pi;
  }
  [[nodiscard]] std::size_t size() const { return plain_.size(); }
  [[nodiscard]] WideVec2 at(std::size_t element, double share) const {
    return plain_[element].at(share);
  }
  [[nodiscard]] double element_length(std::size_t element) const {
    const auto& arc = arcs_[element];
    const double sweep = 4.0 * std::atan(std::abs(arc.bulge));
    const double chord = (arc.end - arc.start).norm();
    return sweep < 1.0e-9 ? chord : chord * sweep / (2.0 * std::sin(0.5 * sweep));
  }
  [[nodiscard]] double length() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < arcs_.size(); ++i) sum += element_length(i);
    return sum;
  }

 private:
  std::vector<contour::exact::ChainArc> arcs_;
  std::vector<contour::exact::PlainArc> plain_;
};

/// The stock in a pocket: points that the tool can reach, and their distance from the passes.
class PocketOracle {
 public:
  /// @param locus  the offset of the pocket by the radius, which the tests of the offset prove
  PocketOracle(const contour::ContourView<double>& pocket,
               const contour::ContourView<double>& locus,
               double radius)
      : radius_{radius} {
    wall_.add(pocket);
    // A neck of exactly the tool's diameter is a loop that returns on itself, and may have either
    // direction.
    locus_.add(locus, 1.0e-9);
    for (const auto& vertex : pocket.vertices) {
      low_ = low_.cwiseMin(vertex.point());
      high_ = high_.cwiseMax(vertex.point());
    }
  }
  void add_pass(const contour::ContourView<double>& loops) { passes_.add(loops); }
  void add_pass_element(const contour::exact::ChainArc& arc) { passes_.add_element(arc); }
  void add_locus(const contour::ContourView<double>& loops) { locus_.add(loops); }

  [[nodiscard]] bool is_reachable(const WideVec2& place) const {
    if (!wall_.encloses(place)) return false;
    if (wall_.distance(place) >= radius_ + 1.0e-6) return true;
    return !locus_.empty() && locus_.distance(place) <= radius_;
  }

  /// Returns the greatest distance of a reachable point from the passes. It takes random points,
  /// and moves the farthest of them to still greater distances.
  [[nodiscard]] double farthest(proof::Random& random, int points) const {
    struct Found {
      double distance;
      WideVec2 place;
    };
    std::vector<Found> found;
    for (int i = 0; i < points; ++i) {
      const WideVec2 place{random.between(low_.x(), high_.x()),
                           random.between(low_.y(), high_.y())};
      if (is_reachable(place)) found.push_back({passes_.distance(place), place});
    }
    std::ranges::sort(found,
                      [](const Found& a, const Found& b) { return a.distance > b.distance; });
    if (found.size() > kClimbers) found.resize(kClimbers);
    double most = 0.0;
    for (const Found& one : found) most = std::max(most, climb(one.place, one.distance, random));
    return most;
  }

  /// Returns the least distance of the passes from the wall, at points along them.
  [[nodiscard]] double min_clearance() const {
    double least = 1.0e30;
    for (std::size_t i = 0; i < passes_.size(); ++i) {
      for (const double share : {0.0, 0.11, 0.29, 0.5, 0.73, 0.97}) {
        least = std::min(least, wall_.distance(passes_.at(i, share)));
      }
    }
    return least;
  }
  [[nodiscard]] double length() const { return passes_.length(); }
  [[nodiscard]] const PlainContour& wall() const { return wall_; }

 private:
  static constexpr std::size_t kClimbers = 24;

  [[nodiscard]] double climb(WideVec2 place, double distance, proof::Random& random) const {
    double step = 0.3 * radius_;
    for (int i = 0; i < 150 && step > 1.0e-9; ++i) {
      const double angle = random.between(0.0, 2.0 * std::numbers::pi);
      const WideVec2 next = place + step * WideVec2{std::cos(angle), std::sin(angle)};
      const double found = passes_.distance(next);
      if (found > distance && is_reachable(next)) {
        place = next;
        distance = found;
        step *= 1.5;
      } else {
        step *= 0.85;
      }
    }
    return distance;
  }

  double radius_;
  PlainContour wall_;
  PlainContour locus_;
  PlainContour passes_;
  WideVec2 low_{1.0e30, 1.0e30};
  WideVec2 high_{-1.0e30, -1.0e30};
};

}  // namespace cnc::pocket
