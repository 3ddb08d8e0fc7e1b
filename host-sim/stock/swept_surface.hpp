#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "host-sim/stock/cutter.hpp"

namespace sim::stock {

/// Position of the tip of a tool, machine coordinates, mm.
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
/// The height over a point of the plan is the least, over all poses that reach the point, of the
/// pose's height plus the profile's height. Both heights are convex, and so is their sum as a
/// function of point and pose together. Therefore the least is convex, too: the surface is convex
/// over the whole plan of the sweep. A pose that is not quite the best only makes the height
/// greater, and the derivative there bounds the error.
class SweptSurface {
 public:
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();

  /// @param ceiling_mm the part of the surface above this height is omitted
  SweptSurface(const Profile& profile, const Pose& from, const Pose& to, double ceiling_mm);

  [[nodiscard]] bool is_empty() const { return radius_ <= 0.0; }
  [[nodiscard]] double radius_mm() const { return radius_; }
  /// Returns the least height of the whole surface.
  [[nodiscard]] double lowest_mm() const {
    return profile_.tip_mm + z_ + std::min(0.0, climb_ * length_);
  }
  /// Returns whether the surface is flat: the height is lowest_mm() at every point.
  [[nodiscard]] bool is_plane() const {
    return is_level_ && profile_.radius_mm <= profile_.flat_mm;
  }
  /// Returns whether the path is inclined and leads downwards.
  [[nodiscard]] bool falls() const { return climb_ < 0.0; }
  /// Returns whether the first pose sweeps lowest all points that ahead_of_start() leaves out.
  [[nodiscard]] bool has_old_rear() const { return !plunges_; }

  /// Returns the least and the greatest Y of the sweep's plan.
  [[nodiscard]] Interval extent_along_y() const {
    const double to_y = from_y_ + length_ * along_y_;
    return {std::min(from_y_, to_y) - radius_, std::max(from_y_, to_y) + radius_};
  }
  /// Returns the part of the line at `y` that is in the sweep's plan, widened by `extra_mm`.
  [[nodiscard]] std::optional<Interval> extent_at(double y, double extra_mm) const;
  /// Removes points behind the start from an extent at `y`. It removes those that are more than
  /// `extra_mm` behind both the start and all points that later poses sweep lower than the first
  /// pose. The result may be empty.
  [[nodiscard]] Interval ahead_of_start(Interval extent, double y, double extra_mm) const;

  /// Returns the height over a point; kNowhere outside of the plan. A table of poses may make it
  /// slightly too great, but never greater than the height at the last pose.
  [[nodiscard]] double height(double x, double y) const {
    const Pose* const sole = sole_pose(x, y, 0.0);
    return sole != nullptr ? height_of_pose(*sole, x - sole->x_mm, y - sole->y_mm)
                           : height_of_path(x, y);
  }

  /// Returns a lower bound of the height over an upright rectangle with half sides `half_x` and
  /// `half_y` around a point; kNowhere if the sweep surely does not touch the rectangle. A bound of
  /// at least `enough_mm` need not be the best possible bound.
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
    double along;   ///< Distance from the start along the path.
    double across;  ///< Distance to the left of the path.
  };
  [[nodiscard]] Place place_of(double x, double y) const {
    const double rx = x - from_x_;
    const double ry = y - from_y_;
    return {rx * along_x_ + ry * along_y_, ry * along_x_ - rx * along_y_};
  }

  [[nodiscard]] Lead kind_of_lead() const;
  void fill_table();
  [[nodiscard]] double bound_of_lead() const;
  /// Returns an end of the path if the pose there decides alone for all points within `margin_mm`
  /// of (x, y) that are swept at all: it sweeps each of them lowest. Returns it also if this pose
  /// sweeps (x, y) with the flat of the tool: no point is swept lower. Returns null where other
  /// poses may matter.
  [[nodiscard]] const Pose* sole_pose(double x, double y, double margin_mm) const {
    const double rx = x - low_.x_mm;
    const double ry = y - low_.y_mm;
    const double up_path = rx * up_x_ + ry * up_y_;
    if (up_path <= -margin_mm) return &low_;
    if (up_path >= length_ + max_lead_ + margin_mm) return &high_;
    const double flat = std::max(0.0, profile_.flat_mm);
    return rx * rx + ry * ry <= flat * flat ? &low_ : nullptr;
  }
  /// Returns the height of the tool at one pose, over a point offset from the tool's axis.
  [[nodiscard]] double height_of_pose(const Pose& pose, double off_x, double off_y) const {
    const double square = off_x * off_x + off_y * off_y;
    if (square > radius_ * radius_) return kNowhere;
    return pose.z_mm + height_at(profile_, std::sqrt(square));
  }
  [[nodiscard]] double height_of_path(double x, double y) const;
  [[nodiscard]] double min_of_path(
      double x, double y, double half_x, double half_y, double enough_mm) const;
  [[nodiscard]] double solved_lead(double side) const;
  /// Returns the lead: the distance, on an endless path, from the foot of a point on the path to
  /// the pose that sweeps the point lowest.
  /// @param side distance of the point from the path
  /// @param reach distance from the foot to the last poses that reach the point
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
  double radius_ = 0.0;  ///< Radius of the part below the ceiling.
  double from_x_;
  double from_y_;
  double z_;              ///< Height of the start; of the lower end where the path is vertical.
  double along_x_ = 1.0;  ///< Direction of the path in the plan.
  double along_y_ = 0.0;
  double length_ = 0.0;  ///< Length in plan.
  double climb_ = 0.0;   ///< Height per mm of `length_`.
  bool is_level_ = true;
  bool plunges_ = false;  ///< Whether the path leads straight down.
  Pose low_;              ///< The lower end of the path; for a level path, the start.
  Pose high_;             ///< The other end of the path.
  double up_x_ = 1.0;     ///< Direction of the path in plan, from the lower end on.
  double up_y_ = 0.0;
  Lead lead_ = Lead::kNone;
  double max_lead_ = 0.0;                ///< Upper bound of the lead for all values of `side`.
  std::array<double, kNodes> shares_{};  ///< Ratio of lead to reach, at equal steps of `side`.
};

}  // namespace sim::stock
