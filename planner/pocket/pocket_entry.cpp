#include "planner/pocket/pocket_entry.hpp"

#include <cmath>

#include "planner/pocket/loop_driver.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace cnc::pocket {
namespace {

constexpr int kHalvings = 3;
constexpr double kMaxRevolutions = 1000.0;
constexpr double kFullTurn = 6.283185307179586;

/// Returns +1 if the area is to the left of the direction of travel, −1 if it is to the right.
template <typename Scalar>
Scalar side_of_area(Milling milling) {
  return milling == Milling::kClimb ? Scalar{1} : Scalar{-1};
}

template <typename Scalar>
BasicVec2<Scalar> helix_centre(const Pose<Scalar>& pose, Scalar radius, Milling milling) {
  return pose.point + side_of_area<Scalar>(milling) * radius * left_normal(pose.tangent);
}

/// Returns the greatest radius above `least` whose circle fits at a pose, among `greatest` and its
/// repeated halves; 0 if none fits.
template <typename Scalar>
Scalar fitting_radius(const contour::ContourView<Scalar>& locus,
                      const NearestCurve<Scalar>& boundary,
                      const Pose<Scalar>& pose,
                      Milling milling,
                      Scalar greatest,
                      Scalar least) {
  // Tolerance in mm: if the pose is on the boundary, the circle touches the boundary from inside.
  constexpr Scalar kTouching{1.0e-9};
  Scalar radius = greatest;
  for (int i = 0; i <= kHalvings && radius > least; ++i) {
    const BasicVec2<Scalar> centre = helix_centre(pose, radius, milling);
    const bool is_far = boundary.nearest_to(centre).distance >= radius - kTouching;
    if (is_far && is_inside(locus, centre)) return radius;
    radius *= Scalar{0.5};
  }
  return Scalar{0};
}

/// Returns the number of revolutions of a descent: the least number with which the descent is not
/// steeper than the slope.
template <typename Scalar>
Scalar parts_of_descent(Scalar descent, Scalar slope, Scalar length) {
  return std::max(Scalar{1}, std::ceil(descent / (slope * length)));
}

template <typename Scalar>
EntryResult write_helix(const EntryPlan<Scalar>& plan,
                        Milling milling,
                        Scalar slope,
                        const Descent<Scalar>& descent,
                        ToolPathWriter<Scalar>& out) {
  const BasicVec2<Scalar> start = plan.place.pose.point;
  const BasicVec2<Scalar> centre = helix_centre(plan.place.pose, plan.helix_radius, milling);
  const BasicVec2<Scalar> opposite = Scalar{2} * centre - start;
  const Scalar turns =
      parts_of_descent(descent.from - descent.to, slope, Scalar{kFullTurn} * plan.helix_radius);
  if (turns > Scalar{kMaxRevolutions}) return EntryResult::kTooShort;
  const auto halves = static_cast<std::uint32_t>(Scalar{2} * turns);
  for (std::uint32_t i = 0; i < halves; ++i) {
    const BasicVec2<Scalar>& from = i % 2 == 0 ? start : opposite;
    const Scalar share = static_cast<Scalar>(i) / (Scalar{2} * turns);
    const Scalar z = descent.from + share * (descent.to - descent.from);
    if (!out.add({from.x(), from.y(), z, side_of_area<Scalar>(milling), Use::kEntry})) {
      return EntryResult::kFull;
    }
  }
  return EntryResult::kDone;
}

template <typename Scalar>
EntryResult write_ramp(const EntryPlan<Scalar>& plan,
                       const contour::ContourView<Scalar>& area,
                       Milling milling,
                       Scalar slope,
                       const Descent<Scalar>& descent,
                       ToolPathWriter<Scalar>& out) {
  const Scalar revolutions =
      parts_of_descent(descent.from - descent.to, slope, loop_length(area, plan.place.loop));
  if (!(revolutions <= Scalar{kMaxRevolutions})) return EntryResult::kTooShort;
  const auto count = static_cast<std::uint32_t>(revolutions);
  const Scalar step = (descent.to - descent.from) / revolutions;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Scalar from = descent.from + static_cast<Scalar>(i) * step;
    const Scalar to = i + 1 == count ? descent.to : from + step;
    if (!drive_loop(area, plan.place, milling, {from, to, Use::kEntry}, out)) {
      return EntryResult::kFull;
    }
  }
  return EntryResult::kDone;
}

}  // namespace

template <typename Scalar>
EntryPlan<Scalar> plan_entry(const contour::ContourView<Scalar>& locus,
                             const NearestCurve<Scalar>& boundary,
                             const contour::ContourView<Scalar>& area,
                             std::size_t loop,
                             Milling milling,
                             const EntryOptions<Scalar>& options) {
  EntryPlan<Scalar> plan;
  Scalar longest{-1};
  for (std::uint32_t i = area.loop_begin(loop); i < area.loop_ends[loop]; ++i) {
    const LoopElement<Scalar> element = element_at(area, loop, i);
    contour::Curve<Scalar> curve;
    if (!make_curve(element, curve)) continue;
    const Pose<Scalar> pose = pose_on(curve, element.middle(), milling);
    const Scalar greatest = options.kind == EntryKind::kHelix ? options.helix_radius : Scalar{0};
    const Scalar radius =
        fitting_radius(locus, boundary, pose, milling, greatest, plan.helix_radius);
    const Scalar chord = (element.end - element.start).norm();
    // If no circle fits, the middle of the longest element is chosen, because it has the most space
    // for links.
    if (radius <= plan.helix_radius && (plan.helix_radius > Scalar{0} || chord <= longest)) {
      continue;
    }
    longest = chord;
    plan.helix_radius = std::max(plan.helix_radius, radius);
    plan.place = {loop, i, pose};
  }
  plan.kind = options.kind;
  if (plan.kind == EntryKind::kHelix && plan.helix_radius == Scalar{0}) {
    plan.kind = EntryKind::kRamp;
  }
  return plan;
}

template <typename Scalar>
EntryResult write_entry(const EntryPlan<Scalar>& plan,
                        const contour::ContourView<Scalar>& area,
                        Milling milling,
                        const EntryOptions<Scalar>& options,
                        const Descent<Scalar>& descent,
                        ToolPathWriter<Scalar>& out) {
  switch (plan.kind) {
    case EntryKind::kHelix:
      return write_helix(plan, milling, options.slope, descent, out);
    case EntryKind::kRamp:
      return write_ramp(plan, area, milling, options.slope, descent, out);
    case EntryKind::kPlunge:
      break;
  }
  const BasicVec2<Scalar>& place = plan.place.pose.point;
  const bool added = out.add({place.x(), place.y(), descent.from, Scalar{0}, Use::kEntry});
  return added ? EntryResult::kDone : EntryResult::kFull;
}

template EntryPlan<double> plan_entry(const contour::ContourView<double>&,
                                      const NearestCurve<double>&,
                                      const contour::ContourView<double>&,
                                      std::size_t,
                                      Milling,
                                      const EntryOptions<double>&);
template EntryResult write_entry(const EntryPlan<double>&,
                                 const contour::ContourView<double>&,
                                 Milling,
                                 const EntryOptions<double>&,
                                 const Descent<double>&,
                                 ToolPathWriter<double>&);

}  // namespace cnc::pocket
