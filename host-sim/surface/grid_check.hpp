#pragma once

#include "host-sim/surface/grid_draft.hpp"

namespace sim::surface {

/// Throws std::invalid_argument for fewer than two rows or columns, for equal neighbours, for a
/// grid without area in plan, and for folds. A fold is a quadrilateral with a triangle that is
/// flipped in plan.
void require_sound_grid(const GridDraft& grid);

/// Returns the points that follow a gap. A gap is a step along a row, or from row to row. Its
/// length in plan is several times the median step in the same direction.
[[nodiscard]] FaultyPoints gaps_of(const GridDraft& grid);

/// Throws std::invalid_argument for X or Y beyond kFarthestMm, and for heights beyond
/// `farthest_height_mm`. Heights of missing points are not checked.
void require_near_points(const GridDraft& grid, double farthest_height_mm);

/// Returns the sum of the projected areas of all quadrilaterals, in mm². The sum is negative if,
/// seen from +Z, the direction of rising row numbers is clockwise from the direction of rising
/// column numbers.
[[nodiscard]] double projected_area(const GridDraft& grid);

}  // namespace sim::surface
