#include "host-sim/cut/controller_way.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace sim::cut {
namespace {

/// Extra overlap, mm: the path ends at this distance past the point where the beam first reached
/// the outline.
constexpr double kLap = 0.05;

/// Returns the strokes of the beam's path along the edge; none if the path has no lead-in.
std::vector<Stroke> edge_of(const std::vector<Stroke>& beam) {
  std::vector<Stroke> contour;
  if (beam.front().purpose == Purpose::kContour) return contour;
  for (const Stroke& stroke : beam) {
    if (stroke.purpose == Purpose::kContour) contour.push_back(stroke);
  }
  return contour;
}

/// Returns the distance along the outline to its point nearest to `place`, which is half a kerf
/// from the outline. Returns nothing if the nearest point is at the end of a stroke.
std::optional<double> foot_of(const MeasuredRow& outline, const Place& place, double half_kerf) {
  // Distance from the end of a stroke within which a point counts as at this end, mm.
  constexpr double kAtAnEnd = 1.0e-3;
  for (std::size_t i = 0; i < outline.strokes().size(); ++i) {
    const Stroke& stroke = outline.strokes()[i];
    if (std::abs(distance_to(stroke, place) - half_kerf) > 1.0e-4) continue;
    const double length = length_of(stroke);
    // Along a stroke of at most half a turn, the distance to `place` is smooth and has one minimum.
    double low = 0.0;
    double high = 1.0;
    for (int k = 0; k < 100; ++k) {
      const double a = low + (high - low) / 3.0;
      const double b = high - (high - low) / 3.0;
      const bool left = drawing::distance(place_at(stroke, a), place) <
                        drawing::distance(place_at(stroke, b), place);
      (left ? high : low) = left ? b : a;
    }
    const double share = 0.5 * (low + high);
    if (std::min(share, 1.0 - share) * length < kAtAnEnd) continue;
    if (std::abs(drawing::distance(place_at(stroke, share), place) - half_kerf) > 1.0e-4) continue;
    return outline.way_to(i) + share * length;
  }
  return std::nullopt;
}

/// Returns the distance from the start of the edge to the point where the beam reaches the edge. At
/// this point the offset lines of the entry and of the outline intersect.
double lag_of(const Place& entry, const Place& leaving, double half_kerf) {
  const double turn = std::atan2(-drawing::cross(entry, leaving), entry.dot(leaving));
  return turn > 0.0 ? half_kerf * std::tan(0.5 * turn) : 0.0;
}

/// Returns the end of a lead-out from `beside`, a point next to the edge, into the waste. Returns
/// nothing if there is no free space.
std::optional<Place> exit_of(const Place& beside,
                             const Place& tangent,
                             double length,
                             const LeadRoom& room) {
  for (const double share : {1.0, 0.5, 0.25}) {
    for (const double along : {1.0, 0.0, -1.0}) {
      const Place way = (right_of(tangent) + along * tangent).normalized();
      const Place end = beside + share * length * way;
      if (room.parts.is_clear({beside, end}, room.half_kerf_mm - kClearSlackMm)) return end;
    }
  }
  return std::nullopt;
}

}  // namespace

ControllerWay controller_way(const std::vector<Stroke>& outline,
                             const std::vector<Stroke>& beam,
                             const LayerSettings& settings,
                             const LeadRoom& room) {
  const double half_kerf = room.half_kerf_mm;
  const std::vector<Stroke> contour = edge_of(beam);
  if (contour.empty()) return {.reason = "it has no lead-in"};
  const MeasuredRow drawn{outline};
  const auto foot = foot_of(drawn, contour.front().from, half_kerf);
  if (!foot) return {.reason = "its lead ends at a corner"};
  const MeasuredRow row{drawn.begun_at(*foot)};
  const Place& start = row.strokes().front().from;
  const Place leaving = row.leaving(0.0);
  const double whole = drawing::distance(beam.front().from, start);
  const double pierce = settings.pierce_s > 0.0 ? kPierceWayMm : 0.0;
  if (whole - pierce < 1.1 * half_kerf) return {.reason = "its lead-in is no longer than the kerf"};
  const Place entry = (start - beam.front().from) / whole;
  const double lag = lag_of(entry, leaving, half_kerf);
  const MeasuredRow beside{contour};
  const Place reached = beside.place(std::min(lag, beside.length()));
  if (!room.parts.is_clear({beam.front().from, reached}, half_kerf - kClearSlackMm)) {
    return {.reason = "there is no free space for a straight lead-in"};
  }
  const double lap = std::min(settings.overcut_mm + lag + kLap, 0.5 * row.length());
  const Place tangent = row.leaving(lap);
  const Place last = row.place(lap) + half_kerf * right_of(tangent);
  const double exit_mm = std::max(settings.lead_out.length_mm, 4.0 * half_kerf);
  const auto exit = exit_of(last, tangent, exit_mm, room);
  if (!exit) return {.reason = "there is no free space for a lead-out"};

  ControllerWay way;
  const Place entered = beam.front().from + pierce * entry;
  if (pierce > 0.0) way.strokes.push_back({beam.front().from, entered, 0.0, Purpose::kPierce});
  way.strokes.push_back({entered, start, 0.0, Purpose::kLeadIn});
  for (Stroke stroke : row.strokes()) {
    stroke.purpose = Purpose::kContour;
    way.strokes.push_back(stroke);
  }
  for (Stroke stroke : row.stretch(0.0, lap)) {
    stroke.purpose = Purpose::kOvercut;
    way.strokes.push_back(stroke);
  }
  way.strokes.push_back({row.place(lap), *exit, 0.0, Purpose::kLeadOut});
  return way;
}

}  // namespace sim::cut
