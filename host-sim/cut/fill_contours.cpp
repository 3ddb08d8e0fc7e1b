#include "host-sim/cut/fill_contours.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/cut/fill_chains.hpp"
#include "host-sim/cut/filled_area.hpp"
#include "host-sim/cut/outlines.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::cut {
namespace {

using View = cnc::contour::ContourView<double>;

/// Removes rows that are so narrow that a line along their middle replaces them.
Contour without_slivers(const View& rows, double min_width_mm) {
  Contour kept;
  for (std::size_t row = 0; row < rows.loop_ends.size(); ++row) {
    double length = 0.0;
    for (std::uint32_t i = rows.loop_begin(row); i < rows.loop_ends[row]; ++i) {
      length += cnc::pocket::length_of(cnc::pocket::element_at(rows, row, i));
    }
    const double area = std::abs(cnc::pocket::signed_area(rows, row));
    if (2.0 * area > min_width_mm * length) append_loop(rows, row, kept);
  }
  return kept;
}

FillRows rows_of(const Contour& contour) {
  FillRows rows = loops_of(contour.view());
  for (std::vector<Stroke>& row : rows) {
    std::erase_if(row, [](const Stroke& stroke) { return stroke.from == stroke.to; });
  }
  std::erase_if(rows, [](const std::vector<Stroke>& row) { return row.empty(); });
  return rows;
}

/// Returns the rows of each level. They result from moving the edge of an area inwards. Returns
/// nothing if there would be too many levels or strokes.
std::optional<std::vector<FillRows>> rows_within(const Contour& area, double interval_mm) {
  std::vector<FillRows> levels;
  ContourOffset offset;
  std::size_t strokes = 0;
  Contour inner = area;
  for (double step = 0.5 * interval_mm;; step = interval_mm) {
    inner = without_slivers(offset.offset(inner.view(), -step), kMinRowWidth * interval_mm);
    if (inner.loop_ends.empty()) return levels;
    strokes += inner.vertices.size();
    if (strokes > kMaxRowStrokes || levels.size() == kMaxFillLevels) return std::nullopt;
    levels.push_back(rows_of(inner));
  }
}

}  // namespace

ContourFill contour_fill(const std::vector<std::vector<Stroke>>& outlines, double interval_mm) {
  Contour drawn;
  for (const std::vector<Stroke>& outline : outlines) {
    append_loop(contour_of(outline).view(), 0, drawn);
  }
  const Contour area = filled_area(drawn);
  if (area.loop_ends.empty()) return {};
  std::optional<std::vector<FillRows>> levels = rows_within(area, interval_mm);
  if (!levels) return {.too_much = true};
  FillRests rests = rests_between_rows(area.view(), interval_mm);
  return {.paths = fill_chains(*std::move(levels), rests.lines, interval_mm), .thin = rests.thin};
}

}  // namespace sim::cut
