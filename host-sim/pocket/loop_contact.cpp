#include "host-sim/pocket/loop_contact.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "planner/contour/box_tree.hpp"
#include "planner/contour/meeting.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using cnc::contour::FlatBox;
using Curve = cnc::contour::Curve<double>;
using Element = cnc::pocket::LoopElement<double>;
using View = cnc::contour::ContourView<double>;

/// Returns an element as a curve. An element of length 0 becomes a point.
Curve curve_of(const Element& element) {
  Curve curve{.start = element.start, .end = element.start};
  static_cast<void>(cnc::pocket::make_curve(element, curve));
  return curve;
}

/// Calls `visit(curve)` for an element. If the element turns by more than half a turn, calls it for
/// both halves.
template <typename Visit>
void for_each_curve(const Element& element, const Visit& visit) {
  if (std::abs(element.bulge) <= 1.0) return visit(curve_of(element));
  const double half = std::tan(0.5 * std::atan(element.bulge));
  visit(curve_of({element.start, element.middle(), half}));
  visit(curve_of({element.middle(), element.end, half}));
}

FlatBox<double> grown(const FlatBox<double>& box) {
  return {box.x0 - kTouchMm, box.y0 - kTouchMm, box.x1 + kTouchMm, box.y1 + kTouchMm};
}

WideVec2 centre_of(const Curve& arc) {
  return arc.start + cnc::left_normal(arc.start_tangent) / arc.curvature;
}

/// Returns the point of an arc that is nearest to another curve, extended to a full circle or an
/// infinite line. Returns none if this point does not touch the other curve itself. For circles
/// that just miss each other, the computed intersections are next to this point.
std::optional<WideVec2> nearest_touch(const Curve& arc, const Curve& other) {
  if (arc.curvature == 0.0) return std::nullopt;
  const WideVec2 centre = centre_of(arc);
  const bool is_line = other.curvature == 0.0;
  const WideVec2 towards = is_line ? WideVec2{cnc::left_normal(other.start_tangent)}
                                   : WideVec2{centre_of(other) - centre};
  const double away = towards.norm();
  // The circles are concentric. The ends of the curves decide.
  if (away <= kTouchMm) return std::nullopt;
  for (const double side : {1.0, -1.0}) {
    const WideVec2 place = centre + side / (std::abs(arc.curvature) * away) * towards;
    if (arc.faces(place, 0.0) && other.distance(place) <= kTouchMm) return place;
  }
  return std::nullopt;
}

/// Returns a point that is on both curves within kTouchMm.
std::optional<WideVec2> contact_of(const Curve& a, const Curve& b) {
  const auto meetings = cnc::contour::meetings_of(a, b, kTouchMm);
  if (meetings.count > 0) return meetings.places[0];
  if (const auto place = nearest_touch(a, b)) return *place;
  if (const auto place = nearest_touch(b, a)) return *place;
  // Curves that overlap along a stretch have no computed intersection. But an end of one curve is
  // on the other curve.
  for (const WideVec2& end : {a.start, a.end}) {
    if (b.distance(end) <= kTouchMm) return end;
  }
  for (const WideVec2& end : {b.start, b.end}) {
    if (a.distance(end) <= kTouchMm) return end;
  }
  return std::nullopt;
}

/// The curves of all loops. For each curve, also its loop.
class LoopCurves {
 public:
  explicit LoopCurves(const View& contour) {
    for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
      for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
        for_each_curve(cnc::pocket::element_at(contour, loop, i), [&](const Curve& curve) {
          curves_.push_back(curve);
          loops_.push_back(loop);
        });
      }
    }
  }

  [[nodiscard]] std::optional<WideVec2> contact() const {
    const auto count = static_cast<std::uint32_t>(curves_.size());
    std::vector<FlatBox<double>> boxes(cnc::contour::BoxTree<double>::size_for(count));
    cnc::contour::BoxTree<double> tree{slice_of(boxes)};
    for (std::uint32_t i = 0; i < count; ++i) tree.leaf(i) = grown(curves_[i].box());
    tree.build(count);
    std::optional<WideVec2> found;
    for (std::uint32_t i = 0; i < count && !found; ++i) {
      tree.search(curves_[i].box(), i + 1, [&](std::uint32_t other) {
        if (loops_[i] != loops_[other]) found = contact_of(curves_[i], curves_[other]);
        return !found;
      });
    }
    return found;
  }

 private:
  std::vector<Curve> curves_;
  std::vector<std::size_t> loops_;
};

bool touches(const View& contour, std::size_t loop, const WideVec2& place) {
  bool is_near = false;
  for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop] && !is_near; ++i) {
    for_each_curve(cnc::pocket::element_at(contour, loop, i), [&](const Curve& curve) {
      is_near = is_near || curve.distance(place) <= kTouchMm;
    });
  }
  return is_near;
}

}  // namespace

std::optional<WideVec2> contact_between_loops(const View& contour) {
  return LoopCurves{contour}.contact();
}

FlatBox<double> box_around(const View& contour, std::size_t loop) {
  const WideVec2 begin = contour.vertices[contour.loop_begin(loop)].point();
  FlatBox<double> box = grown({begin.x(), begin.y(), begin.x(), begin.y()});
  for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
    for_each_curve(cnc::pocket::element_at(contour, loop, i),
                   [&](const Curve& curve) { box.include(grown(curve.box())); });
  }
  return box;
}

std::optional<WideVec2> place_off_loop(const View& contour, std::size_t loop, std::size_t other) {
  for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
    const Element element = cnc::pocket::element_at(contour, loop, i);
    for (const WideVec2& place : {element.start, element.middle()}) {
      if (!touches(contour, other, place)) return place;
    }
  }
  return std::nullopt;
}

}  // namespace sim::pocket
