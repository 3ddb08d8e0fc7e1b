#include "host-sim/cut/waste_beside.hpp"

#include <cmath>
#include <limits>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/cut/filled_area.hpp"
#include "host-sim/cut/outlines.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::cut {
namespace {

/// Returns the area on the left of contours that do not cross, mm². Outlines count as positive,
/// holes as negative.
double signed_area_of(const Contour& contours) {
  double area = 0.0;
  for (std::size_t loop = 0; loop < contours.loop_ends.size(); ++loop) {
    area += cnc::pocket::signed_area(contours.view(), loop);
  }
  return area;
}

/// Adds a rectangle far around outlines to `waste`.
void append_frame(const std::vector<const std::vector<Stroke>*>& rows, Contour& waste) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  Place least{kInfinite, kInfinite};
  Place most = -least;
  for (const std::vector<Stroke>* row : rows) {
    for (const Stroke& stroke : *row) {
      least = least.cwiseMin(stroke.from);
      most = most.cwiseMax(stroke.from);
    }
  }
  // The margin is large enough for arcs, which extend beyond their ends.
  const double margin = 1.0 + 2.0 * (most - least).maxCoeff();
  append_rectangle(least - Place::Constant(margin), most + Place::Constant(margin), waste);
}

}  // namespace

Contour waste_beside(const std::vector<const std::vector<Stroke>*>& rows, bool is_in_holes) {
  Contour drawn;
  double length_mm = 0.0;
  double waste_mm2 = 0.0;
  if (!is_in_holes) {
    append_frame(rows, drawn);
    waste_mm2 = signed_area_of(drawn);
  }
  for (const std::vector<Stroke>* row : rows) {
    const Contour inside = filled_area(contour_of(*row));
    const double area_mm2 = signed_area_of(inside);
    waste_mm2 -= std::copysign(area_mm2, area_of(*row));
    length_mm += length_of(*row);
    append_loops(inside.view(), drawn);
  }
  Contour waste = filled_area(drawn);
  // The filling rule treats the overlap of two parts as waste, because an odd number of contours
  // encloses the overlap. This check detects such an overlap.
  if (std::abs(signed_area_of(waste) - waste_mm2) > kMinFilledWidthMm * length_mm) {
    throw NoOffset{rows.front()->front().from,
                   "this contour, or one near it, overlaps another contour",
                   "separate them"};
  }
  return waste;
}

}  // namespace sim::cut
