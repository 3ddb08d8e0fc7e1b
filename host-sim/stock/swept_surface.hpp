#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "host-sim/stock/cutter.hpp"

namespace sim::stock {

/// Where the tip of a tool is, machine coordinates, mm.
struct Pose {
  double x_mm = 0.0;
  double y_mm = 0.0;
  double z_mm = 0.0;
};

struct Interval {
  double low;
  double high;
};

/// The lower surface of the space that a tool takes on its way straight from one pose to another.
///
/// Over a point of the plan it is the least, over all poses that reach the point, of the height of
/// the pose plus that of the profile. Both are convex, and so are their sum over point and pose
/// together and this least: the surface is convex over the whole plan of the sweep. A pose that is
/// not quite the best one only makes the height greater, and the derivative there bounds by how
/// much.
class SweptSurface {
 public:
  static constexpr double kNowhere = std::numeric_limits<double>::infinity();

  /// @param ceiling_mm the surface above this height is left out
  SweptSurface(const Profile& profile, const Pose& from, const Pose& to, double ceiling_mm);

  [[nodiscard]] bool is_empty() const { return radius_ <= 0.0; }
  [[nodiscard]] double radius_mm() const { return radius_; }
  /// The least height of the whole surface.
  [[nodiscard]] double lowest_mm() const {
    return profile_.tip_mm + z_ + std::min(0.0, climb_ * length_);
  }
  /// Flat all over: the height is lowest_mm() at every point.
  [[nodiscard]] bool is_plane() const {
    return is_level_ && profile_.radius_mm <= profile_.flat_mm;
  }
  /// Whether the path is inclined and goes downwards.
  [[nodiscard]] bool falls() const { return climb_ < 0.0; }
  /// Whether all points that ahead_of_start() leaves out are swept lowest by the first pose.
  [[nodiscard]] bool has_old_rear() const { return !plunges_; }

  /// The least and the greatest Y of the sweep's plan.
  [[nodiscard]] Interval extent_along_y() const {
    const double to_y = from_y_ + length_ * along_y_;
    return {std::min(from_y_, to_y) - radius_, std::max(from_y_, to_y) + radius_};
  }
  /// The part of the line at `y` that is in the sweep's plan, widened by `extra_mm`.
  [[nodiscard]] std::optional<Interval> extent_at(double y, double extra_mm) const;
  /// Leaves the part of an extent at `y` that is no more than `extra_mm` behind the start and the
  /// points that later poses sweep lower than the first, or none.
  [[nodiscard]] Interval ahead_of_start(Interval extent, double y, double extra_mm) const;

  /// The height over a point; kNowhere outside of the plan. A table of poses may have made it
  /// greater by a small part, but never greater than the height at the last pose.
  [[nodiscard]] double height(double x, double y) const {
    const Pose* const sole = sole_pose(x, y, 0.0);
    return sole != nullptr ? height_of_pose(*sole, x - sole->x_mm, y - sole->y_mm)
                           : height_of_path(x, y);
  }

  /// A lower bound of the height over an upright rectangle with half sides `half_x` and `half_y`
  /// round a point; kNowhere if the sweep surely does not touch it. A bound that is at least
  /// `enough_mm` need not be the greatest that is known.
  [[nodiscard]] double least_over(
      double x, double y, double half_x, double half_y, double enough_mm) const {
    const Pose* const sole = sole_pose(x, y, half_x + half_y);
    if (sole == nullptr) return least_of_path(x, y, half_x, half_y, enough_mm);
    const double nearest_x = std::max(0.0, std::abs(x - sole->x_mm) - half_x);
    const double nearest_y = std::max(0.0, std::abs(y - sole->y_mm) - half_y);
    return height_of_pose(*sole, nearest_x, nearest_y);
  }

 private:
  enum class Lead : std::uint8_t { kNone, kEdge, kBall, kCone, kTable };
  static constexpr std::size_t kNodes = 65;

  struct Place {
    double along;   ///< From the start along the path.
    double across;  ///< To the left of it.
  };
  [[nodiscard]] Place place_of(double x, double y) const {
    const double rx = x - from_x_;
    const double ry = y - from_y_;
    return {rx * along_x_ + ry * along_y_, ry * along_x_ - rx * along_y_};
  }

  [[nodiscard]] Lead kind_of_lead() const;
  void fill_table();
  [[nodiscard]] double bound_of_lead() const;
  /// Returns the end of the path that sweeps each point lowest that is within `margin_mm` of (x, y)
  /// and swept at all, or that sweeps (x, y) with the flat of the tool, lower than which no point
  /// is swept. Null where other poses may count.
  [[nodiscard]] const Pose* sole_pose(double x, double y, double margin_mm) const {
    const double rx = x - low_.x_mm;
    const double ry = y - low_.y_mm;
    const double up_path = rx * up_x_ + ry * up_y_;
    if (up_path <= -margin_mm) return &low_;
    if (up_path >= length_ + most_lead_ + margin_mm) return &high_;
    const double flat = std::max(0.0, profile_.flat_mm);
    return rx * rx + ry * ry <= flat * flat ? &low_ : nullptr;
  }
  /// The height of the tool at one pose, over a point off its axis.
  [[nodiscard]] double height_of_pose(const Pose& pose, double off_x, double off_y) const {
    const double square = off_x * off_x + off_y * off_y;
    if (square > radius_ * radius_) return kNowhere;
    return pose.z_mm + height_at(profile_, std::sqrt(square));
  }
  [[nodiscard]] double height_of_path(double x, double y) const;
  [[nodiscard]] double least_of_path(
      double x, double y, double half_x, double half_y, double enough_mm) const;
  [[nodiscard]] double solved_lead(double side) const;
  /// From the foot of a point on the path to the pose that sweeps it lowest, on an endless path.
  /// `side` is the point's distance from the path, `reach` that of the last poses from its foot.
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
  double radius_ = 0.0;  ///< Of the part below the ceiling.
  double from_x_;
  double from_y_;
  double z_;              ///< Of the start; the lowest end where the path is upright.
  double along_x_ = 1.0;  ///< Direction of the path in the plan.
  double along_y_ = 0.0;
  double length_ = 0.0;  ///< In the plan.
  double climb_ = 0.0;   ///< Height per mm of it.
  bool is_level_ = true;
  bool plunges_ = false;  ///< Straight down.
  Pose low_;              ///< The lower end of the path; of a level one, the start.
  Pose high_;             ///< The other.
  double up_x_ = 1.0;     ///< Direction of the path in the plan from the lower end on.
  double up_y_ = 0.0;
  Lead lead_ = Lead::kNone;
  double most_lead_ = 0.0;               ///< None is greater, whatever the side.
  std::array<double, kNodes> shares_{};  ///< Of lead in reach, over the side in equal steps.
};

}  // namespace sim::stock
