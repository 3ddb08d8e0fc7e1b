#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "planner/contour/offset.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::contour {
namespace {

using Vertices = std::vector<Vertex<double>>;

template <typename Item>
Slice<Item> all_of(std::vector<Item>& items) {
  return {items.data(), items.size()};
}

/// Working storage of one offset, with capacity for a given number of cuts.
class Room {
 public:
  Room(std::size_t elements, std::size_t cuts) : sizes_{elements, cuts} {}

  OffsetSpace<double> space() {
    return {all_of(vertices_),
            all_of(elements_),
            all_of(element_boxes_),
            all_of(raw_),
            all_of(raw_boxes_),
            all_of(nodes_),
            all_of(cuts_),
            all_of(sorted_cuts_),
            all_of(first_cuts_),
            all_of(pieces_),
            all_of(runs_),
            all_of(junctions_),
            all_of(queue_)};
  }

 private:
  OffsetSizes sizes_;
  Vertices vertices_ = Vertices(sizes_.elements);
  std::vector<Curve<double>> elements_ = std::vector<Curve<double>>(sizes_.elements);
  std::vector<FlatBox<double>> element_boxes_ =
      std::vector<FlatBox<double>>(sizes_.element_boxes());
  std::vector<RawCurve<double>> raw_ = std::vector<RawCurve<double>>(sizes_.raw());
  std::vector<FlatBox<double>> raw_boxes_ = std::vector<FlatBox<double>>(sizes_.raw_boxes());
  std::vector<Node<double>> nodes_ = std::vector<Node<double>>(sizes_.nodes());
  std::vector<Cut<double>> cuts_ = std::vector<Cut<double>>(sizes_.cuts);
  std::vector<Cut<double>> sorted_cuts_ = std::vector<Cut<double>>(sizes_.cuts);
  std::vector<std::uint32_t> first_cuts_ = std::vector<std::uint32_t>(sizes_.raw() + 1);
  std::vector<Piece> pieces_ = std::vector<Piece>(sizes_.pieces());
  std::vector<Run> runs_ = std::vector<Run>(sizes_.pieces());
  std::vector<Junction> junctions_ = std::vector<Junction>(sizes_.nodes());
  std::vector<std::uint32_t> queue_ = std::vector<std::uint32_t>(sizes_.nodes());
};

/// Result of an offset, and whether the capacity for cuts was sufficient.
struct Done {
  Result<ContourView<double>, OffsetError> result;
  Vertices vertices;
  std::vector<std::uint32_t> ends;
};

Done offset_with(const Vertices& outline, double distance, std::size_t cuts) {
  const std::vector<std::uint32_t> ends{static_cast<std::uint32_t>(outline.size())};
  Room room{outline.size(), cuts};
  Done done{OffsetError{},
            Vertices(2 * outline.size() + cuts),
            std::vector<std::uint32_t>(outline.size())};
  ContourWriter<double> out{all_of(done.vertices), all_of(done.ends)};
  done.result = offset<double>(
      {{outline.data(), outline.size()}, {ends.data(), ends.size()}}, distance, room.space(), out);
  return done;
}

/// Returns a star with rounded tips as a scanner draws it: many points, each with a small
/// deviation.
Vertices scanned(std::size_t count, double radius, double roughness, proof::Random& random) {
  Vertices outline;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    const double r =
        radius * (1.0 + 0.1 * std::sin(5.0 * angle)) + random.between(-roughness, roughness);
    outline.push_back({r * std::cos(angle), r * std::sin(angle), 0.0});
  }
  return outline;
}

/// The work of an offset is proportional to the intersections of moved elements. Sections that
/// nearby corners cover are removed first. Otherwise 32,000 points with 1,000 of them within the
/// distance would require 16,000,000 cuts.
TEST(CrowdedOutline, MeetsNoMoreOfItselfHoweverCloselyItIsDrawn) {
  proof::Random random{proof::test_seed()};
  for (const std::size_t count : {2'000U, 8'000U, 32'000U, 128'000U}) {
    const Vertices outline = scanned(count, 20.0, 0.02, random);
    for (const double distance : {2.0, -2.0}) {
      const Done done = offset_with(outline, distance, 4 * count);
      ASSERT_TRUE(done.result.ok()) << count << " at " << distance << ": too many meetings";
      EXPECT_EQ(done.result.value().loop_ends.size(), 1U);
    }
  }
}

double distance_to(const Vertices& outline, double x, double y) {
  double least = 1.0e9;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const BasicVec2<double> from = outline[i].point();
    const BasicVec2<double> way = outline[(i + 1) % outline.size()].point() - from;
    const BasicVec2<double> q = BasicVec2<double>{x, y} - from;
    const double share = std::clamp(q.dot(way) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (q - share * way).norm());
  }
  return least;
}

bool is_inside(const Vertices& outline, double x, double y) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vertex<double>& a = outline[i];
    const Vertex<double>& b = outline[(i + 1) % outline.size()];
    if ((a.y <= y) == (b.y <= y)) continue;
    if (a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x) > x) inside = !inside;
  }
  return inside;
}

/// Returns the distance to the nearest arc of a result, checked in small steps along each arc.
double distance_to_result(const ContourView<double>& result, double x, double y) {
  double least = 1.0e9;
  for (std::size_t loop = 0; loop < result.loop_ends.size(); ++loop) {
    const std::uint32_t first = result.loop_begin(loop);
    for (std::uint32_t i = first; i < result.loop_ends[loop]; ++i) {
      const std::uint32_t next = i + 1 < result.loop_ends[loop] ? i + 1 : first;
      const auto arc = BasicArc<double>::make(
          result.vertices[i].point(), result.vertices[next].point(), result.vertices[i].bulge);
      if (arc.ok()) least = std::min(least, curve_of(arc.value()).distance({x, y}));
    }
  }
  return least;
}

/// Checks both directions by trying all points. Each point of the result is at the distance, and no
/// point at the distance on this side is missing.
TEST(CrowdedOutline, IsWhereLookingAtEverythingSaysThatItIs) {
  const proof::Trials trials{40};
  std::size_t found = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE("KERFLINE_SEED=" + std::to_string(seed));
    proof::Random random{seed};
    const auto count = static_cast<std::size_t>(random.between(300.0, 900.0));
    const Vertices outline = scanned(count, 20.0, random.magnitude(1.0e-3, 0.04), random);
    const double distance = random.signed_magnitude(0.8, 12.0);
    const Done done = offset_with(outline, distance, 400 * count);
    ASSERT_TRUE(done.result.ok());
    const ContourView<double> result = done.result.value();
    for (const Vertex<double>& vertex : result.vertices) {
      EXPECT_NEAR(distance_to(outline, vertex.x, vertex.y), std::abs(distance), 1.0e-9);
    }
    for (int look = 0; look < 2'000; ++look) {
      const Vertex<double>& corner = outline[random.below(count)];
      const double angle = random.between(0.0, 2.0 * std::numbers::pi);
      const double x = corner.x + std::abs(distance) * std::cos(angle);
      const double y = corner.y + std::abs(distance) * std::sin(angle);
      if (distance_to(outline, x, y) < std::abs(distance) - 1.0e-12) continue;
      if (is_inside(outline, x, y) != (distance < 0.0)) continue;
      ++found;
      EXPECT_LT(distance_to_result(result, x, y), 1.0e-7) << x << ' ' << y;
    }
  }
  std::printf("%zu places at the distance were looked for\n", found);
  if (trials.judges_shares()) {
    EXPECT_GT(found, 50U);
  }
}

}  // namespace
}  // namespace cnc::contour
