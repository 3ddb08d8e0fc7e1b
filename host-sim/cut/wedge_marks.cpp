#include "host-sim/cut/wedge_marks.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "host-sim/cut/segment_distance.hpp"
#include "host-sim/cut/shared_edges.hpp"
#include "host-sim/import/place.hpp"

namespace sim::cut {
namespace {

/// Distance from the end of a closed path within which a point counts as the start of the path, mm.
constexpr double kSameEnd = 1.0e-6;
/// Least distance between the outlines and the end of a line from a node, as a share of half a
/// kerf. At other points of the line, the least distance is proportional to the distance from the
/// node.
constexpr double kGains = 0.4;

/// Returns the angle from one direction, turning left, to another one, radians, above 0.
double angle_between(const Place& from, const Place& to) {
  const double angle = std::atan2(drawing::cross(from, to), drawing::dot(from, to));
  return angle > 0.0 ? angle : angle + drawing::kFullTurn;
}

}  // namespace

WedgeMarks::WedgeMarks(const std::vector<Place>& nodes,
                       const std::vector<MeasuredRow>& rows,
                       const Clearance& near,
                       double half_kerf_mm)
    : nodes_{nodes},
      rows_{rows},
      near_{near},
      half_{half_kerf_mm},
      strokes_{kLongestConnector * half_kerf_mm} {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < rows[i].strokes().size(); ++k) {
      strokes_.add(rows[i].strokes()[k], owners_.size());
      owners_.emplace_back(i, k);
    }
  }
  strokes_.prepare();
}

void WedgeMarks::find(std::vector<FreeStretch>& stretches) const {
  std::map<std::size_t, Ends> ends;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    ends[stretches[i].from].leaving.push_back(i);
    ends[stretches[i].to].arriving.push_back(i);
  }
  for (const auto& [node, here] : ends) mark_wedges(node, here, stretches);
}

void WedgeMarks::mark_wedges(std::size_t node,
                             const Ends& ends,
                             std::vector<FreeStretch>& stretches) const {
  for (const std::size_t arriving : ends.arriving) {
    const Place from = -stretches[arriving].arriving;
    std::optional<std::size_t> next;
    double least = 2.0 * drawing::kFullTurn;
    for (const std::size_t leaving : ends.leaving) {
      const double angle = angle_between(from, stretches[leaving].leaving);
      if (angle >= least) continue;
      least = angle;
      next = leaving;
    }
    if (!next || stretches[*next].first) continue;
    const bool is_only = ends.arriving.size() == 1 && ends.leaving.size() == 1;
    const auto mark = mark_in({node, from, least, is_only});
    stretches[arriving].last = mark;
    stretches[*next].first = mark;
  }
}

std::optional<PathMark> WedgeMarks::mark_in(const Wedge& wedge) const {
  const Place& place = nodes_[wedge.node];
  if (wedge.is_only) {
    const Clearance::Nearest nearest = strokes_.nearest(place);
    if (nearest.stroke == nullptr) return std::nullopt;
    const PathMark mark = mark_on(nearest.owner, place);
    return leads_through_waste(place, mark.place) ? std::optional{mark} : std::nullopt;
  }
  std::optional<PathMark> nearest;
  double least = kLongestConnector * half_;
  for (const std::size_t number : strokes_.owners_near({place, place}, least)) {
    const PathMark mark = mark_on(number, place);
    const double apart = drawing::distance(mark.place, place);
    if (apart >= least || angle_between(wedge.from, mark.place - place) >= wedge.angle) continue;
    if (!leads_through_waste(place, mark.place)) continue;
    least = apart;
    nearest = mark;
  }
  return nearest;
}

/// Returns the point of the stroke `number` that is nearest to `place`, as a mark on its path.
PathMark WedgeMarks::mark_on(std::size_t number, const Place& place) const {
  const auto [loop, stroke_number] = owners_[number];
  const MeasuredRow& row = rows_[loop];
  const Stroke& stroke = row.strokes()[stroke_number];
  double way_mm = row.way_to(stroke_number) + nearest_share(stroke, place) * length_of(stroke);
  if (way_mm > row.length() - kSameEnd) way_mm = 0.0;
  return {loop, way_mm, row.place(way_mm)};
}

bool WedgeMarks::leads_through_waste(const Place& from, const Place& to) const {
  constexpr int kPlacesPerStroke = 8;
  for (int k = 1; k <= kPlacesPerStroke; ++k) {
    const double share = static_cast<double>(k) / kPlacesPerStroke;
    const double apart = near_.nearest(from + share * (to - from)).distance_mm;
    if (apart < kGains * share * half_ - kTouchesMm) return false;
  }
  return true;
}

}  // namespace sim::cut
