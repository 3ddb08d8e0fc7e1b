#include "host-sim/surface/view/stretch_line.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/cut/stroke.hpp"

namespace sim::surface {
namespace {

/// Returns the number of chords for an arc. The deviation of the chords from the arc is at most
/// `chord_mm`.
double chords_for(const cut::Stroke& stroke, double chord_mm) {
  const double size = std::abs(stroke.bulge);
  if (size == 0.0) return 1.0;
  const double radius = (stroke.to - stroke.from).norm() * (1.0 + size * size) / (4.0 * size);
  const double sweep = 4.0 * std::atan(size);
  const double of_chord = 2.0 * std::acos(std::max(0.0, 1.0 - chord_mm / radius));
  return std::max(1.0, std::ceil(sweep / of_chord));
}

}  // namespace

SpaceLine line_of(const SurfaceStretch& stretch, double chord_mm) {
  SpaceLine line;
  line.push_back(stretch.start());
  for (std::size_t i = 0; i + 1 < stretch.vertices.size(); ++i) {
    const ContourVertex& from = stretch.vertices[i];
    const ContourVertex& to = stretch.vertices[i + 1];
    const cut::Stroke stroke{.from = {from.x, from.y}, .to = {to.x, to.y}, .bulge = from.bulge};
    const double chords = chords_for(stroke, chord_mm);
    for (double part = 1.0; part < chords; part += 1.0) {
      const drawing::Place place = cut::place_at(stroke, part / chords);
      line.push_back(stretch.place_of({place.x(), place.y(), 0.0}));
    }
    line.push_back(stretch.place_of(to));
  }
  return line;
}

}  // namespace sim::surface
