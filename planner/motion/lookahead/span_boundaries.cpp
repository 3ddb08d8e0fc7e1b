#include "planner/motion/lookahead/span_boundaries.hpp"

#include <algorithm>

namespace cnc::motion {

void SpanBoundaries::cut_at_zones(const BlockZones& head, const BlockZones& tail) {
  edges_.add(head, tail, length_);
  edges_.number(arc_, grid_);
  count_ = grid_.count() + edges_.count();
}

float SpanBoundaries::distance(int boundary) const {
  if (boundary <= 0) return 0.0F;
  if (boundary >= count_) return length_;
  const int before = edges_.before(boundary);
  if (edges_.is_boundary(before, boundary)) return edges_.distance(before);
  return grid_.distance(arc_, boundary - before);
}

float SpanBoundaries::angle(int boundary) const {
  const int before = edges_.before(boundary);
  if (edges_.is_boundary(before, boundary)) return arc_.angle_at(edges_.distance(before));
  return grid_.angle(arc_, boundary - before);
}

Place SpanBoundaries::place(int boundary) const {
  if (!arc_.turns()) return {};
  const int before = edges_.before(boundary);
  if (edges_.is_boundary(before, boundary)) return arc_.place_at(edges_.distance(before));
  return grid_.place(arc_, boundary - before);
}

float SpanBoundaries::angle_before(int span, float reach) const {
  return std::max(arc_.start_angle(), angle(span) - reach);
}

float SpanBoundaries::angle_behind(int span, float reach) const {
  return std::min(arc_.end_angle(), angle(span + 1) + reach);
}

}  // namespace cnc::motion
