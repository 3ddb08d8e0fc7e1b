#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "planner/path/path_stage.hpp"
#include "tests/support/exact_block.hpp"
#include "tests/support/random_source.hpp"

namespace cnc::path {

using Place = AxisArray<double>;

using proof::to_mm;

inline double distance(const Place& a, const Place& b) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  }
  return std::sqrt(sum);
}

inline double dot(const Place& a, const Place& b) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) sum += a[axis] * b[axis];
  return sum;
}

/// Returns a + share · b.
inline Place sum_of(const Place& a, double share, const Place& b) {
  Place sum = a;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) sum[axis] += share * b[axis];
  return sum;
}

/// Returns a direction in X Y Z, sometimes with rotary axes.
inline Place any_direction(proof::Random& random) {
  const std::size_t axes = random.chance(0.1) ? kAxisCount : kLinearAxisCount;
  Place direction{};
  for (std::size_t axis = 0; axis < axes; ++axis) direction[axis] = random.between(-1.0, 1.0);
  return sum_of({}, 1.0 / std::sqrt(dot(direction, direction)), direction);
}

/// A path element in double precision.
class ExactElement : private proof::ExactBlock {
 public:
  explicit ExactElement(const PathElement& element)
      : ExactBlock{element}, chord_{distance(to_mm(element.start), to_mm(element.end))} {}

  using ExactBlock::length;
  using ExactBlock::radius;
  [[nodiscard]] Place at(double share) const { return place_at(share); }
  [[nodiscard]] double chord() const { return chord_; }
  /// Returns the unit direction.
  [[nodiscard]] Place tangent(bool at_end) const { return tangent_at(at_end ? 1.0 : 0.0); }

  /// Returns the distance of a point from the element, by sampling and narrowing, to 1e-8 mm.
  [[nodiscard]] double distance_to(const Place& place) const {
    double low = 0.0;
    double high = 1.0;
    double best = 1.0e9;
    double at_best = 0.0;
    for (int round = 0; round < 12; ++round) {
      constexpr int kParts = 16;
      const double step = (high - low) / kParts;
      for (int i = 0; i <= kParts; ++i) {
        const double share = low + step * i;
        const double here = distance(at(share), place);
        if (here < best) {
          best = here;
          at_best = share;
        }
      }
      if (step * length() < 1.0e-8) break;
      low = std::max(0.0, at_best - step);
      high = std::min(1.0, at_best + step);
    }
    return best;
  }

 private:
  double chord_;
};

/// Returns the distance of a point from a path.
inline double distance_from(const Place& place, const std::vector<ExactElement>& path) {
  double least = 1.0e9;
  for (const ExactElement& element : path) {
    // No point of an element is farther from its ends than its length.
    const double ends =
        std::min(distance(element.at(0.0), place), distance(element.at(1.0), place));
    if (ends - element.length() >= least) continue;
    least = std::min(least, element.distance_to(place));
  }
  return least;
}

/// Returns the greatest distance of points of one path from another.
inline double farthest(const std::vector<ExactElement>& of,
                       const std::vector<ExactElement>& from,
                       int samples) {
  double greatest = 0.0;
  for (const ExactElement& element : of) {
    for (int i = 0; i <= samples; ++i) {
      const Place place = element.at(static_cast<double>(i) / samples);
      greatest = std::max(greatest, distance_from(place, from));
    }
  }
  return greatest;
}

inline std::vector<ExactElement> exact(const std::vector<PathItem>& items) {
  std::vector<ExactElement> path;
  for (const PathItem& item : items) path.emplace_back(item.request.element);
  return path;
}
inline std::vector<ExactElement> exact(const std::vector<PathPiece>& pieces) {
  std::vector<ExactElement> path;
  for (const PathPiece& piece : pieces) path.emplace_back(piece.request.element);
  return path;
}

inline motion::Limits path_limits() {
  motion::Limits limits;
  limits.rate_mm_s.fill(500.0F);
  limits.acceleration_mm_s2.fill(500.0F);
  // The resolution is so fine that no line is shorter than half a step.
  limits.scale.fill(AxisScale{AxisScale::kMaxStepsPerMm});
  limits.steps_per_s_one_motor = limits.steps_per_s_all_motors = 1.0e9F;
  return limits;
}

/// A program as items, written in millimetres on a grid of nanometres.
class Pen {
 public:
  explicit Pen(const Tolerance& tolerance) { item_.tolerance = tolerance; }

  void line(const Place& travel) { arc(travel, Plane::kXY, 0.0); }
  void arc(const Place& travel, Plane plane, double bulge) {
    item_.request.element = {.start = place_, .end = place_, .plane = plane};
    item_.request.element.bulge = static_cast<float>(bulge);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      item_.request.element.end[axis] +=
          Coordinate{std::llround(travel[axis] * 1.0e6 / static_cast<double>(grid_nm)) * grid_nm};
    }
    if (item_.request.element.start == item_.request.element.end) return;
    item_.request.line = static_cast<std::uint32_t>(items.size() + 1);
    items.push_back(item_);
    place_ = item_.request.element.end;
    item_.request.outputs = {};
  }
  motion::MotionRequest& request() { return item_.request; }

  std::int64_t grid_nm = 1;
  std::vector<PathItem> items;

 private:
  PathItem item_{.request = {.feed_mm_s = 200.0F}};
  Position place_{};
};

/// Returns the pieces that the stage makes of a program that comes without a pause.
inline std::vector<PathPiece> staged(const std::vector<PathItem>& items,
                                     const motion::Limits& limits = path_limits()) {
  const auto stage = std::make_unique<PathStage>(limits);
  std::vector<PathPiece> pieces;
  const auto take = [&] {
    while (const PathPiece* const piece = stage->next()) pieces.push_back(*piece);
  };
  for (const PathItem& item : items) {
    for (int i = 0; i < 100 && !stage->has_room(); ++i) take();
    stage->put(item);
    take();
  }
  for (int i = 0; i < 100 && !stage->empty(); ++i) {
    stage->flush();
    take();
  }
  EXPECT_TRUE(stage->empty());
  return pieces;
}

inline std::size_t stops_in(const std::vector<PathPiece>& pieces) {
  std::size_t stops = 0;
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    if (pieces[i].joint == motion::Joint::kStop) ++stops;
  }
  return stops;
}

/// Distance in mm by which rounded points may lie beside a smooth joint, neighbouring joints
/// included: a blend of two arcs has five of them.
inline constexpr double kRoundedPlaces = 1.2e-5;

/// Checks joins, ends and turns of any path after the stage.
inline void expect_sound(const std::vector<PathItem>& items, const std::vector<PathPiece>& pieces) {
  ASSERT_FALSE(pieces.empty());
  EXPECT_EQ(pieces.front().request.element.start, items.front().request.element.start);
  EXPECT_EQ(pieces.back().request.element.end, items.back().request.element.end);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const PathElement& here = pieces[i].request.element;
    ASSERT_LE(std::abs(here.bulge), 1.0F + 1.0e-5F) << i;
    ASSERT_FALSE(here.start == here.end) << i;
    if (i == 0) continue;
    const PathElement& before = pieces[i - 1].request.element;
    ASSERT_EQ(before.end, here.start) << i;
    if (pieces[i].joint == motion::Joint::kStop) continue;
    const ExactElement old{before};
    const ExactElement next{here};
    const double turn = distance(old.tangent(true), next.tangent(false));
    const double rounding = kRoundedPlaces / std::min(old.length(), next.length());
    const double allowed = motion::kTangentTurn * 1.01 + rounding;
    ASSERT_LE(turn, allowed) << "piece " << i << ", lengths " << old.length() << " and "
                             << next.length();
  }
}

}  // namespace cnc::path
