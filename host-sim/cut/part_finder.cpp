#include "host-sim/cut/part_finder.hpp"

#include <algorithm>
#include <cmath>

#include "host-sim/import/curve_measure.hpp"

namespace sim::cut {

PartFinder::PartFinder(const drawing::Drawing& drawn, const CutPlan& plan)
    : drawn_{drawn}, roles_(drawn.contours.size(), Role::kNone) {
  bool has_open_marks = false;
  for (const Cut& cut : plan.cuts) {
    if (cut.contour == kNoContour) continue;
    const bool is_beside = plan.plan_of(cut).settings.side == Side::kWaste;
    roles_[cut.contour] = !is_beside ? Role::kMark : cut.is_hole ? Role::kHole : Role::kOuter;
    has_open_marks = has_open_marks || !drawn.contours[cut.contour].closed;
  }
  if (has_open_marks) add_outers();
}

std::size_t PartFinder::part_of(const Cut& cut) const {
  if (cut.contour == kNoContour) return kNoPart;
  if (roles_[cut.contour] == Role::kOuter) return cut.contour;
  // The drawing says where closed contours lie only.
  return drawn_.contours[cut.contour].closed ? part_around(cut.contour) : part_at(cut.start());
}

std::size_t PartFinder::part_around(std::size_t contour) const {
  const drawing::DrawnContour& drawn = drawn_.contours[contour];
  auto around = roles_[contour] == Role::kHole ? drawn.parent : drawn.lies_in;
  // The bound only guards against a drawing whose contours lie in each other in a ring.
  for (std::size_t i = 0; around && i < roles_.size(); ++i) {
    if (roles_[*around] == Role::kOuter) return *around;
    around = drawn_.contours[*around].lies_in;
  }
  return kNoPart;
}

void PartFinder::add_outers() {
  for (std::size_t i = 0; i < roles_.size(); ++i) {
    if (roles_[i] != Role::kOuter) continue;
    Outer outer{i, outline_of(drawn_.contours[i].shapes, drawing::kChordToleranceMm)};
    outer.low = outer.high = outer.outline.front();
    for (const Place& place : outer.outline) {
      outer.low = {std::min(outer.low.x(), place.x()), std::min(outer.low.y(), place.y())};
      outer.high = {std::max(outer.high.x(), place.x()), std::max(outer.high.y(), place.y())};
    }
    outers_.push_back(std::move(outer));
  }
  std::ranges::sort(outers_, {}, [this](const Outer& outer) {
    return std::abs(drawn_.contours[outer.contour].area_mm2);
  });
}

std::size_t PartFinder::part_at(const Place& place) const {
  const auto found =
      std::ranges::find_if(outers_, [&](const Outer& outer) { return encloses(outer, place); });
  return found != outers_.end() ? found->contour : kNoPart;
}

/// Counts the crossings of a ray to the right.
bool PartFinder::encloses(const Outer& outer, const Place& place) {
  if (place.x() < outer.low.x() || place.x() > outer.high.x()) return false;
  if (place.y() < outer.low.y() || place.y() > outer.high.y()) return false;
  bool is_inside = false;
  for (std::size_t i = 1; i < outer.outline.size(); ++i) {
    const Place& a = outer.outline[i - 1];
    const Place& b = outer.outline[i];
    if ((a.y() <= place.y()) == (b.y() <= place.y())) continue;
    const double x = a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (x > place.x()) is_inside = !is_inside;
  }
  return is_inside;
}

}  // namespace sim::cut
