#include "host-sim/contour/material_side.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "planner/pocket/loop_measures.hpp"

namespace sim {
namespace {

void turn_round(Contour& contour, std::size_t loop) {
  const auto first = contour.vertices.begin() + contour.view().loop_begin(loop);
  const auto end = contour.vertices.begin() + contour.loop_ends[loop];
  std::reverse(first + 1, end);  // The first vertex of the loop stays the first one.
  const double closing = first->bulge;
  for (auto vertex = first; vertex + 1 != end; ++vertex) vertex->bulge = -(vertex + 1)->bulge;
  (end - 1)->bulge = -closing;
}

}  // namespace

void put_material_left(Contour& contour) {
  const auto view = contour.view();
  const std::size_t loops = contour.loop_ends.size();
  std::vector<bool> outlines;
  for (std::size_t loop = 0; loop < loops; ++loop) {
    const cnc::WideVec2 place = view.vertices[view.loop_begin(loop)].point();
    bool outline = true;
    for (std::size_t other = 0; other < loops; ++other) {
      if (other == loop) continue;
      if (cnc::pocket::turns_around(view, other, place) != 0) outline = !outline;
    }
    outlines.push_back(outline);
  }
  for (std::size_t loop = 0; loop < loops; ++loop) {
    const bool runs_left = cnc::pocket::signed_area(contour.view(), loop) > 0.0;
    if (runs_left != outlines[loop]) turn_round(contour, loop);
  }
}

}  // namespace sim
