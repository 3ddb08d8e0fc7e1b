#include "host-sim/stock/swept_surface.hpp"

namespace sim::stock {
namespace {

/// Tolerance, mm, within which a distance from the axis counts as exactly at a kink or the rim of
/// the profile.
constexpr double kOnIt = 1.0e-9;

}  // namespace

SweptSurface::SweptSurface(const Profile& profile,
                           const Pose& from,
                           const Pose& to,
                           double ceiling_mm)
    : profile_{profile}, from_x_{from.x_mm}, from_y_{from.y_mm}, z_{from.z_mm} {
  const double dx = to.x_mm - from.x_mm;
  const double dy = to.y_mm - from.y_mm;
  length_ = std::sqrt(dx * dx + dy * dy);
  if (length_ > 0.0) {
    along_x_ = dx / length_;
    along_y_ = dy / length_;
    climb_ = (to.z_mm - from.z_mm) / length_;
  } else {
    plunges_ = to.z_mm < from.z_mm;
    z_ = std::min(from.z_mm, to.z_mm);
  }
  is_level_ = climb_ == 0.0;
  const double lowest_pose = z_ + std::min(0.0, climb_ * length_);
  if (profile_.radius_mm > 0.0) radius_ = radius_below(profile_, ceiling_mm - lowest_pose);
  if (is_empty()) return;
  const bool falls = climb_ < 0.0;
  low_ = falls ? to : from;
  high_ = falls ? from : to;
  if (length_ == 0.0) low_.z_mm = high_.z_mm = z_;
  up_x_ = falls ? -along_x_ : along_x_;
  up_y_ = falls ? -along_y_ : along_y_;
  lead_ = kind_of_lead();
  max_lead_ = bound_of_lead();
  if (lead_ == Lead::kTable) fill_table();
}

SweptSurface::Lead SweptSurface::kind_of_lead() const {
  if (is_level_) return Lead::kNone;
  if (profile_.corner_mm > 0.0) return profile_.flat_mm == 0.0 ? Lead::kBall : Lead::kTable;
  return profile_.rise > 0.0 ? Lead::kCone : Lead::kEdge;
}

void SweptSurface::fill_table() {
  // At the rim, reach and lead are both 0, so their ratio is computed just inside the rim.
  constexpr double kRim = 1.0 - 1.0e-6;
  for (std::size_t i = 0; i < kNodes; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(kNodes - 1);
    const double side = radius_ * std::min(share, kRim);
    shares_[i] = solved_lead(side) / std::sqrt((radius_ - side) * (radius_ + side));
  }
}

/// Computes an upper bound of the lead u. The lead satisfies h'(r) u / r = |climb|, where h' is the
/// profile's rise at the distance r from the axis. With u = q r, 0 < q <= 1, the profile rises at r
/// by |climb| / q. In a rounded corner, this holds at r = flat + corner |climb| / sqrt(q² +
/// climb²), so u <= flat + corner |climb| / sqrt(1 + climb²). In a cone, it holds only for q =
/// |climb| / rise and at the cone's kink.
double SweptSurface::bound_of_lead() const {
  if (is_level_) return 0.0;
  const double steepness = std::abs(climb_);
  const double flat = std::max(0.0, profile_.flat_mm);
  double most = radius_;
  if (profile_.corner_mm > 0.0) {
    most = flat + profile_.corner_mm * steepness / std::sqrt(1.0 + steepness * steepness);
  } else if (steepness < profile_.rise) {
    most = std::max(flat, radius_ * steepness / profile_.rise);
  }
  // kOnIt covers the rounding of the formulas, so that the bound always holds.
  return std::min(radius_, most) + kOnIt;
}

/// Returns the lead u >= 0 at which the profile's rise along the path equals the path's climb:
/// h'(r) u / r = |climb| with r² = side² + u². Finds it by bisection. Returns the reach if there is
/// no solution.
double SweptSurface::solved_lead(double side) const {
  constexpr int kHalvings = 40;
  const double steepness = std::abs(climb_);
  double low = 0.0;
  double high = std::sqrt((radius_ - side) * (radius_ + side));
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    const double distance = std::sqrt(side * side + middle * middle);
    (rise_at(profile_, distance) * middle < steepness * distance ? low : high) = middle;
  }
  return high;
}

double SweptSurface::cone_lead(double side, double reach) const {
  const double steepness = std::abs(climb_);
  const double flat = profile_.flat_mm;
  const double edge = side < flat ? std::sqrt((flat - side) * (flat + side)) : 0.0;
  if (edge > 0.0 && profile_.rise * edge >= steepness * flat) return edge;
  if (steepness >= profile_.rise) return reach;
  return steepness * side / std::sqrt((profile_.rise - steepness) * (profile_.rise + steepness));
}

double SweptSurface::lead(double side, double reach) const {
  double size = 0.0;
  switch (lead_) {
    case Lead::kNone:
      return 0.0;
    case Lead::kEdge:
      size = reach;
      break;
    case Lead::kBall: {
      const double across = profile_.corner_mm * profile_.corner_mm - side * side;
      size = std::abs(climb_) * std::sqrt(std::max(0.0, across) / (1.0 + climb_ * climb_));
      break;
    }
    case Lead::kCone:
      size = cone_lead(side, reach);
      break;
    case Lead::kTable: {
      const double place = side / radius_ * static_cast<double>(kNodes - 1);
      const auto node = std::min(static_cast<std::size_t>(place), kNodes - 2);
      const double rest = place - static_cast<double>(node);
      size = reach * (shares_[node] + rest * (shares_[node + 1] - shares_[node]));
      break;
    }
  }
  return climb_ > 0.0 ? -size : size;
}

double SweptSurface::height_of_path(double x, double y) const {
  const auto [along, across] = place_of(x, y);
  const double side = std::abs(across);
  const double reach_squared = (radius_ - side) * (radius_ + side);
  if (side > radius_) return kNowhere;
  double pose = std::clamp(along, 0.0, length_);
  if (!is_level_) {
    const double reach = std::sqrt(reach_squared);
    const double first = std::max(0.0, along - reach);
    const double last = std::min(length_, along + reach);
    if (first > last) return kNowhere;
    pose = std::clamp(along + lead(side, reach), first, last);
  } else if ((along - pose) * (along - pose) > reach_squared) {
    return kNowhere;
  }
  const double ahead = along - pose;
  const double height =
      z_ + climb_ * pose + height_at(profile_, std::sqrt(ahead * ahead + across * across));
  // The next stretch omits the points that its first pose sweeps lowest. Its first pose is the last
  // pose of the present stretch, so that the height of this pose is included here.
  const Pose& end = falls() ? low_ : high_;
  return std::min(height, height_of_pose(end, x - end.x_mm, y - end.y_mm));
}

/// Returns the outward rise of the profile at `distance` that is nearest to the rise that balances
/// the climb. At a kink and at the rim, the profile has a range of rises; elsewhere it has one.
double SweptSurface::slope_for(double distance, double ahead) const {
  const double least = rise_at(profile_, distance);
  double most = least;
  if (profile_.rise > 0.0 && std::abs(distance - profile_.flat_mm) <= kOnIt) most = profile_.rise;
  if (distance >= radius_ - kOnIt) most = kNowhere;
  const double balanced = ahead == 0.0 ? 0.0 : climb_ * distance / ahead;
  return std::max(least, std::min(balanced, most));
}

/// Returns a lower bound of the height over a rectangle around `place`. It is the height at `place`
/// for the best known pose, minus the greatest fall of the tangent plane. The tangent plane is
/// taken over point and pose together, within the rectangle and the poses from `first` to `last`.
double SweptSurface::tangent_bound(
    const Place& place, double half_x, double half_y, double first, double last) const {
  const double side = std::abs(place.across);
  if (side > radius_) return -kNowhere;
  const double reach = std::sqrt((radius_ - side) * (radius_ + side));
  const double low = std::max(0.0, place.along - reach);
  const double high = std::min(length_, place.along + reach);
  if (low > high) return -kNowhere;
  const double pose = std::clamp(place.along + lead(side, reach), low, high);
  const double ahead = place.along - pose;
  const double distance = std::sqrt(ahead * ahead + side * side);
  const double value = z_ + climb_ * pose + height_at(profile_, distance);
  if (distance == 0.0) {
    return value - std::max(climb_ * (pose - first), climb_ * (pose - last));
  }
  const double slope = slope_for(distance, ahead);
  const double rest = climb_ - slope * ahead / distance;
  const double falls = slope * support(ahead / distance, place.across / distance, half_x, half_y) +
                       std::max(rest * (pose - first), rest * (pose - last));
  return falls < kNowhere ? value - falls : -kNowhere;
}

double SweptSurface::min_of_path(
    double x, double y, double half_x, double half_y, double enough_mm) const {
  const Place place = place_of(x, y);
  const double ahead = place.along - std::clamp(place.along, 0.0, length_);
  const double distance = std::sqrt(ahead * ahead + place.across * place.across);
  double nearest = 0.0;
  if (distance > 0.0) {
    const double half = support(ahead / distance, place.across / distance, half_x, half_y);
    nearest = std::max(0.0, distance - half);
  }
  if (nearest > radius_) return kNowhere;
  const double profile_height = height_at(profile_, nearest);
  if (is_level_) return z_ + profile_height;
  const double half_along = support(1.0, 0.0, half_x, half_y);
  const double side = std::max(0.0, std::abs(place.across) - support(0.0, 1.0, half_x, half_y));
  if (side > radius_) return kNowhere;
  const double reach = std::sqrt((radius_ - side) * (radius_ + side)) + half_along;
  const double first = std::max(0.0, place.along - reach);
  const double last = std::min(length_, place.along + reach);
  if (first > last) return kNowhere;
  const double coarse = z_ + std::min(climb_ * first, climb_ * last) + profile_height;
  if (coarse >= enough_mm) return coarse;
  return std::max(coarse, tangent_bound(place, half_x, half_y, first, last));
}

std::optional<Interval> SweptSurface::extent_at(double y, double extra_mm) const {
  const double radius = radius_ + extra_mm;
  Interval extent{kNowhere, -kNowhere};
  const auto include = [&extent](double x) {
    extent.low = std::min(extent.low, x);
    extent.high = std::max(extent.high, x);
  };
  for (const double pose : {0.0, length_}) {
    const double off = y - (from_y_ + pose * along_y_);
    if (std::abs(off) > radius) continue;
    const double half = std::sqrt((radius - off) * (radius + off));
    include(from_x_ + pose * along_x_ - half);
    include(from_x_ + pose * along_x_ + half);
  }
  for (const double side : {-radius, radius}) {
    // Includes the crossing of the sweep's straight side with the line at `y`. For a path along X,
    // there is no crossing, and none is required.
    const double rise = y - (from_y_ + side * along_x_);
    if (rise * along_y_ < 0.0 || std::abs(rise) > length_ * std::abs(along_y_)) continue;
    if (along_y_ == 0.0) continue;
    include(from_x_ - side * along_y_ + rise / along_y_ * along_x_);
  }
  if (extent.low > extent.high) return std::nullopt;
  return extent;
}

Interval SweptSurface::ahead_of_start(Interval extent, double y, double extra_mm) const {
  const double rear = extra_mm + (falls() ? max_lead_ : 0.0);
  // Least permitted value of (x − from_x_) · along_x_.
  const double needed = -rear - (y - from_y_) * along_y_;
  if (along_x_ > 0.0) extent.low = std::max(extent.low, from_x_ + needed / along_x_);
  if (along_x_ < 0.0) extent.high = std::min(extent.high, from_x_ + needed / along_x_);
  if (along_x_ == 0.0 && needed > 0.0) extent.high = -kNowhere;
  return extent;
}

}  // namespace sim::stock
