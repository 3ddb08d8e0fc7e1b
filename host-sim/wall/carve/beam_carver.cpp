#include "host-sim/wall/carve/beam_carver.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "host-sim/wall/axis_angle.hpp"
#include "host-sim/wall/carve/footprint.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Greatest lean of a beam's side, in radians, for which a stroke is divided exactly. If the side
/// leans more, the stroke is divided as if the side had this lean.
constexpr double kSteepest = 1.4;

/// Returns the number of the first cell whose middle is at or after the coordinate `place`, from 0
/// to `count`.
int first_cell(double place, double start, double cell_mm, int count) {
  return static_cast<int>(
      std::clamp(std::ceil((place - start) / cell_mm - 0.5), 0.0, static_cast<double>(count)));
}

/// Returns the pose at the fraction `share` of the motion from one pose to another.
BeamPose between(const BeamPose& from, const BeamPose& to, double share) {
  const double angle = angle_between(from.axis, to.axis);
  BeamPose pose{
      from.tip + share * (to.tip - from.tip), from.axis, std::max(from.depth_mm, to.depth_mm)};
  if (angle > 0.0) {
    pose.axis = (std::sin((1.0 - share) * angle) * from.axis + std::sin(share * angle) * to.axis)
                    .normalized();
  }
  return pose;
}

}  // namespace

void BeamCarver::carve(const BeamStroke& stroke) {
  if (stroke.size() == 1) move(stroke.front(), stroke.front());
  for (std::size_t i = 1; i < stroke.size(); ++i) move(stroke[i - 1], stroke[i]);
}

void BeamCarver::move(const BeamPose& from, const BeamPose& to) {
  ++moves_;
  const double turn = angle_between(from.axis, to.axis);
  const double side = beam_.half_angle_rad + beam_.heat_rad;
  const double height =
      std::max(columns_.box().top - std::min(from.tip.z(), to.tip.z()), kSwingErrorMm);
  // Limits the turn of the axis within a part, so that the beam's side at `height` moves by at most
  // kSwingErrorMm.
  const double lean = side + std::acos(std::min({1.0, from.axis.z(), to.axis.z()}));
  const double cosine = std::cos(std::min(lean, kSteepest));
  const double max_turn = kSwingErrorMm / height * cosine * cosine;
  // A turn below this limit is only rounding of the axes.
  constexpr double kMinTurn = 1.0e-12;
  const auto parts =
      turn < kMinTurn ? std::size_t{1} : static_cast<std::size_t>(turn / max_turn) + 1;
  const double more = turn < kMinTurn ? 0.0 : 0.5 * turn / static_cast<double>(parts);
  const double slope = std::tan(side + more);
  for (std::size_t i = 0; i < parts; ++i) {
    const auto share = [parts](double part) { return part / static_cast<double>(parts); };
    const auto first = static_cast<double>(i);
    const BeamPose start = between(from, to, share(first));
    const Vector3d way = share(1.0) * (to.tip - from.tip);
    CutCone cone{.axis = between(from, to, share(first + 0.5)).axis,
                 .radius_mm = beam_.waist_mm,
                 .slope = slope};
    burn(cone, start.tip, way);
    if (start.depth_mm > 0.0 && beam_.waist_mm > 0.0) {
      cone.slope = 0.0;
      cone.from_mm = -start.depth_mm;
      cone.until_mm = 0.0;
      burn(cone, start.tip, way);
    }
    ++parts_;
  }
}

void BeamCarver::burn(const CutCone& cone, const Vector3d& from, const Vector3d& way) {
  const SweptCone swept{cone, from, way};
  const auto discs = swept.plan_below(columns_.box().top);
  if (!discs) return;
  const Footprint footprint{*discs};
  const stock::StockBox& box = columns_.box();
  const int end = first_cell(footprint.y_max(), box.y_min, columns_.cell_y_mm(), columns_.rows());
  int row = first_cell(footprint.y_min(), box.y_min, columns_.cell_y_mm(), columns_.rows());
  for (; row < end; ++row) {
    const auto reach = footprint.along(columns_.y_of(row));
    if (reach) burn_row(swept, row, reach->from, reach->until);
  }
}

void BeamCarver::burn_row(const SweptCone& cone, int row, double from, double until) {
  const double start = columns_.box().x_min;
  const double y = columns_.y_of(row);
  const int end = first_cell(until, start, columns_.cell_x_mm(), columns_.columns());
  int column = first_cell(from, start, columns_.cell_x_mm(), columns_.columns());
  for (; column < end; ++column) {
    const double x = columns_.x_of(column);
    const double top = columns_.top(column, row);
    const bool is_empty = top <= columns_.box().bottom;
    if (is_empty || cone.misses_below(x, y, top)) continue;
    const auto range = cone.heights(x, y);
    if (range && range->low < top) columns_.remove(column, row, *range);
  }
}

}  // namespace sim::wall
