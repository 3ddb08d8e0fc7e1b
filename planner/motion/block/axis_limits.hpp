#pragma once

#include "planner/base/coordinate.hpp"
#include "planner/kinematics/tool_centre.hpp"
#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

/// Bounds of the motion of the axes X Y Z on a block where rotary axes move the tip.
struct AxisCourse {
  Vec3 first = Vec3::Zero();   ///< Greatest first derivatives by path length, mm per mm.
  Vec3 second = Vec3::Zero();  ///< Greatest second derivatives, 1/mm.
  Vec3 least = Vec3::Zero();   ///< Least positions, mm, as seen from the tool's centre.
  Vec3 most = Vec3::Zero();
};

/// Returns how the axes X Y Z move on a block whose rotary axes turn little. @pre centre.active()
[[nodiscard]] AxisCourse axis_course(const Block& block,
                                     const Position& start,
                                     const kinematics::ToolCentre& centre);

/// Lowers the speed and the acceleration of a block so that the axes X Y Z, too, keep their limits,
/// at up to twice the programmed feed. Braking and turning share the acceleration of an axis.
void limit_axes(Block& block, const AxisCourse& course, const Limits& limits);

}  // namespace cnc::motion
