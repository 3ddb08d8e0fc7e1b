#include "host-sim/cut/waste_map.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/cut/drawn_strokes.hpp"

namespace sim::cut {
namespace {

/// Least step along a path, mm. It is smaller than the accuracy of the path of the beam.
constexpr double kShortestStep = 1.0e-3;
/// Share of the spare distance that one step advances. A step over the whole spare distance would
/// end at the limit, on either side of it because of rounding.
constexpr double kShareOfSpare = 0.9;

}  // namespace

WasteMap::WasteMap(const CutPlan& plan, const drawing::Drawing& drawn, double reach_mm)
    : lines_{reach_mm}, tabs_{reach_mm} {
  for (std::size_t i = 0; i < drawn.contours.size(); ++i) {
    const drawing::DrawnContour& contour = drawn.contours[i];
    const Side side = plan.recipes.of(i, plan.layers[contour.entity.layer]).settings.side;
    if (!is_driven(side) || (side == Side::kWaste && !contour.closed)) continue;
    for (const Stroke& stroke : strokes_of(contour, plan.curves).strokes) lines_.add(stroke, 0);
  }
  for (const Cut& cut : plan.cuts) {
    for (const Stroke& stroke : cut.strokes) {
      if (stroke.purpose == Purpose::kTab) tabs_.add(stroke, 0);
    }
  }
  lines_.prepare();
  tabs_.prepare();
}

double WasteMap::distance_to_lines(const Place& place) const {
  return lines_.nearest(place).distance_mm;
}

bool WasteMap::is_clear(const Place& from,
                        const Place& to,
                        double from_lines_mm,
                        double from_tabs_mm) const {
  const double length = drawing::distance(from, to);
  for (double done = 0.0;;) {
    const Place place = length > 0.0 ? Place{from + done / length * (to - from)} : from;
    const double spare = std::min(distance_to_lines(place) - from_lines_mm,
                                  tabs_.nearest(place).distance_mm - from_tabs_mm);
    if (spare < 0.0) return false;
    if (done >= length) return true;
    done = std::min(length, done + std::max(kShareOfSpare * spare, kShortestStep));
  }
}

std::vector<std::pair<double, double>> WasteMap::clear_stretches(const Place& from,
                                                                 const Place& to,
                                                                 double from_lines_mm) const {
  std::vector<std::pair<double, double>> stretches;
  const double length = drawing::distance(from, to);
  bool was_clear = false;
  for (double done = 0.0; length > 0.0;) {
    const double spare = distance_to_lines(from + done / length * (to - from)) - from_lines_mm;
    const bool is_clear = spare >= 0.0;
    if (is_clear && !was_clear) stretches.emplace_back(done, done);
    if (is_clear) stretches.back().second = done;
    was_clear = is_clear;
    if (done >= length) break;
    done = std::min(length, done + std::max(kShareOfSpare * std::abs(spare), kShortestStep));
  }
  return stretches;
}

}  // namespace sim::cut
