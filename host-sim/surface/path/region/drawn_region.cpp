#include "host-sim/surface/path/region/drawn_region.hpp"

#include <algorithm>

#include "planner/contour/meeting.hpp"

namespace sim::surface {
namespace {

using Curve = cnc::contour::Curve<double>;

/// Distance, mm, up to which two crossings count as one crossing; also half the width of a
/// boundary.
constexpr double kOneCrossingMm = 1.0e-6;

/// Returns the line of a slice from `begin` to `end`, extended by 1 mm at both ends.
Curve line_of(const Slice& slice, double begin, double end) {
  Curve line;
  line.start = slice.at(begin - 1.0);
  line.end = slice.at(end + 1.0);
  line.start_tangent = slice.direction;
  line.end_tangent = slice.direction;
  return line;
}

/// Returns a slightly larger box, so that a search also finds an element that a line only touches.
cnc::contour::FlatBox<double> widened(const cnc::contour::FlatBox<double>& box) {
  constexpr double kMore = 10.0 * kOneCrossingMm;
  return {box.x0 - kMore, box.y0 - kMore, box.x1 + kMore, box.y1 + kMore};
}

void add_parts_in(const pocket::OwnedArea& area,
                  const Slice& slice,
                  const std::pair<double, double>& whole,
                  SliceParts& parts) {
  const Curve line = line_of(slice, whole.first, whole.second);
  std::vector<double> crossings{whole.first, whole.second};
  // Points up to kOneCrossingMm outside the area count as inside. So the line is also divided where
  // it passes an element at such a small distance without an intersection.
  area->search(widened(line.box()), [&](const Curve& curve) {
    const auto found = cnc::contour::meetings_of(curve, line, 2.0 * kOneCrossingMm);
    for (std::uint32_t i = 0; i < found.count; ++i) {
      const double along = slice.direction.dot(found.places[i] - slice.from);
      if (along > whole.first && along < whole.second) crossings.push_back(along);
    }
    return true;
  });
  std::ranges::sort(crossings);
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const double begin = crossings[i - 1];
    const double end = crossings[i];
    if (end - begin <= kOneCrossingMm) continue;
    if (area->depth(slice.at(0.5 * (begin + end))) >= -kOneCrossingMm)
      parts.emplace_back(begin, end);
  }
}

}  // namespace

DrawnRegion::DrawnRegion(const std::vector<Contour>& areas) {
  for (const Contour& area : areas) {
    auto owned = std::make_unique<const pocket::OwnedArea>(area.view());
    if ((*owned)->element_count() > 0) areas_.push_back(std::move(owned));
  }
}

SliceParts DrawnRegion::parts_of(const Slice& slice, double begin, double end) const {
  SliceParts parts;
  for (const auto& area : areas_) add_parts_in(*area, slice, {begin, end}, parts);
  join_parts(parts, kOneCrossingMm);
  return parts;
}

}  // namespace sim::surface
