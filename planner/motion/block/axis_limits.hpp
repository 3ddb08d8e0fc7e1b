#pragma once

#include "planner/base/coordinate.hpp"
#include "planner/kinematics/tool_centre.hpp"
#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

/// Bounds of the motion of the axes X Y Z on a block whose rotary axes move the tip of the tool.
struct AxisCourse {
  /// Greatest magnitudes of the positions' first derivatives by path length, mm per mm.
  Vec3 first = Vec3::Zero();
  /// Greatest magnitudes of the positions' second derivatives by path length, 1/mm.
  Vec3 second = Vec3::Zero();
  Vec3 least = Vec3::Zero();  ///< Least positions, mm, relative to ToolCentre::centre().
  Vec3 most = Vec3::Zero();
};

/// Returns bounds of the motion of the axes X Y Z on a block. The block must be short enough that
/// its rotary axes turn by only a few degrees, see ToolCentre::parts_of().
/// @param start programmed position at the start of the block
/// @pre centre.active()
[[nodiscard]] AxisCourse axis_course(const Block& block,
                                     const Position& start,
                                     const kinematics::ToolCentre& centre);

/// Lowers the limits of speed and acceleration of a block so that the axes X Y Z keep their own
/// limits at up to twice the programmed feed. At constant speed along the path, an axis may use
/// half of its acceleration limit. A change of speed along the path may use the rest.
void limit_axes(Block& block, const AxisCourse& course, const Limits& limits);

}  // namespace cnc::motion
