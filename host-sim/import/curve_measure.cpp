#include "host-sim/import/curve_measure.hpp"

#include <algorithm>

namespace sim::drawing {
namespace {

constexpr int kDeepestHalving = 16;
constexpr double kMaxChords = 65'536.0;

bool near_chord(const Place& place, const Place& start, const Place& end, double tolerance) {
  const Place chord = end - start;
  const double length_squared = chord.squaredNorm();
  const double share = length_squared == 0.0
                           ? 0.0
                           : std::clamp(dot(place - start, chord) / length_squared, 0.0, 1.0);
  return (place - start - chord * share).squaredNorm() <= tolerance * tolerance;
}

/// Appends chords along a span. Halves the span until three points between the ends of each part
/// are within the tolerance of its chord.
class Halver {
 public:
  Halver(const Shape& shape, std::size_t span, double tolerance_mm, std::vector<Place>& into)
      : shape_{shape}, span_{span}, tolerance_{tolerance_mm}, into_{into} {}

  // Bounded by a depth. NOLINTNEXTLINE(misc-no-recursion)
  void halve(double from, const Place& start, double to, const Place& end, int depth) {
    const double middle = 0.5 * (from + to);
    const Place half = at(middle);
    if (depth >= kDeepestHalving || (depth >= 2 && flat(from, start, to, end, half))) {
      into_.push_back(end);
      return;
    }
    halve(from, start, middle, half, depth + 1);
    halve(middle, half, to, end, depth + 1);
  }

  [[nodiscard]] Place at(double share) const { return jet(shape_, span_, share).place; }

 private:
  [[nodiscard]] bool flat(
      double from, const Place& start, double to, const Place& end, const Place& half) const {
    return near_chord(half, start, end, tolerance_) &&
           near_chord(at(from + 0.25 * (to - from)), start, end, tolerance_) &&
           near_chord(at(from + 0.75 * (to - from)), start, end, tolerance_);
  }

  const Shape& shape_;
  std::size_t span_;
  double tolerance_;
  std::vector<Place>& into_;
};

/// Returns the number of equal chords that stay within the tolerance of an arc with this radius and
/// sweep.
double chords_of(double radius, double sweep, double tolerance_mm) {
  const double cosine = std::clamp(1.0 - tolerance_mm / std::max(radius, tolerance_mm), -1.0, 1.0);
  const double widest = std::min(2.0 * std::acos(cosine), 0.25 * kFullTurn);
  return std::min(std::ceil(std::abs(sweep) / widest), kMaxChords);
}

/// Appends points along an elliptical arc, without its end. The ellipse is the image of a unit
/// circle under a map that stretches by at most `stretch`, and its chords are the images of the
/// circle's chords. Their distance from the ellipse is therefore at most the distance between a
/// circle with the radius `stretch` and its chords.
void flatten_turn(const Ellipse& turn,
                  double stretch,
                  double tolerance_mm,
                  std::vector<Place>& into) {
  const double sweep = turn.to - turn.from;
  const double chords = chords_of(stretch, sweep, tolerance_mm);
  for (double chord = 1.0; chord < chords; ++chord) {
    const Place way = direction(turn.from + sweep * chord / chords);
    into.emplace_back(turn.centre + turn.major * way.x() + turn.minor * way.y());
  }
}

void flatten_arc(const Arc& arc, double tolerance_mm, std::vector<Place>& into) {
  const Place first = arc.start - arc.centre;
  const Ellipse turn{arc.centre, first, {-first.y(), first.x()}, 0.0, arc.sweep};
  flatten_turn(turn, first.norm(), tolerance_mm, into);
  into.push_back(arc.end);
}

/// Returns the longest half axis: the greater singular value of the map from a unit circle to the
/// ellipse.
double longest_axis(const Ellipse& ellipse) {
  const double sum = ellipse.major.squaredNorm() + ellipse.minor.squaredNorm();
  const double area = cross(ellipse.major, ellipse.minor);
  return std::sqrt(0.5 * (sum + std::sqrt(std::max(0.0, sum * sum - 4.0 * area * area))));
}

/// Returns the integral of `function` over a shape, by Gauss-Legendre quadrature with five points
/// on each quarter of a span.
template <typename Function>
double integral(const Shape& shape, const Function& function) {
  struct Node {
    double place;
    double weight;
  };
  static constexpr std::array<Node, 5> kNodes{{{-0.906179845938664, 0.236926885056189},
                                               {-0.538469310105683, 0.478628670499366},
                                               {0.0, 0.568888888888889},
                                               {0.538469310105683, 0.478628670499366},
                                               {0.906179845938664, 0.236926885056189}}};
  constexpr double kParts = 4.0;
  double sum = 0.0;
  for (std::size_t span = 0; span < span_count(shape); ++span) {
    for (double part = 0.0; part < kParts; ++part) {
      for (const Node& node : kNodes) {
        const double share = (part + 0.5 + 0.5 * node.place) / kParts;
        sum += node.weight * function(jet(shape, span, share));
      }
    }
  }
  return sum * 0.5 / kParts;
}

}  // namespace

void flatten(const Shape& shape, double tolerance_mm, std::vector<Place>& into) {
  if (const auto* const line = std::get_if<Line>(&shape)) {
    into.push_back(line->end);
  } else if (const auto* const arc = std::get_if<Arc>(&shape)) {
    flatten_arc(*arc, tolerance_mm, into);
  } else if (const auto* const ellipse = std::get_if<Ellipse>(&shape)) {
    flatten_turn(*ellipse, longest_axis(*ellipse), tolerance_mm, into);
    into.push_back(end_of(shape));
  } else {
    for (std::size_t span = 0; span < span_count(shape); ++span) {
      Halver halver{shape, span, tolerance_mm, into};
      halver.halve(0.0, halver.at(0.0), 1.0, halver.at(1.0), 0);
    }
    into.back() = end_of(shape);
  }
}

std::vector<Place> outline_of(std::span<const Shape> shapes, double tolerance_mm) {
  std::vector<Place> places;
  if (!shapes.empty()) places.push_back(start_of(shapes.front()));
  for (const Shape& shape : shapes) flatten(shape, tolerance_mm, places);
  return places;
}

double length_of(const Shape& shape) {
  if (const auto* const line = std::get_if<Line>(&shape)) return distance(line->start, line->end);
  if (const auto* const arc = std::get_if<Arc>(&shape)) {
    return distance(arc->start, arc->centre) * std::abs(arc->sweep);
  }
  return integral(shape, [](const Jet& at) { return at.first.norm(); });
}

double swept_area(const Shape& shape, const Place& from) {
  if (const auto* const line = std::get_if<Line>(&shape)) {
    return 0.5 * cross(line->start - from, line->end - from);
  }
  if (const auto* const arc = std::get_if<Arc>(&shape)) {
    const double radius = distance(arc->start, arc->centre);
    return 0.5 * (radius * radius * arc->sweep + cross(arc->centre - from, arc->end - arc->start));
  }
  return integral(shape, [&from](const Jet& at) { return 0.5 * cross(at.place - from, at.first); });
}

}  // namespace sim::drawing
