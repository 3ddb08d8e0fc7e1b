#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/contour/arrangement.hpp"
#include "host-sim/import/filled_set.hpp"
#include "host-sim/import/filling.hpp"
#include "tests/support/contour_oracle.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using sim::Contour;
using sim::drawing::FillingLoop;

constexpr double kSideMm = 8.0;

/// Draws loops that cross, touch or overlap each other, contain each other, or occur twice.
class RandomLoops {
 public:
  explicit RandomLoops(Random& random) : random_{random} {}

  Contour make() {
    const std::size_t loops = 1 + random_.below(random_.chance(0.2) ? 12 : 4);
    for (std::size_t loop = 0; loop < loops; ++loop) {
      if (loop > 0 && random_.chance(0.2)) {
        add_copy();
      } else {
        add_new();
      }
    }
    return std::move(contour_);
  }

 private:
  /// Returns a coordinate in whole, half or any millimetres, so that corners and edges often
  /// coincide.
  double coordinate() {
    const double any = random_.between(0.0, kSideMm);
    if (random_.chance(0.6)) return std::round(any);
    return random_.chance(0.5) ? 0.5 * std::round(2.0 * any) : any;
  }

  void add(double x, double y, double bulge) { contour_.vertices.push_back({x, y, bulge}); }

  void add_new() {
    switch (random_.below(5)) {
      case 0:
        return add_box();
      case 1:
        return add_circle();
      case 2:
        return add_box_with_corner_loops();
      default:
        return add_polygon();
    }
  }

  void add_box() {
    const double x = coordinate();
    const double y = coordinate();
    const double width = 1.0 + coordinate();
    const double height = 1.0 + coordinate();
    const double bulge = random_.chance(0.3) ? random_.between(-1.0, 1.0) : 0.0;
    add(x, y, 0.0);
    add(x + width, y, bulge);
    add(x + width, y + height, 0.0);
    if (random_.chance(0.2)) add(x + width / 2.0, y + height, 0.0);
    if (random_.chance(0.1)) add_spike(x, y + height);
    add(x, y + height, random_.chance(0.2) ? -bulge : 0.0);
    contour_.end_loop();
  }

  void add_spike(double x, double y) {
    add(x, y, 0.0);
    add(x + coordinate(), y + coordinate(), 0.0);
  }

  void add_circle() {
    const double x = coordinate();
    const double y = coordinate();
    const double radius = 0.5 + 0.5 * std::floor(random_.between(0.0, 6.0));
    const double turn = random_.chance(0.5) ? 1.0 : -1.0;
    add(x - radius, y, turn);
    add(x + radius, y, turn);
    contour_.end_loop();
  }

  /// Adds a box like those of box generators, whose outline passes a corner and loops back to it.
  void add_box_with_corner_loops() {
    const double x = coordinate();
    const double y = coordinate();
    const double size = 1.0 + coordinate();
    const double loop = random_.magnitude(0.01, 0.5);
    add(x, y, 0.0);
    add(x + size, y, 0.0);
    add(x + size + loop, y, -0.9);
    add(x + size, y - loop, 0.0);
    add(x + size, y + size, 0.0);
    add(x, y + size, 0.0);
    contour_.end_loop();
  }

  void add_polygon() {
    const std::size_t corners = 3 + random_.below(6);
    for (std::size_t i = 0; i < corners; ++i) {
      const double bulge = random_.chance(0.4) ? random_.between(-2.0, 2.0) : 0.0;
      add(coordinate(),
          coordinate(),
          random_.chance(0.1) ? random_.signed_magnitude(1e-9, 1e-3) : bulge);
      if (random_.chance(0.05)) contour_.vertices.push_back(contour_.vertices.back());
    }
    contour_.end_loop();
  }

  /// Adds a copy of an earlier loop, shifted by nothing, by a rounding error or by a little more.
  void add_copy() {
    const std::size_t loop = random_.below(contour_.loop_ends.size());
    const double away = random_.chance(0.4) ? 0.0 : random_.signed_magnitude(1.0e-10, 1.0e-1);
    const auto first = contour_.view().loop_begin(loop);
    for (std::uint32_t i = first; i < contour_.loop_ends[loop]; ++i) {
      const sim::ContourVertex vertex = contour_.vertices[i];
      add(vertex.x + away, vertex.y, vertex.bulge);
    }
    contour_.end_loop();
  }

  Random& random_;
  Contour contour_{};
};

/// Returns whether a point is inside of the filled shape, by winding numbers that share nothing
/// with the arrangement.
bool is_inside(const ExactContour& loops,
               const std::vector<std::optional<FillingLoop>>& filling,
               double x,
               double y) {
  bool inside = false;
  int of_shape = 0;
  for (std::size_t loop = 0; loop < filling.size(); ++loop) {
    const int turns = loops.winding_of_loop(loop, x, y);
    if (filling[loop]->is_nonzero) {
      of_shape += turns;
    } else {
      inside = inside != (turns % 2 != 0);
    }
  }
  return inside != (of_shape != 0);
}

struct FilledTrial {
  Contour loops{};
  std::vector<std::optional<FillingLoop>> filling{};
  Contour outlines{};
};

std::optional<FilledTrial> filled(Random& random) {
  FilledTrial shape{.loops = RandomLoops{random}.make()};
  const bool all_nonzero = random.chance(0.3);
  for (std::size_t i = 0; i < shape.loops.loop_ends.size(); ++i) {
    // All loops with the rule `nonzero` form one shape. Each of the other loops is a shape by
    // itself.
    const bool is_nonzero = all_nonzero || random.chance(0.1);
    shape.filling.emplace_back(
        FillingLoop{is_nonzero, is_nonzero ? 0U : static_cast<std::uint32_t>(i + 1)});
  }
  for (const double touch_mm : sim::drawing::kFillTouchesMm) {
    sim::Arrangement arrangement;
    if (!arrangement.divide(shape.loops.view(), touch_mm)) continue;
    std::vector<std::uint32_t> edges(arrangement.edges().size());
    std::iota(edges.begin(), edges.end(), 0U);
    auto found = fill_set(arrangement, edges, shape.filling, {.area_mm2 = 0.0, .width_mm = 0.0});
    if (!found) continue;
    shape.outlines = std::move(found->outlines);
    return shape;
  }
  return std::nullopt;
}

/// Compares inside and outside at points all over the loops and close to their elements.
std::string complaint_about(const FilledTrial& shape, Random& random) {
  constexpr int kPlaces = 300;
  constexpr double kTooNear = 2.0e-4;
  const ExactContour loops{shape.loops.view()};
  const ExactContour outlines{shape.outlines.view()};
  for (int i = 0; i < kPlaces; ++i) {
    double x = random.between(-4.0, 2.5 * kSideMm);
    double y = random.between(-4.0, 2.5 * kSideMm);
    if (random.chance(0.6)) {
      const auto& element = loops.elements()[random.below(loops.elements().size())];
      double right_x = 0.0;
      double right_y = 0.0;
      element.at(random.unit(), x, y, right_x, right_y);
      const double away = random.signed_magnitude(2.0 * kTooNear, 0.1);
      x += away * right_x;
      y += away * right_y;
    }
    if (!(loops.distance(x, y) > kTooNear)) continue;
    const int expected = is_inside(loops, shape.filling, x, y) ? 1 : 0;
    const int turns = outlines.winding(x, y);
    if (turns == expected) continue;
    return "at " + std::to_string(x) + " " + std::to_string(y) + " the outlines turn " +
           std::to_string(turns) + " times, not " + std::to_string(expected);
  }
  return {};
}

// KERFLINE_TRIALS=100000 runs 100,000 sets.
TEST(FilledShape, IsWhatWindingNumbersSayAnywhere) {
  const Trials trials{3'000};
  for (const std::uint64_t seed : trials) {
    Random random{seed};
    const auto shape = filled(random);
    ASSERT_TRUE(shape) << "KERFLINE_SEED=" << seed;
    EXPECT_EQ(complaint_about(*shape, random), "") << "KERFLINE_SEED=" << seed;
  }
}

}  // namespace
}  // namespace proof
