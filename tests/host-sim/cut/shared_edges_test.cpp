
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "tests/host-sim/cut/burnt_sheet.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

using testing::IsEmpty;

constexpr double kWidestGap = 0.02;
constexpr double kEvery = 0.05;  ///< Distance of points along edges and paths, mm.
constexpr double kChord = 1.0e-4;

/// A part as SVG draws it, and as a polygon; y points up from the lower edge of a sheet of 100 mm.
struct Part {
  std::string path{};
  Outline outline{};
  std::vector<Place> corners{};
  Place middle{0.0, 0.0};

  void begin(const Place& place) {
    corners = {place};
    path = fmt::format("M{:.9f} {:.9f}", place.x(), 100.0 - place.y());
    outline = {place};
  }
  void go(const Place& place) {
    path += fmt::format("L{:.9f} {:.9f}", place.x(), 100.0 - place.y());
    outline.push_back(place);
    corners.push_back(place);
  }
  /// Appends an arc around `centre`, from one angle to another one, of less than half a turn.
  void turn(const Place& centre, double radius, double from, double to) {
    const Place end = centre + radius * drawing::direction(to);
    path += fmt::format("A{0:.9f} {0:.9f} 0 0 {1} {2:.9f} {3:.9f}",
                        radius,
                        to > from ? 0 : 1,
                        end.x(),
                        100.0 - end.y());
    corners.push_back(end);
    const int chords = 1 + static_cast<int>(std::abs(to - from) / std::sqrt(8.0 * kChord / radius));
    for (int k = 1; k <= chords; ++k) {
      outline.push_back(centre + radius * drawing::direction(from + (to - from) * k / chords));
    }
  }
};

Part rectangle(const Place& least, const Place& size, double angle) {
  const auto turned = [&](double x, double y) {
    const Place off = least + Place{x * size.x(), y * size.y()} - Place{50.0, 50.0};
    return Place{50.0 + off.x() * std::cos(angle) - off.y() * std::sin(angle),
                 50.0 + off.x() * std::sin(angle) + off.y() * std::cos(angle)};
  };
  Part part;
  part.begin(turned(0.0, 0.0));
  part.go(turned(1.0, 0.0));
  part.go(turned(1.0, 1.0));
  part.go(turned(0.0, 1.0));
  part.middle = turned(0.5, 0.5);
  return part;
}

Part sector(double inner, double outer, double from, double to) {
  const Place centre{50.0, 50.0};
  Part part;
  part.begin(centre + inner * drawing::direction(from));
  part.go(centre + outer * drawing::direction(from));
  part.turn(centre, outer, from, to);
  part.go(centre + inner * drawing::direction(to));
  part.turn(centre, inner, to, from);
  part.middle = centre + 0.5 * (inner + outer) * drawing::direction(0.5 * (from + to));
  return part;
}

/// Returns the limits of bricks in a row, from 0 on.
std::vector<double> random_splits(proof::Random& random, double length, double least) {
  std::vector<double> splits{0.0};
  const double most = random.between(1.5, 4.0) * least;
  while (length - splits.back() > 2.0 * least) {
    const double width = random.between(least, std::max(least, most));
    splits.push_back(splits.back() + std::min(width, length - splits.back() - least));
  }
  splits.push_back(length);
  return splits;
}

void shuffle(std::vector<Part>& parts, proof::Random& random) {
  for (std::size_t i = parts.size(); i > 1; --i) std::swap(parts[i - 1], parts[random.below(i)]);
}

/// Returns rows of bricks. Corners meet each other or the middle of edges, and ends are flush or
/// not. Some bricks are missing, so that others touch only at corners.
std::vector<Part> random_wall(proof::Random& random) {
  const double angle =
      random.chance(0.3) ? 0.0 : random.between(-std::numbers::pi, std::numbers::pi);
  const bool is_grid = random.chance(0.3);
  const bool is_flush = is_grid || random.chance(0.5);
  const double length = random.between(8.0, 40.0);
  const std::vector<double> grid = random_splits(random, length, 3.0);
  std::vector<Part> parts;
  double y = 30.0;
  for (std::size_t row = 1 + random.below(4); row > 0; --row) {
    const double height = random.between(3.0, 9.0);
    const double x = 30.0 + (is_flush ? 0.0 : random.between(-5.0, 5.0));
    const std::vector<double> splits = is_grid ? grid : random_splits(random, length, 3.0);
    for (std::size_t i = 1; i < splits.size(); ++i) {
      if (random.chance(0.1)) continue;
      const Place size{splits[i] - splits[i - 1], height};
      parts.push_back(rectangle({x + splits[i - 1], y}, size, angle));
    }
    y += height;
  }
  shuffle(parts, random);
  return parts;
}

/// Returns similar bricks in rings, which have arcs in common.
std::vector<Part> random_rings(proof::Random& random) {
  const bool is_grid = random.chance(0.3);
  const double span = random.between(1.0, 5.5);
  const double first = random.between(-3.0, 3.0);
  double inner = random.between(8.0, 14.0);
  const std::vector<double> grid = random_splits(random, span, 0.5);
  std::vector<Part> parts;
  for (std::size_t row = 1 + random.below(3); row > 0; --row) {
    const double outer = inner + random.between(3.0, 8.0);
    const std::vector<double> splits = is_grid ? grid : random_splits(random, span, 0.5);
    for (std::size_t i = 1; i < splits.size(); ++i) {
      parts.push_back(sector(inner, outer, first + splits[i - 1], first + splits[i]));
    }
    inner = outer;
  }
  shuffle(parts, random);
  return parts;
}

CutPlan plan_of_parts(const std::vector<Part>& parts, const LayerSettings& settings) {
  std::string content;
  for (const Part& part : parts) {
    content += "<path d=\"" + part.path + "Z\" fill=\"none\" stroke=\"black\"/>";
  }
  return plan_of(drawing::read(drawing::svg_of(content)), settings);
}

double distance_to_outline(const Outline& outline, const Place& place) {
  return distance_to_all({outline}, place);
}

bool holds_place(const Outline& outline, const Place& place) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Place& a = outline[i];
    const Place& b = outline[(i + 1) % outline.size()];
    if ((a.y() > place.y()) == (b.y() > place.y())) continue;
    const double x = a.x() + (b.x() - a.x()) * (place.y() - a.y()) / (b.y() - a.y());
    inside = inside != (place.x() < x);
  }
  return inside;
}

/// A point on a drawn edge.
struct EdgePoint {
  Place place{0.0, 0.0};
  bool is_shared = false;
};

std::vector<EdgePoint> points_of(const std::vector<Part>& parts) {
  std::vector<EdgePoint> points;
  for (const Part& part : parts) {
    for (std::size_t i = 0; i < part.outline.size(); ++i) {
      const Stroke edge{part.outline[i], part.outline[(i + 1) % part.outline.size()]};
      for (const Place& place : places_along(edge, kEvery)) {
        const auto touches = [&](const Part& other) {
          return &other != &part && distance_to_outline(other.outline, place) < 2.0 * kChord;
        };
        points.push_back({place, std::ranges::any_of(parts, touches)});
      }
    }
  }
  return points;
}

/// The strokes of a plan that cut contours, and all its strokes.
struct Driven {
  std::vector<Stroke> contours{};
  std::vector<Place> places{};
};

Driven driven_of(const CutPlan& plan) {
  Driven driven;
  for (const Cut& cut : plan.cuts) {
    for (const Stroke& stroke : cut.strokes) {
      if (stroke.purpose == Purpose::kContour) driven.contours.push_back(stroke);
      for (const Place& place : places_along(stroke, kEvery)) driven.places.push_back(place);
    }
  }
  return driven;
}

double nearest_of(const std::vector<Stroke>& strokes, const Place& place) {
  double nearest = 1.0e9;
  for (const Stroke& stroke : strokes) nearest = std::min(nearest, distance_to(stroke, place));
  return nearest;
}

double nearest_shared(const std::vector<EdgePoint>& points, const Place& place) {
  double nearest = 1.0e9;
  for (const EdgePoint& point : points) {
    if (point.is_shared) nearest = std::min(nearest, drawing::distance(point.place, place));
  }
  return nearest;
}

/// Returns the length of line that is driven a second time, mm.
double length_twice(const std::vector<Stroke>& strokes) {
  double twice = 0.0;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const double length = length_of(strokes[i]);
    const int count = 1 + static_cast<int>(length / kEvery);
    for (int k = 0; k < count; ++k) {
      const double share = (k + 0.5) / count;
      const Place place = place_at(strokes[i], share);
      const Place way = tangent_at(strokes[i], share);
      for (std::size_t other = 0; other < i; ++other) {
        if (distance_to(strokes[other], place) > 1.0e-4) continue;
        const double beside = 0.1 * kHalf;
        const bool runs_along = distance_to(strokes[other], place + beside * way) < 0.1 * beside ||
                                distance_to(strokes[other], place - beside * way) < 0.1 * beside;
        if (!runs_along) continue;
        twice += length / count;
        break;
      }
    }
  }
  return twice;
}

/// Returns whether a place is between two ends of strokes that are so near to each other that the
/// beam at these ends removes the material between them, up to a micrometre at the edges.
bool is_burnt_from_ends(const std::vector<Stroke>& strokes, const Place& place) {
  const double longest = 2.0 * std::sqrt(2.0 * kHalf * 1.0e-3);
  std::vector<Place> ends;
  for (const Stroke& stroke : strokes) {
    for (const Place& end : {stroke.from, stroke.to}) {
      if (drawing::distance(end, place) < longest) ends.push_back(end);
    }
  }
  return std::ranges::any_of(ends, [&](const Place& a) {
    return std::ranges::any_of(ends, [&](const Place& b) {
      return drawing::dot(a - place, b - place) < 0.0 && drawing::distance(a, b) <= longest;
    });
  });
}

/// Returns by how much shared cuts may be beside drawn edges, mm. Corners of different parts that
/// are a little apart count as one, and a cut that ends there ends at one of them.
double allowed_beside(const std::vector<Part>& parts) {
  constexpr double kSameCorner = 0.02;
  double beside = 0.0;
  for (const Part& part : parts) {
    for (const Part& other : parts) {
      for (const Place& corner : part.corners) {
        for (const Place& near : other.corners) {
          const double apart = drawing::distance(corner, near);
          if (apart <= kSameCorner) beside = std::max(beside, apart);
        }
      }
    }
  }
  return beside;
}

/// Checks a plan with the polygons of the parts alone.
void judge(const std::vector<Part>& parts, const CutPlan& plan) {
  const double beside = allowed_beside(parts);
  ASSERT_THAT(plan.faults, IsEmpty()) << plan.faults.front().reason;
  const Driven driven = driven_of(plan);
  const std::vector<EdgePoint> points = points_of(parts);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const EdgePoint& point = points[i];
    const double nearest = nearest_of(driven.contours, point.place);
    if (point.is_shared) {
      // Where only corners touch, no cut is necessary.
      const bool is_line =
          i > 0 && i + 1 < points.size() && points[i - 1].is_shared && points[i + 1].is_shared;
      if (is_line && is_burnt_from_ends(driven.contours, point.place)) continue;
      ASSERT_LT(nearest, is_line ? beside + 1.0e-3 : kHalf + 1.0e-3) << point.place.transpose();
      continue;
    }
    // Lines from the ends of shared edges lead through the waste between both parts.
    const double away = nearest_shared(points, point.place);
    ASSERT_GT(nearest, std::min(kHalf, 0.35 * (away - kEvery)) - 1.0e-3) << point.place.transpose();
    ASSERT_LT(nearest, std::numbers::sqrt2 * kHalf + 1.0e-3) << point.place.transpose();
  }
  for (const Place& place : driven.places) {
    for (const Part& part : parts) {
      if (!holds_place(part.outline, place)) continue;
      ASSERT_LT(distance_to_outline(part.outline, place), beside + 3.0 * kChord)
          << place.transpose();
    }
  }
  const BurntSheet sheet{plan};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    EXPECT_FALSE(sheet.are_one(parts[i].middle, {1.0, 1.0})) << "part " << i;
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_FALSE(sheet.are_one(parts[i].middle, parts[k].middle)) << i << " and " << k;
    }
  }
  EXPECT_LT(length_twice(driven.contours), 1.0e-3);
}

/// Returns whether two parts are nearer than the kerf without touching.
bool are_too_near(const Part& a, const Part& b) {
  double apart = 1.0e9;
  for (const Place& corner : a.outline) {
    apart = std::min(apart, distance_to_outline(b.outline, corner));
  }
  return apart > 1.0e-6 && apart < kTestKerf + 1.0e-3;
}

TEST(EdgesOfParts, AreCutOnceBetweenBricks) {
  const proof::Trials trials{20};
  std::size_t lines = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const std::vector<Part> parts = random_wall(random);
    // If a gap next to two bricks is narrower than the kerf, no cut is possible between them.
    const auto is_near_another = [&parts](const Part& part) {
      return std::ranges::any_of(parts, [&part](const Part& other) {
        return are_too_near(part, other) || are_too_near(other, part);
      });
    };
    if (std::ranges::any_of(parts, is_near_another)) continue;
    const CutPlan plan = plan_of_parts(parts, {.common_line_mm = kWidestGap});
    judge(parts, plan);
    if (testing::Test::HasFailure()) return;
    lines += plan.shared.lines;
  }
  std::printf("%zu lines shared\n", lines);
  if (!trials.judges_shares()) return;
  EXPECT_GT(lines, 0U);
}

TEST(EdgesOfParts, AreCutOnceBetweenBricksOfRings) {
  const proof::Trials trials{20};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const std::vector<Part> parts = random_rings(random);
    judge(parts, plan_of_parts(parts, {.common_line_mm = kWidestGap}));
    if (testing::Test::HasFailure()) return;
  }
}

}  // namespace
}  // namespace sim::cut
