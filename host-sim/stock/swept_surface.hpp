#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "host-sim/stock/cutter.hpp"

namespace sim::stock {

/// Position of a tool's tip, machine coordinates, mm.
struct Pose {
  double x_mm = 0.0;
  double y_mm = 0.0;
  double z_mm = 0.0;
};

struct Interval {
  double low;
  double high;
};

/// The lower surface of the space that a tool occupies on a straight path from one pose to another.
///
/// The height over a point of the plan is the minimum, over all poses that reach the point, of the
/// pose's height plus the profile's height. Both heights are convex, and so is their sum as a
/// function of point and pose together. Therefore the minimum is convex, too, over the complete
/// plan of the sweep. An inexact pose can only increase the computed height, and the derivative at
/// that pose bounds the error.
class SweptSurface {
 public:
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();

  /// @param ceiling_mm height above which the surface is omitted
  SweptSurface(const Profile& profile, const Pose& from, const Pose& to, double ceiling_mm);

  [[nodiscard]] bool is_empty() const { return radius_ <= 0.0; }
  [[nodiscard]] double radius_mm() const { return radius_; }
  /// Returns the lowest height of the surface.
  [[nodiscard]] double lowest_mm() const {
    return profile_.tip_mm + z_ + std::min(0.0, climb_ * length_);
  }
  /// Returns whether the surface is flat: the height is lowest_mm() at every point.
  [[nodiscard]] bool is_plane() const {
    return is_level_ && profile_.radius_mm <= profile_.flat_mm;
  }
  /// Returns whether the path is inclined and leads downwards.
  [[nodiscard]] bool falls() const { return climb_ < 0.0; }
  /// Returns whether the first pose sweeps the points that ahead_of_start() removes at least as low
  /// as every later pose.
  [[nodiscard]] bool has_old_rear() const { return !plunges_; }

  /// Returns the lowest and the highest Y of the sweep's plan.
  [[nodiscard]] Interval extent_along_y() const {
    const double to_y = from_y_ + length_ * along_y_;
    return {std::min(from_y_, to_y) - radius_, std::max(from_y_, to_y) + radius_};
  }
  /// Returns the range of X in which the line at `y` is within the sweep's plan, widened by
  /// `extra_mm`.
  [[nodiscard]] std::optional<Interval> extent_at(double y, double extra_mm) const;
  /// Removes points behind the start from an extent at `y`. A removed point is more than `extra_mm`
  /// behind the start. It is also more than `extra_mm` behind all points that a later pose sweeps
  /// lower than the first pose. The result may be empty.
  [[nodiscard]] Interval ahead_of_start(Interval extent, double y, double extra_mm) const;

  /// Returns the height over a point; kNowhere outside of the plan. The table of poses may make the
  /// height slightly too great, but never greater than the height of the last pose there.
  [[nodiscard]] double height(double x, double y) const {
    const Pose* const sole = sole_pose(x, y, 0.0);
    return sole != nullptr ? height_of_pose(*sole, x - sole->x_mm, y - sole->y_mm)
                           : height_of_path(x, y);
  }

  /// Returns a lower bound of the height over an upright rectangle with half sides `half_x` and
  /// `half_y` around a point; kNowhere if the sweep surely does not touch the rectangle. If a
  /// coarse bound reaches `enough_mm`, it is returned without refinement.
  [[nodiscard]] double min_over(
      double x, double y, double half_x, double half_y, double enough_mm) const {
    const Pose* const sole = sole_pose(x, y, half_x + half_y);
    if (sole == nullptr) return min_of_path(x, y, half_x, half_y, enough_mm);
    const double nearest_x = std::max(0.0, std::abs(x - sole->x_mm) - half_x);
    const double nearest_y = std::max(0.0, std::abs(y - sole->y_mm) - half_y);
    return height_of_pose(*sole, nearest_x, nearest_y);
  }

 private:
  enum class Lead : std::uint8_t { kNone, kEdge, kBall, kCone, kTable };
  static constexpr std::size_t kNodes = 65;

  struct Place {
    double along;   ///< Distance from the start along the path, mm.
    double across;  ///< Distance to the left of the path, mm.
  };
  [[nodiscard]] Place place_of(double x, double y) const {
    const double rx = x - from_x_;
    const double ry = y - from_y_;
    return {rx * along_x_ + ry * along_y_, ry * along_x_ - rx * along_y_};
  }

  [[nodiscard]] Lead kind_of_lead() const;
  void fill_table();
  [[nodiscard]] double bound_of_lead() const;
  /// Returns the pose at an end of the path if it alone determines the heights around (x, y). This
  /// is the case if no other pose sweeps a point within `margin_mm` of (x, y) lower. It is also the
  /// case for the lower end if this pose sweeps (x, y) with the flat of the tool, because no point
  /// is swept lower. Returns null if other poses may determine the heights.
  [[nodiscard]] const Pose* sole_pose(double x, double y, double margin_mm) const {
    const double rx = x - low_.x_mm;
    const double ry = y - low_.y_mm;
    const double up_path = rx * up_x_ + ry * up_y_;
    if (up_path <= -margin_mm) return &low_;
    if (up_path >= length_ + max_lead_ + margin_mm) return &high_;
    const double flat = std::max(0.0, profile_.flat_mm);
    return rx * rx + ry * ry <= flat * flat ? &low_ : nullptr;
  }
  /// Returns the height of the tool's surface at one pose, over a point at an offset from the
  /// tool's axis.
  [[nodiscard]] double height_of_pose(const Pose& pose, double off_x, double off_y) const {
    const double square = off_x * off_x + off_y * off_y;
    if (square > radius_ * radius_) return kNowhere;
    return pose.z_mm + height_at(profile_, std::sqrt(square));
  }
  [[nodiscard]] double height_of_path(double x, double y) const;
  [[nodiscard]] double min_of_path(
      double x, double y, double half_x, double half_y, double enough_mm) const;
  [[nodiscard]] double solved_lead(double side) const;
  /// Returns the lead of a point. This is the distance along the path, taken as endless, from the
  /// point's foot on the path to the pose that sweeps the point lowest.
  /// @param side distance of the point from the path
  /// @param reach distance along the path from the foot to the farthest poses that reach the point
  [[nodiscard]] double lead(double side, double reach) const;
  [[nodiscard]] double cone_lead(double side, double reach) const;
  [[nodiscard]] double tangent_bound(
      const Place& place, double half_x, double half_y, double first, double last) const;
  [[nodiscard]] double support(double along, double across, double half_x, double half_y) const {
    return half_x * std::abs(along * along_x_ - across * along_y_) +
           half_y * std::abs(along * along_y_ + across * along_x_);
  }
  [[nodiscard]] double slope_for(double distance, double ahead) const;

  Profile profile_;
  double radius_ = 0.0;  ///< Radius of the tool's part below the ceiling.
  double from_x_;
  double from_y_;
  double z_;              ///< Height of the start; if the path is vertical, of the lower end.
  double along_x_ = 1.0;  ///< X of the path's unit direction in plan.
  double along_y_ = 0.0;
  double length_ = 0.0;  ///< Length of the path in plan.
  double climb_ = 0.0;   ///< Rise of the path per mm of `length_`.
  bool is_level_ = true;
  bool plunges_ = false;  ///< Whether the path is vertical and leads downwards.
  Pose low_;              ///< Pose at the lower end of the path; for a level path, the start.
  Pose high_;             ///< Pose at the other end of the path.
  double up_x_ = 1.0;     ///< X of the unit direction in plan from the lower end to the other end.
  double up_y_ = 0.0;
  Lead lead_ = Lead::kNone;
  double max_lead_ = 0.0;  ///< Upper bound of the lead for all values of `side`.
  /// Table of the ratio of lead to reach, at equal steps of `side`.
  std::array<double, kNodes> shares_{};
};

}  // namespace sim::stock
