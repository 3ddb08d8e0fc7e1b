#include "host-sim/pocket/scan_line.hpp"

#include <algorithm>
#include <limits>

#include "planner/contour/meeting.hpp"

namespace sim::pocket {
namespace {

using cnc::WideVec2;
using Curve = cnc::contour::Curve<double>;
using cnc::contour::FlatBox;

/// Distance below which two crossings count as one, mm.
constexpr double kOneCrossingMm = 1.0e-9;

Curve line_through(const FlatBox<double>& box, double y) {
  Curve line;
  line.start = {box.x0 - 1.0, y};
  line.end = {box.x1 + 1.0, y};
  return line;
}

}  // namespace

FlatBox<double> box_of(const OwnedArea& area) {
  FlatBox<double> box = area->element(0).box();
  for (std::uint32_t i = 1; i < area->element_count(); ++i) box.include(area->element(i).box());
  return box;
}

std::vector<Stretch> stretches_at(const OwnedArea& area, double y) {
  constexpr double kFar = std::numeric_limits<double>::max();
  std::vector<double> crossings;
  area->search({-kFar, y, kFar, y}, [&](const Curve& curve) {
    const auto found =
        cnc::contour::meetings_of(curve, line_through(curve.box(), y), kOneCrossingMm);
    for (std::uint32_t i = 0; i < found.count; ++i) crossings.push_back(found.places[i].x());
    return true;
  });
  std::ranges::sort(crossings);
  std::vector<Stretch> stretches;
  for (std::size_t i = 1; i < crossings.size(); ++i) {
    const Stretch next{crossings[i - 1], crossings[i]};
    if (next.to_x - next.from_x <= kOneCrossingMm) continue;
    if (area->depth({0.5 * (next.from_x + next.to_x), y}) <= 0.0) continue;
    const bool goes_on =
        !stretches.empty() && next.from_x - stretches.back().to_x <= kOneCrossingMm;
    if (goes_on) {
      stretches.back().to_x = next.to_x;
    } else {
      stretches.push_back(next);
    }
  }
  return stretches;
}

}  // namespace sim::pocket
