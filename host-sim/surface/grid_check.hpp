#pragma once

#include "host-sim/surface/grid_draft.hpp"

namespace sim::surface {

/// Throws std::invalid_argument for fewer than two rows or columns, for equal neighbours, and for
/// folds: quadrilaterals with a triangle that turns over in projection, or no projected area.
void require_sound_grid(const GridDraft& grid);

/// Returns the points behind a step, along a row or from row to row, that is several times the
/// median of such steps in projection.
[[nodiscard]] FaultyPoints gaps_of(const GridDraft& grid);

/// Throws std::invalid_argument for X or Y beyond kFarthestMm, and heights beyond
/// `farthest_height_mm`. Missing points have no height.
void require_near_points(const GridDraft& grid, double farthest_height_mm);

/// Returns the sum of the projected areas of all quadrilaterals, in mm²: negative where +Z sees
/// columns turn clockwise to rows.
[[nodiscard]] double projected_area(const GridDraft& grid);

}  // namespace sim::surface
