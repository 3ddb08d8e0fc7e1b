#include "host-sim/surface/path/region/rest_region.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "planner/surface/grown.hpp"

namespace sim::surface {
namespace {

using cnc::surface::Profile;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// Maximum rise of the surface, mm per mm, for which a search continues.
constexpr double kSteepestSearch = 6.0;
/// Position of the larger tool's rim, relative to its radius. It is slightly inside the radius
/// because of rounding.
constexpr double kAlmostRim = 1.0 - 1.0e-9;

/// Returns the tool, grown so that it leaves at least the allowance everywhere, even if the tool is
/// a cone.
cnc::surface::GrownTool leaving(const Profile& tool, double allowance_mm) {
  if (allowance_mm == 0.0) return {.profile = tool};
  const double band = cnc::surface::grown(tool, allowance_mm).band_mm;
  return cnc::surface::grown(tool, allowance_mm * allowance_mm / band);
}

Vector2d direction_of(int index, int count) {
  const double angle = 2.0 * std::numbers::pi * index / count;
  return {std::cos(angle), std::sin(angle)};
}

/// Returns the height of the lower surface of the reduced tool above the tool's tip, at
/// `distance_mm` from the axis. The reduced tool is smaller than the tool by `depth_mm` on all
/// sides. At each distance from the axis, its surface is the highest point whose distance from the
/// tool's lower surface is at most `depth_mm`.
double inner_height(const Profile& tool, double distance_mm, double depth_mm) {
  constexpr int kSteps = 32;
  double height = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / kSteps - 0.5);
    const double at = std::abs(distance_mm + depth_mm * std::sin(angle));
    if (at > tool.radius_mm) continue;
    height = std::max(height, height_at(tool, at) + depth_mm * std::cos(angle));
  }
  return height;
}

/// Pitch of the raster, relative to the larger tool's radius.
constexpr double kRasterShare = 1.0 / 32.0;
/// Number of steps in the table of clearances, see clearance_at().
constexpr int kClearances = 256;

/// Returns the distance between the axes for an index of the table of clearances, as a share of the
/// reach. The steps decrease linearly to 0 towards the end.
double share_at(int index) {
  const double rest = 1.0 - static_cast<double>(index) / kClearances;
  return 1.0 - rest * rest;
}

/// Returns the least height of the tool's tip above the larger tool's tip at which the reduced tool
/// does not cut deeper than the larger tool. `distance` is the distance between the tools' axes.
/// The height is a convex function of this distance.
double clearance_at(const Profile& tool, const Profile& larger, double depth_mm, double distance) {
  constexpr int kSteps = 256;
  const double rim = std::max(0.0, tool.radius_mm - depth_mm);
  double clearance = -std::numeric_limits<double>::infinity();
  for (int i = 0; i <= kSteps; ++i) {
    const double out = rim * i / kSteps;
    const double at = std::min(distance + out, larger.radius_mm);
    clearance = std::max(clearance, height_at(larger, at) - inner_height(tool, out, depth_mm));
  }
  return clearance;
}

}  // namespace

RestRegion::RestRegion(const Mesh& mesh, const Profile& tool, const RestOptions& options)
    : SampledRegion{tool.radius_mm},
      heights_{mesh, leaving(tool, options.allowance_mm).profile, options.floor_mm},
      larger_heights_{
          mesh, leaving(options.larger, options.larger_allowance_mm).profile, options.floor_mm},
      tool_{tool},
      larger_{options.larger},
      lift_mm_{leaving(tool, options.allowance_mm).lift_mm},
      larger_lift_mm_{leaving(options.larger, options.larger_allowance_mm).lift_mm},
      raster_{
          larger_heights_, mesh, options.larger.radius_mm, kRasterShare * options.larger.radius_mm},
      reach_mm_{options.larger.radius_mm - std::max(0.0, tool.radius_mm - options.depth_mm)} {
  constexpr int kDirections = 12;
  const double rim = std::max(0.0, tool.radius_mm - options.depth_mm);
  points_.push_back({Vector2d::Zero(), inner_height(tool, 0.0, options.depth_mm)});
  for (const double share : {1.0, 0.67, 0.33}) {
    for (int i = 0; i < kDirections; ++i) {
      const double out = share * rim;
      points_.push_back(
          {out * direction_of(i, kDirections), inner_height(tool, out, options.depth_mm)});
    }
  }
  for (int i = 0; i <= kClearances; ++i) {
    clearances_.push_back(clearance_at(tool, larger_, options.depth_mm, reach_mm_ * share_at(i)));
  }
}

/// Returns whether the tool at `place` reaches rest stock. Checks the points of the reduced tool,
/// beginning with the point of index `memory`, at which the last call found stock.
bool RestRegion::holds(const Vector2d& place, std::size_t& memory) const {
  const std::optional<Vector2d> rise = heights_.rise(place);
  if (!rise) return false;
  const double tip = heights_(place) + lift_mm_;
  if (is_taken_at_once({place.x(), place.y(), tip}, *rise)) return false;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const std::size_t index = (memory + i) % points_.size();
    const ToolPoint& point = points_[index];
    const Vector2d at = place + point.out;
    if (is_taken({at.x(), at.y(), tip + point.height}, point.out, *rise)) continue;
    memory = index;
    return true;
  }
  return false;
}

/// Returns whether one position of the larger tool removes everything that the reduced tool
/// removes. Tries the position at which both tools touch the same plane with the slope `rise`, and
/// the best position of the raster.
bool RestRegion::is_taken_at_once(const Vector3d& tip, const Vector2d& rise) const {
  const Vector2d axis = tip.head<2>();
  const double slope = rise.norm();
  Vector2d place = axis;
  if (slope > 0.0) {
    const double apart =
        contact_with_plane(larger_, slope).out - contact_with_plane(tool_, slope).out;
    place -= std::clamp(apart, -reach_mm_, reach_mm_) / slope * rise;
  }
  if (is_all_taken(tip, place)) return true;
  const auto cost = [this](double distance, double height) { return height + clearance(distance); };
  return is_all_taken(tip, raster_.best(axis, reach_mm_, cost));
}

bool RestRegion::is_all_taken(const Vector3d& tip, const Vector2d& place) const {
  const double height = larger_heights_(place);
  return height != cnc::surface::kNoContact &&
         height + larger_lift_mm_ + clearance((place - tip.head<2>()).norm()) <= tip.z();
}

/// Returns a clearance, interpolated between the steps of the table. The exact clearance is a
/// convex function of the distance, so that it never exceeds the result.
double RestRegion::clearance(double distance_mm) const {
  const double distance = std::min(distance_mm, reach_mm_);
  const double index = kClearances * (1.0 - std::sqrt(1.0 - distance / reach_mm_));
  const auto before = std::min(static_cast<std::size_t>(index), clearances_.size() - 2);
  const double share = index - static_cast<double>(before);
  return clearances_[before] + share * (clearances_[before + 1] - clearances_[before]);
}

/// Returns the height, mm, of the stock that the larger tool, at `place`, leaves above a point.
double RestRegion::excess(const Vector3d& point, const Vector2d& place) const {
  const double distance = (place - point.head<2>()).norm();
  const double tip = larger_heights_(place);
  if (distance > larger_.radius_mm || tip == cnc::surface::kNoContact) {
    return std::numeric_limits<double>::infinity();
  }
  return tip + larger_lift_mm_ + height_at(larger_, distance) - point.z();
}

bool RestRegion::is_taken(const Vector3d& point, const Vector2d& out, const Vector2d& rise) const {
  const Vector2d at = point.head<2>();
  const double slope = rise.norm();
  Vector2d guess = at;
  if (slope > 0.0) guess -= contact_with_plane(larger_, slope).out * kAlmostRim / slope * rise;
  if (excess(point, guess) <= 0.0) return true;
  if (const double beside = out.norm(); beside > 0.0) {
    for (const double share : {kAlmostRim, 0.75, 0.5}) {
      if (excess(point, at - share * larger_.radius_mm / beside * out) <= 0.0) return true;
    }
  }
  return is_taken_by_search(point);
}

/// Searches for a position at which the larger tool removes the stock at a point. The search begins
/// at the best point of the raster and uses decreasing steps.
bool RestRegion::is_taken_by_search(const Vector3d& point) const {
  constexpr int kHalvings = 4;
  constexpr int kDirections = 8;
  const Vector2d at = point.head<2>();
  Vector2d best =
      raster_.best(at, kAlmostRim * larger_.radius_mm, [this](double distance, double height) {
        return height + height_at(larger_, distance);
      });
  double least = excess(point, best);
  double step = 0.5 * raster_.pitch_mm();
  for (int halving = 0; halving < kHalvings && least > 0.0; step *= 0.5, ++halving) {
    // On a surface of up to 80 degrees, a step reduces the excess by at most its length times
    // kSteepestSearch.
    if (least > kSteepestSearch * step) return false;
    const Vector2d middle = best;
    for (int i = 0; i < kDirections && least > 0.0; ++i) {
      const Vector2d place = middle + step * direction_of(i, kDirections);
      const double left = excess(point, place);
      if (left < least) {
        least = left;
        best = place;
      }
    }
  }
  return least <= 0.0;
}

}  // namespace sim::surface
