#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/support/random_source.hpp"

namespace sim::cut {

/// Sizes of random sheets of nested parts.
struct NestingSize {
  int columns = 4;
  int rows = 3;
  double pitch_mm = 40.0;
  double min_gap_mm = 0.8;  ///< Least distance between neighbours, mm.
  int levels = 3;           ///< Levels of parts that lie in the hole of the part of the level
                            ///< before.
};

/// Returns an outline around a centre: a circle, a polygon, or a rectangle with or without rounded
/// corners.
inline std::string nested_shape(proof::Random& random, double x, double y, double size) {
  const std::size_t kind = random.below(4);
  if (kind == 0) return fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\"/>", x, y, 0.5 * size);
  if (kind == 1) {
    const double side = M_SQRT1_2 * size;
    const double rounds = random.chance(0.5) ? 0.2 * side : 0.0;
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"{}\"/>",
                       x - 0.5 * side,
                       y - 0.5 * side,
                       side,
                       side,
                       rounds);
  }
  // The corners stay on the circle of this size, so that no part leaves its cell.
  const int corners = kind == 2 ? 6 : 9;
  std::string data = "M";
  for (int i = 0; i < corners; ++i) {
    const double radius = 0.5 * size * (kind == 3 && i % 3 == 1 ? 0.85 : 1.0);
    const double angle = 2.0 * M_PI * i / corners;
    data += fmt::format("{} {} ", x + radius * std::cos(angle), y + radius * std::sin(angle));
  }
  return "<path d=\"" + data + "z\"/>";
}

/// Returns an SVG of parts in a grid. Each part has a hole that contains a part, down to the last
/// level. No two outlines are nearer to each other than 0.65 mm, or than the least gap if that is
/// less.
inline std::string nested_sheet(proof::Random& random, const NestingSize& size) {
  const double width = size.pitch_mm * size.columns;
  const double height = size.pitch_mm * size.rows;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"0 0 {0} {1}\">",
      width,
      height);
  for (int i = 0; i < size.columns * size.rows; ++i) {
    const double x = size.pitch_mm * (i % size.columns + 0.5);
    const double y = size.pitch_mm * (i / size.columns + 0.5);
    double extent = size.pitch_mm - size.min_gap_mm;
    if (random.chance(0.5)) extent -= random.between(0.0, 6.0);
    for (int level = 0; level < 2 * size.levels && extent > 2.0; ++level) {
      text += nested_shape(random, x, y, extent);
      // The next outline fits into any of the shapes, of which the square has the least space. The
      // gap is greater than a kerf, as a cut along one outline would otherwise be in the other
      // part.
      constexpr double kNearest = 0.65;
      const double inside = M_SQRT1_2 * extent - 2.0 * kNearest;
      extent = std::min(0.68 * extent - random.between(1.0, 2.0), inside);
      if (random.chance(0.1)) break;
    }
  }
  return text + "</svg>";
}

}  // namespace sim::cut
