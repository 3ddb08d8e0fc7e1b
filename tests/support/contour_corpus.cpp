#include "tests/support/contour_corpus.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>

#include "host-sim/contour/contour_text.hpp"
#include "tests/support/contour_oracle.hpp"
#include "tests/support/hostile_contours.hpp"

namespace proof {
namespace {

using sim::Contour;
using sim::ContourVertex;

constexpr double kTurn = 2.0 * std::numbers::pi;

/// Reads the loops of a file; comments separate contours.
std::vector<Contour> read_groups(const std::string& file) {
  std::ifstream stream{std::string{KERFLINE_CONTOURS} + "/" + file};
  if (!stream) throw std::runtime_error{"cannot read " + file};
  const std::string text{std::istreambuf_iterator<char>{stream}, {}};
  std::vector<Contour> groups;
  std::size_t place = text.find("\n\n#");
  while (place != std::string::npos) {
    const std::size_t next = text.find("\n\n#", place + 1);
    groups.push_back(sim::contour_from_text(text.substr(place + 2, next - place - 1), file));
    place = next;
  }
  return groups;
}

const std::vector<Contour>& parts() {
  static const std::vector<Contour> kParts = read_groups("nest.txt");
  return kParts;
}

const std::vector<Contour>& glyphs() {
  static const std::vector<Contour> kGlyphs = read_groups("glyphs.txt");
  return kGlyphs;
}

double width_of(const Contour& contour) {
  double least = contour.vertices[0].x;
  double most = least;
  for (const ContourVertex& vertex : contour.vertices) {
    least = std::min(least, vertex.x);
    most = std::max(most, vertex.x);
  }
  return most - least;
}

Contour placed(Contour contour, double angle, double scale, double x_mm, double y_mm) {
  for (ContourVertex& vertex : contour.vertices) {
    const double x = vertex.x * scale;
    const double y = vertex.y * scale;
    vertex.x = x * std::cos(angle) - y * std::sin(angle) + x_mm;
    vertex.y = x * std::sin(angle) + y * std::cos(angle) + y_mm;
  }
  return contour;
}

/// Returns a case with an offset between a thousandth and a fifth of the contour's size, to either
/// side.
OffsetCase real_case(Random& random, const Contour& contour, double size_mm) {
  const double quarter = kTurn / 4.0 * static_cast<double>(random.below(4));
  const double angle = random.chance(0.5) ? quarter : random.between(0.0, kTurn);
  const double scale = size_mm / width_of(contour);
  return {placed(contour, angle, scale, random.between(-500, 500), random.between(-500, 500)),
          random.signed_magnitude(0.001, 0.2) * size_mm};
}

/// Returns a uniform cubic B-spline through random control points around the origin.
Contour random_spline_outline(Random& random) {
  const std::size_t count = 6 + random.below(10);
  std::vector<ContourVertex> control(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = kTurn * static_cast<double>(i) / static_cast<double>(count);
    const double radius = random.between(15.0, 50.0);
    control[i] = {radius * std::cos(angle), radius * std::sin(angle), 0.0};
  }
  Contour contour;
  for (std::size_t i = 0; i < 400; ++i) {
    const double place = static_cast<double>(i * count) / 400.0;
    const auto first = static_cast<std::size_t>(place);
    const double t = place - static_cast<double>(first);
    const double weights[4] = {(1 - t) * (1 - t) * (1 - t) / 6,
                               (3 * t * t * t - 6 * t * t + 4) / 6,
                               (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6,
                               t * t * t / 6};
    ContourVertex vertex;
    for (std::size_t k = 0; k < 4; ++k) {
      vertex.x += weights[k] * control[(first + k) % count].x;
      vertex.y += weights[k] * control[(first + k) % count].y;
    }
    contour.vertices.push_back(vertex);
  }
  contour.end_loop();
  return contour;
}

OffsetCase star_case(Random& random, std::size_t elements) {
  const Contour star = random_star(random, elements, 20.0, 60.0);
  const double size = elements >= 1000 ? random.magnitude(0.01, 3.0) : random.magnitude(0.05, 12.0);
  return {placed(star, 0.0, 1.0, random.between(-300, 300), random.between(-300, 300)),
          random.chance(0.5) ? size : -size};
}

}  // namespace

const char* name_of(Corpus corpus) {
  constexpr const char* kNames[] = {
      "star20", "star100", "star1000", "nest", "glyphs", "spline", "mech", "islands", "hostile"};
  return kNames[static_cast<std::size_t>(corpus)];
}

namespace {

Contour drawn_star(Random& random,
                   std::size_t elements,
                   double min_radius_mm,
                   double max_radius_mm) {
  Contour star;
  const double step = kTurn / static_cast<double>(elements);
  for (std::size_t i = 0; i < elements; ++i) {
    const double angle = step * (static_cast<double>(i) + random.between(-0.4, 0.4));
    const double radius = random.between(min_radius_mm, max_radius_mm);
    star.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
  }
  for (std::size_t i = 0; i < elements; ++i) {
    const ContourVertex& from = star.vertices[i];
    const ContourVertex& to = star.vertices[(i + 1) % elements];
    if (random.chance(0.5)) continue;
    // All tangents of the arc stay within the angles between the chord and the radii to its ends.
    const double dx = to.x - from.x;
    const double dy = to.y - from.y;
    const double start = std::atan2(from.x * dy - from.y * dx, from.x * dx + from.y * dy);
    const double end = std::atan2(to.x * dy - to.y * dx, to.x * dx + to.y * dy);
    const double slack = std::min(std::min(start, end), std::numbers::pi - std::max(start, end));
    star.vertices[i].bulge = std::tan(0.5 * random.between(-0.9, 0.9) * slack);
  }
  star.end_loop();
  return star;
}

OffsetCase drawn_case(Corpus corpus, Random& random) {
  switch (corpus) {
    case Corpus::kStar20:
      return star_case(random, 20);
    case Corpus::kStar100:
      return star_case(random, 100);
    case Corpus::kStar1000:
      return star_case(random, 1000);
    case Corpus::kNest:
      return real_case(random, parts()[random.below(parts().size())], 100.0);
    case Corpus::kGlyphs:
      return real_case(random, glyphs()[random.below(glyphs().size())], 42.0);
    case Corpus::kSpline:
      return {random_spline_outline(random), random.signed_magnitude(0.1, 12)};
    case Corpus::kMech:
      return random_mech(random);
    case Corpus::kIslands:
      return random_islands(random);
    case Corpus::kHostile:
      return random_hostile(random);
  }
  throw std::invalid_argument{"no such corpus"};
}

}  // namespace

Contour random_star(Random& random,
                    std::size_t elements,
                    double min_radius_mm,
                    double max_radius_mm) {
  Contour star = drawn_star(random, elements, min_radius_mm, max_radius_mm);
  while (!is_simple(star.view())) {
    star = drawn_star(random, elements, min_radius_mm, max_radius_mm);
  }
  return star;
}

OffsetCase random_case(Corpus corpus, std::uint64_t seed) {
  Random random{seed * 16 + static_cast<std::uint64_t>(corpus)};
  OffsetCase drawn = drawn_case(corpus, random);
  if (drawn.plain.vertices.empty()) drawn.plain = drawn.contour;
  return drawn;
}

double programmed(double mm) { return std::round(mm * 1.0e4) * 1.0e-4; }

namespace {

Contour drawn_outline(Random& random, std::size_t max_elements) {
  const auto is_long = [](const auto& vertex) { return std::abs(vertex.bulge) > 1.0; };
  Contour star;
  do {
    star = random_star(random, 3 + random.below(max_elements - 2), 8.0, 30.0);
  } while (std::ranges::any_of(star.vertices, is_long));
  Contour outline;
  auto& vertices = outline.vertices;
  star.vertices[0].bulge = 0.0;
  const auto& next = star.vertices[1];
  vertices.push_back({0.5 * (star.vertices[0].x + next.x), 0.5 * (star.vertices[0].y + next.y), 0});
  vertices.insert(vertices.end(), star.vertices.begin() + 1, star.vertices.end());
  vertices.push_back(star.vertices[0]);
  for (auto& vertex : vertices) {
    vertex.x = programmed(vertex.x);
    vertex.y = programmed(vertex.y);
  }
  outline.end_loop();
  return outline;
}

}  // namespace

Contour programmed_star(Random& random, std::size_t max_elements) {
  Contour outline = drawn_outline(random, max_elements);
  // Lines replace some arcs, and may cross other elements: such outlines are discarded.
  while (!is_simple(outline.view())) outline = drawn_outline(random, max_elements);
  return outline;
}

}  // namespace proof
