#include "host-sim/contour/simple_loops.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace sim {
namespace {

/// Greatest distance of a dropped vertex from the straight line between its neighbours, mm.
constexpr double kStraightMm = 1.0e-9;

bool goes_straight_on(const ContourVertex& before,
                      const ContourVertex& vertex,
                      const ContourVertex& after) {
  if (before.bulge != 0.0 || vertex.bulge != 0.0) return false;
  const cnc::WideVec2 in = vertex.point() - before.point();
  const cnc::WideVec2 out = after.point() - vertex.point();
  return in.dot(out) > 0.0 && std::abs(cnc::cross(in, out)) <= kStraightMm * (in + out).norm();
}

void add_loop(const std::vector<ContourVertex>& loop, Contour& to) {
  if (loop.size() < 2) return;
  std::vector<ContourVertex> kept;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const ContourVertex& before = kept.empty() ? loop.back() : kept.back();
    const ContourVertex& after = loop[i + 1 < loop.size() ? i + 1 : 0];
    if (!goes_straight_on(before, loop[i], after)) kept.push_back(loop[i]);
  }
  if (kept.size() < 2) return;
  to.vertices.insert(to.vertices.end(), kept.begin(), kept.end());
  to.end_loop();
}

}  // namespace

Contour simple_loops(const cnc::contour::ContourView<double>& loops) {
  Contour simple;
  std::vector<ContourVertex> open;
  // Index in `open` of each of its vertices, keyed by the coordinates of the vertex.
  std::map<std::pair<double, double>, std::size_t> places;
  for (std::size_t loop = 0; loop < loops.loop_ends.size(); ++loop) {
    open.clear();
    places.clear();
    for (std::uint32_t i = loops.loop_begin(loop); i < loops.loop_ends[loop]; ++i) {
      const ContourVertex& vertex = loops.vertices[i];
      const auto known = places.find({vertex.x, vertex.y});
      if (known != places.end()) {
        const auto first = open.begin() + static_cast<std::ptrdiff_t>(known->second);
        const std::vector<ContourVertex> closed{first, open.end()};
        for (const ContourVertex& gone : closed) places.erase({gone.x, gone.y});
        open.erase(first, open.end());
        add_loop(closed, simple);
      }
      places[{vertex.x, vertex.y}] = open.size();
      open.push_back(vertex);
    }
    add_loop(open, simple);
  }
  return simple;
}

}  // namespace sim
