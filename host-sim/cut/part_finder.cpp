#include "host-sim/cut/part_finder.hpp"

namespace sim::cut {

PartFinder::PartFinder(const drawing::Drawing& drawn, const CutPlan& plan)
    : drawn_{drawn}, roles_(drawn.contours.size(), Role::kNone) {
  for (const Cut& cut : plan.cuts) {
    if (cut.contour == kNoContour) continue;
    const bool is_beside = plan.plan_of(cut).settings.side == Side::kWaste;
    roles_[cut.contour] = !is_beside ? Role::kMark : cut.is_hole ? Role::kHole : Role::kOuter;
  }
}

std::size_t PartFinder::part_of(const Cut& cut) const {
  if (cut.contour == kNoContour) return kNoPart;
  return roles_[cut.contour] == Role::kOuter ? cut.contour : part_around(cut.contour);
}

std::size_t PartFinder::part_around(std::size_t contour) const {
  const drawing::DrawnContour& drawn = drawn_.contours[contour];
  auto around = roles_[contour] == Role::kHole ? drawn.parent : drawn.lies_in;
  // The bound ends the loop for a drawing in which contours lie cyclically inside each other.
  for (std::size_t i = 0; around && i < roles_.size(); ++i) {
    if (roles_[*around] == Role::kOuter) return *around;
    around = drawn_.contours[*around].lies_in;
  }
  return kNoPart;
}

}  // namespace sim::cut
