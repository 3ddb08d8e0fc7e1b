#include "host-sim/pocket/terraces.hpp"

#include <cmath>
#include <limits>
#include <set>

#include "host-sim/contour/contour_loops.hpp"
#include "host-sim/contour/material_side.hpp"
#include "host-sim/pocket/loop_contact.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace sim::pocket {
namespace {

constexpr std::size_t kNoLoop = std::numeric_limits<std::size_t>::max();

/// A loop with its position among other loops.
struct NestedLoop {
  double area_mm2 = 0.0;
  std::size_t parent = kNoLoop;  ///< Number of the smallest loop around this loop.
  std::size_t nesting = 0;       ///< Number of loops around this loop.
  double floor_mm = 0.0;         ///< Depth of the floor between this loop and the loops in it, mm.
};

/// Finds the parent of each loop and the number of loops around it. Loops may touch each other.
std::vector<NestedLoop> nested(const Contour& contours) {
  const auto view = contours.view();
  std::vector<NestedLoop> loops(view.loop_ends.size());
  std::vector<cnc::contour::FlatBox<double>> boxes(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    loops[i].area_mm2 = std::abs(cnc::pocket::signed_area(view, i));
    boxes[i] = box_around(view, i);
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const cnc::WideVec2 begin = view.vertices[view.loop_begin(i)].point();
    for (std::size_t k = 0; k < loops.size(); ++k) {
      if (loops[k].area_mm2 <= loops[i].area_mm2) continue;
      if (!boxes[k].meets({begin.x(), begin.y(), begin.x(), begin.y()})) continue;
      const auto place = place_off_loop(view, i, k);
      if (!place || cnc::pocket::turns_around(view, k, *place) == 0) continue;
      ++loops[i].nesting;
      if (loops[i].parent == kNoLoop || loops[k].area_mm2 < loops[loops[i].parent].area_mm2) {
        loops[i].parent = k;
      }
    }
  }
  return loops;
}

/// Returns the areas in which the floor is at least `depth_mm` deep. Their boundaries are the loops
/// at which this changes.
Contour deeper_than(double depth_mm,
                    const Contour& contours,
                    const std::vector<NestedLoop>& loops,
                    const std::vector<std::size_t>& members) {
  Contour areas;
  for (const std::size_t i : members) {
    const double around_mm = loops[i].parent == kNoLoop ? 0.0 : loops[loops[i].parent].floor_mm;
    if ((loops[i].floor_mm >= depth_mm) != (around_mm >= depth_mm)) {
      append_loop(contours.view(), i, areas);
    }
  }
  put_material_left(areas);
  return areas;
}

}  // namespace

std::vector<Terraces> terraces_of(const Contour& contours,
                                  const std::vector<std::optional<double>>& depths_mm,
                                  double usual_mm) {
  std::vector<NestedLoop> loops = nested(contours);
  std::vector<std::vector<std::size_t>> stacks(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const double usual = loops[i].nesting % 2 == 0 ? usual_mm : 0.0;
    loops[i].floor_mm = depths_mm[i].value_or(usual);
    std::size_t outermost = i;
    while (loops[outermost].parent != kNoLoop) outermost = loops[outermost].parent;
    stacks[outermost].push_back(i);
  }
  std::vector<Terraces> terraces;
  for (const std::vector<std::size_t>& members : stacks) {
    std::set<double> floors;
    for (const std::size_t i : members) floors.insert(loops[i].floor_mm);
    floors.erase(0.0);
    Terraces stack;
    for (const double floor_mm : floors) {
      const double from_mm = stack.empty() ? 0.0 : stack.back().to_mm;
      stack.push_back({from_mm, floor_mm, deeper_than(floor_mm, contours, loops, members)});
    }
    if (!stack.empty()) terraces.push_back(std::move(stack));
  }
  return terraces;
}

}  // namespace sim::pocket
