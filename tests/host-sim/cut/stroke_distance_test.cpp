#include "host-sim/cut/stroke_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/segment_distance.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

Stroke stroke_anywhere(proof::Random& random) {
  const auto place = [&random] {
    return Place{random.between(0.0, 9.0), random.between(0.0, 9.0)};
  };
  Stroke stroke{place(), place()};
  if (random.chance(0.7)) stroke.bulge = random.between(-1.5, 1.5);
  if (random.chance(0.1)) stroke.bulge *= 1.0e-6 * random.between(0.0, 1.0);
  return stroke;
}

/// Returns the distance by samples: never less than the exact distance, and greater by half a
/// spacing at most.
double sampled_distance(const Stroke& a, const Stroke& b, int count) {
  double least = 1.0e9;
  for (int i = 0; i <= count; ++i) {
    least = std::min(least, distance_to(b, place_at(a, static_cast<double>(i) / count)));
  }
  return least;
}

TEST(StrokeDistance, IsThatOfTheNearestSamples) {
  const proof::Trials trials{20'000};
  constexpr int kSamplesOfALine = 400;
  std::size_t crossings = 0;
  std::size_t apart = 0;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const Stroke a = stroke_anywhere(random);
    Stroke b = stroke_anywhere(random);
    if (random.chance(0.1)) b.from = a.to;
    if (random.chance(0.1)) b = {a.from, a.to, a.bulge * random.between(0.5, 1.5)};
    const double exact = distance_between(a, b);
    const double sampled = sampled_distance(a, b, kSamplesOfALine);
    EXPECT_LE(exact, sampled + 1.0e-6) << "KERFLINE_SEED=" << seed;
    EXPECT_GE(exact, sampled - length_of(a) / kSamplesOfALine - 1.0e-6) << "KERFLINE_SEED=" << seed;
    EXPECT_NEAR(exact, distance_between(b, a), 1.0e-6);
    (exact == 0.0 ? crossings : apart) += 1;
    if (HasFailure()) return;
  }
  if (!trials.judges_shares()) return;
  EXPECT_GE(crossings, (crossings + apart) / 19);
  EXPECT_GE(apart, (crossings + apart) / 19);
}

/// The tree must not omit a stroke that is near.
TEST(StrokeDistance, TellsWhatIsClearAsMeasuringAllDoes) {
  const proof::Trials trials{2'000};
  std::size_t clear = 0;
  std::size_t close = 0;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    Clearance clearance{1.0};
    std::vector<Stroke> strokes;
    for (int i = 0; i < 30; ++i) {
      Stroke stroke = stroke_anywhere(random);
      stroke.to = stroke.from + 0.2 * (stroke.to - stroke.from);
      strokes.push_back(stroke);
      clearance.add(stroke, 0);
    }
    clearance.prepare();
    const Stroke lead = stroke_anywhere(random);
    const double least = random.between(0.0, 0.5);
    double nearest = 1.0e9;
    for (const Stroke& stroke : strokes) {
      nearest = std::min(nearest, distance_between(stroke, lead));
    }
    EXPECT_EQ(clearance.is_clear(lead, least), nearest >= least) << "KERFLINE_SEED=" << seed;
    (nearest >= least ? clear : close) += 1;
    if (HasFailure()) return;
  }
  if (!trials.judges_shares()) return;
  EXPECT_GE(clear, (clear + close) / 95);
  EXPECT_GE(close, (clear + close) / 95);
}

TEST(StrokeDistance, HasItsEndsAtShares0And1) {
  for (const std::uint64_t seed : proof::Trials{2'000}) {
    proof::Random random{seed};
    const Stroke stroke = stroke_anywhere(random);
    ASSERT_NEAR(nearest_share(stroke, stroke.from), 0.0, 1.0e-6) << "KERFLINE_SEED=" << seed;
    ASSERT_NEAR(nearest_share(stroke, stroke.to), 1.0, 1.0e-6) << "KERFLINE_SEED=" << seed;
  }
}

/// A search begins at the stroke that was nearest to the previous point, which need not be the
/// result.
TEST(StrokeDistance, FindsTheNearestFromTheLastPlaceOn) {
  for (const std::uint64_t seed : proof::Trials{500}) {
    proof::Random random{seed};
    Clearance clearance{2.0};
    for (std::size_t i = 0; i < 40; ++i) {
      Stroke stroke = stroke_anywhere(random);
      stroke.to = stroke.from + 0.2 * (stroke.to - stroke.from);
      clearance.add(stroke, i);
    }
    clearance.prepare();
    Clearance::Nearest last;
    Place place{4.0, 4.0};
    for (int i = 0; i < 100; ++i) {
      const double step = random.chance(0.1) ? 9.0 : 0.1;
      place += step * Place{random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
      last = clearance.nearest(place, last);
      const Clearance::Nearest anew = clearance.nearest(place);
      ASSERT_EQ(last.distance_mm, anew.distance_mm) << "KERFLINE_SEED=" << seed;
      ASSERT_EQ(last.stroke, anew.stroke) << "KERFLINE_SEED=" << seed;
    }
  }
}

}  // namespace
}  // namespace sim::cut
