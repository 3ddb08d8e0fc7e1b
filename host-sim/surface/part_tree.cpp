#include "host-sim/surface/part_tree.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace sim::surface {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// Mean slope of a part's facets above which the part's plane is horizontal, at the height of its
/// highest point.
constexpr double kSteepest = 20.0;
/// Distance from a ball's axis, relative to its radius, beyond which its tangent is almost
/// vertical.
constexpr double kAlmost = 0.99;
/// Slope of a ball's tangent at kAlmost.
constexpr double kSteepestOfABall = 7.1;
/// Upper bound of the relative error of differences and products of a few coordinates in single
/// precision.
constexpr double kRounding = 1.0e-6;
/// Number that is added to a square before its root is computed. The root is a divisor and must not
/// be zero.
constexpr float kTiny = 1.0e-20F;
/// Distance, relative to a corner's radius, that is inside the corner despite rounding to single
/// precision.
constexpr float kInside = 0.999F;

using Four = PartTree::Four;

Four all(float value) { return Four{value, value, value, value}; }
Four greater(const Four& a, const Four& b) { return a < b ? b : a; }
Four lesser(const Four& a, const Four& b) { return b < a ? b : a; }
Four root(const Four& square) {
  return Four{
      std::sqrt(square[0]), std::sqrt(square[1]), std::sqrt(square[2]), std::sqrt(square[3])};
}

/// A plane that touches the tool's lower surface at a distance from the axis and is nowhere above
/// this surface. `height` is the plane's height at this distance. `share` is the plane's slope
/// divided by the distance.
struct Tangent {
  Four height;
  Four share;
};

Tangent tangent_at(const PartTree::Shape& tool, const Four& distance) {
  const Four out = greater(lesser(distance, all(tool.almost)) - tool.flat, all(0.0F));
  const Four beyond = greater(distance - tool.flat - out, all(0.0F));
  if (tool.corner <= 0.0F) {
    const Four rise = out > 0.0F ? all(tool.rise) : all(0.0F);
    return {rise * (out + beyond), rise / distance};
  }
  const Four inner = lesser(out, all(kInside * tool.corner));
  const Four across = root((tool.corner - inner) * (tool.corner + inner));
  const Four rise = inner / across;
  return {inner * inner / (tool.corner + across) + rise * beyond, rise / distance};
}

/// Returns an upper bound of the tip's height for each of four parts. The tool is convex, so it is
/// nowhere below a tangent plane. The difference between the part's plane and the tangent plane is
/// linear. Its maximum over the part's rectangle is thus a bound. The tangent plane is at the point
/// of the tool that touches the part's plane. If this point is outside the rectangle, the tangent
/// plane is at the nearest point of the rectangle.
Four bounds_of(const PartTree::Shape& tool,
               const PartTree::Node& node,
               std::size_t four,
               float place_x,
               float place_y) {
  const Four min_x = node.min_x.fours[four] - place_x;
  const Four min_y = node.min_y.fours[four] - place_y;
  const Four max_x = node.max_x.fours[four] - place_x;
  const Four max_y = node.max_y.fours[four] - place_y;
  const Four near_x = greater(greater(min_x, -max_x), all(0.0F));
  const Four near_y = greater(greater(min_y, -max_y), all(0.0F));
  const Four x = lesser(greater(node.point_x.fours[four], min_x), max_x);
  const Four y = lesser(greater(node.point_y.fours[four], min_y), max_y);
  const Tangent tangent = tangent_at(tool, root(x * x + y * y + kTiny));
  const Four slope_x = node.slope_x.fours[four];
  const Four slope_y = node.slope_y.fours[four];
  const Four left_x = slope_x - x * tangent.share;
  const Four left_y = slope_y - y * tangent.share;
  const Four ahead = greater(left_x * (max_x - x), left_x * (min_x - x)) +
                     greater(left_y * (max_y - y), left_y * (min_y - y));
  const Four off_x = x - 0.5F * (min_x + max_x);
  const Four off_y = y - 0.5F * (min_y + max_y);
  const Four plane = node.level.fours[four] + slope_x * off_x + slope_y * off_y;
  const Four bound = lesser(node.top.fours[four], plane - tangent.height + ahead);
  return near_x * near_x + near_y * near_y <= tool.reach_square ? bound : all(-kInfinity);
}

}  // namespace

class PartTree::Builder {
 public:
  Builder(const Mesh& mesh, const cnc::surface::Profile& profile, PartTree& tree)
      : mesh_{mesh}, profile_{profile}, tree_{tree} {
    double farthest = profile.radius_mm;
    for (const Eigen::Vector3d& point : mesh.points) {
      farthest = std::max(farthest, point.cwiseAbs().maxCoeff());
    }
    lost_mm_ = kRounding * farthest;
  }

  void build() {
    const auto count = static_cast<std::uint32_t>(mesh_.facets.size());
    tree_.order_.resize(count);
    std::iota(tree_.order_.begin(), tree_.order_.end(), 0U);
    take_normals();
    std::vector<Open> open{{0, {0, count}}};
    tree_.nodes_.emplace_back();
    while (!open.empty()) {
      const Open next = open.back();
      open.pop_back();
      fill(next, open);
    }
    const double reach = profile_.radius_mm + lost_mm_;
    tree_.tool_.reach_square = static_cast<float>(reach * reach);
    tree_.tool_.almost = static_cast<float>(kAlmost * profile_.radius_mm);
    tree_.tool_.flat = static_cast<float>(profile_.flat_mm);
    tree_.tool_.corner = static_cast<float>(profile_.corner_mm);
    tree_.tool_.rise = static_cast<float>(profile_.rise);
  }

 private:
  /// A node whose parts are not built yet, and its facets.
  struct Open {
    std::uint32_t node;
    Run run;
  };

  [[nodiscard]] std::array<Eigen::Vector3d, 3> corners_of(std::uint32_t facet) const {
    const auto& [a, b, c] = mesh_.facets[facet];
    return {mesh_.points[a], mesh_.points[b], mesh_.points[c]};
  }

  void take_normals() {
    for (std::uint32_t facet = 0; facet < mesh_.facets.size(); ++facet) {
      const auto [a, b, c] = corners_of(facet);
      const Eigen::Vector3d normal = (b - a).cross(c - a);
      normals_.push_back(normal.z() < 0.0 ? Eigen::Vector3d{-normal} : normal);
      middles_.emplace_back((a + b + c).head<2>());
    }
  }

  void fill(const Open& open, std::vector<Open>& later) {
    std::array<Run, kParts> parts{open.run};
    for (std::size_t many = 1; many < kParts; many *= 2) {
      for (std::size_t i = many; i-- > 0;) {
        const auto [lower, upper] = halves_of(parts[i]);
        parts[2 * i] = lower;
        parts[2 * i + 1] = upper;
      }
    }
    for (std::size_t i = 0; i < kParts; ++i) {
      const bool is_leaf = parts[i].count <= kMaxInALeaf;
      const auto number = static_cast<std::uint32_t>(tree_.nodes_.size());
      Node& node = tree_.nodes_[open.node];
      node.first[i] = is_leaf ? parts[i].first : number;
      node.count[i] = is_leaf ? parts[i].count : 0;
      bound(node, i, parts[i]);
      if (is_leaf) continue;
      later.push_back({number, parts[i]});
      tree_.nodes_.emplace_back();
    }
  }

  /// Halves a run at the median of its longer side in plan: sorts the facets below the median
  /// before the facets above it.
  std::array<Run, 2> halves_of(const Run& run) {
    Eigen::Array2d least = Eigen::Array2d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Array2d most = -least;
    for (const std::uint32_t facet : facets_of(run)) {
      least = least.min(middles_[facet].array());
      most = most.max(middles_[facet].array());
    }
    const Eigen::Index axis = (most - least).x() < (most - least).y() ? 1 : 0;
    const std::uint32_t half = (run.count + 1) / 2;
    const auto begin = tree_.order_.begin() + run.first;
    std::nth_element(
        begin, begin + half, begin + run.count, [&](std::uint32_t one, std::uint32_t other) {
          return middles_[one][axis] < middles_[other][axis];
        });
    return {Run{run.first, half}, Run{run.first + half, run.count - half}};
  }

  [[nodiscard]] std::span<const std::uint32_t> facets_of(const Run& run) const {
    return std::span{tree_.order_}.subspan(run.first, run.count);
  }

  /// Sets the bounds of a part. The normal of the part's plane is the mean normal of its facets,
  /// weighted by area.
  void bound(Node& node, std::size_t lane, const Run& run) const {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    Eigen::Vector3d least = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity());
    Eigen::Vector3d most = -least;
    for (const std::uint32_t facet : facets_of(run)) {
      normal += normals_[facet];
      for (const Eigen::Vector3d& corner : corners_of(facet)) {
        least = least.cwiseMin(corner);
        most = most.cwiseMax(corner);
      }
    }
    Eigen::Vector2d gradient = -normal.head<2>() / normal.z();
    if (!(gradient.norm() < kSteepest)) gradient.setZero();
    const double slope = gradient.norm();
    const double out = contact_with_plane(profile_, slope).out;
    const Eigen::Vector2d middle = 0.5 * (least + most).head<2>();
    double level = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t facet : facets_of(run)) {
      for (const Eigen::Vector3d& corner : corners_of(facet)) {
        level = std::max(level, corner.z() - gradient.dot(corner.head<2>() - middle));
      }
    }
    // The error of single precision grows with the slopes of the part and of the tool.
    const double steepness = slope + std::max(profile_.rise, kSteepestOfABall);
    set(node, lane, least, most, lost_mm_);
    node.top.set(lane, static_cast<float>(most.z() + lost_mm_));
    node.slope_x.set(lane, static_cast<float>(gradient.x()));
    node.slope_y.set(lane, static_cast<float>(gradient.y()));
    node.level.set(lane, static_cast<float>(level + lost_mm_ * (2.0 + steepness)));
    node.point_x.set(lane, slope > 0.0 ? static_cast<float>(gradient.x() * out / slope) : 0.0F);
    node.point_y.set(lane, slope > 0.0 ? static_cast<float>(gradient.y() * out / slope) : 0.0F);
  }

  static void set(Node& node,
                  std::size_t lane,
                  const Eigen::Vector3d& least,
                  const Eigen::Vector3d& most,
                  double more) {
    node.min_x.set(lane, static_cast<float>(least.x() - more));
    node.min_y.set(lane, static_cast<float>(least.y() - more));
    node.max_x.set(lane, static_cast<float>(most.x() + more));
    node.max_y.set(lane, static_cast<float>(most.y() + more));
  }

  const Mesh& mesh_;
  const cnc::surface::Profile& profile_;
  PartTree& tree_;
  double lost_mm_ = 0.0;
  /// Normals of the facets; the length of a normal is twice the facet's area.
  std::vector<Eigen::Vector3d> normals_;
  std::vector<Eigen::Vector2d> middles_;  ///< Three times the centre of each facet.
};

PartTree::PartTree(const Mesh& mesh, const cnc::surface::Profile& profile) {
  Builder{mesh, profile, *this}.build();
}

PartTree::Lanes PartTree::bounds(const Node& node, const Eigen::Vector2d& place) const {
  const auto x = static_cast<float>(place.x());
  const auto y = static_cast<float>(place.y());
  Lanes found{};
  for (std::size_t i = 0; i < found.fours.size(); ++i) {
    found.fours[i] = bounds_of(tool_, node, i, x, y);
  }
  return found;
}

}  // namespace sim::surface
