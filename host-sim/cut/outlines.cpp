#include "host-sim/cut/outlines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host-sim/contour/known_rows.hpp"
#include "host-sim/contour/shared_work.hpp"
#include "host-sim/cut/drawn_strokes.hpp"

namespace sim::cut {
namespace {

using drawing::DrawnContour;

/// Determines which outlines are holes. Directs all outlines so that the part is on their left.
void find_holes(const drawing::Drawing& drawn, std::vector<Outline>& outlines) {
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (!outlines[i].is_beside) continue;
    std::size_t depth = 0;
    for (auto p = drawn.contours[i].parent; p; p = drawn.contours[*p].parent) {
      if (outlines[*p].is_beside) ++depth;
    }
    outlines[i].is_hole = depth % 2 == 1;
    if ((area_of(outlines[i].strokes) < 0.0) != outlines[i].is_hole) {
      turn_round(outlines[i].strokes);
    }
  }
}

}  // namespace

std::vector<Outline> outlines_of(const drawing::Drawing& drawn,
                                 const std::vector<Side>& sides,
                                 const OutlineOptions& curves,
                                 std::vector<drawing::Fault>& faults) {
  std::vector<Outline> outlines(drawn.contours.size());
  std::vector<std::size_t> driven;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const Side side = sides[i];
    // Such open contours are reported as faults of the drawing.
    const bool is_open_area =
        !drawn.contours[i].closed && (side == Side::kWaste || side == Side::kFill);
    const bool has_line = is_driven(side) && side != Side::kImage;
    if (has_line && !is_open_area) driven.push_back(i);
  }
  std::vector<DrawnStrokes> all(driven.size());
  share_work(driven.size(), [&] {
    return [&, known = KnownRows{}](std::size_t k) mutable {
      all[k] = strokes_of(drawn.contours[driven[k]], curves, known);
    };
  });
  for (std::size_t k = 0; k < driven.size(); ++k) {
    const std::size_t i = driven[k];
    DrawnStrokes& strokes = all[k];
    if (strokes.fault) {
      faults.push_back(std::move(*strokes.fault));
      continue;
    }
    outlines[i].strokes = std::move(strokes.strokes);
    outlines[i].is_closed = drawn.contours[i].closed;
    outlines[i].is_beside = sides[i] == Side::kWaste;
  }
  find_holes(drawn, outlines);
  return outlines;
}

void turn_round(std::vector<Stroke>& strokes) {
  std::ranges::reverse(strokes);
  for (Stroke& stroke : strokes) {
    std::swap(stroke.from, stroke.to);
    stroke.bulge = -stroke.bulge;
  }
}

Contour contour_of(const std::vector<Stroke>& strokes) {
  Contour contour;
  for (const Stroke& stroke : strokes) {
    contour.vertices.push_back({stroke.from.x(), stroke.from.y(), stroke.bulge});
  }
  contour.end_loop();
  return contour;
}

std::vector<std::vector<Stroke>> loops_of(const cnc::contour::ContourView<double>& view) {
  std::vector<std::vector<Stroke>> loops;
  for (std::size_t i = 0; i < view.loop_ends.size(); ++i) {
    std::vector<Stroke>& loop = loops.emplace_back();
    const std::uint32_t first = view.loop_begin(i);
    for (std::uint32_t k = first; k < view.loop_ends[i]; ++k) {
      const ContourVertex& from = view.vertices[k];
      const ContourVertex& to = view.vertices[k + 1 < view.loop_ends[i] ? k + 1 : first];
      loop.push_back({{from.x, from.y}, {to.x, to.y}, from.bulge});
    }
  }
  return loops;
}

double area_of(const std::vector<Stroke>& loop) {
  const Place from = loop.front().from;
  double twice = 0.0;
  for (const Stroke& stroke : loop) {
    twice += drawing::cross(stroke.from - from, stroke.to - from);
    if (stroke.bulge == 0.0) continue;
    const double sweep = 4.0 * std::atan(stroke.bulge);
    const double chord = drawing::distance(stroke.from, stroke.to);
    const double radius = 0.5 * chord / std::sin(0.5 * std::abs(sweep));
    twice += radius * radius * (sweep - std::sin(sweep));
  }
  return 0.5 * twice;
}

}  // namespace sim::cut
