#include "host-sim/cut/corner.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace sim::cut {
namespace {

/// Greatest difference between half the kerf and the radius of an arc that counts as an arc around
/// a drawn corner, mm.
constexpr double kSameRadius = 1.0e-6;
/// Tolerance for measuring whether the beam is clear of parts, mm. A beam along its own edge has no
/// distance to spare.
constexpr double kLoopSlack = 1.0e-5;
/// Greatest turn of a corner that has a loop, radians. The loop of a sharper corner would extend
/// too far.
constexpr double kSharpest = 170.0 * std::numbers::pi / 180.0;

double sweep_of(const Stroke& stroke) { return 4.0 * std::atan(stroke.bulge); }

bool is_around_corner(const Stroke& stroke, double half_kerf_mm) {
  if (stroke.purpose != Purpose::kContour || stroke.bulge <= 0.0) return false;
  const double sweep = sweep_of(stroke);
  const double radius = length_of(stroke) / sweep;
  return std::abs(radius - half_kerf_mm) <= kSameRadius;
}

double turn_between(const Stroke& before, const Stroke& after) {
  const Place from = tangent_at(before, 1.0);
  const Place to = tangent_at(after, 0.0);
  return std::abs(std::atan2(drawing::cross(from, to), drawing::dot(from, to)));
}

/// Returns a loop past an outer corner, where an arc goes around the corner. The loop goes straight
/// on from the start of this arc, turns around to the right, and goes straight to the end of the
/// arc. Both lines are tangential to the round part of the loop. They cross at the point where the
/// path would have its corner without the arc.
std::vector<Stroke> loop_past(const Stroke& arc, double radius_mm) {
  const double turn = sweep_of(arc);
  const double round_mm = length_of(arc) / turn;
  const double way = (round_mm + radius_mm) * std::tan(0.5 * turn);
  const Place out = arc.from + way * tangent_at(arc, 0.0);
  const Place back = arc.to - way * tangent_at(arc, 1.0);
  const double sweep = 2.0 * std::numbers::pi - turn;
  return {{arc.from, out, 0.0, Purpose::kCornerLoop},
          {out, back, -std::tan(0.25 * sweep), Purpose::kCornerLoop},
          {back, arc.to, 0.0, Purpose::kCornerLoop}};
}

struct RoomyLoop {
  std::vector<Stroke> strokes{};  ///< Strokes of the loop; empty if there is no free space.
  double share = 1.0;             ///< Share of the required radius that the loop has.
};

RoomyLoop loop_with_room(const Stroke& arc,
                         double radius_mm,
                         const Clearance& parts,
                         double half_kerf_mm) {
  if (sweep_of(arc) > kSharpest) return {};
  for (const double share : {1.0, 0.5, 0.25, 0.125}) {
    std::vector<Stroke> loop = loop_past(arc, share * radius_mm);
    bool clear = true;
    for (const Stroke& stroke : loop) {
      clear = clear && parts.is_clear(stroke, half_kerf_mm - kLoopSlack);
    }
    if (clear) return {std::move(loop), share};
  }
  return {};
}

}  // namespace

std::vector<Corner> corners_of(const std::vector<Stroke>& strokes,
                               double min_turn,
                               double half_kerf_mm) {
  std::vector<Corner> corners;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    const Stroke& stroke = strokes[i];
    const Stroke& before = strokes[i > 0 ? i - 1 : strokes.size() - 1];
    if (stroke.purpose != Purpose::kContour) continue;
    const bool goes_on = before.purpose == Purpose::kContour && before.to == stroke.from;
    if (goes_on && turn_between(before, stroke) >= min_turn) {
      corners.push_back({i, false, stroke.from});
    }
    if (is_around_corner(stroke, half_kerf_mm) && sweep_of(stroke) >= min_turn) {
      corners.push_back({i, true, place_at(stroke, 0.5)});
    }
  }
  return corners;
}

CornerWork treat_corners(std::vector<Stroke>& strokes,
                         const LayerSettings& settings,
                         const Clearance& parts,
                         double half_kerf_mm) {
  CornerWork work;
  if (settings.corner_loop_mm <= 0.0 && settings.corner_dwell_s <= 0.0) return work;
  const double min_turn = settings.corner_angle_deg * std::numbers::pi / 180.0;
  std::vector<Stroke> treated;
  std::size_t done = 0;
  for (const Corner& corner : corners_of(strokes, min_turn, half_kerf_mm)) {
    for (; done < corner.stroke; ++done) treated.push_back(strokes[done]);
    if (corner.is_outer && settings.corner_loop_mm > 0.0) {
      const auto loop = loop_with_room(strokes[done], settings.corner_loop_mm, parts, half_kerf_mm);
      if (!loop.strokes.empty()) {
        treated.insert(treated.end(), loop.strokes.begin(), loop.strokes.end());
        if (loop.share < 1.0 && work.smaller++ == 0) work.first_smaller = corner.place;
        ++done;
        continue;
      }
      if (work.without_room++ == 0) work.first_without = corner.place;
    }
    // At the start of the cut the beam comes from the lead, so there is no dwell.
    if (corner.stroke != 0) strokes[done].dwell_s = settings.corner_dwell_s;
  }
  treated.insert(treated.end(), strokes.begin() + static_cast<std::ptrdiff_t>(done), strokes.end());
  strokes = std::move(treated);
  return work;
}

}  // namespace sim::cut
