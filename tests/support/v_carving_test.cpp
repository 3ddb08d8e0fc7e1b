#include "host-sim/pocket/v_carving.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "host-sim/contour/outline.hpp"
#include "host-sim/import/drawing.hpp"
#include "tests/support/carve_judge.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using sim::pocket::VCarveOptions;
using sim::pocket::VCarving;

constexpr double kMaxGouge_mm = 1.0e-6;
constexpr double kMaxShallow_mm = 0.01;
constexpr double kMaxUnreached_mm = 0.02;

bool has_long_arc(const sim::Contour& contour) {
  return std::ranges::any_of(contour.vertices,
                             [](const auto& vertex) { return std::abs(vertex.bulge) > 1.0; });
}

const nlohmann::json& glyphs_of_font() {
  static const nlohmann::json kFont = [] {
    std::ifstream stream{std::string{KERFLINE_EXAMPLES} + "/data/dejavu_sans_bold.json"};
    return nlohmann::json::parse(stream);
  }();
  return kFont.at("glyphs");
}

/// Returns a contour of a TrueType letter as an SVG path. Between two successive control points
/// there is an implied point.
std::string svg_path_of(const nlohmann::json& contour) {
  const auto x = [&](std::size_t i) { return contour[i % contour.size()][0].get<double>(); };
  const auto y = [&](std::size_t i) { return contour[i % contour.size()][1].get<double>(); };
  const auto is_on = [&](std::size_t i) { return contour[i % contour.size()][2].get<int>() != 0; };
  std::size_t first = 0;
  while (!is_on(first)) ++first;
  std::string path = fmt::format("M{},{}", x(first), y(first));
  for (std::size_t i = first + 1; i <= first + contour.size(); ++i) {
    if (is_on(i)) {
      path += fmt::format("L{},{}", x(i), y(i));
    } else if (is_on(i + 1)) {
      path += fmt::format("Q{},{} {},{}", x(i), y(i), x(i + 1), y(i + 1));
      ++i;
    } else {
      path +=
          fmt::format("Q{},{} {},{}", x(i), y(i), 0.5 * (x(i) + x(i + 1)), 0.5 * (y(i) + y(i + 1)));
    }
  }
  return path + "Z";
}

/// Returns a letter of a font, with its curves as arcs.
sim::Contour letter(const nlohmann::json& glyph, double height_mm) {
  std::string paths;
  for (const auto& contour : glyph.at("contours")) paths += svg_path_of(contour);
  const std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{0}mm\" "
      "viewBox=\"0 0 2048 2048\"><path d=\"{1}\"/></svg>",
      height_mm,
      paths);
  return sim::outline_of(sim::drawing::read_drawing("letter.svg", svg)).contour;
}

sim::Contour random_letter(Random& random) {
  const nlohmann::json& glyphs = glyphs_of_font();
  auto glyph = glyphs.begin();
  std::advance(glyph, static_cast<std::ptrdiff_t>(random.below(glyphs.size())));
  return letter(*glyph, random.magnitude(4.0, 80.0));
}

sim::Contour random_area(Random& random) {
  sim::Contour area;
  do {
    switch (random.below(5)) {
      case 4:
        area = random_letter(random);
        break;
      case 0:
        area = random_case(Corpus::kGlyphs, random.bits() >> 8).contour;
        break;
      case 1:
        area = random_case(Corpus::kIslands, random.bits() >> 8).contour;
        break;
      case 2:
        area = random_case(Corpus::kMech, random.bits() >> 8).contour;
        break;
      default:
        area = random_star(random, 3 + random.below(20), 5.0, 30.0);
    }
  } while (area.vertices.empty() || has_long_arc(area) || !is_simple(area.view()));
  return area;
}

VCarveOptions random_options(Random& random) {
  VCarveOptions options{.included_angle_deg = random.between(20.0, 140.0)};
  if (random.chance(0.3)) options.greatest_depth_mm = random.magnitude(0.2, 10.0);
  return options;
}

/// Returns the number of links that lead through uncut stock.
std::size_t links_in_stock(const VCarving& carving) {
  using Point = cnc::pocket::PathPoint<double>;
  const auto path = carving.path();
  const auto is_same = [](const Point& a, const Point& b) {
    return a.x == b.x && a.y == b.y && a.z == b.z;
  };
  std::size_t count = 0;
  for (std::size_t row = 0; row < path.row_ends.size(); ++row) {
    for (std::uint32_t i = path.row_begin(row); i + 1 < path.row_ends[row]; ++i) {
      if (path.points[i].use != cnc::pocket::Use::kLink) continue;
      bool is_cut = false;
      for (std::uint32_t k = 0; k < i && !is_cut; ++k) {
        const Point& a = path.points[k];
        const Point& b = path.points[k + 1];
        is_cut = a.use == cnc::pocket::Use::kPass &&
                 ((is_same(a, path.points[i]) && is_same(b, path.points[i + 1])) ||
                  (is_same(b, path.points[i]) && is_same(a, path.points[i + 1])));
      }
      count += is_cut ? 0 : 1;
    }
  }
  return count;
}

void expect_carved(const sim::Contour& area, const VCarveOptions& options) {
  const VCarving carving = sim::pocket::v_carve(area.view(), options);
  const CarveVerdict verdict = judge_carving(area.view(), carving, options);
  EXPECT_LE(verdict.gouge_mm, kMaxGouge_mm);
  EXPECT_LE(verdict.too_shallow_mm, kMaxShallow_mm);
  EXPECT_LE(verdict.unreached_mm, kMaxUnreached_mm);
  EXPECT_GE(verdict.lowest_mm, -options.greatest_depth_mm - 1.0e-6);
  EXPECT_NEAR(carving.depth_mm, -verdict.lowest_mm, 1.0e-9);
  EXPECT_EQ(links_in_stock(carving), 0U);
}

TEST(CarvedAreas, FollowTheLocalWidthAndReachEveryWall) {
  for (const std::uint64_t seed : Trials{60}) {
    Random random{seed};
    const sim::Contour area = random_area(random);
    expect_carved(area, random_options(random));
  }
}

TEST(CarvedAreas, AreLettersOfAFont) {
  std::size_t count = 0;
  for (const auto& [name, glyph] : glyphs_of_font().items()) {
    SCOPED_TRACE(name);
    const sim::Contour area = letter(glyph, 30.0);
    if (area.vertices.empty()) continue;  // The glyph of the space has no contour.
    ASSERT_TRUE(is_simple(area.view()));
    ++count;
    if (is_in_share(count, 4)) expect_carved(area, {.included_angle_deg = 60.0});
  }
  EXPECT_GT(count, 10U);
}

}  // namespace
}  // namespace proof
