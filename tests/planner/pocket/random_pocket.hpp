#pragma once

#include <cmath>
#include <numbers>

#include "tests/planner/contour/exact_distance.hpp"
#include "tests/planner/pocket/pocket_bench.hpp"
#include "tests/planner/pocket/pocket_oracle.hpp"
#include "tests/support/random_source.hpp"

namespace cnc::pocket {

/// Adds a star of lines and arcs around a centre, which does not cross itself. As an island, it
/// runs clockwise.
inline void add_star(PocketBench& bench,
                     proof::Random& random,
                     const WideVec2& centre,
                     double min_radius,
                     double max_radius,
                     bool island) {
  struct Corner {
    WideVec2 place;
    double bulge;
  };
  const std::size_t count = 3 + random.below(12);
  std::vector<Corner> corners;
  const double step = 2.0 * std::numbers::pi / static_cast<double>(count);
  // Each side appears from the centre under an angle of less than π.
  const double max_shift = count == 3 ? 0.2 : 0.3;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = step * (static_cast<double>(i) + random.between(-max_shift, max_shift));
    const double radius = random.between(min_radius, max_radius);
    corners.push_back({radius * WideVec2{std::cos(angle), std::sin(angle)}, 0.0});
  }
  for (std::size_t i = 0; i < count; ++i) {
    // An arc whose tangents stay between the chord and the rays to both ends crosses no ray twice.
    const WideVec2 from = corners[i].place;
    const WideVec2 to = corners[(i + 1) % count].place;
    const WideVec2 chord = to - from;
    const double start = std::atan2(cross(from, chord), from.dot(chord));
    const double end = std::atan2(cross(to, chord), to.dot(chord));
    const double slack = std::min(std::min(start, end), std::numbers::pi - std::max(start, end));
    if (random.chance(0.5)) corners[i].bulge = std::tan(0.5 * random.between(-0.8, 0.8) * slack);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t k = island ? count - 1 - i : i;
    const double bulge = island ? -corners[(k + count - 1) % count].bulge : corners[k].bulge;
    bench.add(centre.x() + corners[k].place.x(), centre.y() + corners[k].place.y(), bulge);
  }
  bench.close();
}

/// Adds rooms in a row with necks between them. Some necks are as wide as the tool, some rooms are
/// round at their ends.
inline void add_rooms(PocketBench& bench, proof::Random& random, double radius) {
  const std::size_t rooms = 2 + random.below(4);
  std::vector<WideVec2> above;
  double x = 0.0;
  for (std::size_t i = 0; i < rooms; ++i) {
    const double width = random.between(1.0, 8.0) * radius;
    const double half = random.between(1.0, 9.0) * radius;
    above.push_back({x, half});
    above.push_back({x + width, half});
    x += width;
    if (i + 1 == rooms) break;
    const double neck = random.chance(0.2) ? radius : random.between(0.5, 3.0) * radius;
    const double length = random.between(0.2, 5.0) * radius;
    above.push_back({x, neck});
    above.push_back({x + length, neck});
    x += length;
  }
  const auto arc = [&random] { return random.chance(0.3) ? random.between(-0.2, 0.3) : 0.0; };
  for (std::size_t i = 0; i < above.size(); ++i) {
    const bool wall = i % 4 == 0;
    bench.add(above[i].x(), -above[i].y(), wall ? std::max(0.0, arc()) : 0.0);
  }
  const double round = random.chance(0.5) ? 1.0 : 0.0;
  for (std::size_t i = above.size(); i-- > 0;) {
    bench.add(above[i].x(), above[i].y(), i == 0 ? round : 0.0);
  }
  bench.close();
}

/// Returns whether no two elements but neighbours are nearer to each other than `gap`.
inline bool is_apart(const contour::ContourView<double>& contour, double gap) {
  struct Element {
    contour::exact::PlainArc arc;
    std::size_t loop;
    std::uint32_t index;
    std::uint32_t count;
  };
  std::vector<Element> elements;
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    const std::uint32_t first = contour.loop_begin(loop);
    const std::uint32_t count = contour.loop_ends[loop] - first;
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto& from = contour.vertices[first + i];
      const auto& to = contour.vertices[first + (i + 1) % count];
      elements.push_back(
          {contour::exact::PlainArc{{from.point(), to.point(), from.bulge}}, loop, i, count});
    }
  }
  for (const Element& one : elements) {
    for (const Element& other : elements) {
      if (one.loop == other.loop) {
        const std::uint32_t apart = (other.index + one.count - one.index) % one.count;
        if (apart <= 1 || apart == one.count - 1) continue;
      }
      for (int k = 0; k <= 100; ++k) {
        if (other.arc.distance(one.arc.at(0.01 * k)) < gap) return false;
      }
    }
  }
  return true;
}

/// Returns whether the first loop encloses the first vertex of each other loop.
inline bool islands_are_inside(const contour::ContourView<double>& contour) {
  PlainContour outline;
  outline.add({{contour.vertices.begin(), contour.loop_ends[0]}, {contour.loop_ends.begin(), 1}});
  for (std::size_t loop = 1; loop < contour.loop_ends.size(); ++loop) {
    if (!outline.encloses(contour.vertices[contour.loop_begin(loop)].point())) return false;
  }
  return true;
}

/// Adds a star with up to four islands, or rooms, as the pocket of the bench.
inline void draw_pocket(PocketBench& bench, proof::Random& random, double radius) {
  if (random.chance(0.3)) {
    add_rooms(bench, random, radius);
    return;
  }
  const double least = random.between(1.5, 14.0) * radius;
  const WideVec2 centre{random.between(-50, 50), 20.0};
  add_star(bench, random, centre, least, least * random.between(1.0, 3.0), false);
  if (random.chance(0.4)) return;
  const double cell = 0.35 * least;
  for (int corner = 0; corner < 4; ++corner) {
    if (random.chance(0.4)) continue;
    const WideVec2 place{centre.x() + ((corner & 1) - 0.5) * cell,
                         centre.y() + ((corner >> 1) - 0.5) * cell};
    add_star(bench, random, place, 0.05 * cell, random.between(0.1, 0.45) * cell, true);
  }
}

/// Fills an empty bench with a random pocket. Its loops do not cross, and all islands are inside.
/// Returns the radius of the tool.
inline double add_random_pocket(PocketBench& bench, proof::Random& random) {
  const double radius = random.magnitude(0.5, 8.0);
  for (;;) {
    draw_pocket(bench, random, radius);
    const contour::ContourView<double> pocket = bench.pocket();
    if (is_apart(pocket, 0.01 * radius) && islands_are_inside(pocket)) return radius;
    bench.forget();
  }
}

}  // namespace cnc::pocket
