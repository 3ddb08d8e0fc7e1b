#pragma once

#include <Eigen/Core>
#include <optional>

#include "host-sim/surface/path/region/tool_heights.hpp"

namespace sim::surface {

/// A point of a crease. At this point, a tool touches the surface on both sides of a valley.
struct CreasePlace {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  /// Whether the point is at the foot of a vertical wall, where the heights jump.
  bool is_wall = false;
};

/// A point in plan, and the height and rise of the tool's tip there.
struct ToolPose {
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  double height = cnc::surface::kNoContact;
  Eigen::Vector2d rise = Eigen::Vector2d::Zero();

  [[nodiscard]] bool is_over() const { return height != cnc::surface::kNoContact; }
};

/// Finds the point where a line in plan crosses a valley that is too narrow for a tool. The heights
/// of the tip have a crease there, because the contact jumps from one side of the valley to the
/// other.
class CreaseFinder {
 public:
  /// @param heights heights of the tip; they outlive this object
  /// @param angle_rad minimum angle between the normals of the two sides
  CreaseFinder(const ToolHeights& heights, double angle_rad)
      : heights_{&heights}, angle_rad_{angle_rad} {}

  [[nodiscard]] ToolPose pose_at(const Eigen::Vector2d& place) const;

  /// Returns the point where the line between two poses crosses a crease, within 1e-4 mm. At a
  /// wall, the point is on the low side. Of several crossings, one is returned. Returns nothing if
  /// the heights do not jump and the normals at the ends differ by less than half of the minimum
  /// angle.
  [[nodiscard]] std::optional<CreasePlace> between(const ToolPose& from, const ToolPose& to) const;

 private:
  [[nodiscard]] std::optional<CreasePlace> foot_between(ToolPose low, ToolPose high) const;
  [[nodiscard]] std::optional<CreasePlace> bottom_between(ToolPose from, ToolPose to) const;

  const ToolHeights* heights_;
  double angle_rad_;
};

}  // namespace sim::surface
