#include "host-sim/cut/middles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <utility>

#include "host-sim/cut/narrow_lines.hpp"
#include "host-sim/cut/waste_beside.hpp"

namespace sim::cut {
namespace {

/// Returns whether the waste at contour `i` is in a hole. It is in a hole if the outermost of the
/// `contours` around contour `i` is a hole, or if none is around it and contour `i` itself is a
/// hole.
bool is_in_hole(const DrawnEdges& edges, const std::vector<std::size_t>& contours, std::size_t i) {
  std::size_t outermost = i;
  for (auto around = edges.drawn.contours[i].lies_in; around;
       around = edges.drawn.contours[*around].lies_in) {
    if (std::ranges::find(contours, *around) != contours.end()) outermost = *around;
  }
  return edges.outlines[outermost].is_hole;
}

void append(NarrowLines& all, NarrowLines more) {
  all.rows.insert(all.rows.end(), more.rows.begin(), more.rows.end());
  all.length_mm += more.length_mm;
  if (more.max_off_mm <= all.max_off_mm) return;
  all.max_off_mm = more.max_off_mm;
  all.place = more.place;
}

}  // namespace

Middles middles_beside(const DrawnEdges& edges, const std::vector<std::size_t>& contours) {
  const double half_kerf_mm = edges.half_kerf_mm(contours.front());
  double max_off_mm = std::numeric_limits<double>::infinity();
  for (const std::size_t i : contours) max_off_mm = std::min(max_off_mm, edges.narrow_mm(i));
  if (max_off_mm <= 0.0 || half_kerf_mm <= 0.0) return {};
  // `rows[0]` has the outlines whose waste is outside of parts, `rows[1]` the outlines whose waste
  // is in holes.
  std::array<std::vector<const std::vector<Stroke>*>, 2> rows;
  for (const std::size_t i : contours) {
    rows[is_in_hole(edges, contours, i) ? 1 : 0].push_back(&edges.outlines[i].strokes);
  }
  const auto is_other_near = [&](const Place& place, double mm) {
    const auto is_near = [&](const Stroke& stroke) { return distance_to(stroke, place) <= mm; };
    return std::ranges::any_of(edges.near.owners_near({place, place}, mm), [&](std::size_t i) {
      return std::ranges::find(contours, i) == contours.end() &&
             std::ranges::any_of(edges.outlines[i].strokes, is_near);
    });
  };
  NarrowLines lines;
  try {
    for (const bool is_in_holes : {false, true}) {
      if (rows[is_in_holes ? 1 : 0].empty()) continue;
      const Contour waste = waste_beside(rows[is_in_holes ? 1 : 0], is_in_holes);
      append(lines, narrow_lines(waste.view(), half_kerf_mm, max_off_mm, is_other_near));
    }
  } catch (const std::runtime_error&) {
    return {};
  }
  if (lines.rows.empty()) return {};
  return {.rows = std::move(lines.rows),
          .warning = drawing::Fault{
              drawing::FaultKind::kTooSmall,
              edges.drawn.contours[contours.front()].entity,
              lines.place,
              fmt::format("waste is narrower than the kerf of {:.3f} mm along {:.3f} mm: it is cut "
                          "once along its middle, which takes up to {:.3f} mm off its edges",
                          2.0 * half_kerf_mm,
                          lines.length_mm,
                          lines.max_off_mm),
              "make it as wide as the kerf, or forbid this cut with narrow=0"}};
}

}  // namespace sim::cut
