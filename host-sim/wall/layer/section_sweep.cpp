#include "host-sim/wall/layer/section_sweep.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace sim::wall {
namespace {

constexpr std::uint64_t kHalf = 32U;

std::uint64_t edge_of(std::uint32_t p, std::uint32_t q) {
  return std::uint64_t{std::min(p, q)} << kHalf | std::max(p, q);
}

}  // namespace

SectionSweep::SectionSweep(const surface::Mesh& solid)
    : solid_{&solid}, by_top_(solid.facets.size()) {
  std::iota(by_top_.begin(), by_top_.end(), 0U);
  std::vector<double> tops(by_top_.size());
  for (const std::uint32_t facet : by_top_) tops[facet] = top_of(facet);
  std::ranges::sort(by_top_, [&tops](std::uint32_t one, std::uint32_t other) {
    return tops[one] == tops[other] ? one < other : tops[one] > tops[other];
  });
}

double SectionSweep::top_of(std::uint32_t facet) const {
  const auto& [a, b, c] = solid_->facets[facet];
  const auto& points = solid_->points;
  return std::max({points[a].z(), points[b].z(), points[c].z()});
}

double SectionSweep::bottom_of(std::uint32_t facet) const {
  const auto& [a, b, c] = solid_->facets[facet];
  const auto& points = solid_->points;
  return std::min({points[a].z(), points[b].z(), points[c].z()});
}

/// Updates crossed_ for a height: adds the facets that reach above the height, and removes the
/// facets that are completely above it.
void SectionSweep::advance(double height_mm) {
  while (next_ < by_top_.size() && top_of(by_top_[next_]) > height_mm) {
    crossed_.push_back(by_top_[next_++]);
  }
  std::erase_if(crossed_, [&](std::uint32_t facet) { return bottom_of(facet) > height_mm; });
}

/// Returns the segment in which a plane cuts a facet. The facet has points above `height_mm` and
/// points that are not above it. The segment begins on the edge at which the facet's border
/// descends through the plane.
SectionSweep::Segment SectionSweep::segment_of(std::uint32_t facet, double height_mm) const {
  const auto& corners = solid_->facets[facet];
  Segment segment;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t here = corners[i];
    const std::uint32_t next = corners[(i + 1) % corners.size()];
    const bool is_above = solid_->points[here].z() > height_mm;
    if (is_above == (solid_->points[next].z() > height_mm)) continue;
    (is_above ? segment.from : segment.to) = edge_of(here, next);
  }
  return segment;
}

Eigen::Vector2d SectionSweep::crossing_of(std::uint64_t edge, double height_mm) const {
  const Eigen::Vector3d& one = solid_->points[edge >> kHalf];
  const Eigen::Vector3d& other = solid_->points[edge & 0xFFFFFFFFU];
  const double share = (height_mm - one.z()) / (other.z() - one.z());
  return one.head<2>() + share * (other - one).head<2>();
}

std::vector<SectionLoop> SectionSweep::loops_at(double height_mm) {
  advance(height_mm);
  std::vector<Segment> segments;
  segments.reserve(crossed_.size());
  for (const std::uint32_t facet : crossed_) segments.push_back(segment_of(facet, height_mm));
  std::ranges::sort(segments, {}, &Segment::from);
  std::vector<SectionLoop> loops;
  for (Segment& first : segments) {
    SectionLoop loop;
    for (Segment* segment = &first; !segment->is_taken;) {
      segment->is_taken = true;
      loop.push_back(crossing_of(segment->from, height_mm));
      // If more than two facets share an edge, several segments begin on this edge, and the same
      // number of segments end on it. Any free segment continues the loop.
      const auto next =
          std::ranges::find_if(std::ranges::lower_bound(segments, segment->to, {}, &Segment::from),
                               segments.end(),
                               [](const Segment& other) { return !other.is_taken; });
      if (next == segments.end() || next->from != segment->to) break;
      segment = &*next;
    }
    if (!loop.empty()) loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace sim::wall
