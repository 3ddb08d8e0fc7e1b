#include "planner/motion/lookahead/time_window.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/block/axes_in_plane.hpp"

namespace cnc::motion {
namespace {

// Length of the shortest window, s. A shorter window would be below the resolution of step timing.
constexpr float kShortest = 0.25e-3F;
constexpr float kLongest = 0.256F;  // Length of the longest window, s.
/// Least length, in s, of a window that WindowChoice chooses. A shorter window has few cells, and
/// so a coarse mean. If the greatest A / J of the axes (acceleration limit / jerk limit) is
/// shorter, the least length is A / J.
constexpr float kShortestChosen = 1.0e-3F;
constexpr float kLongestCell = 1.0e-3F;
constexpr float kShortestCell = 0.5e-3F;
constexpr float kWantedCells = 8.0F;

}  // namespace

std::uint8_t moving_axes(const Block& block) {
  std::uint8_t axes = 0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (block.direction[axis] != 0.0F) axes = static_cast<std::uint8_t>(axes | (1U << axis));
  }
  for (std::size_t axis = 0; block.turns() && axis < kAxisCount; ++axis) {
    if (block.turn.plane.has(axis)) axes = static_cast<std::uint8_t>(axes | (1U << axis));
  }
  return axes;
}

namespace {

/// Returns the greatest acceleration limit / jerk limit of the axes in the bit set `axes`, in s.
float longest_rise(const Limits& limits, std::uint8_t axes) {
  float seconds = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float jerk = limits.jerk_mm_s3[axis];
    if ((axes >> axis & 1U) == 0 || jerk <= 0.0F) continue;
    seconds = std::max(seconds, limits.acceleration_mm_s2[axis] / jerk);
  }
  return seconds;
}

/// Divides a time window of `wanted_s` into cells. The window is limited to kLongest.
/// @pre wanted_s ≥ kShortest
TimeWindow divided(float wanted_s) {
  const float seconds = std::min(wanted_s, kLongest);
  constexpr auto kMax = static_cast<float>(TimeWindow::kMaxCells);
  const float cell = std::clamp(seconds / kWantedCells, kShortestCell, kLongestCell);
  const float cells = std::min(kMax, std::ceil(seconds / cell));
  return {.cells = static_cast<std::uint32_t>(cells),
          .cell_ns = static_cast<std::uint32_t>(std::ceil(seconds / cells * 1.0e9F))};
}

/// Returns the greatest acceleration or jerk along the path with which no axis exceeds its limit
/// anywhere on a block.
/// @param of_axes limits of acceleration or jerk of the axes; 0 or less is no limit
float along_path(const Block& block, const AxisArray<float>& of_axes) {
  constexpr float kNoLimit = 1.0e12F;
  float most = kNoLimit;
  const auto keep = [&](std::size_t axis, float share) {
    const float limit = of_axes[axis];
    if (limit > 0.0F && limit < most * share) most = limit / share;
  };
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) keep(axis, std::abs(block.direction[axis]));
  if (!block.turns()) return most;
  const float start = block.turn.start_angle;
  const float end = start + 2.0F * block.turn.half_sweep;
  const DirectionRange directions{std::min(start, end), std::max(start, end)};
  for (const AxisInPlane& each : AxesInPlane{block.turn.plane, 1.0F}) {
    keep(each.axis, block.turn.plane_share * directions.greatest_shares(each).tangent);
  }
  return most;
}

}  // namespace

TimeWindow window_for(const Limits& limits, std::uint8_t axes) {
  const float seconds = longest_rise(limits, axes);
  return seconds < kShortest ? TimeWindow{} : divided(seconds);
}

void WindowChoice::add(const Block& block, float length, float speed_square) {
  axes_ = static_cast<std::uint8_t>(axes_ | moving_axes(block));
  length_ += length;
  const float jerk = along_path(block, limits_.jerk_mm_s3);
  const float acceleration = along_path(block, limits_.acceleration_mm_s2);
  float rise = std::min(acceleration / jerk, std::sqrt(std::sqrt(speed_square) / jerk));
  const float bend = block.turn.curvature * square(block.turn.plane_share);
  // On an arc of radius R, v²/R is at most the acceleration limit, and v³/R² is at most the jerk
  // limit. Both limit the speed.
  if (bend > 0.0F) {
    const float by_acceleration = std::sqrt(acceleration / bend);
    rise = std::min(
        {rise, std::sqrt(by_acceleration / jerk), bounded_cube_root(1.0F / (bend * jerk))});
  }
  jerk_ = std::min(jerk_, jerk);
  rise_ = std::max(rise_, rise);
}

TimeWindow WindowChoice::window(float share) const {
  const float longest = longest_rise(limits_, axes_);
  if (longest < kShortest) return {};
  // Least length of the chain, mm, with which the window is computed. It is shorter than any step.
  // The remaining path after a halt may be even shorter: a hundred-millionth of a millimetre.
  constexpr float kMinLength = 1.0e-4F;
  const float by_length = bounded_cube_root(std::max(length_, kMinLength) / (2.0F * jerk_));
  const float shortest = std::min(kShortestChosen, longest);
  const float of_one_move = std::clamp(std::min(rise_, by_length), shortest, longest);
  return divided(std::max(shortest, share * of_one_move));
}

}  // namespace cnc::motion
