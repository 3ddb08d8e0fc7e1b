#include "host-sim/plot/path_simplifier.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim {
namespace {

template <typename Vector>
double cross(const Vector& a, const Vector& b) {
  return a.x * b.y - a.y * b.x;
}

double distance_mm(const PathVertex& a, const PathVertex& b) {
  return std::hypot(b.x_mm - a.x_mm, b.y_mm - a.y_mm);
}

}  // namespace

void PathSimplifier::push(const PathVertex& point) {
  if (vertices_.empty()) return make_vertex(point);
  if (is_stretch_open_ && !continues_stretch(point)) make_vertex(last_);
  const bool keeps_speed = is_stretch_open_ && is_driven_alike(point);
  const float stretch_speed_mm_s = keeps_speed ? last_.speed_mm_s : point.speed_mm_s;
  narrow_sector(point);
  last_ = point;
  last_.speed_mm_s = stretch_speed_mm_s;
  is_stretch_open_ = true;
}

std::vector<PathVertex> PathSimplifier::finish() {
  if (is_stretch_open_) make_vertex(last_);
  return std::exchange(vertices_, {});
}

void PathSimplifier::thin_to(std::size_t most) {
  while (vertices_.size() > most) {
    tolerance_.distance_mm *= 2.0;
    PathSimplifier coarser{tolerance_};
    for (const PathVertex& vertex : finish()) coarser.push(vertex);
    *this = std::move(coarser);
  }
}

bool PathSimplifier::continues_stretch(const PathVertex& point) const {
  const PathVertex& start = vertices_.back();
  const double distance = distance_mm(start, point);
  if (reach_mm_ > half_width_mm() && !is_driven_alike(point)) return false;
  if (distance < reach_mm_ - half_width_mm()) return false;  // The path has turned back.
  if (!has_sector_ || distance <= half_width_mm()) return true;
  return is_in_sector({(point.x_mm - start.x_mm) / distance, (point.y_mm - start.y_mm) / distance});
}

bool PathSimplifier::is_driven_alike(const PathVertex& point) const {
  return point.move == last_.move &&
         std::abs(point.speed_mm_s - last_.speed_mm_s) <= tolerance_.speed_mm_s;
}

bool PathSimplifier::is_in_sector(Direction direction) const {
  return cross(right_bound_, direction) >= 0.0 && cross(direction, left_bound_) >= 0.0;
}

// Narrows the sector to the directions that pass near `point`. Ignores points very near the last
// vertex, so that the sector is at most a quarter turn wide. Cross products alone can then decide
// whether a direction is inside the sector.
void PathSimplifier::narrow_sector(const PathVertex& point) {
  const PathVertex& start = vertices_.back();
  const double distance = distance_mm(start, point);
  reach_mm_ = std::max(reach_mm_, distance);
  if (distance < std::sqrt(2.0) * half_width_mm() || distance == 0.0) return;
  const Direction ahead{(point.x_mm - start.x_mm) / distance, (point.y_mm - start.y_mm) / distance};
  const double sine = half_width_mm() / distance;
  const double cosine = std::sqrt(1.0 - sine * sine);
  const Direction left{ahead.x * cosine - ahead.y * sine, ahead.y * cosine + ahead.x * sine};
  const Direction right{ahead.x * cosine + ahead.y * sine, ahead.y * cosine - ahead.x * sine};
  if (!has_sector_ || cross(left, left_bound_) > 0.0) left_bound_ = left;
  if (!has_sector_ || cross(right_bound_, right) > 0.0) right_bound_ = right;
  has_sector_ = true;
}

void PathSimplifier::make_vertex(const PathVertex& point) {
  vertices_.push_back(point);
  is_stretch_open_ = false;
  has_sector_ = false;
  reach_mm_ = 0.0;
}

std::vector<PathVertex> simplified(const std::vector<PathVertex>& vertices,
                                   const PathTolerance& tolerance) {
  PathSimplifier simplifier{tolerance};
  for (const PathVertex& vertex : vertices) simplifier.push(vertex);
  return simplifier.finish();
}

}  // namespace sim
