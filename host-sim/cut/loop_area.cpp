#include "host-sim/cut/loop_area.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host-sim/cut/segment_distance.hpp"
#include "planner/base/contract.hpp"

namespace sim::cut {
namespace {

/// Returns twice the area inside the loop, mm², with the areas between arcs and their chords. The
/// result is positive if the loop turns left.
double twice_area(const std::vector<Stroke>& loop) {
  const Place origin = loop.front().from;
  double twice = 0.0;
  for (const Stroke& stroke : loop) {
    twice += drawing::cross(stroke.from - origin, stroke.to - origin);
    if (stroke.bulge == 0.0) continue;
    const double sweep = 4.0 * std::atan(stroke.bulge);
    const double radius = drawing::distance(arc_centre(stroke), stroke.from);
    twice += radius * radius * (sweep - std::sin(sweep));
  }
  return twice;
}

/// Returns a positive number for a point on the left of a chord, and a negative one for a point on
/// the right. A point on the chord counts as slightly farther in +x, or above a horizontal chord.
/// The ray of turns_by_chord() treats such points in the same way.
double side_of(const Stroke& stroke, const Place& place) {
  const Place way = stroke.to - stroke.from;
  const double side = drawing::cross(way, place - stroke.from);
  if (side != 0.0) return side;
  return way.y() == 0.0 ? way.x() : -way.y();
}

/// Returns the change of the winding number around a point if an arc replaces its chord.
int turns_by_arc(const Stroke& arc, const Place& place) {
  if (arc.bulge == 0.0) return 0;
  const double side = side_of(arc, place);
  if (arc.bulge > 0.0 ? side >= 0.0 : side <= 0.0) return 0;
  const Place centre = arc_centre(arc);
  if (drawing::distance(centre, place) >= drawing::distance(centre, arc.from)) return 0;
  return arc.bulge > 0.0 ? 1 : -1;
}

/// Returns the contribution of a chord to the winding number around a point. It is 1 or −1 if a ray
/// from the point to the right crosses the chord, otherwise 0.
int turns_by_chord(const Stroke& stroke, const Place& place) {
  const bool from_is_above = stroke.from.y() > place.y();
  const bool to_is_above = stroke.to.y() > place.y();
  if (from_is_above == to_is_above) return 0;
  const double side = drawing::cross(stroke.to - stroke.from, place - stroke.from);
  if (to_is_above) return side > 0.0 ? 1 : 0;
  return side < 0.0 ? -1 : 0;
}

}  // namespace

LoopArea::Box box_around(const Stroke& stroke) {
  LoopArea::Box box = box_between(stroke.from, stroke.to);
  if (stroke.bulge == 0.0) return box;
  const double size = std::abs(stroke.bulge);
  const double chord = drawing::distance(stroke.from, stroke.to);
  return grown(box, 0.5 * std::max(size, size * size) * chord);
}

LoopArea::LoopArea(std::vector<Stroke> loop, double skin_mm)
    : loop_{std::move(loop)}, skin_mm_{skin_mm} {
  constexpr double kNothing = 1.0e-9;
  std::erase_if(loop_, [](const Stroke& stroke) {
    return drawing::distance(stroke.from, stroke.to) < kNothing;
  });
  CNC_ASSERT(!loop_.empty());
  if (twice_area(loop_) < 0.0) {
    std::ranges::reverse(loop_);
    for (Stroke& stroke : loop_) {
      std::swap(stroke.from, stroke.to);
      stroke.bulge = -stroke.bulge;
    }
  }
  box_ = box_around(loop_.front());
  for (const Stroke& stroke : loop_) {
    boxes_.push_back(box_around(stroke));
    box_.include(boxes_.back());
  }
  box_ = grown(box_, skin_mm);
}

bool LoopArea::contains(const Place& place) const {
  if (!box_.meets(box_between(place, place))) return false;
  int turns = 0;
  for (const Stroke& stroke : loop_) {
    turns += turns_by_chord(stroke, place) + turns_by_arc(stroke, place);
  }
  return turns != 0;
}

double LoopArea::distance_to_loop(const Place& place) const {
  double least = drawing::distance(place, loop_.front().from);
  for (std::size_t i = 0; i < loop_.size(); ++i) {
    if (!grown(boxes_[i], least).meets(box_between(place, place))) continue;
    least = std::min(least, drawing::distance(place, nearest_on(loop_[i], place)));
  }
  return least;
}

bool LoopArea::comes_near(const Place& from, const Place& to, double mm) const {
  const Box around = grown(box_between(from, to), mm);
  if (!box_.meets(around)) return false;
  const Place way = to - from;
  const double length = std::hypot(way.x(), way.y());
  for (std::size_t i = 0; i < loop_.size(); ++i) {
    const Box& box = boxes_[i];
    if (!box.meets(around)) continue;
    // Compares the distance of the box's middle from the line of the segment with the reach of the
    // box's corners perpendicular to this line.
    const Place middle{0.5 * (box.x0 + box.x1), 0.5 * (box.y0 + box.y1)};
    const double reach =
        0.5 * ((box.x1 - box.x0) * std::abs(way.y()) + (box.y1 - box.y0) * std::abs(way.x()));
    if (std::abs(drawing::cross(way, middle - from)) > reach + mm * length) continue;
    if (segment_distance(from, to, loop_[i]) < mm) return true;
  }
  return false;
}

bool LoopArea::is_crossed(const Place& from, const Place& to, double depth_mm) const {
  const Box around = box_between(from, to);
  if (!box_.meets(around)) return false;
  std::vector<double> shares{0.0, 1.0};
  for (std::size_t i = 0; i < loop_.size(); ++i) {
    if (boxes_[i].meets(around)) add_meetings(from, to, loop_[i], shares);
  }
  std::ranges::sort(shares);
  for (std::size_t i = 1; i < shares.size(); ++i) {
    for (const double part : {0.5, 0.25, 0.75, 0.1, 0.9}) {
      const double share = shares[i - 1] + part * (shares[i] - shares[i - 1]);
      const Place place = from + share * (to - from);
      if (contains(place) && distance_to_loop(place) > depth_mm) return true;
    }
  }
  return false;
}

}  // namespace sim::cut
