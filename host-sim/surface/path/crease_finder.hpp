#pragma once

#include <Eigen/Core>
#include <optional>

#include "host-sim/surface/path/region/tool_heights.hpp"

namespace sim::surface {

/// A place at which a tool touches a surface on both sides of a valley.
struct CreasePlace {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  bool is_wall = false;  ///< Whether the heights jump there, at the foot of a vertical wall.
};

/// A place, and the height and rise of the tool's tip there.
struct ToolPose {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double height = cnc::surface::kNoContact;
  Eigen::Vector2d rise = Eigen::Vector2d::Zero();

  [[nodiscard]] bool is_over() const { return height != cnc::surface::kNoContact; }
};

/// Finds where a line in plan crosses a valley that a tool does not fit into. The heights of the
/// tip have a crease there, because the point of contact jumps from one side to the other.
class CreaseFinder {
 public:
  /// @param heights heights of the tip; they outlive this object
  /// @param angle_rad minimum angle between the normals of both sides
  CreaseFinder(const ToolHeights& heights, double angle_rad)
      : heights_{&heights}, angle_rad_{angle_rad} {}

  [[nodiscard]] ToolPose pose_at(const Eigen::Vector2d& place) const;

  /// Returns where the line between two poses crosses a crease, within 1e-4 mm. At a wall the
  /// result lies on the low side. Returns one crossing if there are several; nothing if the normals
  /// at both ends differ by less than half the angle and the heights do not jump.
  [[nodiscard]] std::optional<CreasePlace> between(const ToolPose& from, const ToolPose& to) const;

 private:
  [[nodiscard]] std::optional<CreasePlace> foot_between(ToolPose low, ToolPose high) const;
  [[nodiscard]] std::optional<CreasePlace> bottom_between(ToolPose from, ToolPose to) const;

  const ToolHeights* heights_;
  double angle_rad_;
};

}  // namespace sim::surface
