#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/import/curve.hpp"
#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/drawing.hpp"
#include "host-sim/import/sketch.hpp"

namespace sim {

/// Returns the lines and arcs between vertices.
inline std::vector<drawing::Shape> shapes_of(const std::vector<ContourVertex>& loop) {
  std::vector<drawing::Shape> shapes;
  for (std::size_t i = 0; i + 1 < loop.size(); ++i) {
    shapes.push_back(drawing::bulge_edge(loop[i].point(), loop[i + 1].point(), loop[i].bulge));
  }
  return shapes;
}

/// Returns the distance of the farthest point of one row from the chords of another, mm.
inline double farthest(const std::vector<drawing::Place>& from,
                       const std::vector<drawing::Place>& chords) {
  double greatest = 0.0;
  for (const drawing::Place& place : from) {
    double least = 1.0e9;
    for (std::size_t i = 1; i < chords.size(); ++i) {
      const drawing::Place chord = chords[i] - chords[i - 1];
      const drawing::Place seen = place - chords[i - 1];
      const double square = chord.squaredNorm();
      const double share = square > 0.0 ? std::clamp(seen.dot(chord) / square, 0.0, 1.0) : 0.0;
      least = std::min(least, (seen - share * chord).norm());
    }
    greatest = std::max(greatest, least);
  }
  return greatest;
}

/// Returns the distance between a contour and arcs in both directions, mm. Chords deviate from both
/// by a hundredth of the tolerance at most.
inline double deviation(const drawing::DrawnContour& drawn,
                        const std::vector<ContourVertex>& loop,
                        double tolerance) {
  const auto curve = drawing::outline_of(drawn.shapes, 0.005 * tolerance);
  const auto arcs = drawing::outline_of(shapes_of(loop), 0.005 * tolerance);
  return std::max(farthest(curve, arcs), farthest(arcs, curve)) - 0.01 * tolerance;
}

}  // namespace sim
