#include "host-sim/surface/patch/surface_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

/// Maximum number of Gauss-Newton steps. Each step multiplies the error by about the ratio of the
/// distance to the radius of curvature. If the steps do not converge, divisions of the patch find
/// the foot.
constexpr int kMaxFootSteps = 12;
/// Maximum number of successive divisions of a patch in four. The parts are then as small as the
/// rounding error of their points.
constexpr int kMaxDivisions = 24;

Eigen::AlignedBox3d box_of(const BezierPatch& patch) {
  Eigen::AlignedBox3d box;
  for (const BezierCurve& row : patch.rows) {
    for (const Vector3d& control : row.controls) box.extend(control);
  }
  return box;
}

/// Returns a step of u and v towards the foot. A parameter at its limit is not changed if the step
/// would leave the patch. If both derivatives have the same direction, only the parameter with the
/// greater derivative is changed.
Eigen::Vector2d step_to_foot(const PatchJet& jet, const Vector3d& away, double u, double v) {
  const double uu = jet.along_u.squaredNorm();
  const double uv = jet.along_u.dot(jet.along_v);
  const double vv = jet.along_v.squaredNorm();
  const double du = jet.along_u.dot(away);
  const double dv = jet.along_v.dot(away);
  const bool u_is_held = (u == 0.0 && du < 0.0) || (u == 1.0 && du > 0.0) || uu == 0.0;
  const bool v_is_held = (v == 0.0 && dv < 0.0) || (v == 1.0 && dv > 0.0) || vv == 0.0;
  if (u_is_held && v_is_held) return {0.0, 0.0};
  const double determinant = uu * vv - uv * uv;
  const bool is_singular = determinant <= 1.0e-12 * uu * vv;
  if (u_is_held || (is_singular && !v_is_held && vv > uu)) return {0.0, dv / vv};
  if (v_is_held || is_singular) return {du / uu, 0.0};
  return {(du * vv - dv * uv) / determinant, (dv * uu - du * uv) / determinant};
}

/// Returns a lower bound of the distance between the point and the patch. It is the least distance
/// of the patch's control points from the plane through `point` that is perpendicular to the line
/// from `foot` to `point`.
double min_distance(const BezierPatch& patch, const Vector3d& point, const Vector3d& foot) {
  const Vector3d away = point - foot;
  const double length = away.norm();
  if (length == 0.0) return 0.0;
  double least = std::numeric_limits<double>::infinity();
  for (const BezierCurve& row : patch.rows) {
    for (const Vector3d& control : row.controls) least = std::min(least, away.dot(point - control));
  }
  return least / length;
}

}  // namespace

double move_to_foot(const BezierPatch& patch, const Vector3d& point, double& u, double& v) {
  PatchJet jet = patch.jet(u, v);
  double distance = (point - jet.point).norm();
  for (int step = 0; step < kMaxFootSteps; ++step) {
    const Eigen::Vector2d move = step_to_foot(jet, point - jet.point, u, v);
    const double next_u = std::clamp(u + move.x(), 0.0, 1.0);
    const double next_v = std::clamp(v + move.y(), 0.0, 1.0);
    if (next_u == u && next_v == v) break;
    const PatchJet next = patch.jet(next_u, next_v);
    const double next_distance = (point - next.point).norm();
    if (!(next_distance < distance)) break;
    const bool is_settled = distance - next_distance < 1.0e-3 * kDistanceErrorMm;
    jet = next;
    u = next_u;
    v = next_v;
    distance = next_distance;
    if (is_settled) break;
  }
  return distance;
}

/// A part of a patch that is still to be searched.
struct SurfaceDistance::Part {
  BezierPatch shape;
  Interval u;
  Interval v;
  int divisions = 0;
  double least = 0.0;  ///< Lower bound of the distance between the searched point and the part, mm.

  [[nodiscard]] Part quarter(bool far_u, bool far_v) const {
    const auto half = [](Interval whole, bool far) {
      const double middle = 0.5 * (whole.from + whole.to);
      return far ? Interval{middle, whole.to} : Interval{whole.from, middle};
    };
    return {shape.part(half({}, far_u), half({}, far_v)),
            half(u, far_u),
            half(v, far_v),
            divisions + 1,
            least};
  }
  /// Orders a heap so that the part with the smallest lower bound comes first.
  bool operator<(const Part& other) const { return least > other.least; }
};

struct SurfaceDistance::Search {
  Vector3d point = Vector3d::Zero();
  SurfacePoint best;
  /// Distance at which the search stops, because a nearer point is not needed.
  double enough = 0.0;
  double too_far = 0.0;  ///< Distance above which points are ignored.
  /// Heap of the parts of the current patch that are still to be searched.
  std::vector<Part> open{};

  [[nodiscard]] bool is_over() const { return best.distance_mm <= enough; }
  [[nodiscard]] double bound() const {
    return is_over() ? -1.0 : std::min(too_far, best.distance_mm - kDistanceErrorMm);
  }

  /// Searches for the foot of the perpendicular on a part, beginning at the part's parameters `u`
  /// and `v`. Stores the foot in `best` if it is the nearest foot so far. Returns the foot.
  Vector3d try_foot(std::uint32_t patch, const Part& part, double u, double v) {
    const double distance = move_to_foot(part.shape, point, u, v);
    if (distance < best.distance_mm) {
      best = {patch,
              part.u.from + u * (part.u.to - part.u.from),
              part.v.from + v * (part.v.to - part.v.from),
              distance};
    }
    return part.shape.at(u, v);
  }

  /// Adds a part to the heap unless it cannot contain a nearer point.
  void add(std::uint32_t patch, Part part) {
    part.least = std::max(part.least, std::sqrt(box_of(part.shape).squaredExteriorDistance(point)));
    if (part.least > bound()) return;
    const Vector3d foot = try_foot(patch, part, 0.5, 0.5);
    part.least = std::max(part.least, min_distance(part.shape, point, foot));
    if (part.least > bound() || part.divisions == kMaxDivisions) return;
    open.push_back(part);
    std::push_heap(open.begin(), open.end());
  }
};

SurfaceDistance::SurfaceDistance(const PatchSurface& surface) : surface_{&surface} {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(surface.patches.size());
  for (const GridPatch& patch : surface.patches) boxes.push_back(box_of(patch.shape));
  tree_ = BoxTree{boxes};
}

void SurfaceDistance::search_patch(std::uint32_t number, Search& search) const {
  search.open.clear();
  search.add(number, {surface_->patches[number].shape, {}, {}, 0, 0.0});
  while (!search.open.empty()) {
    std::pop_heap(search.open.begin(), search.open.end());
    const Part part = search.open.back();
    search.open.pop_back();
    // The lower bound of each remaining part is at least part.least, so that no part contains a
    // nearer point.
    if (part.least > search.bound()) return;
    for (const bool far_u : {false, true}) {
      for (const bool far_v : {false, true}) search.add(number, part.quarter(far_u, far_v));
    }
  }
}

void SurfaceDistance::search(Search& search) const {
  const auto bound = [&search] { return search.bound(); };
  // A good first distance excludes patches that are farther away, so that they need no exact
  // search.
  tree_.visit_near(search.point, bound, [&](std::uint32_t number) {
    const Part whole{surface_->patches[number].shape, {}, {}, 0, 0.0};
    for (const double u : {0.1, 0.5, 0.9}) {
      for (const double v : {0.1, 0.5, 0.9}) search.try_foot(number, whole, u, v);
    }
  });
  tree_.visit_near(
      search.point, bound, [&](std::uint32_t number) { search_patch(number, search); });
}

SurfacePoint SurfaceDistance::nearest(const Vector3d& point, const SurfacePoint& near) const {
  Search begun{.point = point,
               .best = near,
               .enough = kDistanceErrorMm,
               .too_far = std::numeric_limits<double>::infinity()};
  SurfacePoint& best = begun.best;
  best.distance_mm = move_to_foot(surface_->patches[near.patch].shape, point, best.u, best.v);
  search(begun);
  return best;
}

SurfacePoint SurfaceDistance::nearest(const Vector3d& point) const {
  return nearest(point, SurfacePoint{});
}

bool SurfaceDistance::is_within(const Vector3d& point,
                                double tolerance_mm,
                                const SurfacePoint& near) const {
  const BezierPatch& patch = surface_->patches[near.patch].shape;
  Search begun{.point = point, .best = near, .enough = tolerance_mm, .too_far = tolerance_mm};
  SurfacePoint& best = begun.best;
  best.distance_mm = (point - patch.at(best.u, best.v)).norm();
  if (begun.is_over()) return true;
  best.distance_mm = move_to_foot(patch, point, best.u, best.v);
  if (begun.is_over()) return true;
  search(begun);
  return begun.is_over();
}

}  // namespace sim::surface::patch
