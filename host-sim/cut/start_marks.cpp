#include "host-sim/cut/start_marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/drawn_strokes.hpp"
#include "host-sim/cut/segment_distance.hpp"

namespace sim::cut {
namespace {

/// Greatest distance of a mark from its contour, mm. A mark that is farther from all contours is a
/// fault.
constexpr double kFarthestMark = 5.0;

Place middle_of(const std::vector<Stroke>& strokes) {
  Place least = strokes.front().from;
  Place most = least;
  for (const Stroke& stroke : strokes) {
    for (const double share : {0.0, 0.5, 1.0}) {
      least = least.cwiseMin(place_at(stroke, share));
      most = most.cwiseMax(place_at(stroke, share));
    }
  }
  return 0.5 * (least + most);
}

}  // namespace

double way_nearest_to(const MeasuredRow& row, const Place& place) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < row.strokes().size(); ++i) {
    const double distance = distance_to(row.strokes()[i], place);
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  const double share = nearest_share(row.strokes()[nearest], place);
  const double length = row.way_to(nearest + 1) - row.way_to(nearest);
  const double way = row.way_to(nearest) + share * length;
  return way >= row.length() ? 0.0 : way;
}

std::vector<std::optional<Place>> marked_starts(const drawing::Drawing& drawn,
                                                const std::vector<Side>& sides,
                                                const std::vector<Outline>& outlines,
                                                const OutlineOptions& curves,
                                                std::vector<drawing::Fault>& faults) {
  std::vector<std::optional<Place>> starts(outlines.size());
  if (std::ranges::find(sides, Side::kStart) == sides.end()) return starts;
  Clearance contours{kFarthestMark};
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (!outlines[i].is_closed) continue;
    for (const Stroke& stroke : outlines[i].strokes) contours.add(stroke, i);
  }
  contours.prepare();
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] != Side::kStart) continue;
    const drawing::DrawnContour& mark = drawn.contours[i];
    const DrawnStrokes strokes = strokes_of(mark, curves);
    if (strokes.fault || strokes.strokes.empty()) continue;
    const Place place = middle_of(strokes.strokes);
    const Clearance::Nearest nearest = contours.nearest(place);
    if (nearest.distance_mm >= kFarthestMark) {
      faults.push_back(
          {drawing::FaultKind::kBadEntity,
           mark.entity,
           place,
           fmt::format("marks a start, but no closed contour that is cut is within {:g} mm of it",
                       kFarthestMark),
           "move it to a contour, or skip its layer"});
    } else if (starts[nearest.owner]) {
      faults.push_back({drawing::FaultKind::kBadEntity,
                        mark.entity,
                        place,
                        fmt::format("marks the start of {}, which already has a mark",
                                    drawn.contours[nearest.owner].entity.name),
                        "leave one mark at each contour"});
    } else {
      starts[nearest.owner] = place;
    }
  }
  return starts;
}

}  // namespace sim::cut
