#pragma once

#include <vector>

#include "host-sim/cut/doubled_lines.hpp"
#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/plan_work.hpp"

namespace sim::cut {

/// Appends the cuts of all contours to the plan, in the order of the drawing and without their
/// beginnings. The cuts run at half a kerf from edges, along lines, and across the areas that are
/// filled. Faults and warnings are appended, too.
/// @param work plan, with the outlines and the prepared edges
/// @param sides side of each contour
/// @param left_lines rests of the lines that partly run along other lines; see without_doubled()
/// @param wish limits of the machine, which determine the overscan of a fill
void find_cuts(PlanWork& work,
               const std::vector<Side>& sides,
               const LeftLines& left_lines,
               const OrderWish& wish);

}  // namespace sim::cut
