#include "host-sim/cut/stroke.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host-sim/cut/clearance.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

/// An arc by its centre, and the stroke that should represent it.
struct KnownArc {
  Place centre;
  double radius;
  double from;
  double sweep;

  [[nodiscard]] Place at(double share) const {
    return centre + radius * drawing::direction(from + share * sweep);
  }
  [[nodiscard]] Stroke stroke() const { return {at(0.0), at(1.0), std::tan(0.25 * sweep)}; }
};

KnownArc random_arc(proof::Random& random) {
  return {{random.between(-50.0, 50.0), random.between(-50.0, 50.0)},
          random.magnitude(0.1, 200.0),
          random.between(-3.0, 3.0),
          random.signed_magnitude(0.01, 6.0)};
}

TEST(Stroke, IsTheArcOfItsBulge) {
  const proof::Trials trials{2'000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const KnownArc arc = random_arc(random);
    const Stroke stroke = arc.stroke();
    EXPECT_NEAR(length_of(stroke), arc.radius * std::abs(arc.sweep), 1.0e-8);
    const double share = random.unit();
    EXPECT_LT(drawing::distance(place_at(stroke, share), arc.at(share)), 1.0e-8);
    const Place way = arc.at(share + 1.0e-6) - arc.at(share - 1.0e-6);
    EXPECT_LT(drawing::distance(tangent_at(stroke, share), way.normalized()), 1.0e-5);
    const double more = share + (1.0 - share) * random.between(0.1, 1.0);
    const Stroke part = part_of(stroke, share, more);
    EXPECT_LT(drawing::distance(place_at(part, 0.5), arc.at(0.5 * (share + more))), 1.0e-8);
  }
}

TEST(Stroke, IsAsFarAsTheNearestOfManyPlaces) {
  const proof::Trials trials{500};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const KnownArc arc = random_arc(random);
    Stroke stroke = arc.stroke();
    if (random.chance(0.3)) stroke.bulge = 0.0;
    const Place place{random.between(-99.0, 99.0), random.between(-99.0, 99.0)};
    constexpr int kLooks = 5'000;
    double least = 1.0e9;
    for (int i = 0; i <= kLooks; ++i) {
      const Place on = place_at(stroke, static_cast<double>(i) / kLooks);
      least = std::min(least, drawing::distance(on, place));
    }
    EXPECT_NEAR(distance_to(stroke, place), least, 0.5 * length_of(stroke) / kLooks + 1.0e-9);
    EXPECT_LE(distance_to(stroke, place), least + 1.0e-9);
  }
}

TEST(Strokes, AreCutOutOfARowByTheirLength) {
  const std::vector<Stroke> row{{{0, 0}, {10, 0}, 0.0}, {{10, 0}, {10, 4}, 1.0}};
  const MeasuredRow measured{row};
  EXPECT_DOUBLE_EQ(measured.length(), length_of(row));
  const auto middle = measured.stretch(9.0, 11.0);
  ASSERT_EQ(middle.size(), 2U);
  EXPECT_NEAR(length_of(middle), 2.0, 1.0e-12);
  EXPECT_LT(drawing::distance(middle[0].to, middle[1].from), 1.0e-12);
  EXPECT_TRUE(measured.stretch(3.0, 3.0).empty());
  EXPECT_NEAR(length_of(measured.stretch(-1.0, 99.0)), length_of(row), 1.0e-12);
}

/// A half disc: a row that begins at any point of it contains all of it, and has the right
/// directions at its beginning and end.
TEST(Strokes, OfAClosedRowBeginAnywhere) {
  const std::vector<Stroke> row{{{-5, 0}, {5, 0}, 0.0}, {{5, 0}, {-5, 0}, 1.0}};
  const MeasuredRow measured{row};
  for (const double way : {0.0, 3.0, 10.0, 12.0, measured.length()}) {
    SCOPED_TRACE(way);
    const std::vector<Stroke> begun = measured.begun_at(way);
    EXPECT_NEAR(length_of(begun), measured.length(), 1.0e-9);
    EXPECT_LT(drawing::distance(begun.front().from, begun.back().to), 1.0e-12);
    EXPECT_LT(drawing::distance(begun.front().from, measured.place(way)), 1.0e-9);
    EXPECT_LT(drawing::distance(tangent_at(begun.front(), 0.0), measured.leaving(way)), 1.0e-9);
    EXPECT_LT(drawing::distance(tangent_at(begun.back(), 1.0), measured.arriving(way)), 1.0e-9);
  }
}

/// Counts the work instead of the time: even if strokes are very close together, few distances are
/// computed to find the nearest.
TEST(Clearance, MeasuresFewStrokesHoweverManyLieClose) {
  for (const std::size_t count : {1'000U, 10'000U, 100'000U}) {
    SCOPED_TRACE(count);
    Clearance clearance{2.0};
    const auto place = [count](std::size_t i, double radius) {
      const double angle = 6.283185307179586 * static_cast<double>(i) / static_cast<double>(count);
      return Place{radius * std::cos(angle), radius * std::sin(angle) * (1.0 + 0.2 * radius)};
    };
    for (std::size_t i = 0; i < count; ++i) clearance.add({place(i, 10.0), place(i + 1, 10.0)}, i);
    clearance.prepare();
    std::size_t looks = 0;
    constexpr std::size_t kQuestions = 1'000;
    for (std::size_t i = 0; i < kQuestions; ++i) {
      looks += clearance.nearest(place(i * count / kQuestions, 10.3)).looks;
    }
    // 3 of 100 strokes are within reach. The number of boxes that are as near grows only with the
    // root.
    const double most = 2.0 * std::sqrt(static_cast<double>(count));
    EXPECT_LT(static_cast<double>(looks), most * static_cast<double>(kQuestions));
  }
}

TEST(Clearance, FindsWhatLookingAtEveryStrokeFinds) {
  const proof::Trials trials{100};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const double reach = random.magnitude(0.1, 50.0);
    Clearance clearance{reach};
    std::vector<Stroke> strokes;
    for (std::size_t i = 0; i < 30; ++i) {
      strokes.push_back(random_arc(random).stroke());
      if (random.chance(0.5)) strokes.back().bulge = 0.0;
      clearance.add(strokes.back(), i);
    }
    clearance.prepare();
    for (int look = 0; look < 50; ++look) {
      const Place place{random.between(-300.0, 300.0), random.between(-300.0, 300.0)};
      double least = reach;
      for (const Stroke& stroke : strokes) least = std::min(least, distance_to(stroke, place));
      EXPECT_DOUBLE_EQ(clearance.nearest(place).distance_mm, least);
    }
  }
}

}  // namespace
}  // namespace sim::cut
