#include "planner/order/entry_refinement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace {

using cnc::order::EntryPiece;
using cnc::order::PiercePoint;
using cnc::order::Place;

Place random_place(proof::Random& random) {
  return {random.between(-10.0, 10.0), random.between(-10.0, 10.0)};
}

EntryPiece random_piece(proof::Random& random, bool is_arc) {
  EntryPiece piece{random_place(random), random_place(random)};
  if (is_arc) piece.bulge = random.chance(0.1) ? 1.0 : random.between(-1.0, 1.0);
  piece.first = random.chance(0.5) ? 0.0 : random.between(0.0, 0.5);
  piece.last = random.chance(0.5) ? 1.0 : random.between(piece.first, 1.0);
  return piece;
}

double distance(const Place& a, const Place& b) { return std::sqrt(squared_distance(a, b)); }

double path_by(const Place& from, const Place& by, const Place& to) {
  return distance(from, by) + distance(by, to);
}

/// All points of the arc lie on one circle, on the side that the bulge says.
TEST(EntryRefinementTest, ItsArcsAreArcs) {
  for (const std::uint64_t seed : proof::Trials{10'000}) {
    proof::Random random{seed};
    EntryPiece arc = random_piece(random, true);
    const double half = 0.5 * distance(arc.start, arc.end);
    if (half < 1.0e-3 || std::abs(arc.bulge) < 1.0e-3) continue;
    // The point at the middle is the bulge times half the chord aside, to the right if positive.
    const Place middle = arc.at(0.5);
    const double dx = arc.end.x - arc.start.x;
    const double dy = arc.end.y - arc.start.y;
    EXPECT_NEAR(middle.x, 0.5 * (arc.start.x + arc.end.x) + 0.5 * arc.bulge * dy, 1.0e-9);
    EXPECT_NEAR(middle.y, 0.5 * (arc.start.y + arc.end.y) - 0.5 * arc.bulge * dx, 1.0e-9);
    const double radius = half * (1.0 + arc.bulge * arc.bulge) / (2.0 * arc.bulge);
    const Place centre{middle.x - radius * dy / (2.0 * half),
                       middle.y + radius * dx / (2.0 * half)};
    for (int i = 0; i <= 8; ++i) {
      EXPECT_NEAR(
          distance(arc.at(i / 8.0), centre), std::abs(radius), 1.0e-9 * (1.0 + radius * radius));
    }
    if (HasFailure()) return;
  }
}

/// Against many samples: exact on lines, on arcs as good as the finest of them.
TEST(EntryRefinementTest, NoSampleIsBetter) {
  for (const std::uint64_t seed : proof::Trials{3'000}) {
    proof::Random random{seed};
    const bool is_arc = random.chance(0.5);
    const EntryPiece piece = random_piece(random, is_arc);
    const Place from = random_place(random);
    const Place to = random.chance(0.1) ? from : random_place(random);
    const double parameter = best_parameter(piece, from, to);
    EXPECT_GE(parameter, piece.first);
    EXPECT_LE(parameter, piece.last);
    const double length = path_by(from, piece.at(parameter), to);
    constexpr int kSamples = 1000;
    for (int i = 0; i <= kSamples; ++i) {
      const double t = piece.first + (piece.last - piece.first) * i / kSamples;
      ASSERT_LE(length, path_by(from, piece.at(t), to) + (is_arc ? 1.0e-6 : 1.0e-9));
    }
  }
}

/// The path gets shorter by what is returned. Where each contour is one line, where nothing is left
/// to jump to, hardly any point can be moved any more; rounds gain less and less without an end.
TEST(EntryRefinementTest, ShortensThePathByWhatItSays) {
  for (const std::uint64_t seed : proof::Trials{1'000}) {
    proof::Random random{seed};
    const bool is_simple = random.chance(0.5);
    std::vector<std::vector<EntryPiece>> contours(1 + random.below(6));
    std::vector<PiercePoint> points;
    for (auto& contour : contours) {
      const std::size_t pieces = is_simple ? 1 : 1 + random.below(5);
      for (std::size_t i = 0; i < pieces; ++i) {
        contour.push_back(random_piece(random, !is_simple && random.chance(0.3)));
      }
      points.push_back({contour, 0, contour.front().first});
    }
    const Place start = random_place(random);
    const Place end = random_place(random);
    const auto length = [&] {
      double sum = 0.0;
      Place before = start;
      for (const PiercePoint& point : points) {
        sum += distance(before, point.place());
        before = point.place();
      }
      return sum + distance(before, end);
    };
    const double before = length();
    const double gain = refine_pierce_points(points, start, end, 1.0e-9, 500);
    EXPECT_NEAR(length(), before - gain, 1.0e-9);
    EXPECT_GE(gain, 0.0);
    const double more = refine_pierce_points(points, start, end, 0.0, 1);
    EXPECT_GE(more, 0.0);
    if (is_simple) {
      EXPECT_LE(more, 1.0e-4);
    }
    if (HasFailure()) return;
  }
}

}  // namespace
