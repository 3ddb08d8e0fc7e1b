#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

/// Upper bound of the distance between a drawn curve and the chords of its samples, mm.
constexpr double kChordSlack = 2.0e-4;
constexpr int kSamples = 2'000;
constexpr double kPageMm = 100.0;

using Bezier = std::array<Place, 4>;

double three_decimals(double mm) { return std::round(1000.0 * mm) / 1000.0; }

Place at(double turn, double radius) {
  return {three_decimals(50.0 + radius * std::cos(turn)),
          three_decimals(50.0 + radius * std::sin(turn))};
}

/// Returns an outline around the middle of the page, with and without corners.
std::vector<Bezier> random_outline(proof::Random& random) {
  const std::size_t count = 3 + random.below(5);
  const double step = 2.0 * std::numbers::pi / static_cast<double>(count);
  std::vector<Place> ends;
  for (std::size_t i = 0; i < count; ++i) {
    ends.push_back(at(step * static_cast<double>(i), random.between(15.0, 40.0)));
  }
  std::vector<Bezier> outline;
  for (std::size_t i = 0; i < count; ++i) {
    const double turn = step * static_cast<double>(i);
    const bool smooth = i > 0 && random.chance(0.5);
    const Place mirrored = smooth ? Place{2.0 * ends[i] - outline.back()[2]} : ends[i];
    outline.push_back({ends[i],
                       smooth ? mirrored : at(turn + 0.3 * step, random.between(8.0, 45.0)),
                       at(turn + 0.7 * step, random.between(8.0, 45.0)),
                       ends[(i + 1) % count]});
  }
  return outline;
}

std::string svg_path_of(const std::vector<Bezier>& outline) {
  const auto text = [](const Place& place) {
    return fmt::format("{:.3f} {:.3f} ", place.x(), kPageMm - place.y());
  };
  std::string data = "M" + text(outline.front()[0]);
  for (const Bezier& curve : outline) {
    data += "C" + text(curve[1]) + text(curve[2]) + text(curve[3]);
  }
  return "<path id=\"p\" d=\"" + data + "Z\"/>";
}

/// Returns points of the outline, by de Casteljau's algorithm.
Outline sampled(const std::vector<Bezier>& outline) {
  Outline places;
  for (const Bezier& curve : outline) {
    for (int i = 0; i < kSamples; ++i) {
      const double share = static_cast<double>(i) / kSamples;
      Bezier row = curve;
      for (std::size_t left = 3; left > 0; --left) {
        for (std::size_t k = 0; k < left; ++k) row[k] += share * (row[k + 1] - row[k]);
      }
      places.push_back(row[0]);
    }
  }
  return places;
}

/// A cubic spline that ends where it begins, as DXF stores it; its knots are integers.
struct Spline {
  std::vector<Place> points;

  [[nodiscard]] std::vector<double> knots() const {
    std::vector<double> knots(4, 0.0);
    const std::size_t spans = points.size() - 3;
    for (std::size_t i = 1; i < spans; ++i) knots.push_back(static_cast<double>(i));
    knots.insert(knots.end(), 4, static_cast<double>(spans));
    return knots;
  }

  /// Returns points of the spline, by de Boor's algorithm.
  [[nodiscard]] Outline sampled() const {
    const std::vector<double> knot = knots();
    Outline places;
    for (std::size_t span = 3; span < points.size(); ++span) {
      for (int i = 0; i < kSamples; ++i) {
        const double u = knot[span] + static_cast<double>(i) / kSamples;
        std::array<Place, 4> row{
            points[span - 3], points[span - 2], points[span - 1], points[span]};
        for (std::size_t level = 1; level <= 3; ++level) {
          for (std::size_t k = 3; k >= level; --k) {
            const double low = knot[span - 3 + k];
            const double share = (u - low) / (knot[span + k + 1 - level] - low);
            row[k] = (1.0 - share) * row[k - 1] + share * row[k];
          }
        }
        places.push_back(row[3]);
      }
    }
    return places;
  }

  [[nodiscard]] std::string dxf() const {
    std::string text = "0\nSPLINE\n5\nA1\n70\n8\n71\n3\n";
    for (const double knot : knots()) text += fmt::format("40\n{:g}\n", knot);
    for (const Place& point : points) {
      text += fmt::format("10\n{:.3f}\n20\n{:.3f}\n", point.x(), point.y());
    }
    return drawing::dxf_of(text);
  }
};

Spline random_spline(proof::Random& random) {
  const std::size_t count = 6 + random.below(6);
  const double step = 2.0 * std::numbers::pi / static_cast<double>(count);
  Spline spline;
  for (std::size_t i = 0; i < count; ++i) {
    spline.points.push_back(at(step * static_cast<double>(i), random.between(15.0, 45.0)));
  }
  spline.points.push_back(spline.points.front());
  return spline;
}

double area_of(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    twice += drawing::cross(outline[i], outline[(i + 1) % outline.size()]);
  }
  return 0.5 * std::abs(twice);
}

/// Returns the greatest deviation of the distance between contour strokes and a drawn curve from
/// half a kerf. Leads may be farther away, but not nearer.
double worst_distance(const CutPlan& plan, const Outline& drawn) {
  double worst = 0.0;
  for (const Cut& cut : plan.cuts) {
    for (const Stroke& stroke : cut.strokes) {
      for (const Place& place : places_along(stroke, 0.25)) {
        const double more = distance_to_all({drawn}, place) - kHalf;
        if (more > 0.0 && stroke.purpose != Purpose::kContour) continue;
        worst = std::max(worst, std::abs(more));
      }
    }
  }
  return worst;
}

/// Sums and extremes of all random drawings.
struct Tally {
  std::size_t parts = 0;
  std::size_t strokes = 0;
  double worst = 0.0;  ///< Greatest deviation, as a fraction of the tolerance.

  void look(const drawing::Drawing& drawn, const Outline& curve, proof::Random& random) {
    // Some outlines cross themselves, and are skipped.
    if (drawn.has_errors()) return;
    const OutlineOptions curves{.tolerance_mm = random.magnitude(0.002, 0.1),
                                .method = random.chance(0.8) ? cnc::contour::FitMethod::kFewest
                                                             : cnc::contour::FitMethod::kBisecting};
    const LayerSettings settings{.pierce_s = 0.1};
    const CutPlan plan = plan_cuts(drawn, layers_with(drawn, settings), curves);
    EXPECT_TRUE(plan.faults.empty()) << to_string(plan.faults.front(), "");
    ASSERT_FALSE(plan.cuts.empty());
    EXPECT_GT(plan.cuts.back().area_mm2, area_of(curve));
    const double found = worst_distance(plan, curve);
    EXPECT_LE(found, curves.tolerance_mm + kChordSlack);
    worst = std::max(worst, found / curves.tolerance_mm);
    ++parts;
    for (const Cut& cut : plan.cuts) strokes += cut.strokes.size();
  }
};

/// Compares the path with the drawn curve itself, which is sampled here by its own formula.
TEST(CutCurves, KeepHalfAKerfAwayWithinTheTolerance) {
  const proof::Trials trials{8};
  Tally outlines;
  Tally splines;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const auto outline = random_outline(random);
    outlines.look(drawing::read(drawing::svg_of(svg_path_of(outline))), sampled(outline), random);
    const Spline spline = random_spline(random);
    splines.look(drawing::read(spline.dxf()), spline.sampled(), random);
  }
  for (const Tally& tally : {outlines, splines}) {
    std::printf("%zu parts, %zu strokes: half a kerf within %.4f of the tolerance\n",
                tally.parts,
                tally.strokes,
                tally.worst);
    if (!trials.judges_shares()) continue;
    EXPECT_GE(3 * tally.parts, trials.count());
  }
}

TEST(CutCurves, AreFollowedOnTheLineToTheEndsOfOpenOnes) {
  const Bezier curve{Place{10, 20}, Place{30, 90}, Place{60, -20}, Place{80, 70}};
  const auto drawn = drawing::read(drawing::svg_of("<path d=\"M10 80C30 10 60 120 80 30\"/>"));
  const OutlineOptions curves{.tolerance_mm = 0.02};
  const CutPlan plan = plan_cuts(drawn, layers_with(drawn, {.side = Side::kOn}), curves);
  EXPECT_TRUE(plan.faults.empty());
  ASSERT_EQ(plan.cuts.size(), 1U);
  EXPECT_LT(drawing::distance(plan.cuts[0].start(), curve.front()), 1.0e-9);
  EXPECT_LT(drawing::distance(plan.cuts[0].end(), curve.back()), 1.0e-9);
  const Outline open = sampled({curve});
  for (const Stroke& stroke : plan.cuts[0].strokes) {
    for (const Place& place : places_along(stroke, 0.25)) {
      double nearest = drawing::distance(place, curve.back());
      for (std::size_t i = 1; i < open.size(); ++i) {
        nearest = std::min(nearest, distance_to_chord(open[i - 1], open[i], place));
      }
      EXPECT_LT(nearest, curves.tolerance_mm + kChordSlack);
    }
  }
}

// Three control points coincide: the curve has no direction there that arcs could follow.
TEST(CutCurves, AreNamedWithTheirPlaceWhereNoArcsFollowThem) {
  const auto drawn =
      drawing::read(drawing::svg_of("<path id=\"odd\" d=\"M10 10C10 10 10 10 30 20L10 40Z\"/>"
                                    "<ellipse cx=\"70\" cy=\"50\" rx=\"9\" ry=\"5\"/>"));
  const CutPlan plan = plan_of(drawn);
  ASSERT_EQ(plan.faults.size(), 1U);
  EXPECT_EQ(plan.faults[0].kind, drawing::FaultKind::kNoArcs);
  EXPECT_THAT(to_string(plan.faults[0], "x.svg"), testing::HasSubstr("path \"odd\" at 30.000"));
  EXPECT_EQ(plan.cuts.size(), 1U) << "the ellipse is cut";
}

}  // namespace
}  // namespace sim::cut
