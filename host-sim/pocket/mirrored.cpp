#include "host-sim/pocket/mirrored.hpp"

namespace sim::pocket {

/// Reverses each loop, so that its material stays on the left. Mirroring and reversing each change
/// the sign of a bulge, so bulges keep their signs.
Contour mirrored(const Contour& contour) {
  const auto view = contour.view();
  Contour other;
  for (std::size_t loop = 0; loop < view.loop_ends.size(); ++loop) {
    const std::uint32_t first = view.loop_begin(loop);
    const std::uint32_t end = view.loop_ends[loop];
    for (std::uint32_t i = end; i-- > first;) {
      const std::uint32_t before = i > first ? i - 1 : end - 1;
      const ContourVertex& vertex = view.vertices[i];
      other.vertices.push_back({vertex.x, -vertex.y, view.vertices[before].bulge});
    }
    other.end_loop();
  }
  return other;
}

void mirror(PathRows& path) {
  for (cnc::pocket::PathPoint<double>& point : path.points) {
    point.y = -point.y;
    point.bulge = -point.bulge;
  }
}

}  // namespace sim::pocket
