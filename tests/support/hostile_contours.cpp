#include "tests/support/hostile_contours.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/contour_oracle.hpp"

namespace proof {
namespace {

using sim::Contour;
using sim::ContourVertex;

constexpr double kQuarterBulge = 0.41421356237309503;  ///< Bulge of a quarter circle: tan(90° / 4).

void append(Contour& to, const Contour& loops) {
  const auto before = static_cast<std::uint32_t>(to.vertices.size());
  to.vertices.insert(to.vertices.end(), loops.vertices.begin(), loops.vertices.end());
  for (const std::uint32_t end : loops.loop_ends) to.loop_ends.push_back(before + end);
}

Contour moved(Contour contour, double x_mm, double y_mm) {
  for (ContourVertex& vertex : contour.vertices) {
    vertex.x += x_mm;
    vertex.y += y_mm;
  }
  return contour;
}

/// Returns the contour with its direction reversed, so that the material is outside.
Contour as_hole(const Contour& contour) {
  Contour hole = contour;
  const std::size_t count = contour.vertices.size();
  for (std::size_t i = 0; i < count; ++i) {
    hole.vertices[i] = contour.vertices[count - 1 - i];
    hole.vertices[i].bulge = -contour.vertices[(2 * count - 2 - i) % count].bulge;
  }
  return hole;
}

Contour circle(double radius_mm) {
  Contour contour{{{radius_mm, 0.0, 1.0}, {-radius_mm, 0.0, 1.0}}, {}};
  contour.end_loop();
  return contour;
}

/// Returns a counter-clockwise outline with steps above and below, on a grid of millimetres.
std::vector<ContourVertex> skyline(Random& random) {
  const std::size_t columns = 2 + random.below(5);
  std::vector<ContourVertex> below;
  std::vector<ContourVertex> above;
  double x = 0.0;
  double low = -100.0;
  double high = -100.0;
  for (std::size_t i = 0; i < columns; ++i) {
    const double next_low = static_cast<double>(random.below(5));
    const double next_high = static_cast<double>(5 + random.below(6));
    if (next_low != low) {
      if (i > 0) below.push_back({x, low, 0.0});
      below.push_back({x, next_low, 0.0});
    }
    if (next_high != high) {
      if (i > 0) above.push_back({x, high, 0.0});
      above.push_back({x, next_high, 0.0});
    }
    low = next_low;
    high = next_high;
    x += static_cast<double>(1 + random.below(4));
  }
  below.push_back({x, low, 0.0});
  above.push_back({x, high, 0.0});
  below.insert(below.end(), above.rbegin(), above.rend());
  return below;
}

/// Returns the polygon with a quarter circle instead of each corner that has space for it.
Contour filleted(const std::vector<ContourVertex>& corners, double radius, Random& random) {
  Contour contour;
  const std::size_t count = corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const ContourVertex& before = corners[(i + count - 1) % count];
    const ContourVertex& corner = corners[i];
    const ContourVertex& after = corners[(i + 1) % count];
    const double in_x = corner.x - before.x;
    const double in_y = corner.y - before.y;
    const double out_x = after.x - corner.x;
    const double out_y = after.y - corner.y;
    const double in = std::abs(in_x) + std::abs(in_y);
    const double out = std::abs(out_x) + std::abs(out_y);
    if (radius == 0.0 || 2.0 * radius > std::min(in, out) || random.chance(0.3)) {
      contour.vertices.push_back(corner);
      continue;
    }
    const double turn = in_x * out_y - in_y * out_x > 0.0 ? kQuarterBulge : -kQuarterBulge;
    contour.vertices.push_back(
        {corner.x - radius * in_x / in, corner.y - radius * in_y / in, turn});
    contour.vertices.push_back(
        {corner.x + radius * out_x / out, corner.y + radius * out_y / out, 0.0});
  }
  contour.end_loop();
  return contour;
}

/// Doubles some vertices, some of them a hundred-billionth of a millimetre apart.
void stutter(Contour& contour, Random& random) {
  std::vector<ContourVertex> vertices;
  for (const ContourVertex& vertex : contour.vertices) {
    vertices.push_back(vertex);
    if (!random.chance(0.3)) continue;
    vertices.back().bulge = 0.0;
    vertices.push_back(vertex);
    if (random.chance(0.3)) vertices.back().x += 1.0e-11;
  }
  contour.vertices = vertices;
  contour.loop_ends.back() = static_cast<std::uint32_t>(vertices.size());
}

/// Adds a spike without width to some lines: out from the middle of the line and back.
void add_spikes(Contour& contour, Random& random) {
  std::vector<ContourVertex> vertices;
  for (std::size_t i = 0; i < contour.vertices.size(); ++i) {
    const ContourVertex& vertex = contour.vertices[i];
    const ContourVertex& next = contour.vertices[(i + 1) % contour.vertices.size()];
    vertices.push_back(vertex);
    if (vertex.bulge != 0.0 || !random.chance(0.3)) continue;
    const double reach = random.between(0.1, 3.0);
    const double dx = next.x - vertex.x;
    const double dy = next.y - vertex.y;
    const double length = std::hypot(dx, dy);
    if (length < 0.5) continue;
    const ContourVertex middle{vertex.x + 0.5 * dx, vertex.y + 0.5 * dy, 0.0};
    vertices.push_back(middle);
    vertices.push_back({middle.x + dy / length * reach, middle.y - dx / length * reach, 0.0});
    vertices.push_back(middle);
  }
  contour.vertices = vertices;
  contour.loop_ends.back() = static_cast<std::uint32_t>(vertices.size());
}

/// Returns a comb with teeth and slots of the given widths; `depth` is that of the slots, mm.
Contour comb(Random& random, double tooth, double slot, double depth) {
  Contour contour;
  const std::size_t teeth = 2 + random.below(4);
  const double width = static_cast<double>(teeth) * (tooth + slot) - slot;
  contour.vertices = {{0.0, -3.0, 0.0}, {width, -3.0, 0.0}};
  for (std::size_t i = teeth; i-- > 0;) {
    const double left = static_cast<double>(i) * (tooth + slot);
    contour.vertices.push_back({left + tooth, depth, 0.0});
    contour.vertices.push_back({left, depth, 0.0});
    if (i == 0) break;
    const bool round = random.chance(0.5);
    contour.vertices.push_back({left, 0.0, round ? -1.0 : 0.0});
    contour.vertices.push_back({left - slot, 0.0, 0.0});
  }
  contour.end_loop();
  return contour;
}

/// Returns a wheel of arcs whose joints are almost tangent.
Contour near_tangent_wheel(Random& random) {
  Contour contour;
  const std::size_t count = 3 + random.below(9);
  const double step = 2.0 * std::numbers::pi / static_cast<double>(count);
  const double radius = random.between(5.0, 40.0);
  const double error = random.signed_magnitude(1.0e-14, 1.0e-2);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = step * static_cast<double>(i);
    const double wobble = random.chance(0.5) ? error : 0.0;
    contour.vertices.push_back({radius * std::cos(angle),
                                radius * std::sin(angle),
                                std::tan(0.25 * step) * (1.0 + wobble)});
  }
  contour.end_loop();
  return contour;
}

/// Returns a plate with a thin wedge.
Contour needle(Random& random) {
  const double width = random.magnitude(1.0e-7, 1.0);
  const double reach = random.between(1.0, 20.0);
  const bool inwards = random.chance(0.5);
  Contour contour{{{0.0, 0.0, 0.0},
                   {40.0, 0.0, 0.0},
                   {40.0, 30.0, 0.0},
                   {20.0 + width, 30.0, 0.0},
                   {20.0 + 0.5 * width, 30.0 + (inwards ? -reach : reach), 0.0},
                   {20.0, 30.0, 0.0},
                   {0.0, 30.0, 0.0}},
                  {}};
  contour.end_loop();
  return contour;
}

Contour hostile_contour(Random& random, double& distance) {
  const double width = 0.5 * static_cast<double>(1 + random.below(8));
  switch (random.below(7)) {
    case 0: {
      distance = 0.5 * width;
      const double other = 0.5 * static_cast<double>(1 + random.below(8));
      return comb(random, width, other, random.between(1.0, 30.0));
    }
    case 1:
      return near_tangent_wheel(random);
    case 2:
      return needle(random);
    case 3: {
      Contour rings = circle(10.0 + width);
      append(rings, as_hole(circle(10.0 - width)));
      append(rings, moved(circle(10.0 - 3.0 * width > 0.5 ? 10.0 - 3.0 * width : 0.5), 0.0, 0.0));
      distance = width;
      return rings;
    }
    case 4:
      return random_star(random, 5 + random.below(20), 1.0, 60.0);
    case 5: {
      const OffsetCase mech = random_mech(random);
      distance = std::abs(mech.distance_mm);
      return mech.contour;
    }
    default: {
      Contour lens{
          {{-10.0, 0.0, random.magnitude(1.0e-9, 1.0)}, {10.0, 0.0, random.magnitude(1.0e-9, 1.0)}},
          {}};
      lens.end_loop();
      return lens;
    }
  }
}

}  // namespace

OffsetCase random_mech(Random& random) {
  const double radius = 0.5 * static_cast<double>(random.below(3));
  const Contour contour = filleted(skyline(random), radius, random);
  const double distance = 0.25 * static_cast<double>(1 + random.below(12));
  return {contour, random.chance(0.5) ? distance : -distance};
}

namespace {

Contour drawn_plate(Random& random) {
  Contour plate{
      {{-100.0, -60.0, 0.0}, {100.0, -60.0, 0.0}, {100.0, 60.0, 0.0}, {-100.0, 60.0, 0.0}}, {}};
  plate.end_loop();
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 2; ++row) {
      const double x = 64.0 * (column - 1);
      const double y = 56.0 * row - 28.0;
      if (random.chance(0.2)) continue;
      append(plate, moved(as_hole(random_star(random, 5 + random.below(30), 18.0, 27.0)), x, y));
      if (random.chance(0.3)) continue;
      append(plate, moved(random_star(random, 5 + random.below(20), 8.0, 14.0), x, y));
      if (random.chance(0.5)) append(plate, moved(as_hole(circle(random.between(0.5, 3.0))), x, y));
    }
  }
  return plate;
}

}  // namespace

OffsetCase random_islands(Random& random) {
  Contour plate = drawn_plate(random);
  // The tip of an island may leave its hole by some hundredths of a millimetre; such plates are
  // discarded.
  while (!is_simple(plate.view())) plate = drawn_plate(random);
  return {plate, random.signed_magnitude(0.05, 6.0)};
}

OffsetCase random_hostile(Random& random) {
  double distance = random.magnitude(0.01, 30.0);
  Contour contour = hostile_contour(random, distance);
  const Contour plain = contour;
  if (contour.loop_ends.size() == 1 && random.chance(0.5)) add_spikes(contour, random);
  if (contour.loop_ends.size() == 1 && random.chance(0.5)) stutter(contour, random);
  if (random.chance(0.2)) distance *= 1.0 + random.signed_magnitude(1.0e-13, 1.0e-3);
  return {contour, random.chance(0.5) ? distance : -distance, plain};
}

}  // namespace proof
