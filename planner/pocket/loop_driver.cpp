#include "planner/pocket/loop_driver.hpp"

#include "planner/pocket/loop_measures.hpp"

namespace cnc::pocket {
namespace {

/// Returns part number `step` of a revolution. The first part leads from `place` to the end of its
/// element. Then all other elements follow. The last part leads from the start of the first element
/// to `place`.
template <typename Scalar>
LoopElement<Scalar> part_of(const contour::ContourView<Scalar>& contour,
                            const LoopPlace<Scalar>& place,
                            Milling milling,
                            std::uint32_t step) {
  const std::uint32_t first = contour.loop_begin(place.loop);
  const std::uint32_t count = contour.loop_ends[place.loop] - first;
  const bool climb = milling == Milling::kClimb;
  const std::uint32_t turned = step % count;
  const std::uint32_t index = place.vertex - first + (climb ? turned : count - turned);
  LoopElement<Scalar> part = element_at(contour, place.loop, first + index % count);
  contour::Curve<Scalar> curve;
  const bool is_curve = make_curve(part, curve);
  const bool starts_at_place = climb ? step == 0 : step == count;
  const bool ends_at_place = climb ? step == count : step == 0;
  if (starts_at_place) part.start = place.pose.point;
  if (ends_at_place) part.end = place.pose.point;
  if (is_curve && (starts_at_place || ends_at_place)) {
    part.bulge = curve.bulge_between(part.start, part.end);
  }
  if (climb) return part;
  return {part.end, part.start, -part.bulge};
}

}  // namespace

template <typename Scalar>
Scalar loop_length(const contour::ContourView<Scalar>& contour, std::size_t loop) {
  Scalar sum{};
  for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
    sum += length_of(element_at(contour, loop, i));
  }
  return sum;
}

template <typename Scalar>
bool drive_loop(const contour::ContourView<Scalar>& contour,
                const LoopPlace<Scalar>& place,
                Milling milling,
                const LoopDrive<Scalar>& drive,
                ToolPathWriter<Scalar>& out) {
  const std::uint32_t count = contour.loop_ends[place.loop] - contour.loop_begin(place.loop);
  const Scalar slope = (drive.z_to - drive.z_from) / loop_length(contour, place.loop);
  Scalar driven{};
  for (std::uint32_t step = 0; step <= count; ++step) {
    const LoopElement<Scalar> part = part_of(contour, place, milling, step);
    const Scalar z = drive.z_from + slope * driven;
    if (!out.add({part.start.x(), part.start.y(), z, part.bulge, drive.use})) return false;
    driven += length_of(part);
  }
  return true;
}

template double loop_length(const contour::ContourView<double>&, std::size_t);
template bool drive_loop(const contour::ContourView<double>&,
                         const LoopPlace<double>&,
                         Milling,
                         const LoopDrive<double>&,
                         ToolPathWriter<double>&);

}  // namespace cnc::pocket
