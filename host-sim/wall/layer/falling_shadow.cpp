#include "host-sim/wall/layer/falling_shadow.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <stdexcept>

namespace sim::wall {
namespace {

namespace bp = boost::polygon;

using Eigen::Vector2d;
using Eigen::Vector3d;
using Point = WholePoint;
using Polygon = bp::polygon_data<int>;
using Holed = bp::polygon_with_holes_data<int>;
using PolygonSet = bp::polygon_set_data<int>;

/// Distance of a corner from the line between its neighbours, in steps of the grid, up to which the
/// corner is left out.
constexpr double kStraight = 2.0;
/// Slope from the vertical up to which a facet counts as upright. The slope is 1 µm in 200 mm,
/// which allows for the single precision of STL files.
constexpr double kUpright = 5.0e-6;
/// Maximum change of areas because of rounding to the grid, relative to the stock's area.
constexpr double kAreaError = 1.0e-6;

double cross(const Point& from, const Point& over, const Point& to) {
  const double ax = static_cast<double>(over.x()) - from.x();
  const double ay = static_cast<double>(over.y()) - from.y();
  const double bx = static_cast<double>(to.x()) - from.x();
  const double by = static_cast<double>(to.y()) - from.y();
  return ax * by - ay * bx;
}

double distance(const Point& from, const Point& to) {
  return std::hypot(static_cast<double>(to.x()) - from.x(), static_cast<double>(to.y()) - from.y());
}

/// Returns the corners of a loop without corners that only result from rounding to the grid.
std::vector<Point> corners_of(const auto& polygon) {
  std::vector<Point> all(polygon.begin(), polygon.end());
  if (all.size() > 1 && all.front() == all.back()) all.pop_back();
  std::vector<Point> corners;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Point& before = corners.empty() ? all.back() : corners.back();
    const Point& after = all[(i + 1) % all.size()];
    const double length = distance(before, after);
    const bool is_between = distance(before, all[i]) <= length && distance(all[i], after) <= length;
    if (is_between && std::abs(cross(before, all[i], after)) <= kStraight * length) continue;
    corners.push_back(all[i]);
  }
  return corners;
}

double area_of(const std::vector<Point>& corners) {
  double twice = 0.0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    twice += cross(corners.front(), corners[i - 1], corners[i]);
  }
  return 0.5 * twice;
}

void append_loop(const WholeGrid& grid, std::vector<Point> corners, bool is_hole, Contour& to) {
  if (corners.size() < 3) return;
  if ((area_of(corners) < 0.0) != is_hole) std::ranges::reverse(corners);
  for (const Point& corner : corners) {
    const Vector2d place = grid.place(corner);
    to.vertices.push_back({place.x(), place.y(), 0.0});
  }
  to.end_loop();
}

std::vector<Contour> areas_of(const WholeGrid& grid, const PolygonSet& set) {
  std::vector<Holed> polygons;
  set.get(polygons);
  std::vector<Contour> areas;
  for (const Holed& polygon : polygons) {
    Contour area;
    append_loop(grid, corners_of(polygon), false, area);
    if (area.loop_ends.empty()) continue;
    for (auto hole = polygon.begin_holes(); hole != polygon.end_holes(); ++hole) {
      append_loop(grid, corners_of(*hole), true, area);
    }
    areas.push_back(std::move(area));
  }
  return areas;
}

double area_in(const PolygonSet& set) { return static_cast<double>(bp::area(set)); }

/// Returns the union of several sets of polygons.
/// @param is_swapped whether X and Y are swapped during the computation
PolygonSet sum_of(std::initializer_list<const PolygonSet*> sets, bool is_swapped) {
  const bp::axis_transformation swap{bp::axis_transformation::SWAP_XY};
  PolygonSet sum;
  for (const PolygonSet* set : sets) sum.insert(*set);
  if (is_swapped) sum.transform(swap);
  sum.clean();
  if (is_swapped) sum.transform(swap);
  return sum;
}

/// Returns the part of `whole` that is not in `taken`.
/// @pre `taken` is clean
PolygonSet difference_of(const PolygonSet& whole, const PolygonSet& taken, bool is_swapped) {
  const bp::axis_transformation swap{bp::axis_transformation::SWAP_XY};
  PolygonSet left;
  left.insert(whole);
  left.insert(taken, true);
  if (is_swapped) left.transform(swap);
  left.clean();
  if (is_swapped) left.transform(swap);
  return left;
}

Polygon polygon_of(const std::vector<Point>& points) {
  Polygon polygon;
  bp::set_points(polygon, points.begin(), points.end());
  return polygon;
}

}  // namespace

FallingShadow::FallingShadow(const surface::Mesh& part, const Eigen::AlignedBox2d& stock)
    : part_{&part},
      grid_{stock},
      stock_{grid_.whole(stock.min()), grid_.whole(stock.max())},
      sweep_{part} {
  for (std::uint32_t i = 0; i < part.facets.size(); ++i) {
    const auto& [a, b, c] = part.facets[i];
    const Vector3d across =
        (part.points[b] - part.points[a]).cross(part.points[c] - part.points[a]);
    if (across.z() < -kUpright * across.norm()) overhanging_.push_back(i);
  }
  std::ranges::sort(
      overhanging_, std::greater{}, [this](std::uint32_t facet) { return top_of(facet); });
}

std::vector<Contour> FallingShadow::lower_to(double height_mm) {
  PolygonSet section;
  for (const SectionLoop& loop : sweep_.loops_at(height_mm)) insert(loop, section);
  pass_facets(height_mm);
  PolygonSet crossed;
  for (const std::uint32_t facet : open_) insert(part_above(facet, height_mm), crossed);
  PolygonSet stock;
  stock.insert(bp::rectangle_data<int>{
      stock_.first.x(), stock_.first.y(), stock_.second.x(), stock_.second.y()});
  const double stock_area = area_in(stock);
  // The polygon sweep of Boost may fail. If the areas show a failure, the sweep is repeated with X
  // and Y swapped.
  for (const bool is_swapped : {false, true}) {
    const PolygonSet cleaned = sum_of({&section}, is_swapped);
    // Without overhangs, the part above the plane is completely within the section.
    const PolygonSet shadow =
        passed_ == 0 ? cleaned : sum_of({&cleaned, &hidden_, &crossed}, is_swapped);
    const PolygonSet left = difference_of(stock, shadow, is_swapped);
    const double error = kAreaError * stock_area;
    const double shadow_area = area_in(shadow);
    const bool is_sound = shadow_area >= area_in(cleaned) - error &&
                          (passed_ == 0 || shadow_area >= shadow_area_ - error) &&
                          std::abs(area_in(left) + shadow_area - stock_area) <= error;
    if (!is_sound) continue;
    section_area_ = area_in(cleaned);
    shadow_area_ = shadow_area;
    return wall::areas_of(grid_, left);
  }
  throw std::invalid_argument(
      fmt::format("the part has no clean section at Z {:g}; move it up by a micrometre, or repair "
                  "the mesh where it crosses itself",
                  height_mm));
}

Undercut FallingShadow::undercut() const {
  Undercut found{.area_mm2 = (shadow_area_ - section_area_) * grid_.square_mm2()};
  double most = 0.0;
  for (std::size_t i = 0; i < passed_; ++i) {
    const auto& [a, b, c] = part_->facets[overhanging_[i]];
    const auto& points = part_->points;
    const double area = -(points[b] - points[a]).cross(points[c] - points[a]).z();
    if (area <= most) continue;
    most = area;
    found.place = (points[a] + points[b] + points[c]) / 3.0;
  }
  return found;
}

double FallingShadow::top_of(std::uint32_t facet) const {
  const auto& [a, b, c] = part_->facets[facet];
  const auto& points = part_->points;
  return std::max({points[a].z(), points[b].z(), points[c].z()});
}

/// Inserts the area inside a counter-clockwise loop into a set; inserts a clockwise loop as a hole.
void FallingShadow::insert(const SectionLoop& loop, PolygonSet& set) const {
  std::vector<Point> points;
  points.reserve(loop.size());
  for (const Vector2d& place : loop) points.push_back(grid_.whole(place));
  const double area = area_of(points);
  if (area != 0.0) set.insert(polygon_of(points), area < 0.0);
}

/// Moves the plane down to a height: adds the overhanging facets that reach above it to open_.
/// Moves facets that are completely above the height from open_ to hidden_, because they hide the
/// area below them at all lower heights. Neighbouring facets have common corners, so that their
/// areas leave no gaps.
void FallingShadow::pass_facets(double height_mm) {
  while (passed_ < overhanging_.size() && top_of(overhanging_[passed_]) > height_mm) {
    open_.push_back(overhanging_[passed_++]);
  }
  std::erase_if(open_, [&](std::uint32_t facet) {
    const bool is_above = std::ranges::all_of(part_->facets[facet], [&](std::uint32_t point) {
      return part_->points[point].z() > height_mm;
    });
    if (is_above) insert(part_above(facet, height_mm), hidden_);
    return is_above;
  });
  hidden_.clean();
}

/// Returns the part of a facet above a height, in plan, as a loop that is counter-clockwise as seen
/// from above.
SectionLoop FallingShadow::part_above(std::uint32_t facet, double height_mm) const {
  SectionLoop loop;
  const auto& corners = part_->facets[facet];
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector3d& here = part_->points[corners[i]];
    const Vector3d& next = part_->points[corners[(i + 1) % corners.size()]];
    if (here.z() > height_mm) loop.emplace_back(here.head<2>());
    if ((here.z() > height_mm) == (next.z() > height_mm)) continue;
    const double share = (height_mm - here.z()) / (next.z() - here.z());
    loop.emplace_back(here.head<2>() + share * (next - here).head<2>());
  }
  std::ranges::reverse(loop);
  return loop;
}

}  // namespace sim::wall
