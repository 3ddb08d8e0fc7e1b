#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

#include "planner/compensation/compensator.hpp"
#include "tests/support/contour_corpus.hpp"
#include "tests/support/contour_oracle.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::compensation::Compensator;
using cnc::compensation::Fault;
using Element = ExactContour::Element;

/// Depth of a cut into the outline from which on it counts as a gouge, mm.
constexpr double kGouge = 1.0e-4;

/// A closed outline that begins within a line, with an entry that starts at a distance from the
/// outline.
struct Outline {
  sim::Contour contour;
  /// Offset of the tool, mm; positive is to the right of the outline, which is outside.
  double offset_mm = 0.0;
  double entry_x = 0.0;
  double entry_y = 0.0;
};

Outline random_outline(Random& random) {
  Outline outline{.contour = programmed_star(random, 14)};
  for (auto& vertex : outline.contour.vertices) {
    vertex.bulge = static_cast<double>(static_cast<float>(vertex.bulge));
  }
  outline.offset_mm = random.signed_magnitude(0.05, 10.0);
  return outline;
}

struct Driven {
  std::vector<cnc::PathElement> way;
  std::optional<Fault> fault;
  std::size_t given_before_end = 0;
};

cnc::Coordinate place(double mm) {
  return cnc::Coordinate{static_cast<std::int64_t>(std::llround(mm * 1.0e6))};
}

class OutlineDriver {
 public:
  explicit OutlineDriver(const Outline& outline) : outline_{outline} {}

  Driven drive() {
    const auto& first = outline_.contour.vertices[0];
    at(here_, outline_.entry_x, outline_.entry_y);
    compensator_.begin(here_, cnc::Plane::kXY, static_cast<float>(outline_.offset_mm));
    put(first.x, first.y, 0.0);
    const auto& vertices = outline_.contour.vertices;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const auto& to = vertices[(i + 1) % vertices.size()];
      put(to.x, to.y, vertices[i].bulge);
    }
    driven_.given_before_end = driven_.way.size();
    if (!driven_.fault) driven_.fault = compensator_.end();
    if (!driven_.fault) take();
    return driven_;
  }

 private:
  static void at(cnc::Position& position, double x, double y) {
    position[0] = place(x);
    position[1] = place(y);
  }
  void put(double x, double y, double bulge) {
    if (driven_.fault) return;
    cnc::PathElement element{.start = here_, .bulge = static_cast<float>(bulge)};
    at(here_, x, y);
    element.end = here_;
    driven_.fault = compensator_.put({.request = {.element = element, .feed_mm_s = 10.0F}});
    if (!driven_.fault) take();
  }
  void take() {
    cnc::path::PathItem item;
    while (compensator_.take(item)) driven_.way.push_back(item.request.element);
  }

  const Outline& outline_;
  Compensator compensator_{};
  cnc::Position here_{};
  Driven driven_{};
};

/// Returns the elements of an open path by centres and angles, without a closing line.
std::vector<Element> exact(const std::vector<cnc::PathElement>& way) {
  sim::Contour contour;
  for (const cnc::PathElement& element : way) {
    contour.vertices.push_back({static_cast<double>(element.start[0].nanometres()) * 1.0e-6,
                                static_cast<double>(element.start[1].nanometres()) * 1.0e-6,
                                static_cast<double>(element.bulge)});
  }
  contour.vertices.push_back({static_cast<double>(way.back().end[0].nanometres()) * 1.0e-6,
                              static_cast<double>(way.back().end[1].nanometres()) * 1.0e-6,
                              0.0});
  contour.end_loop();
  auto elements = ExactContour{contour.view()}.elements();
  if (elements.size() > way.size()) elements.resize(way.size());
  return elements;
}

template <typename See>
void sample(const std::vector<Element>& elements, See&& see) {
  for (const Element& element : elements) {
    const auto steps = 8 + static_cast<int>(4.0 * element.length());
    for (int i = 0; i <= steps; ++i) {
      std::array<double, 4> at{};
      element.at(static_cast<double>(i) / steps, at[0], at[1], at[2], at[3]);
      see(at[0], at[1]);
    }
  }
}

double distance(const std::vector<Element>& elements, double x, double y) {
  double least = 1.0e9;
  for (const Element& element : elements) least = std::min(least, element.distance(x, y));
  return least;
}

/// Returns whether the result contains points at the offset from every element of the outline.
bool all_are_reached(const ExactContour& outline, const std::vector<Element>& result, double r) {
  return std::ranges::all_of(outline.elements(), [&](const Element& element) {
    bool reached = false;
    sample(result, [&](double x, double y) {
      reached = reached || element.distance(x, y) < std::abs(r) + 1.0e-5;
    });
    return reached;
  });
}

/// Returns whether the tool has room at the offset from the start, and room for the turn of the
/// entry there.
bool begins_in_the_open(const ExactContour& outline, double offset_mm) {
  std::array<double, 4> at{};
  outline.elements()[0].at(0.0, at[0], at[1], at[2], at[3]);
  const double r = std::abs(offset_mm);
  if (outline.elements()[0].length() < 2.0 * r) return false;
  for (const double along : {0.0, 1.0}) {
    for (const double aside : {1.0, 1.25, 1.5}) {
      const double x = at[0] + aside * offset_mm * at[2] - along * r * at[3];
      const double y = at[1] + aside * offset_mm * at[3] + along * r * at[2];
      if (outline.distance(x, y) < r - 1.0e-6) return false;
    }
  }
  return true;
}

struct Tally {
  std::uint64_t accepted = 0;
  std::uint64_t refused = 0;
  std::uint64_t refused_although_one_loop = 0;
  std::uint64_t refused_needlessly = 0;  ///< Refused although the offset reaches every element.
  double deepest = -1.0;
  double farthest = 0.0;
};

void judge(Random& random, Tally& tally) {
  Outline outline = random_outline(random);
  const ExactContour exact_outline{outline.contour.view()};
  sim::ContourOffset offsetter;
  const auto oracle_view = offsetter.offset(outline.contour.view(), outline.offset_mm);
  const bool one_loop = oracle_view.loop_ends.size() == 1;
  const ExactContour oracle{oracle_view};
  // The entry begins beside the start of the first element, at 1.5 times the offset.
  const auto& first = outline.contour.vertices[0];
  std::array<double, 4> at{};
  exact_outline.elements()[0].at(0.0, at[0], at[1], at[2], at[3]);
  outline.entry_x = programmed(first.x + 1.5 * outline.offset_mm * at[2]);
  outline.entry_y = programmed(first.y + 1.5 * outline.offset_mm * at[3]);

  const Driven driven = OutlineDriver{outline}.drive();
  const double r = std::abs(outline.offset_mm);
  if (driven.fault) {
    ++tally.refused;
    EXPECT_EQ(driven.given_before_end, 0U) << "refused after motion";
    // The entry turns into the first element, which requires room for the tool.
    if (!one_loop || !begins_in_the_open(exact_outline, outline.offset_mm)) return;
    ++tally.refused_although_one_loop;
    if (all_are_reached(exact_outline, oracle.elements(), r)) ++tally.refused_needlessly;
    return;
  }
  ++tally.accepted;
  const std::vector<Element> way = exact(driven.way);
  sample(way, [&](double x, double y) {
    tally.deepest = std::max(tally.deepest, r - exact_outline.distance(x, y));
  });
  EXPECT_LE(tally.deepest, kGouge);
  EXPECT_TRUE(one_loop) << oracle_view.loop_ends.size() << " loops";
  if (!one_loop) return;
  // The compensated path and the oracle's offset are one curve. Only the end of the entry lies
  // beyond the start.
  const std::vector<Element> beside{way.begin() + 1, way.end()};
  sample(beside, [&](double x, double y) {
    tally.farthest = std::max(tally.farthest, oracle.distance(x, y));
  });
  EXPECT_LE(tally.farthest, kGouge);
  sample(oracle.elements(), [&](double x, double y) {
    const double near_start = std::hypot(x - at[0], y - at[1]);
    if (near_start > 3.0 * r) tally.farthest = std::max(tally.farthest, distance(beside, x, y));
  });
  EXPECT_LE(tally.farthest, kGouge);
}

// KERFLINE_TRIALS=100000 runs 100,000 trials.
TEST(CompensatedOutlines, NeverComeNearerThanTheOffsetAndAreTheOffset) {
  const Trials trials{2000};
  Tally tally;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    judge(random, tally);
  }
  // Refusals are allowed where several offsets touch each other to within single precision.
  EXPECT_LE(tally.refused_needlessly * 2000, trials.count() + 2000);
  std::printf(
      "%llu driven, %llu refused (%llu of them one loop, %llu without need), "
      "at most %.2g mm too near\n",
      static_cast<unsigned long long>(tally.accepted),
      static_cast<unsigned long long>(tally.refused),
      static_cast<unsigned long long>(tally.refused_although_one_loop),
      static_cast<unsigned long long>(tally.refused_needlessly),
      tally.deepest);
}

}  // namespace
}  // namespace proof
