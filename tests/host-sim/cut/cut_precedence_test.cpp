#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "host-sim/cut/plan.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

/// Returns parts in rows, some with holes, and red lines at any position, in any order.
std::string random_content(proof::Random& random) {
  std::string content;
  const auto add = [&](const std::string& text) {
    content = random.chance(0.5) ? content + text : text + content;
  };
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      const double x = 5.0 + 30.0 * column;
      const double y = 5.0 + 30.0 * row;
      if (random.chance(0.2)) continue;
      add(fmt::format("<rect x=\"{}\" y=\"{}\" width=\"24\" height=\"24\"/>", x, y));
      if (random.chance(0.5)) {
        add(fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"8\"/>", x + 12.0, y + 12.0));
      }
    }
  }
  for (int i = 0; i < 8; ++i) {
    const double x = random.between(1.0, 99.0);
    const double y = random.between(1.0, 99.0);
    const double reach = random.magnitude(1.0, 60.0);
    add(fmt::format("<path stroke=\"red\" d=\"M{} {}L{} {}\"/>",
                    x,
                    y,
                    std::clamp(x + random.between(-reach, reach), 0.0, 100.0),
                    std::clamp(y + random.between(-reach, reach), 0.0, 100.0)));
  }
  return content;
}

std::vector<LayerPlan> with_red_on_the_line(const drawing::Drawing& drawn) {
  std::vector<LayerPlan> layers = layers_with(drawn, {});
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (drawn.layers[i].colour == "red") layers[i].settings.side = Side::kOn;
  }
  return layers;
}

/// Returns whether a point is inside, by the crossings of a ray.
bool is_inside(const Outline& outline, const Place& place) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Place& a = outline[i];
    const Place& b = outline[(i + 1) % outline.size()];
    if ((a.y() > place.y()) == (b.y() > place.y())) continue;
    if (place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside;
}

/// Returns the length of a cut inside of an outline, mm.
double length_in(const Outline& outline, const Cut& cut) {
  constexpr double kEvery = 0.05;
  double sum = 0.0;
  for (const Stroke& stroke : cut.strokes) {
    for (const Place& place : places_along(stroke, kEvery)) {
      if (is_inside(outline, place)) sum += kEvery;
    }
  }
  return sum;
}

TEST(CutPrecedence, LinesThatReachIntoAPartComeBeforeItIsFree) {
  const proof::Trials trials{60};
  std::size_t inside = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const auto drawn = drawing::read(drawing::svg_of(random_content(random)));
    const OrderWish wish{
        .method = random.chance(0.5) ? order::OrderMethod::kOurs : order::OrderMethod::kNearest,
        .from = {random.between(0.0, 100.0), random.between(0.0, 100.0)}};
    const CutPlan plan =
        plan_cuts(drawn, with_red_on_the_line(drawn), {}, WayBeside::kHere, {}, wish);
    for (std::size_t i = 0; i < plan.cuts.size(); ++i) {
      if (drawn.contours[plan.cuts[i].contour].closed) continue;
      for (std::size_t k = 0; k < plan.cuts.size(); ++k) {
        const drawing::DrawnContour& contour = drawn.contours[plan.cuts[k].contour];
        if (!contour.closed) continue;
        // The product samples lines every two millimetres.
        if (length_in(outline_of(contour.shapes, 0.01), plan.cuts[i]) < 2.2) continue;
        EXPECT_LT(i, k) << "a line comes after " << contour.entity.name;
        ++inside;
      }
    }
  }
  if (!trials.judges_shares()) return;
  EXPECT_GT(inside, 0U);
}

/// A contour that is cut on its line separates no part.
TEST(CutPrecedence, LinesInAFrameThatIsNoPartBelongToWhatIsAroundIt) {
  const auto drawn = drawing::read(drawing::svg_of(
      "<rect id=\"part\" x=\"5\" y=\"5\" width=\"80\" height=\"80\"/>"
      "<rect id=\"frame\" x=\"20\" y=\"20\" width=\"40\" height=\"40\" stroke=\"red\"/>"
      "<path id=\"mark\" stroke=\"red\" d=\"M30 40H50\"/>"));
  const CutPlan plan = plan_cuts(drawn, with_red_on_the_line(drawn));
  ASSERT_EQ(plan.cuts.size(), 3U);
  EXPECT_EQ(drawn.contours[plan.cuts[2].contour].entity.name, "rect \"part\"");
}

}  // namespace
}  // namespace sim::cut
