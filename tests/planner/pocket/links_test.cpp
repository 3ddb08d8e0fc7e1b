#include "planner/pocket/links.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "planner/pocket/loop_measures.hpp"
#include "tests/planner/pocket/path_bench.hpp"
#include "tests/support/trials.hpp"

namespace cnc::pocket {
namespace {

using contour::exact::BothWays;
using contour::exact::ChainArc;

/// A search with its storage.
struct LinkBench {
  std::vector<contour::Curve<double>> curves{PocketBench::kElements};
  std::vector<contour::FlatBox<double>> boxes = std::vector<contour::FlatBox<double>>(
      contour::BoxTree<double>::size_for(PocketBench::kElements));
  LinkSearch<double> search{{curves.data(), curves.size()}, {boxes.data(), boxes.size()}};
};

double degrees_of(const WideVec2& direction) {
  return std::atan2(direction.y(), direction.x()) * 180.0 / std::numbers::pi;
}

/// Returns the arcs and lines of a link that have a length.
std::vector<ChainArc> parts_of(const Link<double>& link) {
  std::vector<ChainArc> parts;
  for (std::size_t i = 0; i < 3; ++i) {
    if ((link.points[i + 1] - link.points[i]).norm() < 1.0e-7) continue;
    parts.push_back({link.points[i], link.points[i + 1], link.bulges[i]});
  }
  return parts;
}

/// Returns the greatest angle between a link and the path that it joins, and between its parts, in
/// degrees.
double worst_kink(const Pose<double>& from, const Link<double>& link) {
  double direction = degrees_of(from.tangent);
  double worst = 0.0;
  for (const ChainArc& part : parts_of(link)) {
    worst = std::max(worst, BothWays::kink(direction, BothWays::leaving(part)));
    direction = BothWays::arriving(part);
  }
  return std::max(worst, BothWays::kink(direction, degrees_of(link.landing.pose.tangent)));
}

/// Returns the distance by which a link leaves the area, at points along it; 0 if it stays inside.
double outside(const PlainContour& area, const Link<double>& link) {
  double worst = 0.0;
  for (const ChainArc& part : parts_of(link)) {
    const contour::exact::PlainArc arc{part};
    for (int i = 1; i < 60; ++i) {
      const WideVec2 place = arc.at(i / 60.0);
      if (area.distance(place) > 1.0e-9 && !area.encloses(place)) {
        worst = std::max(worst, area.distance(place));
      }
    }
  }
  return worst;
}

TEST(LinkSearch, GoesFromASquareToTheOneAroundIt) {
  PocketBench outer;
  outer.rectangle(0, 0, 40, 40);
  LinkBench bench;
  ASSERT_TRUE(bench.search.enter(outer.pocket()));
  const Pose<double> from{{20, 8}, {1, 0}};
  const auto link = bench.search.find(from, {}, Milling::kClimb, 5.0);
  ASSERT_TRUE(link.has_value());
  EXPECT_LT(worst_kink(from, *link), 1.0e-6);
  PlainContour area;
  area.add(outer.pocket());
  EXPECT_EQ(outside(area, *link), 0.0);
  EXPECT_NEAR(area.distance(link->landing.pose.point), 0.0, 1.0e-12);
  EXPECT_EQ(link->landing.vertex, 0U);
  EXPECT_NEAR(link->landing.pose.point.y(), 0.0, 1.0e-12);
  EXPECT_GT(link->landing.pose.point.x(), 20.0);
}

TEST(LinkSearch, LandsTheOtherWayRoundAgainstTheLoop) {
  PocketBench outer;
  outer.rectangle(0, 0, 40, 40);
  LinkBench bench;
  ASSERT_TRUE(bench.search.enter(outer.pocket()));
  const Pose<double> from{{20, 8}, {-1, 0}};
  const auto link = bench.search.find(from, {}, Milling::kConventional, 5.0);
  ASSERT_TRUE(link.has_value());
  EXPECT_LT(worst_kink(from, *link), 1.0e-6);
  EXPECT_LT(link->landing.pose.tangent.x(), -0.99);
}

TEST(LinkSearch, DoesNotCrossAnIsland) {
  PocketBench outer;
  outer.rectangle(0, 0, 60, 60).add(25, 5).add(25, 12).add(35, 12).add(35, 5).close();
  LinkBench bench;
  ASSERT_TRUE(bench.search.enter(outer.pocket()));
  const Pose<double> from{{30, 15}, {1, 0}};
  const auto link = bench.search.find(from, {}, Milling::kClimb, 5.0);
  ASSERT_TRUE(link.has_value());
  PlainContour area;
  area.add(outer.pocket());
  EXPECT_EQ(outside(area, *link), 0.0);
}

TEST(LinkSearch, FindsNoneThatIsTooLong) {
  PocketBench outer;
  outer.rectangle(0, 0, 400, 400);
  LinkBench bench;
  ASSERT_TRUE(bench.search.enter(outer.pocket()));
  EXPECT_FALSE(bench.search.find({{200, 200}, {1, 0}}, {}, Milling::kClimb, 5.0).has_value());
}

TEST(LinkSearch, InRandomPocketsStaysWithinThePassAndHasOneTangent) {
  std::size_t wanted = 0;
  std::size_t found = 0;
  const proof::Trials trials{100};
  LinkBench bench;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    PocketBench pocket;
    const double radius = add_random_pocket(pocket, random);
    const auto count = pocket.clear({radius, 0.1 * radius, 2.0 * radius});
    ASSERT_TRUE(count.ok()) << "KERFLINE_SEED=" << seed << ": fault "
                            << static_cast<int>(count.error().fault);
    for (std::uint32_t i = 0; i < count.value(); ++i) {
      const std::uint32_t parent = pocket.passes().note(i).parent;
      if (parent == contour::kNone) continue;
      const auto inner = pocket.passes().loops(i);
      contour::Curve<double> curve;
      const auto vertex = static_cast<std::uint32_t>(random.below(inner.loop_ends[0]));
      const auto element = element_at(inner, 0, vertex);
      if (!make_curve(element, curve)) continue;
      const Milling milling = random.chance(0.5) ? Milling::kClimb : Milling::kConventional;
      const Pose<double> from = pose_on(curve, element.middle(), milling);
      ASSERT_TRUE(bench.search.enter(pocket.passes().loops(parent)));
      const auto link = bench.search.find(from, {}, milling, radius);
      ++wanted;
      if (!link) continue;
      ++found;
      EXPECT_LT(worst_kink(from, *link), 1.0e-5) << "KERFLINE_SEED=" << seed;
      PlainContour area;
      area.add(pocket.passes().loops(parent));
      EXPECT_LT(outside(area, *link), 1.0e-7) << "KERFLINE_SEED=" << seed;
    }
  }
  std::printf("%zu links of %zu\n", found, wanted);
  if (trials.judges_shares()) {
    EXPECT_GT(static_cast<double>(found), 0.9 * static_cast<double>(wanted));
  }
}

}  // namespace
}  // namespace cnc::pocket
